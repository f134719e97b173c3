#include "app/cmd/doctor/doctor_character.h"

#include "app/scene/instance/instance.h"

static void count(
	const struct character *character, struct doctor_character *out)
{
	out->right = true;
	out->states = character->machine.state_count;
	out->layers = character->layer_count;
	out->effects = character->switch_count - character->layer_count;
	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		out->buttons++;
	}
}

int doctor_character_check(const struct character_request *request,
	size_t memory_bytes, const struct log *findings, const struct log *log,
	struct doctor_character *out)
{
	struct model *model;
	struct instance *instance;
	struct character *character;
	int error;

	*out = (struct doctor_character){.path = ""};
	out->found = character_open_path(request, out->path, sizeof(out->path));
	if (!out->found) {
		return 0;
	}
	error = model_load_within(request->model_path,
		memory_bytes ? memory_bytes : MODEL_MEMORY_BYTES, log, &model);
	if (error) {
		return error;
	}
	error = instance_create(model, &kernel_float, log, &instance);
	if (!error) {
		if (character_load(out->path, instance, findings, &character) ==
			0) {
			count(character, out);
			character_destroy(character);
		}
		instance_destroy(instance);
	}
	model_destroy(model);
	return error;
}

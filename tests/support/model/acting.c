#include "tests/support/model/acting.h"

#include "app/character/sketch/character_sketch.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

void acting_begin(struct acting *acting, const char *model_path)
{
	struct log log = log_to_stderr(LOG_ERROR);

	*acting = (struct acting){0};
	assert_int_equal(model_load(model_path, &log, &acting->model), 0);
	assert_int_equal(instance_create(acting->model, &kernel_float, &log,
				 &acting->instance),
		0);
}

static void replace(struct acting *acting)
{
	character_destroy(acting->character);
	acting->character = NULL;
	acting->now_s = 0.0;
}

char *acting_sketch(
	const struct model *model, const struct character_sketch_play *play)
{
	char *text = NULL;
	size_t size;
	FILE *file = open_memstream(&text, &size);

	assert_non_null(file);
	assert_int_equal(character_sketch(model, play, file), 0);
	fclose(file);
	return text;
}

void acting_read(struct acting *acting, const char *text)
{
	struct log log = log_capture_begin(&acting->logged);
	FILE *file = fmemopen((void *)text, strlen(text), "r");

	assert_non_null(file);
	replace(acting);
	acting->error = character_read(file, "test.character", acting->instance,
		&log, &acting->character);
	fclose(file);
}

void acting_expect(struct acting *acting, const char *text)
{
	acting_read(acting, text);
	if (acting->error) {
		print_message("%s\n", acting->logged.sentence[0]);
	}
	assert_int_equal(acting->error, 0);
}

void acting_load(struct acting *acting, const char *path)
{
	struct log log = log_capture_begin(&acting->logged);

	replace(acting);
	acting->error = character_load(
		path, acting->instance, &log, &acting->character);
	if (acting->error) {
		print_message("%s\n", acting->logged.sentence[0]);
	}
}

void acting_run_to(struct acting *acting, double time_s, double rate_hz)
{
	while (acting->now_s < time_s) {
		struct character_frame frame = {
			.time_s = acting->now_s + 1.0 / rate_hz,
			.eye = {0.0f, 1.0f, 4.0f},
		};

		acting->now_s = frame.time_s;
		character_update(acting->character, &frame);
	}
}

static void send(struct acting *acting, enum button button, bool down)
{
	struct button_event event = {.button = button, .down = down};

	character_press(acting->character, &event);
}

void acting_press(struct acting *acting, enum button button)
{
	send(acting, button, true);
}

void acting_release(struct acting *acting, enum button button)
{
	send(acting, button, false);
}

void acting_tap(struct acting *acting, enum button button, double held_s,
	double rate_hz)
{
	acting_press(acting, button);
	acting_run_to(acting, acting->now_s + held_s, rate_hz);
	acting_release(acting, button);
}

float acting_value(const struct acting *acting, const char *parameter)
{
	const struct character *character = acting->character;

	for (int i = 0; i < character->parameter_count; i++) {
		if (strcmp(character->parameter[i].name, parameter) == 0) {
			return character->parameter[i].value;
		}
	}
	fail_msg("there is no parameter %s", parameter);
	return 0.0f;
}

const char *acting_state(const struct acting *acting)
{
	const struct character_machine *machine = &acting->character->machine;

	return machine->state[machine->current].name;
}

void acting_place(const struct acting *acting, const char *node, float out[3])
{
	int found = model_find_node(acting->model, node);

	assert_true(found >= 0);
	memcpy(out, acting->instance->world[found][3], sizeof(float[3]));
}

void acting_end(struct acting *acting)
{
	character_destroy(acting->character);
	instance_destroy(acting->instance);
	model_destroy(acting->model);
}

#include "app/model/model.h"

#include "app/model/color.h"
#include "app/model/model_loader.h"
#include "platform/base/name_list.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const struct model_material model_plain_material = {
	.name = "",
	.base_color = {1, 1, 1, 1},
	.texture = -1,
	.normal_texture = -1,
	.roughness = 1,
	.emissive_texture = -1,
	.alpha_cutoff = 0.5f,
};

void model_material_shown(
	const struct model_material *material, float out_srgb[3])
{
	bool shines = model_material_emits(material) &&
		(material->emissive_texture < 0 ||
			material->emissive_texture == material->texture);
	float brightest = 0.0f;

	for (int i = 0; i < 3; i++) {
		out_srgb[i] = color_encode_srgb(material->base_color[i]);
		brightest = fmaxf(brightest, out_srgb[i]);
	}
	for (int i = 0; i < 3 && !material->unlit && !shines; i++) {
		out_srgb[i] += color_mirrored(brightest);
	}
}

/*
 * Lets the arena, which owns the budget, count against it, and takes the
 * source's bytes. Returns false if the budget is too small.
 */
static bool fits(struct arena *arena, struct memory_budget *budget, size_t bytes)
{
	return arena_set_budget(arena, budget) &&
		memory_budget_take(budget, bytes);
}

struct model *model_create(const struct model_source *source,
	const char *format, const struct log *log)
{
	struct arena arena = arena_empty();
	struct model *model = ARENA_NEW(&arena, struct model);
	struct memory_budget *budget = ARENA_NEW(&arena, struct memory_budget);

	if (budget) {
		budget->limit_bytes = source->memory_bytes;
	}
	if (model && budget && fits(&arena, budget, source->size)) {
		model->path = arena_strdup(&arena, source->name);
		model->format = arena_strdup(&arena, format);
		model->budget = budget;
		model->arena = arena;
		model->targets = arena_within(budget);
		if (model->path && model->format) {
			return model;
		}
	}
	(void)memory_budget_fail(budget, source->name, log);
	arena_release(&arena);
	return NULL;
}

void model_destroy(struct model *model)
{
	if (model) {
		struct arena arena = model->arena;

		arena_release(&model->targets);
		arena_release(&arena);
	}
}

int model_find_node(const struct model *model, const char *name)
{
	int i;

	for (i = 0; i < model->node_count; i++) {
		if (strcmp(model->node[i].name, name) == 0) {
			return i;
		}
	}
	return -1;
}

bool model_node_shows_mesh(const struct model_node *node)
{
	return node->mesh >= 0 && node->in_scene && !node->hidden;
}

bool model_is_below(const struct model *model, int node, int top)
{
	/* Parents come before their children. */
	while (node > top) {
		node = model->node[node].parent;
	}
	return node == top;
}

int model_find_common(const struct model *model, int a, int b)
{
	while (a != b) {
		/* parents come before their children */
		if (a > b) {
			a = model->node[a].parent;
		} else {
			b = model->node[b].parent;
		}
	}
	return a;
}

int model_find_carrier(const struct model *model)
{
	int top = model->node_count;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];
		const struct model_skin *skin =
			node->skin >= 0 ? &model->skin[node->skin] : NULL;
		int count = skin ? skin->joint_count : 1;

		for (int j = 0; j < count && model_node_shows_mesh(node); j++) {
			int at = skin ? skin->joint[j] : i;

			top = top == model->node_count
				? at
				: model_find_common(model, top, at);
		}
	}
	return top < model->node_count ? top : -1;
}

int model_lod_of_size(const struct model_primitive *primitive, int index_count)
{
	int level = 0;

	for (int i = 0; i < primitive->lod_count; i++) {
		if (!primitive->lod[i].shadow_only &&
			primitive->lod[i].index_count >= index_count) {
			level = i + 1;
		}
	}
	return level;
}

bool model_material_emits(const struct model_material *material)
{
	const float *light = material->emissive;

	return !material->unlit &&
		(light[0] > 0.0f || light[1] > 0.0f || light[2] > 0.0f);
}

bool model_has_triangles(const struct model *model)
{
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (model_node_shows_mesh(node) &&
			model->mesh[node->mesh].primitive_count > 0) {
			return true;
		}
	}
	return false;
}

bool *model_find_joints(const struct model *model, struct arena *arena)
{
	bool *is_joint = ARENA_ARRAY(arena, bool, model->node_count);

	for (int s = 0; is_joint && s < model->skin_count; s++) {
		for (int j = 0; j < model->skin[s].joint_count; j++) {
			is_joint[model->skin[s].joint[j]] = true;
		}
	}
	return is_joint;
}

int model_find_morphed(const struct model *model)
{
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (model_node_shows_mesh(node) &&
			model->mesh[node->mesh].target_count > 0) {
			return i;
		}
	}
	return -1;
}

int model_find_clip(const struct model *model, const char *name_or_index)
{
	char *end;
	long number;
	int i;

	for (i = 0; i < model->clip_count; i++) {
		if (strcmp(model->clip[i].name, name_or_index) == 0) {
			return i;
		}
	}
	if (name_or_index[0] < '0' || name_or_index[0] > '9') {
		return -1;
	}
	number = strtol(name_or_index, &end, 10);
	if (*end || number >= model->clip_count) {
		return -1;
	}
	return (int)number;
}

bool model_clip_moves_weights(const struct model_clip *clip, int node)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path == MODEL_WEIGHTS &&
			clip->channel[i].node == node) {
			return true;
		}
	}
	return false;
}

void model_clip_mark_moved(const struct model_clip *clip, bool *moved)
{
	for (int i = 0; i < clip->channel_count; i++) {
		moved[clip->channel[i].node] = true;
	}
}

static bool moves_any(const struct model_clip *clip, const bool *moved)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (moved[clip->channel[i].node]) {
			return true;
		}
	}
	return false;
}

int model_clips_apart(
	const struct model *model, int first, bool *moved, int *list)
{
	int count = 0;

	for (int i = -1; i < model->clip_count; i++) {
		int number = i < 0 ? first : i;
		const struct model_clip *clip = &model->clip[number];

		if (i >= 0 &&
			(clip->channel_count == 0 || i == first ||
				moves_any(clip, moved))) {
			continue;
		}
		list[count++] = number;
		model_clip_mark_moved(clip, moved);
	}
	return count;
}

static void add_clip_names(struct name_choice *names, const void *context)
{
	const struct model *model = context;

	for (int i = 0; i < model->clip_count; i++) {
		if (model->clip[i].name[0]) {
			name_choice_add(names, model->clip[i].name);
		}
	}
}

/* Fails because no clip has the name or the number that --clip gives. */
static int fail_clip(
	const struct model *model, const char *wanted, const struct log *log)
{
	struct name_choice names = {.wanted = wanted};

	name_choice_list(&names, add_clip_names, model);
	if (model->clip_count == 0) {
		log_error(log, "--clip %s: %s has no clips: leave out --clip",
			wanted, model->path);
	} else {
		log_error(log, "--clip %s: %s has no such clip: give %s%s%s%d",
			wanted, model->path, names.list.text,
			names.list.text[0] ? ", or " : "",
			model->clip_count > 1 ? "a number from 0 to " : "",
			model->clip_count - 1);
	}
	return -ENOENT;
}

int model_choose_clip(const struct model *model, const char *wanted,
	int fallback, const struct log *log, int *out)
{
	*out = wanted ? model_find_clip(model, wanted) : fallback;
	return wanted && *out < 0 ? fail_clip(model, wanted, log) : 0;
}

/*
 * A vertex without weights would collapse into the origin. It follows its first
 * joint, because exporters put the bone of a rigid vertex there.
 */
static void normalize_vertex(uint16_t *joint, float *weight, int count)
{
	double sum = 0;
	int i;

	for (i = 0; i < count; i++) {
		weight[i] = weight[i] > 0 ? weight[i] : 0;
		sum += weight[i];
	}
	if (sum <= 0) {
		weight[0] = 1;
		sum = 1;
	}
	for (i = 0; i < count; i++) {
		weight[i] = (float)(weight[i] / sum);
		if (weight[i] <= 0) {
			joint[i] = 0;
		}
	}
}

void model_normalize_influences(struct model_primitive *primitive)
{
	int count = primitive->influences;
	int i;

	for (i = 0; count && i < primitive->vertex_count; i++) {
		normalize_vertex(primitive->joint + (size_t)i * (size_t)count,
			primitive->weight + (size_t)i * (size_t)count, count);
	}
}

int model_max_joint(const struct model_primitive *primitive)
{
	size_t total =
		(size_t)primitive->vertex_count * (size_t)primitive->influences;
	int max = -1;
	size_t i;

	for (i = 0; i < total; i++) {
		if (primitive->joint[i] > max) {
			max = primitive->joint[i];
		}
	}
	return max;
}

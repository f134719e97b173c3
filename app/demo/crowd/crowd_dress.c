#include "app/demo/crowd/crowd_dress.h"

#include "app/scene/instance/batch/batch.h"
#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <float.h>
#include <string.h>

/* A walker's look, in sRGB. A colour of all zeros keeps the model's own. */
struct look {
	float shirt[3]; /* factors of the stripes' colours, or the plain colour */
	bool plain;
	uint8_t hair[3], trousers[3], shoes[3];
};

static const struct look looks[] = {
	{{1.0f, 1.0f, 1.0f}, false, {0}, {0}, {0}},
	{{0.90f, 0.36f, 0.28f}, true, {52, 42, 40}, {70, 72, 80},
		{230, 230, 226}},
	{{1.0f, 0.62f, 0.45f}, false, {210, 170, 100}, {158, 136, 100},
		{96, 62, 40}},
	{{0.96f, 0.80f, 0.30f}, true, {92, 58, 40}, {0}, {60, 90, 170}},
	{{0.55f, 0.75f, 1.0f}, false, {150, 148, 148}, {58, 60, 66}, {0}},
	{{0.62f, 0.45f, 0.82f}, true, {60, 44, 38}, {120, 150, 190},
		{50, 50, 56}},
	{{1.0f, 0.95f, 0.55f}, false, {170, 84, 40}, {72, 90, 70},
		{220, 190, 80}},
	{{0.92f, 0.92f, 0.90f}, true, {48, 40, 38}, {0}, {190, 60, 60}},
	{{0.6f, 1.0f, 0.55f}, false, {224, 190, 122}, {104, 62, 60},
		{70, 70, 76}},
	{{0.94f, 0.52f, 0.68f}, true, {110, 66, 40}, {196, 190, 178}, {0}},
	{{0.62f, 0.62f, 0.66f}, false, {0}, {96, 120, 160}, {60, 130, 110}},
	{{0.28f, 0.46f, 0.72f}, true, {190, 150, 92}, {150, 128, 92},
		{234, 234, 230}},
};

/* Parts of the height, at rest, that tell hair, trousers and shoes apart. */
static const float hair_from = 0.683f, waist = 0.626f, ankle = 0.091f;

/* Replaces color by target, dimmed by the old colour's share of brightest. */
static void recolor(uint8_t color[4], const uint8_t target[3], int brightest)
{
	int light = color[0] > color[2] ? color[0] : color[2];

	if (!(target[0] | target[1] | target[2])) {
		return;
	}
	light = light > brightest ? brightest : light;
	for (int i = 0; i < 3; i++) {
		color[i] = (uint8_t)(target[i] * light / brightest);
	}
}

struct dyeing {
	const struct look *look;
	const struct model_primitive *primitive;
	float height; /* of the highest vertex of all meshes, above 0 */
};

/*
 * Recolours a vertex. In the model, trousers are blue, and hair and shoes are
 * of a deeper red than the skin. color has what dark colours mirror as well.
 */
static void dye(void *user, int vertex, uint8_t color[4])
{
	const struct dyeing *dyeing = user;
	const struct look *look = dyeing->look;
	float height = dyeing->primitive->position[vertex][1] / dyeing->height;
	const uint8_t *own = dyeing->primitive->color[vertex];
	bool blue = own[2] > own[0] + 8;
	bool red = 10 * own[1] < 6 * own[0];

	if (blue && height < waist) {
		recolor(color, look->trousers, 118);
	} else if (red && height > hair_from) {
		recolor(color, look->hair, 124);
	} else if (red && height < ankle) {
		recolor(color, look->shoes, 222);
	}
}

/* Gives the instance a copy of its model whose clothes have no texture. */
static int use_plain_cloth(struct instance *instance)
{
	const struct model *model = instance->model;
	struct model *plain = ARENA_NEW(&instance->arena, struct model);
	struct model_material *material = ARENA_ARRAY(&instance->arena,
		struct model_material, (size_t)model->material_count);

	if (!plain || !material) {
		return -ENOMEM;
	}
	*plain = *model;
	plain->material = material;
	for (int i = 0; i < model->material_count; i++) {
		material[i] = model->material[i];
		if (material[i].normal_texture < 0) {
			material[i].texture = -1;
		}
	}
	instance->model = plain;
	return 0;
}

static bool is_shirt(const struct model_material *material)
{
	return strcmp(material->name, "shirt") == 0;
}

/*
 * Whether a primitive is made as those of the walker are: without a texture it
 * has a colour at each vertex, and only the shirt has a texture without a
 * normal map.
 */
static bool is_made_as_walker(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material =
		&model->material[primitive->material];

	if (material->texture < 0) {
		return primitive->color != NULL;
	}
	return material->normal_texture >= 0 || is_shirt(material);
}

/* Other models may have a material of this name, too. */
static bool has_clothes(const struct instance *instance)
{
	const struct model *model = instance->model;
	bool has_shirt = false;

	for (int i = 0; i < model->material_count; i++) {
		has_shirt = has_shirt || is_shirt(&model->material[i]);
	}
	for (int i = 0; has_shirt && i < instance->drawable_count; i++) {
		has_shirt = is_made_as_walker(
			model, instance->drawable[i].primitive);
	}
	return has_shirt;
}

/* Tints the whole figure lightly by the colour of the look's shirt. */
static int tint(struct instance *instance, const struct look *look)
{
	float factor[3];
	int error = 0;

	for (int i = 0; i < 3; i++) {
		factor[i] = 0.6f + 0.4f * look->shirt[i];
	}
	for (int i = 0; !error && i < instance->drawable_count; i++) {
		error = batch_tint(
			&instance->drawable[i], factor, &instance->arena);
	}
	return error;
}

static float find_height(const struct instance *instance)
{
	float height = FLT_MIN;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct model_primitive *primitive =
			instance->drawable[i].primitive;

		for (int v = 0; v < primitive->vertex_count; v++) {
			height = scalar_max(primitive->position[v][1], height);
		}
	}
	return height;
}

int crowd_dress(struct instance *instance, int number)
{
	const struct look *look = &looks[number % (int)ARRAY_COUNT(looks)];
	const struct model *model = instance->model;
	struct dyeing dyeing = {.look = look};
	int error;

	if (!has_clothes(instance)) {
		return tint(instance, look);
	}
	dyeing.height = find_height(instance);
	error = look->plain ? use_plain_cloth(instance) : 0;
	for (int i = 0; !error && i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];
		const struct model_material *material =
			&model->material[drawable->primitive->material];

		if (material->texture >= 0 && material->normal_texture < 0) {
			error = batch_tint(
				drawable, look->shirt, &instance->arena);
		} else if (material->texture < 0 && !drawable->morphed) {
			dyeing.primitive = drawable->primitive;
			error = batch_recolor(
				drawable, dye, &dyeing, &instance->arena);
		}
	}
	return error;
}

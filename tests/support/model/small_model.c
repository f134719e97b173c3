#include "tests/support/model/small_model.h"

#include "tests/support/test.h"

#include <string.h>

const uint8_t small_model_flat_map[1][4] = {{128, 128, 255, 255}};

static void *take(struct model *model, size_t count, size_t size)
{
	void *memory = arena_alloc(&model->arena, count, size);

	assert_non_null(memory);
	return memory;
}

static void fill_vertices(
	struct model_primitive *primitive, int columns, int rows, float size)
{
	int v = 0;

	for (int y = 0; y <= rows; y++) {
		for (int x = 0; x <= columns; x++, v++) {
			primitive->position[v][0] =
				size * (float)x / (float)columns;
			primitive->position[v][1] =
				size * (float)y / (float)rows;
			if (primitive->normal) {
				primitive->normal[v][2] = 1.0f;
			}
		}
	}
}

static void fill_indices(
	struct model_primitive *primitive, int columns, int rows)
{
	uint32_t *next = primitive->index;

	for (int y = 0; y < rows; y++) {
		for (int x = 0; x < columns; x++) {
			uint32_t at = (uint32_t)(y * (columns + 1) + x);
			uint32_t above = at + (uint32_t)columns + 1;

			*next++ = at;
			*next++ = at + 1;
			*next++ = above;
			*next++ = above;
			*next++ = at + 1;
			*next++ = above + 1;
		}
	}
}

struct model *small_model_grid(
	int columns, int rows, float size, bool with_normals)
{
	struct arena arena = arena_empty();
	struct model *model = ARENA_NEW(&arena, struct model);
	struct model_primitive *primitive;
	size_t vertices = (size_t)(columns + 1) * (size_t)(rows + 1);
	size_t indices = (size_t)columns * (size_t)rows * 6;

	assert_non_null(model);
	model->arena = arena;
	model->path = "grid";
	model->node_count = model->mesh_count = model->material_count = 1;
	model->node = take(model, 1, sizeof(*model->node));
	model->mesh = take(model, 1, sizeof(*model->mesh));
	model->material = take(model, 1, sizeof(*model->material));
	model->rest_weights = take(model, 0, sizeof(float));
	*model->node = (struct model_node){
		.name = "grid",
		.parent = -1,
		.in_scene = true,
		.rest = {.rotation = {0, 0, 0, 1}, .scale = {1, 1, 1}},
		.skin = -1,
		.camera = -1,
	};
	*model->material = (struct model_material){
		.name = "white",
		.base_color = {1, 1, 1, 1},
		.texture = -1,
		.normal_texture = -1,
		.emissive_texture = -1,
		.roughness = 1,
	};
	primitive = take(model, 1, sizeof(*primitive));
	*model->mesh = (struct model_mesh){
		.name = "grid", .primitive_count = 1, .primitive = primitive};
	primitive->vertex_count = (int)vertices;
	primitive->position = take(model, vertices, sizeof(float[3]));
	if (with_normals) {
		primitive->normal = take(model, vertices, sizeof(float[3]));
	}
	primitive->index_count = (int)indices;
	primitive->index = take(model, indices, sizeof(uint32_t));
	fill_vertices(primitive, columns, rows, size);
	fill_indices(primitive, columns, rows);
	return model;
}

static void add_frames(struct model *model)
{
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	size_t count = (size_t)primitive->vertex_count;
	const float *far = primitive->position[count - 1];

	primitive->tangent = take(model, count, sizeof(float[4]));
	primitive->texcoord = take(model, count, sizeof(float[2]));
	for (size_t v = 0; v < count; v++) {
		primitive->tangent[v][0] = 1.0f;
		primitive->tangent[v][3] = 1.0f;
		primitive->texcoord[v][0] = primitive->position[v][0] / far[0];
		primitive->texcoord[v][1] =
			1.0f - primitive->position[v][1] / far[1];
	}
}

void small_model_add_normal_map(
	struct model *model, int width, const uint8_t (*rgba)[4])
{
	size_t bytes = (size_t)width * 4;

	add_frames(model);
	model->texture_count = model->image_count = 1;
	model->texture = take(model, 1, sizeof(*model->texture));
	model->image = take(model, 1, sizeof(*model->image));
	*model->texture = (struct model_texture){
		.wrap_s = MODEL_CLAMP,
		.wrap_t = MODEL_CLAMP,
		.nearest = true,
	};
	*model->image = (struct model_image){
		.name = "normals",
		.width = width,
		.height = 1,
		.opaque = true,
		.rgba = take(model, bytes, 1),
	};
	memcpy(model->image->rgba, rgba, bytes);
	model->material[0].normal_texture = 0;
}

struct instance *small_model_instance(const struct model *model)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance = NULL;

	assert_int_equal(
		instance_create(model, &kernel_float, &nowhere, &instance), 0);
	return instance;
}

void small_model_fill_picture(struct instance *instance)
{
	struct transform *local = &instance->pose.local[0];

	for (int axis = 0; axis < 2; axis++) {
		local->translation[axis] = -1;
		local->scale[axis] = 2;
	}
	instance_update(instance);
}

void small_model_light_from(struct instance *instance, float x, float y, float z)
{
	instance->towards_light[0] = x;
	instance->towards_light[1] = y;
	instance->towards_light[2] = z;
	instance_update(instance);
}

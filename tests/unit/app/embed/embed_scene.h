/*
 * A model made in memory, and what app/embed writes of it.
 */
#ifndef TESTS_UNIT_APP_EMBED_EMBED_SCENE_H
#define TESTS_UNIT_APP_EMBED_EMBED_SCENE_H

#include "app/embed/embed.h"
#include "app/model/model_deltas.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/*
 * A model whose tables differ from each other: a mesh of two primitives, the
 * first with two morph targets and neither normals nor colours; a skinned
 * triangle; the same without a skin; a node outside the scene.
 * Behind the last skin, channel and node there is another one, which nothing
 * may show.
 */
struct embed_scene {
	float position[4][3], normal[4][3];
	uint8_t color[4][4];
	float delta[4][4][3];
	uint16_t joint[12];
	float weight[12];
	uint32_t index[6];
	struct model_target target[4];
	struct model_primitive pair[2], skinned[1];
	struct model_mesh mesh[2];
	mat4 bind[3];
	int joint_node[3];
	struct model_skin skin[3];
	float time_s[2], value[18];
	int16_t packed[2][4];
	struct model_channel channel[5];
	struct model_clip clip[1];
	struct model_node node[5];
	struct model_material material[2];
	float rest_weights[4];
	struct model model;
	struct log_capture logged;
	char *text;
	struct embed_size size;
};

static inline void embed_scene_make_vertices(struct embed_scene *s)
{
	static const uint32_t index[6] = {0, 1, 2, 2, 1, 3};

	memcpy(s->index, index, sizeof(index));
	for (int v = 0; v < 4; v++) {
		for (int k = 0; k < 3; k++) {
			s->position[v][k] = (float)(10 * v + k);
			s->normal[v][k] = -(float)(10 * v + k);
			for (int t = 0; t < 4; t++) {
				s->delta[t][v][k] =
					(float)(100 * t + 10 * v + k);
			}
		}
		for (int k = 0; k < 4; k++) {
			s->color[v][k] = (uint8_t)(40 * v + k);
		}
	}
	for (int i = 0; i < 12; i++) {
		s->joint[i] = (uint16_t)(i % 2);
		s->weight[i] = 0.25f;
	}
	for (int t = 0; t < 4; t++) {
		s->target[t].position = model_deltas_view(
			(const float(*)[3])s->delta[t], t < 2 ? 3 : 4);
	}
}

static inline void embed_scene_make_meshes(struct embed_scene *s)
{
	s->pair[0] = (struct model_primitive){.material = 1,
		.vertex_count = 3,
		.position = s->position,
		.index_count = 3,
		.index = s->index,
		.target = s->target};
	s->pair[1] = (struct model_primitive){.material = 0,
		.vertex_count = 4,
		.position = s->position,
		.normal = s->normal,
		.color = s->color,
		.index_count = 6,
		.index = s->index,
		.target = s->target + 2};
	s->skinned[0] = (struct model_primitive){.material = 0,
		.vertex_count = 3,
		.position = s->position + 1,
		.index_count = 3,
		.index = s->index,
		.influences = 4,
		.joint = s->joint,
		.weight = s->weight};
	s->mesh[0] = (struct model_mesh){
		.primitive_count = 2, .primitive = s->pair, .target_count = 2};
	s->mesh[1] = (struct model_mesh){
		.primitive_count = 1, .primitive = s->skinned};
	s->material[0] = (struct model_material){.base_color = {1, 1, 1, 1}};
	s->material[1] = (struct model_material){
		.base_color = {0.5f, 0.25f, 0.125f, 0.1f}};
}

static inline void embed_scene_make_skins(struct embed_scene *s)
{
	static const int nodes[3] = {3, 1, 0};

	memcpy(s->joint_node, nodes, sizeof(nodes));
	for (int j = 0; j < 3; j++) {
		for (int i = 0; i < 16; i++) {
			s->bind[j][i / 4][i % 4] = (float)(100 * j + i);
		}
	}
	s->skin[0] = (struct model_skin){.joint_count = 1,
		.joint = s->joint_node,
		.inverse_bind = s->bind};
	s->skin[1] = (struct model_skin){.joint_count = 2,
		.joint = s->joint_node + 1,
		.inverse_bind = s->bind + 1};
	s->skin[2] = s->skin[0];
}

static inline void embed_scene_make_nodes(struct embed_scene *s)
{
	static const struct model_node node[4] = {
		{.parent = -1,
			.in_scene = true,
			.mesh = 0,
			.skin = -1,
			.weight_offset = 2},
		{.parent = 0,
			.in_scene = true,
			.mesh = 1,
			.skin = 1,
			.weight_offset = 4},
		{.parent = 1, .in_scene = false, .mesh = 0, .skin = -1},
		{.parent = 1, .in_scene = true, .mesh = 1, .skin = -1},
	};

	memcpy(s->node, node, sizeof(node));
	s->node[4] = s->node[0];
	for (int n = 0; n < 4; n++) {
		float x = (float)n;

		s->node[n].rest = (struct transform){
			{x, x + 0.5f, -x}, {0, 0, x, 1}, {1, 2, 3 + x}};
	}
	for (int w = 0; w < 4; w++) {
		s->rest_weights[w] = 0.25f * (float)w;
	}
}

static inline void embed_scene_make_clip(struct embed_scene *s)
{
	s->time_s[1] = 1.5f;
	for (int i = 0; i < 18; i++) {
		s->value[i] = (float)i;
	}
	s->packed[0][3] = s->packed[1][1] = MODEL_PACKED_UNIT;
	s->channel[0] = (struct model_channel){.node = 3,
		.path = MODEL_TRANSLATION,
		.interpolation = MODEL_STEP,
		.width = 3,
		.key_count = 2,
		.time_s = s->time_s,
		.value = s->value};
	s->channel[1] = (struct model_channel){.node = 1,
		.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.width = 4,
		.key_count = 2,
		.time_s = s->time_s,
		.packed = (const int16_t(*)[4])s->packed};
	s->channel[2] = (struct model_channel){.node = 0,
		.path = MODEL_WEIGHTS,
		.interpolation = MODEL_CUBICSPLINE,
		.width = 2,
		.key_count = 1,
		.time_s = s->time_s,
		.value = s->value + 6};
	s->channel[3] = (struct model_channel){.node = 2,
		.path = MODEL_SCALE,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 1,
		.time_s = s->time_s + 1,
		.value = s->value + 12};
	s->channel[4] = s->channel[0];
	s->clip[0] = (struct model_clip){.name = "go",
		.duration_s = 1.5f,
		.channel_count = 4,
		.channel = s->channel};
}

static inline void embed_scene_begin(struct embed_scene *s)
{
	memset(s, 0, sizeof(*s));
	embed_scene_make_vertices(s);
	embed_scene_make_meshes(s);
	embed_scene_make_skins(s);
	embed_scene_make_nodes(s);
	embed_scene_make_clip(s);
	s->model = (struct model){.path = "a.glb",
		.node_count = 4,
		.node = s->node,
		.mesh_count = 2,
		.mesh = s->mesh,
		.skin_count = 2,
		.skin = s->skin,
		.clip_count = 1,
		.clip = s->clip,
		.material_count = 2,
		.material = s->material,
		.weight_count = 4,
		.rest_weights = s->rest_weights};
}

/* Prints the model with the names "t_..." or those of another prefix. */
static inline int embed_scene_print_as(
	struct embed_scene *s, const char *prefix, int clip)
{
	struct log log = log_capture_begin(&s->logged);
	size_t length;
	FILE *out;
	int error;

	free(s->text);
	s->text = NULL;
	out = open_memstream(&s->text, &length);
	assert_non_null(out);
	error = embed_print(&s->model, clip, prefix, &log, out, &s->size);
	assert_int_equal(fclose(out), 0);
	assert_int_equal(log_capture_count(&s->logged, LOG_ERROR), error != 0);
	return error;
}

static inline void embed_scene_print(struct embed_scene *s, int clip)
{
	assert_int_equal(embed_scene_print_as(s, "t", clip), 0);
}

static inline void embed_scene_end(struct embed_scene *s)
{
	free(s->text);
}

#endif

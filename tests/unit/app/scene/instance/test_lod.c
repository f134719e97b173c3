/* How many triangles: which level is drawn, and what the models' levels are. */
#include "app/anim/clip.h"
#include "app/model/model_stats.h"
#include "app/scene/instance/lod.h"
#include "platform/base/compiler.h"
#include "tests/support/demo_run.h"
#include "tests/support/small_model.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void test_reads_words_pixels_and_levels(void **state)
{
	struct lod lod;

	(void)state;
	assert_true(lod_parse("auto", &lod));
	assert_int_equal(lod.kind, LOD_AUTO);
	assert_true(lod_parse("off", &lod));
	assert_int_equal(lod.kind, LOD_ALL);
	assert_true(lod_parse("1.5", &lod));
	assert_int_equal(lod.kind, LOD_ERROR);
	assert_near(lod.error_px, 1.5, 0.0);
	assert_true(lod_parse("level:2", &lod));
	assert_int_equal(lod.kind, LOD_LEVEL);
	assert_int_equal(lod.level, 2);
}

static void test_refuses_other_words(void **state)
{
	static const char *const bad[] = {"", "0", "-1", "101", "1.5px", "nan",
		"on", "level:", "level:-1", "level:x", "level:100"};
	struct lod lod;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_false(lod_parse(bad[i], &lod));
	}
}

/* Eight triangles, a level of two and one of one, for errors of 1 and 4 cm. */
struct scene {
	struct model *model;
	struct instance *instance;
	struct drawable *drawable;
};

static struct scene begin(void)
{
	static uint32_t two[6] = {0, 2, 8, 0, 8, 6}, one[3] = {0, 2, 8};
	static struct model_lod lod[3] = {
		{.error_m = 0.01f, .index_count = 6, .index = two},
		{.error_m = 0.04f, .index_count = 3, .index = one},
		{.error_m = 0.02f, .shadow_only = true, .index_count = 3, .index = one},
	};
	struct scene scene = {.model = small_model_grid(2, 2, 1.0f, true)};
	struct model_primitive *primitive = &scene.model->mesh[0].primitive[0];

	primitive->lod_count = 3;
	primitive->lod = lod;
	scene.instance = small_model_instance(scene.model);
	scene.drawable = &scene.instance->drawable[0];
	return scene;
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

static const struct lod by_itself = {.kind = LOD_AUTO};

static void test_takes_the_coarsest_that_is_a_pixel_off(void **state)
{
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &by_itself, 1000.0f);
	assert_int_equal(scene.drawable->lod, 0);
	assert_int_equal(lod_triangles(scene.instance), 8);
	lod_choose(scene.instance, &by_itself, 99.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 1);
	assert_int_equal(lod_triangles(scene.instance), 2);
	lod_choose(scene.instance, &by_itself, 24.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 2);
	assert_int_equal(lod_triangles(scene.instance), 1);
	end(&scene);
}

static void test_does_what_it_is_told(void **state)
{
	static const struct lod all = {.kind = LOD_ALL};
	static const struct lod last = {.kind = LOD_LEVEL, .level = 9};
	static const struct lod coarse = {.kind = LOD_ERROR, .error_px = 5.0f};
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &coarse, 120.0f);
	assert_int_equal(scene.drawable->lod, 2);
	lod_choose(scene.instance, &all, 120.0f);
	assert_int_equal(scene.drawable->lod, 0);
	lod_choose(scene.instance, &last, 120.0f);
	assert_int_equal(scene.drawable->lod, 2);
	end(&scene);
}

/* What sways around the border between two levels keeps one. */
static void test_small_changes_change_nothing(void **state)
{
	float border = 100.0f * LOD_ERROR_PX;
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &by_itself, border * 0.98f);
	assert_int_equal(scene.drawable->lod, 1);
	for (int i = 0; i < 100; i++) {
		lod_choose(scene.instance, &by_itself,
			border * (i % 2 ? 0.96f : 1.05f));
		assert_int_equal(scene.drawable->lod, 1);
	}
	lod_choose(scene.instance, &by_itself, border * 1.2f);
	assert_int_equal(scene.drawable->lod, 0);
	end(&scene);
}

static void test_what_is_large_needs_more(void **state)
{
	struct scene scene = begin();

	(void)state;
	scene.instance->pose.local[0].scale[0] = 3.0f;
	instance_update(scene.instance);
	lod_choose(scene.instance, &by_itself, 40.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 0);
	lod_choose(scene.instance, &by_itself, 30.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 1);
	end(&scene);
}

static void test_a_budget_asks_for_less_but_never_for_more(void **state)
{
	static const struct lod all = {.kind = LOD_ALL};
	static const struct lod five = {.kind = LOD_ERROR, .error_px = 5.0f};

	(void)state;
	assert_int_equal(lod_relax(&by_itself, 0.0f).kind, LOD_AUTO);
	assert_near(lod_relax(&by_itself, 2.0f).error_px, 2.0, 0.0);
	assert_near(lod_relax(&five, 2.0f).error_px, 5.0, 0.0);
	assert_int_equal(lod_relax(&all, 2.0f).kind, LOD_ALL);
}

static void test_half_as_far_has_twice_the_pixels(void **state)
{
	struct scene scene = begin();
	struct camera camera = camera_default();
	float far;

	(void)state;
	camera.distance = 100.5f;
	far = lod_px_per_unit(scene.instance, &camera, 1.0f, 640);
	camera.distance = 50.5f;
	assert_near(lod_px_per_unit(scene.instance, &camera, 1.0f, 640),
		2.0f * far, 1e-3f * far);
	assert_near(lod_px_per_unit(scene.instance, &camera, 1.0f, 1280),
		4.0f * far, 1e-3f * far);
	/* 30 degrees high, at the near side of the box. */
	assert_near(far, 320.0 / (100.0 * tan(acos(-1.0) / 12.0)), 1e-2 * far);
	end(&scene);
}

/* The models of assets/. */

static const char *const assets[] = {
	"assets/walker.glb", "assets/face.glb", "assets/arm.glb"};

static struct model *load(const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load(path, &nowhere, &model), 0);
	return model;
}

static void test_fixed_point_draws_the_same_vertices(void **state)
{
	struct log nowhere = log_to_nowhere();
	struct model *model = load(assets[0]);
	struct instance *instance;
	int lists = 0;

	(void)state;
	assert_int_equal(instance_create(model, kernel_find("fixed"), &nowhere,
				 &instance),
		0);
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct batch *batch = drawable->batch;

		for (int k = 0; k < batch->lod_count; k++, lists++) {
			const uint32_t *order = drawable->fixed->order;
			const struct batch_lod *lod = &batch->lod[k];

			for (int v = 0; v < lod->index_count; v++) {
				uint32_t at = lod->index[v];

				assert_int_equal(order ? order[at] : at,
					drawable->primitive->lod[k].index[v]);
			}
		}
	}
	assert_true(lists >= 12);
	instance_destroy(instance);
	model_destroy(model);
}

struct edge {
	float end[2][3]; /* the lesser first */
	int turns;       /* 1 as a triangle goes round, -1 the other way */
};

static int compare_points(const float *a, const float *b)
{
	for (int axis = 0; axis < 3; axis++) {
		if (a[axis] != b[axis]) {
			return a[axis] < b[axis] ? -1 : 1;
		}
	}
	return 0;
}

static int compare_ends(const void *left, const void *right)
{
	return compare_points(left, right);
}

static int compare_edges(const void *left, const void *right)
{
	const struct edge *a = left, *b = right;
	int first = compare_points(a->end[0], b->end[0]);

	return first ? first : compare_points(a->end[1], b->end[1]);
}

static void add_triangles(const struct model_primitive *primitive,
	const uint32_t *index, int count, struct edge *edge, int *edges)
{
	for (int i = 0; i < count; i++) {
		const float *a = primitive->position[index[i]];
		const float *b =
			primitive->position[index[i % 3 < 2 ? i + 1 : i - 2]];
		bool turned = compare_points(a, b) > 0;

		memcpy(edge[*edges].end[turned], a, sizeof(float[3]));
		memcpy(edge[*edges].end[!turned], b, sizeof(float[3]));
		edge[(*edges)++].turns = turned ? -1 : 1;
	}
}

/* The ends of all edges that a mesh (level -1: all of it) has open, sorted. */
static int open_ends(const struct model_mesh *mesh, int level, float (**out)[3])
{
	struct edge *edge = calloc(100000, sizeof(*edge));
	int edges = 0, ends = 0;

	*out = calloc(200000, sizeof(**out));
	assert_non_null(edge);
	assert_non_null(*out);
	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];
		const struct model_lod *lod = &primitive->lod[level];

		if (level < 0) {
			add_triangles(primitive, primitive->index,
				primitive->index_count, edge, &edges);
		} else {
			add_triangles(primitive, lod->index, lod->index_count,
				edge, &edges);
		}
	}
	qsort(edge, (size_t)edges, sizeof(*edge), compare_edges);
	for (int i = 0, next; i < edges; i = next) {
		int turns = 0;

		for (next = i; next < edges &&
			compare_edges(&edge[i], &edge[next]) == 0;
			next++) {
			turns += edge[next].turns;
		}
		if (turns != 0 &&
			compare_points(edge[i].end[0], edge[i].end[1]) != 0) {
			memcpy((*out)[ends], edge[i].end, sizeof(edge[i].end));
			ends += 2;
		}
	}
	qsort(*out, (size_t)ends, sizeof(**out), compare_ends);
	free(edge);
	return ends;
}

/* Where a level is open the full mesh is, too: at seams nothing gapes. */
static void test_levels_have_no_cracks(void **state)
{
	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(assets); a++) {
		struct model *model = load(assets[a]);

		for (int m = 0; m < model->mesh_count; m++) {
			const struct model_mesh *mesh = &model->mesh[m];
			float(*full)[3], (*few)[3];
			int full_count = open_ends(mesh, -1, &full);

			assert_true(mesh->primitive[0].lod_count > 0);
			for (int k = 0; k < mesh->primitive[0].lod_count; k++) {
				int count = open_ends(mesh, k, &few);

				for (int i = 0; i < count; i++) {
					assert_non_null(bsearch(few[i], full,
						(size_t)full_count,
						sizeof(*full), compare_ends));
				}
				free(few);
			}
			free(full);
		}
		model_destroy(model);
	}
}

static void test_coarser_levels_have_fewer_triangles(void **state)
{
	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(assets); a++) {
		struct model *model = load(assets[a]);

		for (int m = 0; m < model->mesh_count; m++) {
			const struct model_mesh *mesh = &model->mesh[m];
			struct model_level finer = {.triangle_count = INT_MAX};

			for (int k = 0; k < model_level_count(mesh); k++) {
				struct model_level level = model_level(mesh, k);

				assert_true(level.shadow_only ||
					(level.error_m > finer.error_m &&
						level.triangle_count <
							finer.triangle_count));
				finer = level;
			}
			assert_true(finer.shadow_only);
		}
		model_destroy(model);
	}
}

static float squared_distance(const float p[3], const float q[3])
{
	float x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];

	return x * x + y * y + z * z;
}

/* By projections onto the plane and, outside of it, onto the sides. */
static float to_triangle(const float p[3], const float corner[3][3])
{
	vec3 u, v, normal, w;
	float best = INFINITY, area, share[3];

	glm_vec3_sub((float *)corner[1], (float *)corner[0], u);
	glm_vec3_sub((float *)corner[2], (float *)corner[0], v);
	glm_vec3_sub((float *)p, (float *)corner[0], w);
	glm_vec3_cross(u, v, normal);
	area = glm_vec3_dot(normal, normal);
	if (area > 0.0f) {
		vec3 cross;

		glm_vec3_cross(w, v, cross);
		share[1] = glm_vec3_dot(cross, normal) / area;
		glm_vec3_cross(u, w, cross);
		share[2] = glm_vec3_dot(cross, normal) / area;
		if (share[1] >= 0.0f && share[2] >= 0.0f &&
			share[1] + share[2] <= 1.0f) {
			float height = glm_vec3_dot(w, normal);

			return height * height / area;
		}
	}
	for (int i = 0; i < 3; i++) {
		const float *a = corner[i], *b = corner[(i + 1) % 3];
		float along, near[3], length = squared_distance(a, b);

		glm_vec3_sub((float *)b, (float *)a, u);
		glm_vec3_sub((float *)p, (float *)a, w);
		along = length > 0.0f ? glm_vec3_dot(u, w) / length : 0.0f;
		along = along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along;
		glm_vec3_scale(u, along, near);
		glm_vec3_add(near, (float *)a, near);
		best = fminf(best, squared_distance(p, near));
	}
	return best;
}

/* Of a vertex of the node's mesh to the mesh as the level has it, in metres. */
static float to_level(
	const struct instance *instance, int node, int level, const float at[3])
{
	float best = INFINITY;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct model_lod *lod = &drawable->primitive->lod[level];

		for (int t = 0; drawable->node == node && t < lod->index_count;
			t += 3) {
			float corner[3][3];

			for (int k = 0; k < 3; k++) {
				drawable_position(drawable,
					(int)lod->index[t + k], corner[k]);
			}
			best = fminf(best, to_triangle(at, corner));
		}
	}
	return sqrtf(best);
}

/* How many of some vertices are off by more than twice the stated error. */
static float share_off(const struct instance *instance, int node, int level)
{
	int off = 0, all = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct model_primitive *primitive = drawable->primitive;

		for (int v = 0;
			drawable->node == node && v < primitive->vertex_count;
			v += 37, all++) {
			float at[3];

			drawable_position(drawable, v, at);
			off += to_level(instance, node, level, at) >
				2.0f * primitive->lod[level].error_m;
		}
	}
	return (float)off / (float)all;
}

/* Errors are measured at rest; limbs bend, and faces move. */
static void test_levels_keep_near_in_motion(void **state)
{
	static const char *const clips[] = {"run", "wave", "jump"};
	struct model *model = load(assets[0]);
	struct instance *instance = small_model_instance(model);
	struct clip_cursor none = {0};

	(void)state;
	for (size_t c = 0; c < ARRAY_COUNT(clips); c++) {
		const struct model_clip *clip =
			&model->clip[model_find_clip(model, clips[c])];

		clip_sample(
			clip, 0.4f * clip->duration_s, &none, &instance->pose);
		instance_update(instance);
		for (int level = 0; level < 3; level++) {
			float body = share_off(instance,
				model_find_node(model, "walker_body"), level);
			float head = share_off(instance,
				model_find_node(model, "walker_head"), level);
			assert_true(body <= 0.05f);
			assert_true(head <= 0.05f);
		}
	}
	instance_destroy(instance);
	model_destroy(model);
}

/* All that she does by herself, the camera going round her. */
static void test_nothing_pops_while_she_moves(void **state)
{
	static const struct demo_press press[] = {{0.05, BUTTON_F9}};
	struct demo_run run;
	long first;

	(void)state;
	demo_run_begin(&run, "walker");
	demo_run_to(&run, 0.2, 25, press, 1);
	demo_run_draw(&run);
	demo_run_to(&run, 0.4, 25, press, 1);
	first = demo_get_facts(run.driver, run.demo).triangles;
	assert_true(first < 5000);
	for (double at_s = 0.5; at_s < 18.0; at_s += 0.1) {
		demo_run_to(&run, at_s, 25, press, 1);
		assert_int_equal(
			demo_get_facts(run.driver, run.demo).triangles, first);
	}
	demo_run_end(&run);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_words_pixels_and_levels),
		cmocka_unit_test(test_refuses_other_words),
		cmocka_unit_test(test_takes_the_coarsest_that_is_a_pixel_off),
		cmocka_unit_test(test_does_what_it_is_told),
		cmocka_unit_test(test_small_changes_change_nothing),
		cmocka_unit_test(test_what_is_large_needs_more),
		cmocka_unit_test(test_a_budget_asks_for_less_but_never_for_more),
		cmocka_unit_test(test_half_as_far_has_twice_the_pixels),
		cmocka_unit_test(test_fixed_point_draws_the_same_vertices),
		cmocka_unit_test(test_coarser_levels_have_fewer_triangles),
		cmocka_unit_test(test_levels_have_no_cracks),
		cmocka_unit_test(test_levels_keep_near_in_motion),
		cmocka_unit_test(test_nothing_pops_while_she_moves),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

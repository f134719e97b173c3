/* The levels of detail of the models in assets/. */
#include "app/anim/clip.h"
#include "app/model/levels/levels.h"
#include "app/model/model_stats.h"
#include "app/scene/instance/lod.h"
#include "platform/base/compiler.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const assets[] = {
	"assets/walker.glb", "assets/face.glb", "assets/arm.glb"};

static struct model *load(const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load(path, &nowhere, &model), 0);
	/* Files have no levels of meshes with morph targets. */
	assert_int_equal(levels_make(model), 0);
	return model;
}

enum {
	INDICES_MAX = 65536
};

static int compare_triangles(const void *left, const void *right)
{
	const uint64_t *a = left, *b = right;

	return *a < *b ? -1 : *a > *b;
}

/* Triangles in ascending order, each from its least corner on. */
static void sort_triangles(const uint32_t *index, int count, uint64_t *out)
{
	assert_true(count <= INDICES_MAX);
	for (int i = 0; i < count; i += 3) {
		const uint32_t *t = index + i;
		int k = t[0] < t[1] && t[0] < t[2] ? 0 : t[1] < t[2] ? 1 : 2;

		out[i / 3] = (uint64_t)t[k] << 40 |
			(uint64_t)t[(k + 1) % 3] << 20 | t[(k + 2) % 3];
	}
	qsort(out, (size_t)count / 3, sizeof(out[0]), compare_triangles);
}

/* Lists may be in another order, which is better for the vertex cache. */
static void test_fixed_point_draws_the_same_triangles(void **state)
{
	struct log nowhere = log_to_nowhere();
	struct model *model = load(assets[0]);
	struct instance *instance;
	static uint32_t index[INDICES_MAX];
	static uint64_t drawn[INDICES_MAX / 3], expected[INDICES_MAX / 3];
	int lists = 0;

	(void)state;
	assert_int_equal(instance_create(model, kernel_find("fixed"), &nowhere,
				 &instance),
		0);
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct batch *batch = drawable->batch;
		const struct model_lod *from = drawable->primitive->lod;

		for (int k = 0; k < batch->lod_count; k++, lists++, from++) {
			const uint32_t *order = drawable->fixed->order;
			const struct batch_lod *lod = &batch->lod[k];

			while (from->shadow_only) {
				from++;
			}
			assert_int_equal(lod->index_count, from->index_count);
			sort_triangles(from->index, lod->index_count, expected);
			for (int v = 0; v < lod->index_count; v++) {
				uint32_t at = lod->index[v];

				index[v] = order ? order[at] : at;
			}
			sort_triangles(index, lod->index_count, drawn);
			assert_memory_equal(drawn, expected,
				(size_t)(lod->index_count / 3) *
					sizeof(drawn[0]));
		}
	}
	assert_true(lists >= 12);
	instance_destroy(instance);
	model_destroy(model);
}

struct edge {
	float end[2][3]; /* in ascending order */
	int turns;       /* 1 if the triangle has that order, else -1 */
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

/* The sorted ends of a level's border edges; level -1 is the full mesh. */
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

/* How many levels all primitives of a mesh have. */
static int common_levels(const struct model_mesh *mesh)
{
	int count = INT_MAX;

	for (int p = 0; p < mesh->primitive_count; p++) {
		int own = mesh->primitive[p].lod_count;

		count = own < count ? own : count;
	}
	return count;
}

/* A level's border edges end at border vertices of the full mesh. */
static void test_levels_have_no_cracks(void **state)
{
	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(assets); a++) {
		struct model *model = load(assets[a]);

		for (int m = 0; m < model->mesh_count; m++) {
			const struct model_mesh *mesh = &model->mesh[m];
			float(*full)[3], (*few)[3];
			int full_count = open_ends(mesh, -1, &full);

			assert_true(common_levels(mesh) > 0);
			for (int k = 0; k < common_levels(mesh); k++) {
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

/* The squared distance of a point to a triangle: to its plane or its edges. */
static float to_triangle(const float p[3], const float corner[3][3])
{
	vec3 u, v, normal, w;
	float best = INFINITY, area, fraction[3];

	glm_vec3_sub((float *)corner[1], (float *)corner[0], u);
	glm_vec3_sub((float *)corner[2], (float *)corner[0], v);
	glm_vec3_sub((float *)p, (float *)corner[0], w);
	glm_vec3_cross(u, v, normal);
	area = glm_vec3_dot(normal, normal);
	if (area > 0.0f) {
		vec3 cross;

		glm_vec3_cross(w, v, cross);
		fraction[1] = glm_vec3_dot(cross, normal) / area;
		glm_vec3_cross(u, w, cross);
		fraction[2] = glm_vec3_dot(cross, normal) / area;
		if (fraction[1] >= 0.0f && fraction[2] >= 0.0f &&
			fraction[1] + fraction[2] <= 1.0f) {
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

/* The distance of a point to the level of the node's mesh, in metres. */
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

/* The fraction of sampled vertices that exceed twice the stated error. */
static float fraction_off(const struct instance *instance, int node, int level)
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

/* The stated errors are measured at rest; here limbs and faces move. */
static void test_levels_keep_their_error_in_motion(void **state)
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
			float body = fraction_off(instance,
				model_find_node(model, "walker_body"), level);
			float head = fraction_off(instance,
				model_find_node(model, "walker_head"), level);
			assert_true(body <= 0.05f);
			assert_true(head <= 0.05f);
		}
	}
	instance_destroy(instance);
	model_destroy(model);
}

/* Plays the walker's whole autoplay. */
static void test_no_level_changes_while_the_walker_moves(void **state)
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

/* The least depth of any vertex, in scene units. */
static double nearest_vertex(
	const struct instance *instance, const struct camera *camera)
{
	double nearest = 1e9;
	float eye[3];

	camera_eye(camera, eye);
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			double depth = 0;
			float at[3];

			instance_world_vertex(instance, drawable, v, at);
			for (int i = 0; i < 3; i++) {
				depth += ((double)at[i] * instance->unit_scale -
						 (double)eye[i]) *
					(double)(camera->target[i] - eye[i]) /
					(double)camera->distance;
			}
			nearest = depth < nearest ? depth : nearest;
		}
	}
	return nearest;
}

/* From eight sides: never coarser than the nearest vertex asks for. */
static void assert_pixels_of_the_nearest_vertex(const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct model *model = load(path);
	struct camera camera = camera_default();
	struct instance *instance;
	struct bounds box;

	assert_int_equal(
		instance_create(model, kernel_find(NULL), &nowhere, &instance),
		0);
	box = bounds_of_instance(instance);
	bounds_center(&box, camera.target);
	camera.distance = 2.5f * bounds_extent(&box);
	for (int i = 0; i < 8; i++) {
		double want, got;

		camera.yaw_rad = (float)i * 0.785f;
		want = 320.0 /
			(tan(0.5 * (double)camera.yfov_rad) *
				nearest_vertex(instance, &camera));
		got = (double)lod_px_per_unit(
			instance, &camera, bounds_extent(&box), 640);
		assert_true(got > 0.999 * want && got < 1.12 * want);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_parts_without_joints_have_the_pixels_of_their_boxes(
	void **state)
{
	(void)state;
	assert_pixels_of_the_nearest_vertex("assets/arm.glb");
	assert_pixels_of_the_nearest_vertex("assets/face.glb");
}

/* A helper joint may be scaled to nothing, while the others move the skin. */
static void test_no_joint_alone_decides_how_coarse_a_skin_is(void **state)
{
	const struct lod by_itself = {.kind = LOD_AUTO};
	struct model *model = load(assets[0]);
	struct instance *instance = small_model_instance(model);
	const int *joint = model->skin[0].joint;
	long all;

	(void)state;
	instance_update(instance);
	lod_choose(instance, &by_itself, 200.0f);
	all = lod_triangles(instance);
	for (int i = 0; i < model->skin[0].joint_count; i++) {
		struct transform *local = &instance->pose.local[joint[i]];

		if (model->node[joint[i]].parent == joint[0] || i == 0) {
			glm_vec3_scale(local->scale, i == 0 ? 1e-3f : 1e3f,
				local->scale);
		}
	}
	instance_update(instance);
	lod_choose(instance, &by_itself, 400.0f);
	assert_int_equal(lod_triangles(instance), all);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_parts_without_joints_have_the_pixels_of_their_boxes),
		cmocka_unit_test(test_fixed_point_draws_the_same_triangles),
		cmocka_unit_test(test_coarser_levels_have_fewer_triangles),
		cmocka_unit_test(test_levels_have_no_cracks),
		cmocka_unit_test(test_levels_keep_their_error_in_motion),
		cmocka_unit_test(test_no_level_changes_while_the_walker_moves),
		cmocka_unit_test(
			test_no_joint_alone_decides_how_coarse_a_skin_is),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

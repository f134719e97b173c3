/* How the levels of detail of the models in assets/ follow motion and size. */
#include "app/anim/clip.h"
#include "app/scene/instance/lod.h"
#include "platform/base/compiler.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/instance/asset_levels.h"

#include <cglm/cglm.h>

#include <math.h>

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
		cmocka_unit_test(test_levels_keep_their_error_in_motion),
		cmocka_unit_test(test_no_level_changes_while_the_walker_moves),
		cmocka_unit_test(
			test_no_joint_alone_decides_how_coarse_a_skin_is),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

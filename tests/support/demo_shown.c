#include "tests/support/demo_shown.h"

#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>

#include <cglm/cglm.h>

const int shown_sizes[SHOWN_SIZES][2] = {{480, 640}, {320, 240}, {240, 320},
	{800, 480}, {1920, 1080}, {640, 480}};

static void begin(
	struct shown *shown, const char *name, const struct demo_env *wanted)
{
	struct demo_env env = *wanted;
	char path[64];

	shown->log = log_to_stderr(LOG_ERROR);
	shown->gl = gl_recorder_begin();
	shown->driver = demo_find(name);
	snprintf(path, sizeof(path), "assets/%s",
		shown->driver ? shown->driver->asset : name);
	shown->driver = shown->driver ? shown->driver : &demo_driver_viewer;
	env.log = &shown->log;
	env.gl = &shown->gl;
	env.target = PIXELS_RGBA8888;
	env.kernel = kernel_find("fixed");
	env.model_path = path;
	env.repeat = CLIP_LOOP;
	env.speed = 1.0f;
	assert_int_equal(demo_create(shown->driver, &env, &shown->demo), 0);
	shown->driver->update(shown->demo, 0.02);
}

void shown_begin_env(struct shown *shown, const char *name,
	const char *character, const int size[2], bool no_labels)
{
	begin(shown, name,
		&(struct demo_env){.width = size[0],
			.height = size[1],
			.no_labels = no_labels,
			.character = character});
}

void shown_begin(struct shown *shown, const char *name, const int size[2],
	bool no_labels)
{
	shown_begin_env(shown, name, NULL, size, no_labels);
}

void shown_begin_timed(struct shown *shown, const char *name, const int size[2],
	bool no_labels)
{
	begin(shown, name,
		&(struct demo_env){.width = size[0],
			.height = size[1],
			.no_labels = no_labels,
			.frame_times = true});
}

void shown_end(struct shown *shown)
{
	demo_destroy(shown->driver, shown->demo);
}

struct camera_region shown_project(const struct camera *camera,
	const int size[2], const float center[3], const float half_extent[3])
{
	const struct camera_frustum frustum =
		camera_frustum(camera, size[0], size[1]);
	struct camera_region region = {9.0f, -9.0f, 9.0f, -9.0f};
	mat4 view;

	camera_view(camera, view);
	for (int i = 0; i < 8; i++) {
		vec4 at = {0.0f, 0.0f, 0.0f, 1.0f}, eye;
		float x, y;

		for (int axis = 0; axis < 3; axis++) {
			float half = half_extent[axis];

			at[axis] = center[axis] + (i >> axis & 1 ? half : -half);
		}
		glm_mat4_mulv(view, at, eye);
		x = eye[0] / -eye[2] * (float)frustum.near;
		y = eye[1] / -eye[2] * (float)frustum.near;
		x = (2.0f * x - (float)(frustum.right + frustum.left)) /
			(float)(frustum.right - frustum.left);
		y = (2.0f * y - (float)(frustum.top + frustum.bottom)) /
			(float)(frustum.top - frustum.bottom);
		region.left = fminf(region.left, x);
		region.right = fmaxf(region.right, x);
		region.bottom = fminf(region.bottom, y);
		region.top = fmaxf(region.top, y);
	}
	return region;
}

struct camera_region shown_framed(const struct shown *shown, const int size[2])
{
	const struct camera *camera =
		&((const struct demo_base *)shown->demo)->stage.camera;

	return shown_project(camera, size, camera->target, camera->fit.half);
}

struct camera_region shown_now(const struct shown *shown, const int size[2])
{
	const struct demo_base *base = (const struct demo_base *)shown->demo;
	struct bounds bounds = bounds_of_instance(base->actor.instance);
	float center[3], half[3];

	bounds_center(&bounds, center);
	for (int axis = 0; axis < 3; axis++) {
		half[axis] = bounds.high[axis] - center[axis];
	}
	return shown_project(&base->stage.camera, size, center, half);
}

bool shown_hides(
	const struct hud *hud, int first, const struct camera_region *figure)
{
	float half[2] = {0.5f * (float)hud->width, 0.5f * (float)hud->height};
	float left = (figure->left + 1.0f) * half[0] + 2.0f;
	float right = (figure->right + 1.0f) * half[0] - 2.0f;
	float top = (1.0f - figure->top) * half[1] + 2.0f;
	float bottom = (1.0f - figure->bottom) * half[1] - 2.0f;

	for (int i = first; i < hud->quad_count; i++) {
		const struct hud_vertex *a = &hud->vertex[4 * i];
		const struct hud_vertex *b = a + 3; /* the opposite corner */
		float x[2] = {fminf(a->x, b->x), fmaxf(a->x, b->x)};
		float y[2] = {fminf(a->y, b->y), fmaxf(a->y, b->y)};

		/* A group that got shorter leaves empty rectangles. */
		if (x[0] < x[1] && y[0] < y[1] && x[0] < right && x[1] > left &&
			y[0] < bottom && y[1] > top) {
			return true;
		}
	}
	return false;
}

void shown_check_whole(const struct camera_region *region)
{
	assert_true(region->left > -1.001f && region->right < 1.001f);
	assert_true(region->bottom > -1.001f && region->top < 1.001f);
}

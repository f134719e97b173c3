/* The moments of onion skins, and the camera of a row of shapes. */
#include "app/anim/clip.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/overlay/overlay_bench.h"

#include <math.h>
#include <string.h>

enum {
	NODES_MAX = 64,
	SKINS_MAX = 8
};

/* The poses in which the ghost was drawn, each in a colour of its own. */
static struct {
	const struct instance *ghost;
	GLfixed color[4], last[4];
	int count;
	struct transform local[SKINS_MAX][NODES_MAX];
	bool early[SKINS_MAX]; /* in the colour of keys before */
} seen;

static void keep_color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed color[4] = {red, green, blue, alpha};

	memcpy(seen.color, color, sizeof(color));
}

static void note_draw(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	const struct pose *pose = &seen.ghost->pose;

	(void)mode;
	(void)count;
	(void)type;
	(void)indices;
	if (memcmp(seen.color, seen.last, sizeof(seen.last)) != 0) {
		assert_in_range(seen.count, 0, SKINS_MAX - 1);
		memcpy(seen.local[seen.count], pose->local,
			(size_t)seen.ghost->model->node_count *
				sizeof(*pose->local));
		seen.early[seen.count++] = seen.color[2] > seen.color[0];
		memcpy(seen.last, seen.color, sizeof(seen.last));
	}
}

static void record(struct overlay_bench *bench)
{
	bench->gl = gl_recorder_begin();
	memset(&seen, 0, sizeof(seen));
	seen.ghost = bench->overlay->ghost.instance;
	assert_in_range(seen.ghost->model->node_count, 1, NODES_MAX);
	bench->gl.Color4x = keep_color;
	bench->gl.DrawElements = note_draw;
	bench->overlay->gl = &bench->gl;
}

/* The key nearest to a time that is beyond it by the gap, which has a sign. */
static double nearest_key(
	const struct model_clip *clip, double time_s, double gap_s)
{
	double nearest = -1;

	for (int c = 0; c < clip->channel_count; c++) {
		for (int k = 0; k < clip->channel[c].key_count; k++) {
			double key = (double)clip->channel[c].time_s[k];
			bool beyond = gap_s > 0 ? key >= time_s + gap_s
						: key < time_s + gap_s;

			if (beyond &&
				(nearest < 0 ||
					fabs(key - time_s) <
						fabs(nearest - time_s))) {
				nearest = key;
			}
		}
	}
	return nearest;
}

/* The clip repeats: beyond its end are the keys of its beginning. */
static double key_beyond(
	const struct model_clip *clip, double time_s, double gap_s)
{
	double key = nearest_key(clip, time_s, gap_s);
	double duration_s = (double)clip->duration_s;

	return key >= 0
		? key
		: nearest_key(clip,
			  gap_s > 0 ? time_s - duration_s : time_s + duration_s,
			  gap_s);
}

static void expect_pose(
	const struct model *model, const struct transform *local, double time_s)
{
	struct clip_cursor none = {0};
	struct arena arena = arena_empty();
	struct pose pose;

	assert_int_equal(pose_init(&pose, model, &arena), 0);
	pose_rest(&pose, model);
	clip_sample(&model->clip[0], (float)time_s, &none, &pose);
	for (int n = 0; n < model->node_count; n++) {
		assert_all_near(local[n].translation, pose.local[n].translation,
			3, 1e-4);
		assert_all_near(
			local[n].rotation, pose.local[n].rotation, 4, 1e-4);
	}
	arena_release(&arena);
}

static void test_onion_skins_are_two_keys_before_and_two_after(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct overlay_bench bench;
	const struct model *model;
	double duration_s;

	(void)state;
	overlay_bench_begin(&bench, "walker", 1u << OVERLAY_KEYS);
	model = bench.figure.instance->model;
	duration_s = (double)model->clip[0].duration_s;
	motion.clip = 0;
	for (int i = 0; i < 7; i++) {
		motion.time_s = (float)(duration_s * (0.03 + i / 7.0));
		record(&bench);
		overlay_draw_keys(
			bench.overlay, &motion, &bench.figure, 480, 640);
		assert_int_equal(seen.count, 4);
		for (int side = 0; side < 2; side++) {
			double gap_s = (side ? 0.08 : -0.08) * duration_s;
			double at_s = (double)motion.time_s;

			for (int k = 2 * side; k < 2 * side + 2; k++) {
				at_s = key_beyond(&model->clip[0], at_s, gap_s);
				assert_int_equal(seen.early[k], !side);
				expect_pose(model, seen.local[k], at_s);
			}
		}
	}
	overlay_bench_end(&bench);
}

/* The box alone, without the scene's zoom, as a picture of the row has it. */
static void test_a_row_shows_the_box_whole_however_the_scene_is_zoomed(
	void **state)
{
	static const struct overlay_row row = {
		.count = 5, .width = 96, .height = 100};
	const struct bounds box = {{-1, 0, -0.5f}, {1, 1.5f, 0.5f}};
	struct camera_framing framing = {.aspect = 0.75f,
		.yaw_rad = 0.4f,
		.pitch_rad = 0.2f,
		.margin = 1.3f,
		.region = {0.1f, 0.9f, -0.7f, 0.6f},
		.follow = true};
	struct camera scene = camera_default(), wanted = camera_default(), own;

	(void)state;
	camera_frame(&scene, &box, &framing);
	framing.aspect = 0.96f;
	framing.margin = 1.15f;
	framing.region = (struct camera_region){-1, 1, -1, 1};
	camera_frame(&wanted, &box, &framing);
	for (int i = 0; i < 3; i++) {
		camera_zoom(&scene, i == 0 ? 1 : i == 1 ? 3 : 0.1f);
		own = overlay_row_camera(&row, &scene);
		assert_near(own.distance, wanted.distance,
			1e-3 * (double)wanted.distance);
		assert_near(own.shift_x, wanted.shift_x, 1e-3);
		assert_near(own.shift_y, wanted.shift_y, 1e-3);
		assert_all_near(own.target, wanted.target, 3, 1e-5);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_onion_skins_are_two_keys_before_and_two_after),
		cmocka_unit_test(
			test_a_row_shows_the_box_whole_however_the_scene_is_zoomed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

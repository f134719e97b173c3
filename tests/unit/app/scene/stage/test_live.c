/* A demo's use of a camera, with a camera that the test simulates. */
#include "app/scene/stage/live.h"

#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

#include <cglm/cglm.h>

struct camera_source {
	enum camera_status news;
	uint8_t luma;
	uint8_t data[64 * 48 * 2];
	int taken, given_back;
};

static int never_create(
	const struct camera_options *options, struct camera_source **out)
{
	(void)options;
	(void)out;
	return -1;
}

static enum camera_status take(
	struct camera_source *source, int64_t now_ms, struct camera_image *out)
{
	struct camera_layout layout = camera_layout_of(CAMERA_UYVY, 64, 48, 0);

	(void)now_ms;
	if (source->news == CAMERA_NEW) {
		memset(source->data, source->luma, sizeof(source->data));
		*out = camera_image_at(
			CAMERA_UYVY, 64, 48, &layout, source->data);
		source->taken++;
	}
	return source->news;
}

static void give_back(struct camera_source *source)
{
	source->given_back++;
}

static void destroy(struct camera_source *source)
{
	(void)source;
}

static const struct camera_driver driver = {
	.name = "played",
	.create = never_create,
	.take = take,
	.give_back = give_back,
	.destroy = destroy,
};

struct rig {
	struct camera_source source;
	struct camera_feed feed;
	struct gl gl;
	struct stage stage;
	struct live live;
	double now_s;
};

static void rig_begin(struct rig *rig, enum live_use use)
{
	struct log log = log_to_stderr(LOG_WARNING);

	memset(rig, 0, sizeof(*rig));
	rig->feed = (struct camera_feed){&driver, &rig->source};
	rig->gl = gl_recorder_begin();
	rig->stage.camera = camera_default();
	assert_int_equal(
		live_init(&rig->live, &rig->feed, use, false, &rig->gl, &log),
		0);
	live_set_stage(&rig->live, &rig->stage, 0.75f);
}

static void rig_frame(struct rig *rig, enum camera_status news, int luma)
{
	rig->source.news = news;
	rig->source.luma = (uint8_t)luma;
	rig->now_s += 0.04;
	live_update(&rig->live, &rig->gl, &rig->stage, rig->now_s, 480, 640);
	assert_int_equal(rig->source.taken, rig->source.given_back);
}

static void test_the_background_comes_and_goes_with_the_picture(void **state)
{
	static struct rig rig;

	(void)state;
	rig_begin(&rig, LIVE_BACKGROUND);
	rig_frame(&rig, CAMERA_NONE, 0);
	assert_null(rig.stage.backdrop);
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_ptr_equal(rig.stage.backdrop, &rig.live.texture);
	assert_null(rig.stage.monitor);
	/* The middle of the image at its full height, 3 : 4. */
	assert_int_equal(rig.live.texture.width, 36);
	assert_int_equal(rig.live.texture.height, 48);
	rig_frame(&rig, CAMERA_SAME, 0);
	assert_ptr_equal(rig.stage.backdrop, &rig.live.texture);
	rig_frame(&rig, CAMERA_NONE, 0);
	assert_null(rig.stage.backdrop);
	live_finish(&rig.live, &rig.gl);
}

static void test_the_screen_stays_and_goes_dark(void **state)
{
	static struct rig rig;

	(void)state;
	rig_begin(&rig, LIVE_SCREEN);
	rig_frame(&rig, CAMERA_NONE, 0);
	assert_ptr_equal(rig.stage.monitor, &rig.live.monitor);
	assert_null(rig.stage.monitor_picture);
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_ptr_equal(rig.stage.monitor_picture, &rig.live.texture);
	assert_int_equal(rig.live.texture.width, 64);
	rig_frame(&rig, CAMERA_NONE, 0);
	assert_ptr_equal(rig.stage.monitor, &rig.live.monitor);
	assert_null(rig.stage.monitor_picture);
	live_finish(&rig.live, &rig.gl);
}

static void test_the_screen_stays_beside_what_the_camera_frames(void **state)
{
	static struct rig rig;
	float origin[3];

	(void)state;
	rig_begin(&rig, LIVE_SCREEN);
	rig_frame(&rig, CAMERA_NEW, 100);
	memcpy(origin, rig.live.monitor.origin, sizeof(origin));
	camera_orbit(&rig.stage.camera, 1.0f, 0.2f);
	camera_zoom(&rig.stage.camera, 1.5f);
	rig_frame(&rig, CAMERA_SAME, 0);
	assert_all_near(rig.live.monitor.origin, origin, 3, 1e-4);
	rig.stage.camera.target[0] += 0.5f;
	rig_frame(&rig, CAMERA_SAME, 0);
	assert_near(rig.live.monitor.origin[0], origin[0] + 0.5f, 1e-4);
	live_finish(&rig.live, &rig.gl);
}

static void test_motion_rises_quickly_and_falls_slowly(void **state)
{
	static struct rig rig;
	float high;

	(void)state;
	rig_begin(&rig, LIVE_MOTION);
	for (int i = 0; i < 10; i++) {
		rig_frame(&rig, CAMERA_NEW, 100);
	}
	assert_near(rig.live.smooth_level, 0.0, 0.0);
	for (int i = 0; i < 10; i++) {
		rig_frame(&rig, CAMERA_NEW, i % 2 ? 100 : 140);
	}
	high = rig.live.smooth_level;
	assert_true(high > 0.95f && high <= 1.0f);
	for (int i = 0; i < 10; i++) {
		rig_frame(&rig, CAMERA_NEW, 100);
	}
	assert_true(rig.live.smooth_level > 0.3f * high);
	assert_true(rig.live.smooth_level < 0.6f * high);
	for (int i = 0; i < 100; i++) {
		rig_frame(&rig, CAMERA_NONE, 0);
	}
	assert_true(rig.live.smooth_level < 0.01f);
	assert_null(rig.stage.backdrop);
	assert_null(rig.stage.monitor);
	live_finish(&rig.live, &rig.gl);
}

/* An image that was cut for one use is not shown for the next one. */
static void test_another_use_waits_for_its_own_picture(void **state)
{
	static struct rig rig;

	(void)state;
	rig_begin(&rig, LIVE_BACKGROUND);
	rig_frame(&rig, CAMERA_NEW, 100);
	live_next_use(&rig.live);
	rig_frame(&rig, CAMERA_SAME, 0);
	assert_int_equal(rig.live.use, LIVE_SCREEN);
	assert_null(rig.stage.backdrop);
	assert_null(rig.stage.monitor_picture);
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_non_null(rig.stage.monitor_picture);
	live_next_use(&rig.live);
	assert_true(live_controls_motion(&rig.live));
	live_next_use(&rig.live);
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_int_equal(rig.live.use, LIVE_OFF);
	assert_null(rig.stage.backdrop);
	assert_null(rig.stage.monitor);
	live_next_use(&rig.live);
	assert_int_equal(rig.live.use, LIVE_BACKGROUND);
	live_finish(&rig.live, &rig.gl);
}

static int deleted;

static void count_deleted(GLsizei count, const GLuint *names)
{
	(void)names;
	deleted += count;
}

static void test_the_texture_is_released_once(void **state)
{
	static struct rig rig;

	(void)state;
	rig_begin(&rig, LIVE_BACKGROUND);
	rig.gl.DeleteTextures = count_deleted;
	deleted = 0;
	live_finish(&rig.live, &rig.gl);
	assert_int_equal(deleted, 1);
	live_finish(&rig.live, &rig.gl);
	assert_int_equal(deleted, 1);
}

static GLint alignment;
static int uploads;

static void keep_alignment(GLenum name, GLint value)
{
	alignment = name == GL_UNPACK_ALIGNMENT ? value : alignment;
}

static void check_upload(GLenum target, GLint level, GLint x, GLint y,
	GLsizei width, GLsizei height, GLenum format, GLenum type,
	const void *texels)
{
	(void)texels;
	assert_int_equal(target, GL_TEXTURE_2D);
	assert_int_equal(level + x + y, 0);
	assert_true(width > 0 && height > 0);
	assert_int_equal(format, GL_RGB);
	assert_int_equal(type, GL_UNSIGNED_SHORT_5_6_5);
	assert_in_range(alignment, 1, 2);
	uploads++;
}

/* Its rows may be of an odd number of pixels, whatever was uploaded before. */
static void test_an_image_is_uploaded_without_gaps(void **state)
{
	static struct rig rig;

	(void)state;
	rig_begin(&rig, LIVE_BACKGROUND);
	rig.gl.PixelStorei = keep_alignment;
	rig.gl.TexSubImage2D = check_upload;
	uploads = 0;
	alignment = 4;
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_int_equal(uploads, 1);
	live_finish(&rig.live, &rig.gl);
}

/* The motion has a row of its own while there is a picture to move. */
static void test_labels_have_a_row_for_the_motion(void **state)
{
	static struct rig rig;
	struct live none = {.feed = NULL};

	(void)state;
	assert_int_equal(live_label_rows(&none), 0);
	rig_begin(&rig, LIVE_MOTION);
	rig_frame(&rig, CAMERA_NONE, 0);
	assert_int_equal(live_label_rows(&rig.live), 1);
	rig_frame(&rig, CAMERA_NEW, 100);
	assert_int_equal(live_label_rows(&rig.live), 2);
	live_next_use(&rig.live);
	assert_int_equal(live_label_rows(&rig.live), 1);
	live_finish(&rig.live, &rig.gl);
}

/* Else the change of all that happened meanwhile would count as motion. */
static void test_motion_begins_anew_after_a_pause(void **state)
{
	static struct rig rig;

	(void)state;
	for (int other_use = 0; other_use < 2; other_use++) {
		rig_begin(&rig, LIVE_MOTION);
		rig_frame(&rig, CAMERA_NEW, 100);
		rig_frame(&rig, CAMERA_NEW, 100);
		if (other_use) {
			for (int i = 0; i < LIVE_USES; i++) {
				live_next_use(&rig.live);
			}
		} else {
			rig_frame(&rig, CAMERA_NONE, 0);
		}
		rig_frame(&rig, CAMERA_NEW, 200);
		assert_near(rig.live.smooth_level, 0.0, 1e-6);
		rig_frame(&rig, CAMERA_NEW, 100);
		assert_true(rig.live.smooth_level > 0.2f);
		live_finish(&rig.live, &rig.gl);
	}
}

static void test_without_a_camera_nothing_changes(void **state)
{
	static struct live live;
	struct stage stage = {0};
	struct gl gl = gl_recorder_begin();
	struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	assert_int_equal(
		live_init(&live, NULL, LIVE_SCREEN, true, &gl, &log), 0);
	live_update(&live, &gl, &stage, 1.0, 480, 640);
	assert_null(stage.monitor);
	assert_false(live_controls_motion(&live));
	live_finish(&live, &gl);
}

static void test_the_names_of_uses(void **state)
{
	(void)state;
	assert_int_equal(live_use_find("background"), LIVE_BACKGROUND);
	assert_int_equal(live_use_find("screen"), LIVE_SCREEN);
	assert_int_equal(live_use_find("motion"), LIVE_MOTION);
	assert_int_equal(live_use_find("off"), LIVE_OFF);
	assert_int_equal(live_use_find("nothing"), LIVE_USES);
}

/* The whole monitor is visible, left of the figure, before the far plane. */
static void test_the_screen_stands_where_it_is_seen(void **state)
{
	static const float aspects[] = {0.75f, 1.333f, 2.6f};

	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(aspects); a++) {
		struct camera camera = camera_default();
		static struct monitor monitor;
		float tan_y, sine, cosine;
		mat4 view;

		camera.target[1] = 0.8f;
		monitor_init(&monitor);
		monitor_place(&monitor, &camera, aspects[a], 0.0f);
		camera_view(&camera, view);
		tan_y = camera_tan_half(camera.yfov_rad);
		sine = sinf(monitor.yaw_rad);
		cosine = cosf(monitor.yaw_rad);
		for (int i = 0; i < MONITOR_VERTICES; i++) {
			const float *p = monitor.position[i];
			float s = monitor.scale;
			vec4 eye,
				world = {monitor.origin[0] +
						s * (cosine * p[0] + sine * p[2]),
					monitor.origin[1] + s * p[1],
					monitor.origin[2] +
						s * (cosine * p[2] - sine * p[0]),
					1.0f};

			glm_mat4_mulv(view, world, eye);
			assert_true(eye[2] < 0.0f);
			assert_true(eye[0] > eye[2] * -tan_y * -aspects[a]);
			assert_true(
				eye[0] < 0.2f * -eye[2] * tan_y * aspects[a]);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_background_comes_and_goes_with_the_picture),
		cmocka_unit_test(test_the_screen_stays_and_goes_dark),
		cmocka_unit_test(
			test_the_screen_stays_beside_what_the_camera_frames),
		cmocka_unit_test(test_motion_rises_quickly_and_falls_slowly),
		cmocka_unit_test(test_another_use_waits_for_its_own_picture),
		cmocka_unit_test(test_the_texture_is_released_once),
		cmocka_unit_test(test_an_image_is_uploaded_without_gaps),
		cmocka_unit_test(test_labels_have_a_row_for_the_motion),
		cmocka_unit_test(test_motion_begins_anew_after_a_pause),
		cmocka_unit_test(test_without_a_camera_nothing_changes),
		cmocka_unit_test(test_the_names_of_uses),
		cmocka_unit_test(test_the_screen_stands_where_it_is_seen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

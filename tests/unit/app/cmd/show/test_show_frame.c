/* What a frame shows over the demo, and what becomes of a GL without memory. */
#include "app/cmd/show/show_state.h"
#include "tests/support/demo_shown.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 480,
	HEIGHT = 640
};

/* The GL and the display carry no context of the test. */
static struct {
	const struct hud *hud;
	struct hud_vertex vertex[HUD_QUADS_MAX * 4];
	int quad_count; /* of the hud, in the last frame */
	int width;      /* of the display's picture, at most WIDTH */
	int frames;     /* that the display got */
	GLenum error;   /* of the GL, until it is asked for */
	int end_error;  /* of the GL's end of a frame */
	void (*draw)(
		GLenum mode, GLsizei count, GLenum type, const void *indices);
} noted;

static void note_elements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	if (indices == noted.hud->index) {
		noted.quad_count = count / 6;
		memcpy(noted.vertex, noted.hud->vertex,
			(size_t)count / 6 * 4 * sizeof(noted.vertex[0]));
	}
	noted.draw(mode, count, type, indices);
}

static GLenum get_error(void)
{
	GLenum error = noted.error;

	noted.error = GL_NO_ERROR;
	return error;
}

static int begin_pixels(struct display *display, struct pixels *out)
{
	static uint8_t data[HEIGHT][WIDTH][4];

	(void)display;
	*out = (struct pixels){&data[0][0][0], noted.width, HEIGHT, WIDTH * 4,
		PIXELS_RGBA8888};
	return 0;
}

static int end_pixels(struct display *display)
{
	(void)display;
	noted.frames++;
	return 0;
}

static int finish(struct display *display)
{
	(void)display;
	return 0;
}

static int begin_gl(struct gl_context *context, const struct pixels *target)
{
	(void)context;
	assert_int_equal(target->width, noted.width);
	return 0;
}

static int end_gl(struct gl_context *context)
{
	(void)context;
	return noted.end_error;
}

static const struct gl_driver gl_driver = {
	.name = "made-up", .begin_frame = begin_gl, .end_frame = end_gl};
static const struct display_driver screen = {
	.begin_frame = begin_pixels, .end_frame = end_pixels};
static const struct display_driver file = {
	.begin_frame = begin_pixels, .end_frame = end_pixels, .finish = finish};

struct scene {
	struct shown shown;
	struct show_plan plan;
	struct options options;
	struct failsafe failsafe;
	struct gl_context gl;
	struct hud hud;
	struct log_capture said;
	struct log log;
	struct show show;
};

/* All tests share the demo, as loading it takes longest. */
static int load(void **state)
{
	static const int size[2] = {WIDTH, HEIGHT};
	static struct scene scene;

	shown_begin(&scene.shown, "arm", size, false);
	*state = &scene;
	return 0;
}

static int unload(void **state)
{
	shown_end(&((struct scene *)*state)->shown);
	return 0;
}

static int begin(void **state)
{
	struct scene *scene = *state;

	gl_recorder_clear();
	memset(&noted, 0, sizeof(noted));
	noted.width = WIDTH;
	scene->failsafe = (struct failsafe){.path = NULL};
	scene->log = log_capture_begin(&scene->said);
	scene->options = options_default();
	scene->options.show.no_labels = true;
	scene->plan = (struct show_plan){.demo = scene->shown.driver};
	scene->gl = (struct gl_context){
		.driver = &gl_driver, .gl = scene->shown.gl};
	noted.draw = scene->gl.gl.DrawElements;
	scene->gl.gl.DrawElements = note_elements;
	scene->gl.gl.GetError = get_error;
	assert_int_equal(hud_init(&scene->hud, &scene->gl.gl, &scene->log), 0);
	noted.hud = &scene->hud;
	scene->show = (struct show){
		.plan = &scene->plan,
		.options = &scene->options,
		.log = &scene->log,
		.demo = scene->shown.demo,
		.hud = &scene->hud,
		.screen = {.driver = &screen, .gl = &scene->gl},
		.governor = governor_begin(0.0f),
	};
	return 0;
}

static int end(void **state)
{
	struct scene *scene = *state;

	hud_finish(&scene->hud, &scene->gl.gl);
	return 0;
}

static void test_nothing_lies_over_a_demo_without_labels(void **state)
{
	struct scene *scene = *state;

	scene->plan.failsafe = &scene->failsafe;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_int_equal(noted.quad_count, 0);
	assert_int_equal(noted.frames, 1);
}

static void test_labels_and_the_graph_lie_over_the_demo(void **state)
{
	struct scene *scene = *state;
	int labels;

	scene->options.show.no_labels = false;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	labels = noted.quad_count;
	assert_true(labels > 10);
	scene->show.watch.shown = true;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_true(noted.quad_count > labels + 10);
	scene->options.show.no_labels = true;
	noted.quad_count = 0;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_in_range(noted.quad_count, 10, HUD_QUADS_MAX);
}

/* Even the least one that --budget-ms allows. */
static void test_a_budget_has_a_label(void **state)
{
	struct scene *scene = *state;
	int without;

	scene->options.show.no_labels = false;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	without = noted.quad_count;
	scene->show.governor = governor_begin(1.0f);
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_true(noted.quad_count > without);
}

/* Without labels, the graph says what the governor leaves out. */
static void test_the_graph_has_the_governors_words_without_labels(void **state)
{
	struct scene *scene = *state;
	int without;

	scene->show.watch.shown = true;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	without = noted.quad_count;
	scene->show.governor.level = 3;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_true(noted.quad_count > without);
}

/* Adds the notice: two lines in the middle, on a panel as wide as the picture. */
static void add_notice(struct hud *wanted, int width)
{
	int em = hud_em(wanted), line = hud_line_height(wanted);
	int left = em, top = 320 - line - em / 2;

	hud_panel(wanted, left, top, width - em - left, em + line + line,
		em / 2, hud_color_panel);
	left += em;
	top += em / 2;
	hud_text_cut(wanted, left, top, width - left - left, hud_color_amber,
		"robot.glb ended limber 2 times within");
	hud_text_cut(wanted, left, top + line, width - left - left,
		hud_color_amber, "a minute of its start, so this is a demo");
}

/* Each line is cut where the picture is too narrow for it. */
static void test_the_notice_names_the_model_in_the_middle(void **state)
{
	static const int widths[] = {WIDTH, 320, 300, 280, 200};
	struct scene *scene = *state;
	struct hud *wanted = calloc(1, sizeof(*wanted));

	assert_non_null(wanted);
	strcpy(scene->failsafe.name, "robot.glb");
	scene->failsafe.gives_way = true;
	scene->plan.failsafe = &scene->failsafe;
	for (size_t i = 0; i < sizeof(widths) / sizeof(widths[0]); i++) {
		noted.width = widths[i];
		assert_int_equal(show_frame_draw(&scene->show), 0);
		wanted->font = scene->hud.font;
		hud_begin(wanted, noted.width, HEIGHT);
		add_notice(wanted, noted.width);
		assert_int_equal(noted.quad_count, wanted->quad_count);
		hud_end(wanted, &scene->shown.gl);
		assert_memory_equal(noted.vertex, wanted->vertex,
			(size_t)noted.quad_count * 4 * sizeof(noted.vertex[0]));
	}
	free(wanted);
}

/* A long name ends in an ellipsis within the panel. */
static void test_the_notice_cuts_a_long_name(void **state)
{
	struct scene *scene = *state;
	int16_t panel, text = INT16_MIN;

	memset(scene->failsafe.name, 'W', FAILSAFE_NAME_BYTES - 1);
	scene->failsafe.gives_way = true;
	scene->plan.failsafe = &scene->failsafe;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	panel = INT16_MIN;
	for (int i = 0; i < noted.quad_count * 4; i++) {
		const struct hud_vertex *v = &noted.vertex[i];
		bool amber = memcmp(&v->color, &hud_color_amber,
				     sizeof(v->color)) == 0;
		int16_t *most = amber ? &text : &panel;

		*most = v->x > *most ? v->x : *most;
	}
	assert_true(text > 0 && text < panel);
}

static void test_a_screen_without_memory_is_warned_about_once(void **state)
{
	struct scene *scene = *state;

	for (int frame = 0; frame < 3; frame++) {
		noted.error = GL_OUT_OF_MEMORY;
		assert_int_equal(show_frame_draw(&scene->show), 0);
		assert_int_equal(scene->said.count, 1);
		assert_true(log_capture_has(&scene->said, LOG_WARNING,
			"--gl made-up: there is not enough memory"));
	}
	assert_int_equal(noted.frames, 3);
}

/* No incomplete picture gets into a file; the GL of a GPU is not asked. */
static void test_a_file_without_memory_is_an_error(void **state)
{
	struct scene *scene = *state;

	scene->show.screen.driver = &file;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	noted.error = GL_OUT_OF_MEMORY;
	assert_int_equal(show_frame_draw(&scene->show), -ENOMEM);
	assert_int_equal(log_capture_count(&scene->said, LOG_ERROR), 1);
	assert_int_equal(noted.frames, 1);
	scene->gl.accelerated = true;
	noted.error = GL_OUT_OF_MEMORY;
	assert_int_equal(show_frame_draw(&scene->show), 0);
	assert_int_equal(scene->said.count, 1);
	assert_int_equal(noted.frames, 2);
}

static void test_a_frame_that_is_not_completed_is_not_shown(void **state)
{
	struct scene *scene = *state;

	noted.end_error = -EIO;
	assert_int_equal(show_frame_draw(&scene->show), -EIO);
	assert_int_equal(noted.frames, 0);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, begin, end)
	static const struct CMUnitTest tests[] = {
		CASE(test_nothing_lies_over_a_demo_without_labels),
		CASE(test_labels_and_the_graph_lie_over_the_demo),
		CASE(test_a_budget_has_a_label),
		CASE(test_the_graph_has_the_governors_words_without_labels),
		CASE(test_the_notice_names_the_model_in_the_middle),
		CASE(test_the_notice_cuts_a_long_name),
		CASE(test_a_screen_without_memory_is_warned_about_once),
		CASE(test_a_file_without_memory_is_an_error),
		CASE(test_a_frame_that_is_not_completed_is_not_shown),
	};
#undef CASE

	return cmocka_run_group_tests(tests, load, unload);
}

/* What is drawn of a character with ground of its own, or on uneven ground. */
#include "app/anim/math/matrix.h"
#include "app/character/run/effects.h"
#include "app/scene/stage/light.h"
#include "tests/unit/app/character/show/drawn.h"

#include <stdio.h>
#include <string.h>

/*
 * The drawables of the model: a lawn and a plate, and a lamp above them. The
 * lawn is seen from both sides, which takes two calls.
 */
static const char model_path[] = "tests/fixtures/gltf/scene/ground.gltf";

enum {
	LAWN,
	PLATE,
	LAMP,
	ALL
};

/* Lifts two corners of the lawn so high, and draws with the ground. */
static void begin_on_ground(struct shown *shown, const char *text, float hill)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct shadow_ground ground;
	struct acting *acting = &shown->acting;

	memset(shown, 0, sizeof(*shown));
	acting_begin(acting, model_path);
	acting->model->node[LAMP].name = "lamp";
	acting->model->mesh[LAWN].primitive->position[0][1] = hill;
	acting->model->mesh[LAWN].primitive->position[1][1] = hill / 2;
	acting->instance->unit_scale = unit;
	acting_expect(acting, text);
	assert_int_equal(shadow_ground_find(&ground, acting->instance), 0);
	assert_int_equal(ground.count, 2);
	assert_int_equal(ground.relief.height != NULL, hill > 0);
	shown->gl = gl_recorder_begin();
	assert_int_equal(texture_set_create(&shown->textures, acting->model,
				 &shown->gl, PIXELS_RGB565, &log),
		0);
	shown->stage.camera = camera_default();
	shown->stage.has_stencil = true;
	assert_int_equal(character_draw_init(&shown->drawing, acting->character,
				 &ground, &log),
		0);
	acting_run_to(acting, 0.1, 50.0);
}

static void expect_nothing_hidden(const struct shown *shown)
{
	for (int i = 0; i < ALL; i++) {
		assert_false(shown->acting.instance->drawable[i].hidden);
	}
}

static const char plain_text[] = "[state a]\nclip = rest\n";
static const char cape_text[] =
	"[state a]\nclip = rest\n[cape c]\nbone = lamp\nplace = 0 1.4 0.6\n"
	"fade = 0\n";

/* Shadows of all on the floor, the ground, the lamp's shadow, and the lamp. */
static void test_ground_of_its_own_is_drawn_before_the_shadows_on_it(
	void **state)
{
	static struct monitor monitor;
	struct shown shown;
	int plain;

	(void)state;
	begin_on_ground(&shown, plain_text, 0);
	plain = draw(&shown);
	assert_int_equal(plain, 3 + 3 + 1 + 1);
	/* The lamp's shadow lies there as it does on the floor, at 0, too. */
	for (int i = 0; i < 16; i++) {
		assert_near(gl_recorder_result()->draw[6].matrix[i],
			gl_recorder_result()->draw[2].matrix[i], 1e-5);
	}
	expect_nothing_hidden(&shown);
	shown.stage.has_stencil = false;
	assert_int_equal(draw(&shown), 3 + 4);
	shown.stage.has_stencil = true;
	shown.stage.floor.wave_height = 0.1f;
	assert_int_equal(draw(&shown), 4);
	expect_nothing_hidden(&shown);
	end(&shown);
	begin_on_ground(&shown, "[scene]\nshadow = no\n", 0);
	assert_int_equal(draw(&shown), 4);
	/* A monitor is drawn after the shadows, and without any. */
	monitor_init(&monitor);
	monitor_place(&monitor, &shown.stage.camera, 1, 0);
	shown.stage.monitor = &monitor;
	assert_true(draw(&shown) > 4);
	end(&shown);
	begin_on_ground(&shown, cape_text, 0);
	assert_true(shown.acting.character->cape[0].worn);
	/* On the floor and on the ground, and the cape itself. */
	assert_int_equal(draw(&shown), plain + 3);
	end(&shown);
}

/* The corners of the shadow of a drawable on uneven ground. */
static int corners_of(const struct shown *shown, int drawable)
{
	const struct shadow_drape *drape = &shown->drawing.drape;
	int corners = 0;

	for (int i = 0; i < drape->sheet_count; i++) {
		corners += drape->sheet[i].drawable ==
				&shown->acting.instance->drawable[drawable]
			? drape->sheet[i].index_count
			: 0;
	}
	return corners;
}

static int marked, references;

static void note_mark(GLenum function, GLint reference, GLuint mask)
{
	(void)function;
	(void)mask;
	references |= reference;
	marked += (reference & STAGE_GROUND_MARK) != 0;
}

/* The hill's shadow would lie on itself. */
static void test_hills_of_its_own_carry_the_shadows_of_all_else(void **state)
{
	struct shown shown;
	int drawn;

	(void)state;
	begin_on_ground(&shown, plain_text, 0.2f);
	assert_false(shown.drawing.may_wave);
	character_draw_update(&shown.drawing, &shown.stage);
	assert_true(corners_of(&shown, LAMP) > 0);
	assert_int_equal(corners_of(&shown, LAWN), 0);
	assert_int_equal(corners_of(&shown, PLATE), 0);
	expect_nothing_hidden(&shown);
	shown.gl.StencilFunc = note_mark;
	marked = 0;
	drawn = draw(&shown);
	assert_true(marked >= 2);
	/* Shadows on the floor, ground, lamp; and the shadow's triangles. */
	assert_true(drawn > 3 + 3 + 1);
	expect_nothing_hidden(&shown);
	end(&shown);
}

/* Only where a shadow is drawn on such hills. */
static void test_no_shadow_is_laid_on_hills_that_show_none(void **state)
{
	(void)state;
	for (int i = 0; i < 3; i++) {
		struct shown shown;

		begin_on_ground(&shown,
			i == 2 ? "[scene]\nshadow = no\n" : plain_text, 0.2f);
		shown.stage.has_stencil = i != 1;
		character_draw_update(&shown.drawing, &shown.stage);
		assert_int_equal(corners_of(&shown, LAMP) > 0, i == 0);
		end(&shown);
	}
}

/* Those of the stage hide the model's own, whose shadow is one of many. */
static void test_waves_carry_the_shadows_of_hills_too(void **state)
{
	struct shown shown;

	(void)state;
	begin_on_ground(&shown, "[scene]\nwaves = 0.1\n", 0.2f);
	shown.stage.floor = (struct floor){
		.tile = 1.0f, .radius = 9.0f, .wave_height = 0.05f};
	character_draw_update(&shown.drawing, &shown.stage);
	assert_true(corners_of(&shown, LAWN) > 0);
	assert_true(corners_of(&shown, LAMP) > 0);
	shown.gl.StencilFunc = note_mark;
	references = 0;
	/* All, and what darkens the ground wherever it is. */
	assert_true(draw(&shown) > 4);
	assert_int_equal(references, 0);
	end(&shown);
}

/* The middle of the positions of a drawable's shadow. */
static void middle_of(const struct shown *shown, int drawable, float out[3])
{
	const struct shadow_drape *drape = &shown->drawing.drape;
	struct bounds box = bounds_empty();

	for (int i = 0; i < drape->sheet_count; i++) {
		const struct shadow_sheet *sheet = &drape->sheet[i];

		for (int v = 0; sheet->drawable ==
				&shown->acting.instance->drawable[drawable] &&
			v < sheet->vertex_count;
			v++) {
			bounds_add(&box, sheet->position[v]);
		}
	}
	assert_false(bounds_is_empty(&box));
	bounds_center(&box, out);
}

/* The lamp is 0.2 to 1.6 m high, so that it lies there; but nearer to the eye. */
static void test_shadows_on_hills_lie_where_light_falls(void **state)
{
	float light[3], left[3], right[3];
	struct shown shown;

	(void)state;
	light_direction(light);
	begin_on_ground(&shown, plain_text, 0.01f);
	shown.stage.camera.distance = 4;
	shown.stage.camera.yaw_rad = -1;
	character_draw_update(&shown.drawing, &shown.stage);
	middle_of(&shown, LAMP, left);
	shown.stage.camera.yaw_rad = 1;
	character_draw_update(&shown.drawing, &shown.stage);
	middle_of(&shown, LAMP, right);
	assert_near(left[0], -light[0] / light[1] * 0.9f * unit, 0.1);
	assert_near(left[2], -light[2] / light[1] * 0.9f * unit, 0.1);
	assert_true(right[0] > left[0] + 1e-4f);
	end(&shown);
}

/* A number, or what a parameter may become. */
static void test_ground_may_be_uneven_unless_it_is_always_level(void **state)
{
	static const struct {
		const char *text;
		bool may_wave;
	} rows[] = {
		{"[scene]\nwaves = 0\n", false},
		{"[scene]\nwaves = 0.01\n", true},
		{"[parameter p]\nrange = 0 1\n[scene]\nwaves = p\n", true},
		{"[parameter p]\nrange = -1 0\n[scene]\nwaves = p\n", true},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct floor_content content;
		struct shown shown;

		begin(&shown, model_path, rows[i].text);
		acting_run_to(&shown.acting, 0.1, 50.0);
		assert_int_equal(shown.drawing.may_wave, rows[i].may_wave);
		content = character_draw_content(&shown.drawing, &shown.stage);
		assert_int_equal(content.bounded, rows[i].may_wave);
		end(&shown);
	}
}

/* A ball at each side of the figure, above, below, before and behind it. */
static const float balls[6][3] = {
	{-3, 1, 0}, {3, 1, 0}, {0, -2, 0}, {0, 4, 0}, {0, 1, -3}, {0, 1, 3}};

static void begin_with_balls(struct shown *shown)
{
	char text[1024] =
		"[state a]\nclip = rest\n[scene]\nwaves = 0.2\n[cape c]\n"
		"bone = chest\nplace = 0 1.42 -0.4\nlength = 1.2\nflare = 2\n"
		"fade = 0\n";

	for (int i = 0; i < 6; i++) {
		size_t length = strlen(text);

		snprintf(text + length, sizeof(text) - length,
			"[target t%d]\nplace = %g %g %g\nradius = 0.1\n", i,
			(double)balls[i][0], (double)balls[i][1],
			(double)balls[i][2]);
	}
	begin(shown, "assets/walker.glb", text);
	shown->stage.floor = (struct floor){
		.y = 0.05f, .tile = 1.0f, .radius = 9.0f, .wave_height = 0.1f};
	acting_run_to(&shown->acting, 0.1, 50.0);
	character_draw_update(&shown->drawing, &shown->stage);
}

static void to_eye(const float place[3], mat4 view, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = unit * place[axis];
	}
	matrix_apply(view, out, out);
}

static void add_cape(struct bounds *box, const struct shown *shown, mat4 view)
{
	const struct cloth *cloth = &shown->acting.character->cape[0].cloth;

	for (int i = 0; i < cloth->count; i++) {
		float at[3];

		to_eye(cloth->position[i], view, at);
		bounds_add(box, at);
	}
}

static void add_ball(struct bounds *box, const float place[3], mat4 view)
{
	float at[3];

	to_eye(place, view, at);
	for (int k = 0; k < 6; k++) {
		float side[3] = {at[0], at[1], at[2]};

		side[k / 2] += k % 2 ? 0.1f * unit : -0.1f * unit;
		bounds_add(box, side);
	}
}

/* All in the eye's space, and a fiftieth larger. */
static void test_content_stands_where_the_eye_sees_it(void **state)
{
	struct floor_content content;
	struct bounds wanted;
	struct shown shown;
	struct reach reach;
	mat4 view;

	(void)state;
	begin_with_balls(&shown);
	assert_int_equal(reach_init(&reach, shown.acting.instance), 0);
	/* Balls first that are all switched off, so that the cape counts. */
	for (int balls_on = 0; balls_on < 2; balls_on++) {
		float margin;

		camera_view(&shown.stage.camera, view);
		wanted = reach_now(
			&reach, shown.acting.instance, (const vec4 *)view);
		add_cape(&wanted, &shown, view);
		for (int i = 0; i < 6; i++) {
			shown.acting.character->target[i].used = balls_on;
			if (balls_on) {
				add_ball(&wanted, balls[i], view);
			}
		}
		margin = 0.02f * bounds_extent(&wanted);
		content = character_draw_content(&shown.drawing, &shown.stage);
		if (!balls_on) {
			const struct bounds *lying = &shown.drawing.drape.box;

			assert_all_near(content.lying.low, lying->low, 3, 0);
			assert_all_near(content.lying.high, lying->high, 3, 0);
		}
		for (int axis = 0; axis < 3; axis++) {
			assert_near(content.standing.low[axis],
				wanted.low[axis] - margin, 1e-4);
			assert_near(content.standing.high[axis],
				wanted.high[axis] + margin, 1e-4);
		}
	}
	end(&shown);
}

/* At any height between the troughs and the crests; three radii suffice. */
static void test_shadows_of_balls_lie_on_some_ground(void **state)
{
	struct floor_content content;
	struct bounds wanted;
	struct shown shown;
	float light[3];

	(void)state;
	light_direction(light);
	begin_with_balls(&shown);
	wanted = shown.drawing.drape.box;
	assert_false(bounds_is_empty(&wanted));
	for (int i = 0; i < 12; i++) {
		float y = i % 2 ? -0.05f : 0.15f, low[3], high[3];
		const float *ball = balls[i / 2];
		float fall = (unit * ball[1] - y) / light[1];

		for (int axis = 0; axis < 3; axis++) {
			low[axis] =
				unit * (ball[axis] - 0.3f) - light[axis] * fall;
			high[axis] = low[axis] + unit * 0.6f;
		}
		bounds_add(&wanted, low);
		bounds_add(&wanted, high);
	}
	content = character_draw_content(&shown.drawing, &shown.stage);
	assert_all_near(content.lying.low, wanted.low, 3, 1e-4);
	assert_all_near(content.lying.high, wanted.high, 3, 1e-4);
	end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_ground_of_its_own_is_drawn_before_the_shadows_on_it),
		cmocka_unit_test(
			test_hills_of_its_own_carry_the_shadows_of_all_else),
		cmocka_unit_test(test_no_shadow_is_laid_on_hills_that_show_none),
		cmocka_unit_test(test_waves_carry_the_shadows_of_hills_too),
		cmocka_unit_test(test_shadows_on_hills_lie_where_light_falls),
		cmocka_unit_test(
			test_ground_may_be_uneven_unless_it_is_always_level),
		cmocka_unit_test(test_content_stands_where_the_eye_sees_it),
		cmocka_unit_test(test_shadows_of_balls_lie_on_some_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

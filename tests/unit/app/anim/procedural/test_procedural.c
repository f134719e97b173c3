#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/procedural/procedural.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double FACTOR = 0.3; /* cos(0) * amplitude */

/* A shoulder, elbow and hand, and a head that is not below them. */
enum {
	ROOT,
	SHOULDER,
	ELBOW,
	HAND,
	HEAD
};

struct fixture {
	struct bones bones;
	struct procedural shake;
};

static void set_up(struct fixture *f)
{
	struct procedural_preset preset = procedural_preset_default();

	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 0, 0);
	bones_add(&f->bones, ROOT, 0.2f, 1.4f, 0);
	bones_add(&f->bones, SHOULDER, 0.3f, 0, 0);
	bones_add(&f->bones, ELBOW, 0.3f, 0, 0);
	bones_add(&f->bones, ROOT, 0, 1.7f, 0);
	bones_pose(&f->bones);
	f->shake = procedural_begin(&preset, SHOULDER);
	procedural_fade(&f->shake, 0, 0);
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

static void test_the_default_is_the_documents(void **state)
{
	struct procedural_preset preset = procedural_preset_default();

	(void)state;
	assert_string_equal(preset.name, "snowboard");
	assert_true(preset.speed == 40 && preset.amplitude == 0.3f);
	assert_true(preset.attenuation == 0.3f);
	assert_true(preset.translation[0] == 0 && preset.translation[1] == 1 &&
		preset.translation[2] == 0);
	assert_true(preset.rotation[0] == 0 && preset.rotation[1] == 0.1f &&
		preset.rotation[2] == 0);
}

/* The factor of a bone, which is how far it moves along y. */
static float factor_of(struct fixture *f, double time_s, int node)
{
	pose_rest(&f->bones.pose, &f->bones.model);
	procedural_apply(&f->shake, time_s, &f->bones.pose);
	return f->bones.pose.local[node].translation[1] -
		f->bones.node[node].rest.translation[1];
}

static void test_the_factor_is_the_documents_formula(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = 0; i < 200; i++) {
		double time_s = i * 0.0137;
		double want = cos(time_s * 40) * (double)0.3f;

		assert_near(factor_of(&f, time_s, SHOULDER), want, 1e-6);
		assert_near(factor_of(&f, time_s, HAND), want * 1.6, 1e-6);
		f.shake.fade = 0.25f;
		assert_near(
			factor_of(&f, time_s, HAND), want * 1.6 * 0.75, 1e-6);
		f.shake.fade = 0;
	}
	tear_down(&f);
}

static void test_the_factor_keeps_its_rhythm_for_days(void **state)
{
	struct fixture f;
	double time_s = 3 * 86400 + 0.123;

	(void)state;
	set_up(&f);
	assert_near(factor_of(&f, time_s, SHOULDER),
		cos(time_s * 40) * (double)0.3f, 1e-6);
	tear_down(&f);
}

static void test_the_modifier_grows_with_each_level(void **state)
{
	struct procedural_preset preset = procedural_preset_default();

	(void)state;
	assert_near(procedural_modifier(&preset, 0), 1, 1e-6);
	assert_near(procedural_modifier(&preset, 1), 1.3, 1e-6);
	assert_near(procedural_modifier(&preset, 3), 1.9, 1e-6);
}

static void test_a_small_modifier_does_not_grow(void **state)
{
	struct procedural_preset preset = procedural_preset_default();

	(void)state;
	preset.modifier = 0.1f;
	assert_near(procedural_modifier(&preset, 5), 0.1, 1e-6);
	preset.modifier = 0;
	assert_near(procedural_modifier(&preset, 5), 0, 0);
	preset.modifier = 0.11f;
	assert_near(procedural_modifier(&preset, 1), 0.41, 1e-6);
}

static void test_the_modifier_is_never_below_zero(void **state)
{
	struct procedural_preset preset = procedural_preset_default();

	(void)state;
	preset.attenuation = -0.6f;
	assert_near(procedural_modifier(&preset, 1), 0.4, 1e-6);
	assert_true(procedural_modifier(&preset, 2) == 0);
	assert_true(procedural_modifier(&preset, 9) == 0);
	preset.modifier = -2;
	assert_true(procedural_modifier(&preset, 0) == 0);
}

static void test_bones_below_move_and_turn_more(void **state)
{
	struct fixture f;
	const struct transform *local;

	(void)state;
	set_up(&f);
	local = f.bones.pose.local;
	procedural_apply(&f.shake, 0, &f.bones.pose);
	assert_near(local[SHOULDER].translation[1], 1.4 + FACTOR, 1e-6);
	assert_near(local[ELBOW].translation[1], FACTOR * 1.3, 1e-6);
	assert_near(local[HAND].translation[1], FACTOR * 1.6, 1e-6);
	assert_near(local[SHOULDER].rotation[1], sin(0.05 * FACTOR), 1e-6);
	assert_near(local[ELBOW].rotation[1], sin(0.05 * FACTOR * 1.3), 1e-6);
	assert_near(local[HAND].rotation[1], sin(0.05 * FACTOR * 1.6), 1e-6);
	assert_true(f.bones.pose.animated[HAND]);
	tear_down(&f);
}

static void test_other_bones_are_left_alone(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	procedural_apply(&f.shake, 0, &f.bones.pose);
	assert_memory_equal(&f.bones.pose.local[ROOT], &f.bones.node[ROOT].rest,
		sizeof(struct transform));
	assert_memory_equal(&f.bones.pose.local[HEAD], &f.bones.node[HEAD].rest,
		sizeof(struct transform));
	assert_false(f.bones.pose.animated[HEAD]);
	tear_down(&f);
}

static void test_the_swing_is_multiplied_onto_the_animated_bone(void **state)
{
	struct fixture f;
	struct transform *elbow;
	mat4 animated, got;
	const float point[3] = {0.3f, 0.2f, 0.1f};
	float moved[3], want[3], out[3];
	double angle = 0.1 * FACTOR * 1.3;

	(void)state;
	set_up(&f);
	elbow = &f.bones.pose.local[ELBOW];
	elbow->rotation[0] = elbow->rotation[3] = 0.70710678f;
	elbow->scale[0] = elbow->scale[1] = elbow->scale[2] = 2;
	transform_to_matrix(elbow, animated);
	procedural_apply(&f.shake, 0, &f.bones.pose);
	transform_to_matrix(elbow, got);
	/* The point is rotated about y and moved along y, then animated. */
	moved[0] = (float)(cos(angle) * point[0] + sin(angle) * point[2]);
	moved[1] = point[1] + (float)(FACTOR * 1.3);
	moved[2] = (float)(cos(angle) * point[2] - sin(angle) * point[0]);
	matrix_apply(animated, moved, want);
	matrix_apply(got, point, out);
	assert_all_near(out, want, 3, 2e-6);
	tear_down(&f);
}

static void test_rotations_turn_about_x_then_y_then_z(void **state)
{
	struct fixture f;
	const float up[3] = {0, 1, 0};
	/* Rotations by 90 degrees about x, y and z take +y to +z, +x, +y. */
	float out[3];

	(void)state;
	set_up(&f);
	for (int i = 0; i < 3; i++) {
		f.shake.preset.rotation[i] = acosf(-1) / 2;
	}
	f.shake.preset.amplitude = 1;
	procedural_apply(&f.shake, 0, &f.bones.pose);
	quat_rotate(f.bones.pose.local[SHOULDER].rotation, up, out);
	assert_all_near(out, up, 3, 1e-5);
	tear_down(&f);
}

static void test_the_unit_scales_the_translation_alone(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.shake.preset.unit = 0.01f;
	procedural_apply(&f.shake, 0, &f.bones.pose);
	assert_near(f.bones.pose.local[ELBOW].translation[1],
		FACTOR * 1.3 * 0.01, 1e-6);
	assert_near(f.bones.pose.local[ELBOW].rotation[1],
		sin(0.05 * FACTOR * 1.3), 1e-6);
	tear_down(&f);
}

static void test_a_faded_out_swing_changes_nothing(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	procedural_fade(&f.shake, 1, 0);
	procedural_apply(&f.shake, 0.3, &f.bones.pose);
	for (int i = 0; i < 5; i++) {
		assert_memory_equal(&f.bones.pose.local[i],
			&f.bones.node[i].rest, sizeof(struct transform));
	}
	f.shake.fade = 0;
	f.shake.node = -1;
	procedural_apply(&f.shake, 0.3, &f.bones.pose);
	tear_down(&f);
}

static void test_fades_take_their_time(void **state)
{
	struct procedural_preset preset = procedural_preset_default();
	struct procedural shake = procedural_begin(&preset, 0);

	(void)state;
	assert_true(shake.fade == 1);
	procedural_fade(&shake, 0, 0.5f);
	procedural_update(&shake, 0.125f);
	assert_near(shake.fade, 0.75, 1e-6);
	procedural_update(&shake, 0.125f);
	assert_near(shake.fade, 0.5, 1e-6);
	procedural_fade(&shake, 1, 1);
	procedural_update(&shake, 0.25f);
	assert_near(shake.fade, 0.75, 1e-6);
	procedural_update(&shake, 9);
	assert_true(shake.fade == 1);
	procedural_fade(&shake, 0, 0.5f);
	procedural_update(&shake, 100);
	assert_true(shake.fade == 0);
}

static void test_presets_are_read_from_text(void **state)
{
	static const char text[] = "; a comment\n"
				   "\n"
				   "[ snowboard ]\n"
				   "[twist] # another\n"
				   "\tspeed=7.5;fast\r\n"
				   "translation = 1 -2.5 3e-1\n"
				   "  rotation =0 0 1\n"
				   "unit = .01";
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct procedural_preset standard = procedural_preset_default();
	struct procedural_preset preset[4];

	(void)state;
	assert_int_equal(
		procedural_presets_parse(text, "p.ini", &log, preset, 4), 2);
	assert_int_equal(capture.count, 0);
	assert_string_equal(preset[0].name, "snowboard");
	assert_true(preset[0].speed == standard.speed);
	assert_string_equal(preset[1].name, "twist");
	assert_near(preset[1].speed, 7.5, 1e-6);
	assert_near(preset[1].translation[1], -2.5, 1e-6);
	assert_near(preset[1].translation[2], 0.3, 1e-6);
	assert_near(preset[1].rotation[2], 1, 1e-6);
	assert_near(preset[1].unit, 0.01, 1e-6);
	assert_true(preset[1].attenuation == standard.attenuation);
	assert_int_equal(procedural_preset_find(preset, 2, "twist"), 1);
	assert_int_equal(procedural_preset_find(preset, 2, "twis"), -1);
}

static void test_bad_presets_get_one_sentence_with_the_line(void **state)
{
	static const struct {
		const char *text;
		const char *part;
	} cases[] = {
		{"speed = 1\n", "p.ini:1: "},
		{"[a]\n\nspeed = fast\n", "p.ini:3: "},
		{"[a]\nspeed =\n7\n", "p.ini:2: "},
		{"[a]\nspeed = 1 2\n", "p.ini:2: "},
		{"[a]\nspeed = nan\n", "p.ini:2: "},
		{"[a]\nspeed = 1e9\n", "p.ini:2: "},
		{"[a]\ntranslation = 1 2\n", "three numbers"},
		{"[a]\nspeeed = 1\n", "unknown key"},
		{"[a]\nspeed 1\n", "key = value"},
		{"[a\n", "[name]"},
		{"[]\n", "1 to 31"},
		{"[aaaaaaaaaabbbbbbbbbbccccccccccdd]", "1 to 31"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		struct procedural_preset preset[2];

		assert_int_equal(procedural_presets_parse(cases[i].text,
					 "p.ini", &log, preset, 2),
			-EINVAL);
		assert_int_equal(capture.count, 1);
		assert_contains(capture.sentence[0], cases[i].part);
	}
}

static void test_too_many_presets_are_refused(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct procedural_preset preset[1];

	(void)state;
	assert_int_equal(
		procedural_presets_parse("[a]\n[b]\n", "p.ini", &log, preset, 1),
		-ENOSPC);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0], "p.ini:2: ");
}

static void test_the_shipped_presets_hold_the_documents_values(void **state)
{
	struct procedural_preset want = procedural_preset_default();
	struct procedural_preset preset[16];
	struct log log = log_to_stderr(LOG_NOTE);
	char *text = file_read("assets/presets.ini", NULL);
	int count = procedural_presets_parse(
		text, "assets/presets.ini", &log, preset, 16);
	int index;

	(void)state;
	free(text);
	assert_true(count > 0);
	index = procedural_preset_find(preset, count, "snowboard");
	assert_int_equal(index, 0);
	want.unit = preset[0].unit;
	assert_string_equal(preset[0].name, want.name);
	assert_all_near(&preset[0].speed, &want.speed, 11, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_default_is_the_documents),
		cmocka_unit_test(test_the_factor_is_the_documents_formula),
		cmocka_unit_test(test_the_factor_keeps_its_rhythm_for_days),
		cmocka_unit_test(test_the_modifier_grows_with_each_level),
		cmocka_unit_test(test_a_small_modifier_does_not_grow),
		cmocka_unit_test(test_the_modifier_is_never_below_zero),
		cmocka_unit_test(test_bones_below_move_and_turn_more),
		cmocka_unit_test(test_other_bones_are_left_alone),
		cmocka_unit_test(
			test_the_swing_is_multiplied_onto_the_animated_bone),
		cmocka_unit_test(test_rotations_turn_about_x_then_y_then_z),
		cmocka_unit_test(test_the_unit_scales_the_translation_alone),
		cmocka_unit_test(test_a_faded_out_swing_changes_nothing),
		cmocka_unit_test(test_fades_take_their_time),
		cmocka_unit_test(test_presets_are_read_from_text),
		cmocka_unit_test(test_bad_presets_get_one_sentence_with_the_line),
		cmocka_unit_test(test_too_many_presets_are_refused),
		cmocka_unit_test(
			test_the_shipped_presets_hold_the_documents_values),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

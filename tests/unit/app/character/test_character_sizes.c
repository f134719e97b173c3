/*
 * A character of any unit moves alike: a model made in centimetres, or a toy,
 * only has other lengths.
 */
#include "app/character/run/effects.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>

static const char walker[] = "assets/walker.glb";
static const double rate_hz = 30.0;
static const float sizes[] = {100.0f, 0.05f, 0.01f};

struct actor {
	struct acting acting;
	float size;
};

/* Loads a model, size times as large. */
static void begin(struct actor *actor, const char *path, float size)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct acting *acting = &actor->acting;

	*actor = (struct actor){.size = size};
	assert_int_equal(model_load(path, &log, &acting->model), 0);
	for (int i = 0; i < acting->model->node_count; i++) {
		struct model_node *node = &acting->model->node[i];

		for (int axis = 0; axis < 3 && node->parent < 0; axis++) {
			node->rest.translation[axis] *= size;
			node->rest.scale[axis] *= size;
		}
	}
	assert_int_equal(instance_create(acting->model, &kernel_float, &log,
				 &acting->instance),
		0);
}

/* Hills that move with the ground under the walker. */
static float hills(void *user, float x, float z)
{
	const struct actor *actor = user;

	x /= actor->size;
	z /= actor->size;
	return actor->size *
		(0.1f * sinf(2.0f * x) +
			0.1f *
				cosf(3.0f *
					(z - 1.03f * (float)actor->acting.now_s)));
}

static void expect_cape_alike(
	const struct actor *actor, const struct actor *own, double tolerance)
{
	for (int c = 0; c < own->acting.character->cape_count; c++) {
		const struct cloth *cloth =
			&actor->acting.character->cape[c].cloth;
		const struct cloth *wanted =
			&own->acting.character->cape[c].cloth;

		for (int i = 0; i < wanted->count; i++) {
			for (int axis = 0; axis < 3; axis++) {
				assert_near(
					cloth->position[i][axis] / actor->size,
					wanted->position[i][axis], tolerance);
			}
		}
	}
}

/*
 * Compares the places of nodes, and of capes, with those of the walker in its
 * own size.
 */
static void expect_alike(struct actor *actor, struct actor *own,
	const char *const node[], double tolerance)
{
	for (int frame = 0; frame < 150; frame++) {
		if (frame == 30 || frame == 90) {
			enum button button =
				frame == 30 ? BUTTON_UP : BUTTON_DOWN;

			acting_press(&actor->acting, button);
			acting_press(&own->acting, button);
		}
		acting_run_to(&actor->acting, (frame + 0.5) / rate_hz, rate_hz);
		acting_run_to(&own->acting, (frame + 0.5) / rate_hz, rate_hz);
		for (int i = 0; node[i]; i++) {
			float at[3], wanted[3];

			acting_place(&actor->acting, node[i], at);
			acting_place(&own->acting, node[i], wanted);
			for (int axis = 0; axis < 3; axis++) {
				assert_near(at[axis] / actor->size,
					wanted[axis], tolerance);
			}
		}
		expect_cape_alike(actor, own, tolerance);
	}
}

/* act() reads the file of an actor, with lengths of its size. */
static void expect_alike_at_any_size(const char *path,
	void (*act)(struct actor *actor), const char *const *node,
	double tolerance)
{
	for (size_t i = 0; i < ARRAY_COUNT(sizes); i++) {
		struct actor actor, own;

		begin(&actor, path, sizes[i]);
		begin(&own, path, 1.0f);
		act(&actor);
		act(&own);
		expect_alike(&actor, &own, node, tolerance);
		acting_end(&own.acting);
		acting_end(&actor.acting);
	}
}

static void walk(struct actor *actor)
{
	double size = (double)actor->size;
	char text[700];

	snprintf(text, sizeof(text),
		"[parameter speed]\nrange = 0 %.9g\nease = 0.5\n"
		"[state move]\nblend = speed, idle 0, walk %.9g, run %.9g\n"
		"[feet steps]\nhips = hips\nleft = thigh.L shin.L foot.L\n"
		"right = thigh.R shin.R foot.R\n"
		"[motion]\nfeet = toe.L toe.R\n"
		"[buttons]\nUP = set speed %.9g\nDOWN = set speed 0\n"
		"[scene]\nwaves = %.9g\n",
		2.6 * size, 1.03 * size, 2.6 * size, 1.03 * size, 0.2 * size);
	acting_expect(&actor->acting, text);
	actor->acting.character->ground_height = hills;
	actor->acting.character->ground_user = actor;
}

static void test_feet_step_alike_on_uneven_ground(void **state)
{
	static const char *const node[] = {
		"hips", "foot.L", "foot.R", "toe.L", "toe.R", NULL};

	(void)state;
	expect_alike_at_any_size(walker, walk, node, 0.002);
}

/* Lengths that the file leaves out, and gravity. */
static void swing(struct actor *actor)
{
	double size = (double)actor->size;
	char text[700];

	snprintf(text, sizeof(text),
		"[state run]\nclip = run\n[motion]\nspeed = %.9g\n"
		"[spring tail]\nbones = ponytail.4 4\n"
		"[shake left]\nbone = shoulder.L\ntranslation = 0 3 0\n"
		"[cape cape]\nbone = chest\nplace = 0 %.9g %.9g\n",
		2.6 * size, 1.45 * size, -0.118 * size);
	acting_expect(&actor->acting, text);
}

static void test_springs_shakes_and_capes_move_alike(void **state)
{
	static const char *const node[] = {
		"ponytail.2", "ponytail.4", "hand.L", NULL};

	(void)state;
	expect_alike_at_any_size(walker, swing, node, 0.02);
}

static void fall(struct actor *actor)
{
	double size = (double)actor->size;
	char text[200];

	snprintf(text, sizeof(text),
		"[part walker_head]\ny = %.9g 0 %.9g\n[buttons]\nUP = drop walker_head\n",
		2.0 * size, 2.0 * size);
	acting_expect(&actor->acting, text);
}

static void test_parts_fall_alike(void **state)
{
	static const char *const node[] = {"walker_head", NULL};

	(void)state;
	expect_alike_at_any_size(walker, fall, node, 0.02);
}

/* The arm lowers until its capsule meets the floor, with the hand shifted. */
static void shift(struct actor *actor)
{
	double size = (double)actor->size;
	char text[300];

	snprintf(text, sizeof(text),
		"[part Hand]\nx = %.9g\ny = %.9g\nz = %.9g\n"
		"[part Arm]\npitch = 0 0 120 45\nguard = %.9g 0 0 %.9g\n"
		"[buttons]\nUP = move Arm pitch 1\n",
		0.1 * size, -0.2 * size, 0.3 * size, 0.1 * size, 3.0 * size);
	acting_expect(&actor->acting, text);
}

static void test_parts_shift_and_meet_the_floor_alike(void **state)
{
	static const char *const node[] = {"Arm", "Hand", "Thumb", NULL};

	(void)state;
	expect_alike_at_any_size("assets/arm.glb", shift, node, 0.002);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_feet_step_alike_on_uneven_ground),
		cmocka_unit_test(test_springs_shakes_and_capes_move_alike),
		cmocka_unit_test(test_parts_fall_alike),
		cmocka_unit_test(test_parts_shift_and_meet_the_floor_alike),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

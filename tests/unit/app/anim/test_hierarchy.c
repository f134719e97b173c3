#include "app/anim/hierarchy.h"
#include "app/anim/math/matrix.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	ARM,
	FOREARM,
	HAND,
	FINGER
};

/* A visitor that records each call. */
struct record {
	char text[2000];
	size_t used;
};

static void note(struct record *record, const char *line)
{
	int left = (int)(sizeof(record->text) - record->used);
	int wrote = snprintf(
		record->text + record->used, (size_t)left, "%s\n", line);

	assert_true(wrote > 0 && wrote < left);
	record->used += (size_t)wrote;
}

static void note_push(void *user)
{
	note(user, "push");
}

static void note_pop(void *user)
{
	note(user, "pop");
}

static void note_translate(void *user, const float offset[3])
{
	char line[80];

	snprintf(line, sizeof(line), "translate %g %g %g", (double)offset[0],
		(double)offset[1], (double)offset[2]);
	note(user, line);
}

static void note_rotate(void *user, float angle_rad, const float axis[3])
{
	char line[80];

	snprintf(line, sizeof(line), "rotate %g about %g %g %g",
		(double)angle_rad, (double)axis[0], (double)axis[1],
		(double)axis[2]);
	note(user, line);
}

static void note_scale(void *user, const float factor[3])
{
	char line[80];

	snprintf(line, sizeof(line), "scale %g %g %g", (double)factor[0],
		(double)factor[1], (double)factor[2]);
	note(user, line);
}

static void note_draw(void *user, int part)
{
	char line[20];

	snprintf(line, sizeof(line), "draw %d", part);
	note(user, line);
}

static struct hierarchy_visitor recorder(struct record *record)
{
	return (struct hierarchy_visitor){record, note_push, note_translate,
		note_rotate, note_scale, note_draw, note_pop};
}

/* The document's robot arm, each part with its order of rotations. */
static void make_robot_arm(struct hierarchy_pivot pivot[4])
{
	static const enum hierarchy_order order[4] = {
		HIERARCHY_HEADING_PITCH_BANK, HIERARCHY_PITCH_HEADING_BANK,
		HIERARCHY_PITCH_BANK_HEADING, HIERARCHY_HEADING_PITCH_BANK};

	for (int i = 0; i < 4; i++) {
		pivot[i] = hierarchy_pivot_default();
		pivot[i].parent = i - 1;
		pivot[i].part = i;
		pivot[i].order = order[i];
		pivot[i].position[0] = (float)i + 1;
		pivot[i].heading_rad = 0.5f + 0.125f * (float)i;
		if (i != FINGER) {
			pivot[i].pitch_rad = 0.25f;
			pivot[i].bank_rad = -0.75f;
		}
	}
}

static void test_the_robot_arm_makes_the_documents_calls(void **state)
{
	static const char want[] = "push\n"
				   "translate 1 0 0\n"
				   "rotate 0.5 about 0 1 0\n"
				   "rotate 0.25 about 1 0 0\n"
				   "rotate -0.75 about 0 0 1\n"
				   "draw 0\n"
				   "push\n"
				   "translate 2 0 0\n"
				   "rotate 0.25 about 1 0 0\n"
				   "rotate 0.625 about 0 1 0\n"
				   "rotate -0.75 about 0 0 1\n"
				   "draw 1\n"
				   "push\n"
				   "translate 3 0 0\n"
				   "rotate 0.25 about 1 0 0\n"
				   "rotate -0.75 about 0 0 1\n"
				   "rotate 0.75 about 0 1 0\n"
				   "draw 2\n"
				   "push\n"
				   "translate 4 0 0\n"
				   "rotate 0.875 about 0 1 0\n"
				   "draw 3\n"
				   "pop\n"
				   "pop\n"
				   "pop\n"
				   "pop\n";
	struct hierarchy_pivot pivot[4];
	struct hierarchy arm = {4, pivot};
	struct record record = {.used = 0};
	struct hierarchy_visitor visitor = recorder(&record);

	(void)state;
	make_robot_arm(pivot);
	hierarchy_walk(&arm, &visitor);
	assert_string_equal(record.text, want);
}

static void test_siblings_are_popped_between(void **state)
{
	static const char want[] = "push\n"
				   "translate 0 1 0\n"
				   "push\n"
				   "translate 1 0 0\n"
				   "scale 2 1 1\n"
				   "draw 7\n"
				   "pop\n"
				   "push\n"
				   "translate -1 0 0\n"
				   "draw 8\n"
				   "pop\n"
				   "pop\n"
				   "push\n"
				   "translate 0 0 0\n"
				   "draw 9\n"
				   "pop\n";
	struct hierarchy_pivot pivot[4] = {hierarchy_pivot_default(),
		hierarchy_pivot_default(), hierarchy_pivot_default(),
		hierarchy_pivot_default()};
	struct hierarchy car = {4, pivot};
	struct record record = {.used = 0};
	struct hierarchy_visitor visitor = recorder(&record);

	(void)state;
	pivot[0].position[1] = 1;
	pivot[1].part = 9; /* a second root between the first one's children */
	pivot[2].parent = 0;
	pivot[2].part = 7;
	pivot[2].position[0] = 1;
	pivot[2].scale[0] = 2;
	pivot[3].parent = 0;
	pivot[3].part = 8;
	pivot[3].position[0] = -1;
	hierarchy_walk(&car, &visitor);
	assert_string_equal(record.text, want);
}

/* A visitor with a matrix stack in double, as OpenGL defines it. */
struct stack {
	double matrix[HIERARCHY_DEPTH + 1][4][4]; /* [column][row] */
	int top;
	int highest;
	double drawn[32][4][4];
};

static void multiply_top(struct stack *stack, double right[4][4])
{
	double out[4][4];

	for (int c = 0; c < 4; c++) {
		for (int r = 0; r < 4; r++) {
			out[c][r] = 0;
			for (int k = 0; k < 4; k++) {
				out[c][r] += stack->matrix[stack->top][k][r] *
					right[c][k];
			}
		}
	}
	memcpy(stack->matrix[stack->top], out, sizeof(out));
}

static void stack_push(void *user)
{
	struct stack *stack = user;

	assert_true(stack->top < HIERARCHY_DEPTH);
	stack->top++;
	stack->highest =
		stack->top > stack->highest ? stack->top : stack->highest;
	memcpy(stack->matrix[stack->top], stack->matrix[stack->top - 1],
		sizeof(stack->matrix[0]));
}

static void stack_pop(void *user)
{
	struct stack *stack = user;

	assert_true(stack->top > 0);
	stack->top--;
}

static void stack_translate(void *user, const float o[3])
{
	double m[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0},
		{o[0], o[1], o[2], 1}};

	multiply_top(user, m);
}

/* glRotate: the formula of the OpenGL ES 1.1 specification, section 2.10.2. */
static void stack_rotate(void *user, float angle_rad, const float u[3])
{
	double s = sin(angle_rad);
	double c = cos(angle_rad);
	double cross[3][3] = {
		{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
	double m[4][4] = {{0}};

	for (int row = 0; row < 3; row++) {
		for (int col = 0; col < 3; col++) {
			double uu = (double)u[row] * u[col];

			m[col][row] = uu + c * ((row == col) - uu) +
				s * cross[row][col];
		}
	}
	m[3][3] = 1;
	multiply_top(user, m);
}

static void stack_scale(void *user, const float f[3])
{
	double m[4][4] = {{f[0], 0, 0, 0}, {0, f[1], 0, 0}, {0, 0, f[2], 0},
		{0, 0, 0, 1}};

	multiply_top(user, m);
}

static void stack_draw(void *user, int part)
{
	struct stack *stack = user;

	memcpy(stack->drawn[part], stack->matrix[stack->top],
		sizeof(stack->drawn[part]));
}

static void walk_on_a_stack(
	const struct hierarchy *hierarchy, struct stack *stack)
{
	struct hierarchy_visitor visitor = {stack, stack_push, stack_translate,
		stack_rotate, stack_scale, stack_draw, stack_pop};

	memset(stack, 0, sizeof(*stack));
	for (int i = 0; i < 4; i++) {
		stack->matrix[0][i][i] = 1;
	}
	hierarchy_walk(hierarchy, &visitor);
	assert_int_equal(stack->top, 0);
}

static void assert_same_matrix(mat4 got, double want[4][4])
{
	for (int c = 0; c < 4; c++) {
		for (int r = 0; r < 4; r++) {
			assert_near(got[c][r], want[c][r], 1e-5);
		}
	}
}

static void test_world_matrices_equal_a_matrix_stacks(void **state)
{
	struct hierarchy_pivot pivot[4];
	struct hierarchy arm = {4, pivot};
	struct stack stack;
	mat4 world[4];

	(void)state;
	make_robot_arm(pivot);
	pivot[ARM].scale[0] = 1.5f;
	pivot[HAND].scale[1] = 0.5f;
	pivot[FOREARM].position[2] = -0.25f;
	walk_on_a_stack(&arm, &stack);
	hierarchy_world(&arm, world);
	for (int i = 0; i < 4; i++) {
		assert_same_matrix(world[i], stack.drawn[i]);
	}
}

static void test_each_order_turns_as_computed_by_hand(void **state)
{
	/*
	 * Quarter turns carry +x, innermost turn first:
	 * heading pitch bank: bank +y, pitch +z, heading +x;
	 * pitch heading bank: bank +y, heading +y, pitch +z;
	 * pitch bank heading: heading -z, bank -z, pitch +y.
	 */
	static const float by_hand[3][3] = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
	const float unit_x[3] = {1, 0, 0};

	(void)state;
	for (int order = 0; order < 3; order++) {
		struct hierarchy_pivot pivot = hierarchy_pivot_default();
		struct hierarchy one = {1, &pivot};
		struct stack stack;
		mat4 world[1];
		float out[3];

		pivot.part = 0;
		pivot.order = (enum hierarchy_order)order;
		pivot.heading_rad = acosf(-1) / 2;
		pivot.pitch_rad = acosf(-1) / 2;
		pivot.bank_rad = acosf(-1) / 2;
		hierarchy_world(&one, world);
		matrix_apply_direction(world[0], unit_x, out);
		assert_all_near(out, by_hand[order], 3, 1e-5);
		walk_on_a_stack(&one, &stack);
		assert_same_matrix(world[0], stack.drawn[0]);
	}
}

static void test_check_wants_parents_first(void **state)
{
	struct hierarchy_pivot pivot[3] = {hierarchy_pivot_default(),
		hierarchy_pivot_default(), hierarchy_pivot_default()};
	struct hierarchy hierarchy = {3, pivot};

	(void)state;
	pivot[1].parent = 0;
	pivot[2].parent = 1;
	assert_int_equal(hierarchy_check(&hierarchy), 0);
	pivot[1].parent = 2;
	assert_int_equal(hierarchy_check(&hierarchy), -EINVAL);
	pivot[1].parent = 1;
	assert_int_equal(hierarchy_check(&hierarchy), -EINVAL);
	pivot[1].parent = -2;
	assert_int_equal(hierarchy_check(&hierarchy), -EINVAL);
	hierarchy.pivot_count = 0;
	assert_int_equal(hierarchy_check(&hierarchy), 0);
}

static void make_chain(struct hierarchy_pivot *pivot, int count)
{
	for (int i = 0; i < count; i++) {
		pivot[i] = hierarchy_pivot_default();
		pivot[i].parent = i - 1;
		pivot[i].part = i;
	}
}

static void test_the_deepest_tree_fits_gl_es_stacks(void **state)
{
	struct hierarchy_pivot pivot[HIERARCHY_DEPTH];
	struct hierarchy chain = {HIERARCHY_DEPTH, pivot};
	struct stack stack;

	(void)state;
	make_chain(pivot, HIERARCHY_DEPTH);
	assert_int_equal(hierarchy_check(&chain), 0);
	walk_on_a_stack(&chain, &stack);
	/* The current matrix and 15 pushes make the 16 levels of GL ES 1.1. */
	assert_int_equal(stack.highest, 15);
}

static void test_deeper_trees_are_refused_and_cut(void **state)
{
	struct hierarchy_pivot pivot[HIERARCHY_DEPTH + 3];
	struct hierarchy chain = {HIERARCHY_DEPTH + 3, pivot};
	struct stack stack;

	(void)state;
	make_chain(pivot, HIERARCHY_DEPTH + 3);
	assert_int_equal(hierarchy_check(&chain), -EINVAL);
	walk_on_a_stack(&chain, &stack);
	assert_int_equal(stack.highest, HIERARCHY_DEPTH);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_robot_arm_makes_the_documents_calls),
		cmocka_unit_test(test_siblings_are_popped_between),
		cmocka_unit_test(test_world_matrices_equal_a_matrix_stacks),
		cmocka_unit_test(test_each_order_turns_as_computed_by_hand),
		cmocka_unit_test(test_check_wants_parents_first),
		cmocka_unit_test(test_the_deepest_tree_fits_gl_es_stacks),
		cmocka_unit_test(test_deeper_trees_are_refused_and_cut),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

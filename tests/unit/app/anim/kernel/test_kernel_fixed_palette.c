/* The matrices of skins in fixed point, at the limits of their scale. */
#include "app/anim/kernel/run/fixed_palette.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	JOINTS = 2
};

struct fixture {
	mat4 palette[JOINTS];
	struct fixed_joint joint[JOINTS];
	struct fixed_skin skin;
	struct fixed_matrix matrix[JOINTS];
	struct fixed_placement placement;
};

/* Joints that do not turn and whose vertices are all in one point. */
static void set_up(struct fixture *f, int joints, float scale)
{
	memset(f, 0, sizeof(*f));
	memset(f->matrix, 0x5A, sizeof(f->matrix));
	f->placement = (struct fixed_placement){99, {99, 99, 99}};
	for (int j = 0; j < joints; j++) {
		f->joint[j] = (struct fixed_joint){.joint = j, .used = true};
		for (int k = 0; k < 4; k++) {
			f->palette[j][k][k] = 1;
		}
	}
	f->skin = (struct fixed_skin){
		.joint_count = joints, .joint = f->joint, .scale = {scale}};
}

static int make(struct fixture *f)
{
	return fixed_palette_make(
		&f->skin, (const mat4 *)f->palette, f->matrix, &f->placement);
}

/* 1 becomes 28672 if nothing is larger: 1.75 times a power of two. */
static void assert_element(const struct fixture *f, double element)
{
	assert_near(f->placement.scale * f->skin.scale[FIXED_POSITION] *
			element / 65536,
		1, 1e-6);
}

static void test_matrices_and_translations_are_rounded(void **state)
{
	static const float middle[3] = {3, -6.5f, 12};
	static struct fixture f;
	const struct fixed_matrix *m = f.matrix;

	(void)state;
	set_up(&f, 2, 1024);
	f.joint[0].middle[0] = 2;
	f.joint[1].middle[1] = 3;
	f.palette[0][1][0] = 0.5f;
	f.palette[0][2][1] = -0.25f;
	f.palette[0][0][2] = 0.125f;
	f.palette[0][3][1] = -7;
	f.palette[1][3][0] = 4;
	f.palette[1][3][1] = -9;
	f.palette[1][3][2] = 23.75f;
	assert_int_equal(make(&f), 0);
	assert_element(&f, 28672);
	assert_all_near(f.placement.offset, middle, 3, 0);
	/* A unit is 448 in the output, 896 in translations. */
	assert_int_equal(m[0].row[0][0], 28672);
	assert_int_equal(m[0].row[0][1], 14336);
	assert_int_equal(m[0].row[0][2], 0);
	assert_int_equal(m[0].row[0][3], 896 - 1);
	assert_int_equal(m[0].row[1][2], -7168);
	assert_int_equal(m[0].row[1][3], 448 - 1);
	assert_int_equal(m[0].row[2][0], 3584);
	assert_int_equal(m[0].row[2][3], 10528 - 1);
	assert_int_equal(m[1].row[0][3], -896 - 1);
	assert_int_equal(m[1].row[1][3], -448 - 1);
	assert_int_equal(m[1].row[2][3], -10528 - 1);
	for (int j = 0; j < 2; j++) {
		for (int k = 0; k < 4; k++) {
			assert_int_equal(m[j].unused[k], 0x5A5A);
		}
	}
}

/* Whichever it is, and of either sign. */
static void test_the_largest_element_fits(void **state)
{
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 36; i++) {
		int joint = i / 18, column = i / 3 % 3, row = i % 3;
		int sign = i / 9 % 2 ? 1 : -1;

		set_up(&f, 2, 1024);
		f.palette[joint][column][row] = (float)sign * 2;
		assert_int_equal(make(&f), 0);
		assert_element(&f, 14336);
		assert_int_equal(f.matrix[joint].row[row][column], sign * 28672);
	}
}

/* Along an axis of the model that the joint turns to another one. */
static void test_the_largest_box_fits(void **state)
{
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 18; i++) {
		int column = i / 3 % 3, row = i % 3;

		set_up(&f, 2, 32768);
		for (int k = 0; k < 3; k++) {
			f.palette[1][k][k] = 0;
		}
		for (int k = 0; k < 3; k++) {
			f.palette[1][(column + k) % 3][(row + k) % 3] =
				i < 9 ? 1 : -1;
		}
		f.joint[1].half[column] = 4;
		assert_int_equal(make(&f), 0);
		/* 32700 / 4 * 2 is 16350. */
		assert_element(&f, 14336);
		for (int k = 0; k < 3; k++) {
			assert_near(f.placement.offset[k], 0, 0);
		}
	}
}

/* The limits are 14335.9, just below the step of 14336, and just above it. */
static void test_limits_are_rounded_down_to_a_step(void **state)
{
	static const double limits[] = {14335.9, 14336.1};
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 18; i++) {
		double limit = limits[i / 9];
		int axis = i % 3;

		set_up(&f, 2, 65536);
		if (i / 3 % 3 == 0) {
			f.joint[0].half[axis] = (float)(32700 / limit);
		} else {
			float away = (float)(16380 / limit);
			int far = i / 3 % 3 - 1;

			f.palette[far][3][axis] = away;
			f.palette[!far][3][axis] = -away;
		}
		assert_int_equal(make(&f), 0);
		assert_element(&f, i < 9 ? 12288 : 14336);
	}
}

/* A large box on one side moves the middle, and translations are far from it. */
static void test_translations_fit_on_both_sides(void **state)
{
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 6; i++) {
		float side = i < 3 ? 1 : -1;
		int axis = i % 3;

		set_up(&f, 2, 65536);
		f.joint[0].half[axis] = 1;
		f.palette[0][3][axis] = side;
		f.palette[1][3][axis] = side * -2;
		assert_int_equal(make(&f), 0);
		/* From -2 to 2: the joints are 2 and 1 away; 16380 / 2. */
		assert_near(f.placement.offset[axis], 0, 0);
		assert_element(&f, 7168);
	}
}

static void test_numbers_up_to_1e18_are_usable(void **state)
{
	static const struct {
		float value;
		bool usable;
	} cases[] = {{1e18f, true}, {-1e18f, true}, {1.1e18f, false},
		{-1.1e18f, false}, {NAN, false}, {-NAN, false},
		{INFINITY, false}, {-INFINITY, false}};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases) * 3; i++) {
		int wanted = cases[i / 3].usable ? 0 : -ERANGE;

		set_up(&f, 1, 1024);
		f.palette[0][3][i % 3] = cases[i / 3].value;
		assert_int_equal(make(&f), wanted);
		for (int k = 0; k < 3; k++) {
			set_up(&f, 1, 1024);
			f.palette[0][k][i % 3] = cases[i / 3].value;
			/* Elements of 1e18 would become 0 in the others. */
			assert_int_equal(make(&f), -ERANGE);
		}
		if (!(cases[i / 3].value < 0)) {
			set_up(&f, 1, 1e-6f);
			f.joint[0].half[i % 3] = cases[i / 3].value;
			assert_int_equal(make(&f), wanted);
		}
	}
}

static void test_unused_joints_do_not_count(void **state)
{
	static struct fixture f;
	struct fixed_matrix before;

	(void)state;
	memset(&before, 0x5A, sizeof(before));
	for (int unused = 0; unused < 2; unused++) {
		set_up(&f, 2, 1024);
		f.joint[unused].used = false;
		f.palette[unused][1][1] = NAN;
		f.palette[unused][3][2] = 1000;
		assert_int_equal(make(&f), 0);
		assert_element(&f, 28672);
		assert_near(f.placement.offset[2], 0, 0);
		assert_memory_equal(&f.matrix[unused], &before, sizeof(before));
	}
}

/* A third of the element, so that no product with a normal wraps. */
static void test_normals_have_a_third_of_the_element(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f, 1, 1024);
	assert_int_equal(make(&f), 0);
	memset(f.matrix, 0x5A, sizeof(f.matrix));
	for (int i = 0; i < 9; i++) {
		f.palette[0][i / 3][i % 3] =
			(float)((9000.4 - i) * 3 / 28672) * (i & 1 ? -1 : 1);
	}
	fixed_palette_make_normals(
		&f.skin, &f.placement, (const mat4 *)f.palette, f.matrix);
	for (int i = 0; i < 9; i++) {
		assert_int_equal(f.matrix[0].row[i % 3][i / 3],
			(9000 - i) * (i & 1 ? -1 : 1));
	}
	for (int row = 0; row < 3; row++) {
		assert_int_equal(f.matrix[0].row[row][3], 0);
	}
	for (int k = 0; k < 4; k++) {
		assert_int_equal(f.matrix[0].unused[k], 0x5A5A);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_matrices_and_translations_are_rounded),
		cmocka_unit_test(test_the_largest_element_fits),
		cmocka_unit_test(test_the_largest_box_fits),
		cmocka_unit_test(test_limits_are_rounded_down_to_a_step),
		cmocka_unit_test(test_translations_fit_on_both_sides),
		cmocka_unit_test(test_numbers_up_to_1e18_are_usable),
		cmocka_unit_test(test_unused_joints_do_not_count),
		cmocka_unit_test(test_normals_have_a_third_of_the_element),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

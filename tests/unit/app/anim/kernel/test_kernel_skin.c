#include "app/anim/kernel/kernel.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 60,
	WIDTH = 8,
	JOINTS = 7
};

/* A mesh of scattered vertices with one to eight influences. */
struct fixture {
	float position[VERTICES][3];
	float normal[VERTICES][3];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	mat4 palette[JOINTS];
	struct arena arena;
	struct skin_stream stream;
	float out[VERTICES][3];
	float out_normal[VERTICES][3];
	float tangent[VERTICES][4];
	float delta[3][VERTICES][3];
	float out_tangent[VERTICES][3];
};

static void make_palette(struct fixture *f)
{
	for (int j = 0; j < JOINTS; j++) {
		struct transform t = transform_identity();

		for (int k = 0; k < 3; k++) {
			t.translation[k] = 2 * scattered(j * 9 + k);
			t.rotation[k] = scattered(j * 9 + 3 + k);
		}
		quat_normalize(t.rotation);
		transform_to_matrix(&t, f->palette[j]);
	}
}

static void make_vertex(struct fixture *f, int v)
{
	scattered_point(v, f->position[v], f->normal[v]);
	scattered_influences(
		v, v % WIDTH + 1, JOINTS, f->joint[v], f->weight[v]);
}

static void set_up(struct fixture *f)
{
	struct model_primitive primitive;

	memset(f, 0, sizeof(*f));
	make_palette(f);
	for (int v = 0; v < VERTICES; v++) {
		make_vertex(f, v);
	}
	primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0]};
	assert_int_equal(
		skin_stream_init(&f->stream, &primitive, 1, &f->arena), 0);
}

static void tear_down(struct fixture *f)
{
	arena_release(&f->arena);
}

/* The heaviest influence that is not used yet, or -1. */
static int next_heaviest(const float weight[WIDTH], bool used[WIDTH])
{
	int best = -1;

	for (int i = 0; i < WIDTH; i++) {
		if (!used[i] && weight[i] > 0 &&
			(best < 0 || weight[i] > weight[best])) {
			best = i;
		}
	}
	if (best >= 0) {
		used[best] = true;
	}
	return best;
}

/*
 * Example 4 of AN4044 in double, from the vertex attributes. w is 1 for
 * positions and 0 for normals.
 */
static void skin_reference(const struct fixture *f, int v, int cap,
	const float base[3], double w, double out[3])
{
	bool used[WIDTH] = {false};
	double sum = 0;
	int i;

	out[0] = out[1] = out[2] = 0;
	for (int n = 0; n < cap && (i = next_heaviest(f->weight[v], used)) >= 0;
		n++) {
		const vec4 *m = f->palette[f->joint[v][i]];
		double weight = f->weight[v][i];

		sum += weight;
		for (int r = 0; r < 3; r++) {
			out[r] += weight *
				((double)m[0][r] * base[0] +
					(double)m[1][r] * base[1] +
					(double)m[2][r] * base[2] + m[3][r] * w);
		}
	}
	for (int r = 0; r < 3; r++) {
		out[r] /= sum;
	}
}

static void assert_skinned(const struct fixture *f, int cap)
{
	for (int v = 0; v < VERTICES; v++) {
		double want[3];
		double length;

		skin_reference(f, v, cap, f->position[v], 1, want);
		for (int r = 0; r < 3; r++) {
			assert_near(f->out[v][r], want[r], 2e-6);
		}
		skin_reference(f, v, cap, f->normal[v], 0, want);
		length = sqrt(want[0] * want[0] + want[1] * want[1] +
			want[2] * want[2]);
		for (int r = 0; r < 3; r++) {
			/* Normalising a short sum magnifies its error. */
			assert_near(f->out_normal[v][r], want[r] / length,
				1e-6 + 1e-6 / length);
		}
	}
}

static void test_skinning_sums_the_weighted_matrices(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	kernel_float.skin(
		&f.stream, (const mat4 *)f.palette, 0, f.out, f.out_normal);
	assert_skinned(&f, WIDTH);
	tear_down(&f);
}

static void test_capped_weights_count_as_if_they_summed_to_one(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int cap = 1; cap <= WIDTH + 1; cap++) {
		kernel_float.skin(&f.stream, (const mat4 *)f.palette, cap,
			f.out, f.out_normal);
		assert_skinned(&f, cap);
	}
	tear_down(&f);
}

static void test_positions_alone_are_the_same_positions(void **state)
{
	struct fixture f;
	float alone[VERTICES][3];

	(void)state;
	set_up(&f);
	kernel_float.skin(
		&f.stream, (const mat4 *)f.palette, 2, f.out, f.out_normal);
	kernel_float.skin(&f.stream, (const mat4 *)f.palette, 2, alone, NULL);
	assert_memory_equal(alone, f.out, sizeof(alone));
	tear_down(&f);
}

static void test_the_bind_pose_stays_where_it_is(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int j = 0; j < JOINTS; j++) {
		struct transform t = transform_identity();

		transform_to_matrix(&t, f.palette[j]);
	}
	kernel_float.skin(
		&f.stream, (const mat4 *)f.palette, 0, f.out, f.out_normal);
	assert_all_near(f.out, f.position, 3 * VERTICES, 1e-6);
	assert_all_near(f.out_normal, f.normal, 3 * VERTICES, 1e-6);
	tear_down(&f);
}

static void test_pitfall_16_a_morphed_shape_is_skinned(void **state)
{
	struct fixture f;
	float delta[VERTICES][3];
	struct morph_term term = {.weight = 0.5f,
		.position = (const float(*)[3])delta,
		.normal = (const float(*)[3])delta};

	(void)state;
	set_up(&f);
	for (int v = 0; v < VERTICES; v++) {
		for (int k = 0; k < 3; k++) {
			delta[v][k] = 0.4f * scattered(v * 3 + k + 1234);
		}
	}
	kernel_float.morph_targets(VERTICES, (const float(*)[3])f.position,
		&term, 1, false, f.position);
	kernel_float.morph_targets(VERTICES, (const float(*)[3])f.normal, &term,
		1, true, f.normal);
	kernel_float.normalize(VERTICES, f.normal);
	skin_stream_rebase(&f.stream, (const float(*)[3])f.position,
		(const float(*)[3])f.normal, 1);
	kernel_float.skin(
		&f.stream, (const mat4 *)f.palette, 0, f.out, f.out_normal);
	assert_skinned(&f, WIDTH);
	tear_down(&f);
}

/* The tangent of a vertex is the normal of the third one after it. */
static void add_tangents(struct fixture *f, struct morph_term term[3])
{
	struct model_primitive primitive = {.tangent = f->tangent};

	for (int v = 0; v < VERTICES; v++) {
		memcpy(f->tangent[v], f->normal[(v + 3) % VERTICES],
			3 * sizeof(float));
		f->tangent[v][3] = v % 3 ? 1 : -1;
		for (int t = 0; t < 3; t++) {
			for (int k = 0; k < 3; k++) {
				f->delta[t][v][k] =
					scattered(v * 9 + t * 3 + k + 77);
			}
		}
	}
	assert_int_equal(
		skin_stream_add_tangents(&f->stream, &primitive, &f->arena), 0);
	for (int t = 0; t < 3; t++) {
		term[t] = (struct morph_term){
			.weight = 0.3f * (float)(t - 1),
			.position = (const float(*)[3])f->delta[t],
			.normal = t ? (const float(*)[3])f->delta[0] : NULL,
			.tangent = t ? (const float(*)[3])f->delta[1] : NULL,
		};
	}
}

static void assert_unit_sum(const struct fixture *f, int v, int cap,
	const float base[3], const float got[3])
{
	double want[3];
	double length;

	skin_reference(f, v, cap, base, 0, want);
	length = sqrt(want[0] * want[0] + want[1] * want[1] + want[2] * want[2]);
	for (int r = 0; r < 3; r++) {
		assert_near(got[r], want[r] / length, 1e-6 + 1e-6 / length);
	}
}

static void test_tangents_are_skinned_like_normals(void **state)
{
	struct fixture f;
	struct morph_term term[3];

	(void)state;
	set_up(&f);
	add_tangents(&f, term);
	for (int cap = 1; cap <= 9; cap += 4) {
		kernel_float.skin_directions(&f.stream,
			(const float(*)[4])f.stream.tangent,
			(const mat4 *)f.palette, cap, f.out_tangent);
		for (int v = 0; v < VERTICES; v++) {
			assert_unit_sum(
				&f, v, cap, f.tangent[v], f.out_tangent[v]);
		}
	}
	tear_down(&f);
}

static void test_primitives_without_tangents_are_refused(void **state)
{
	struct fixture f;
	struct model_primitive primitive = {.vertex_count = VERTICES};

	(void)state;
	set_up(&f);
	assert_int_equal(
		skin_stream_add_tangents(&f.stream, &primitive, &f.arena),
		-EINVAL);
	assert_null(f.stream.tangent);
	tear_down(&f);
}

static void test_morph_and_skin_in_one_pass_is_morph_then_skin(void **state)
{
	struct fixture f;
	struct morph_term term[3];
	struct morph_input input;
	struct skin_output output;

	(void)state;
	set_up(&f);
	add_tangents(&f, term);
	input = (struct morph_input){
		.position = (const float(*)[3])f.position,
		.normal = (const float(*)[3])f.normal,
		.tangent = (const float(*)[4])f.tangent,
		.term = term,
		.term_count = 3,
		.position_scale = 2,
	};
	output = (struct skin_output){f.out, f.out_normal, f.out_tangent};
	for (int cap = 0; cap <= 9; cap += 3) {
		kernel_float.skin_morphed(&f.stream, &input,
			(const mat4 *)f.palette, cap, &output);
		for (int v = 0; v < VERTICES; v++) {
			int used = cap ? cap : WIDTH;
			float at[3], normal[3], tangent[3];
			double want[3];

			for (int k = 0; k < 3; k++) {
				float last = term[2].weight;

				at[k] = 2 *
					(f.position[v][k] -
						0.3f * f.delta[0][v][k] +
						last * f.delta[2][v][k]);
				normal[k] = f.normal[v][k] +
					last * f.delta[0][v][k];
				tangent[k] = f.tangent[v][k] +
					last * f.delta[1][v][k];
			}
			skin_reference(&f, v, used, at, 1, want);
			for (int r = 0; r < 3; r++) {
				assert_near(f.out[v][r], want[r], 4e-6);
			}
			assert_unit_sum(&f, v, used, normal, f.out_normal[v]);
			assert_unit_sum(&f, v, used, tangent, f.out_tangent[v]);
		}
	}
	tear_down(&f);
}

static void test_one_pass_takes_a_palette_for_normals(void **state)
{
	struct fixture f;
	struct morph_input input;
	struct skin_output output;
	float want[VERTICES][3];
	mat4 other[JOINTS];

	(void)state;
	set_up(&f);
	for (int j = 0; j < JOINTS; j++) {
		memcpy(other[j], f.palette[JOINTS - 1 - j], sizeof(mat4));
	}
	input = (struct morph_input){
		.position = (const float(*)[3])f.position,
		.normal = (const float(*)[3])f.normal,
		.position_scale = 1,
		.normal_palette = (const mat4 *)other,
	};
	output = (struct skin_output){.position = f.out, .normal = f.out_normal};
	kernel_float.skin_morphed(
		&f.stream, &input, (const mat4 *)f.palette, 2, &output);
	kernel_float.skin_directions(&f.stream,
		(const float(*)[4])f.stream.normal, (const mat4 *)other, 2,
		want);
	assert_all_near(f.out_normal, want, 3 * VERTICES, 1e-5);
	kernel_float.skin(&f.stream, (const mat4 *)f.palette, 2, want, NULL);
	assert_all_near(f.out, want, 3 * VERTICES, 1e-5);
	tear_down(&f);
}

static void test_one_pass_gives_positions_alone(void **state)
{
	struct fixture f;
	struct morph_input input;
	struct skin_output output = {NULL, NULL, NULL};
	float alone[VERTICES][3];

	(void)state;
	set_up(&f);
	input = (struct morph_input){
		.position = (const float(*)[3])f.position,
		.position_scale = 1,
	};
	output.position = alone;
	kernel_float.skin_morphed(
		&f.stream, &input, (const mat4 *)f.palette, 0, &output);
	kernel_float.skin(&f.stream, (const mat4 *)f.palette, 0, f.out, NULL);
	assert_all_near(alone, f.out, 3 * VERTICES, 1e-6);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_skinning_sums_the_weighted_matrices),
		cmocka_unit_test(
			test_capped_weights_count_as_if_they_summed_to_one),
		cmocka_unit_test(test_positions_alone_are_the_same_positions),
		cmocka_unit_test(test_the_bind_pose_stays_where_it_is),
		cmocka_unit_test(test_pitfall_16_a_morphed_shape_is_skinned),
		cmocka_unit_test(test_tangents_are_skinned_like_normals),
		cmocka_unit_test(test_primitives_without_tangents_are_refused),
		cmocka_unit_test(
			test_morph_and_skin_in_one_pass_is_morph_then_skin),
		cmocka_unit_test(test_one_pass_takes_a_palette_for_normals),
		cmocka_unit_test(test_one_pass_gives_positions_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

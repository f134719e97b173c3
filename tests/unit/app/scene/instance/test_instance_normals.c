/*
 * Normals of skinned vertices below joints of uneven scale, compared with the
 * inverse transpose of the matrix that transforms each vertex.
 */
#include "app/anim/math/quat.h"
#include "tests/support/model/instance_pair.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const double DEGREE = 0.017453292519943295;

/* The mean of the palette's matrices, by the vertex's weights. */
static void blend(const struct instance *instance,
	const struct drawable *drawable, int vertex, double out[3][3])
{
	const struct model_primitive *primitive = drawable->primitive;

	memset(out, 0, 9 * sizeof(double));
	for (int i = 0; i < primitive->influences; i++) {
		int at = vertex * primitive->influences + i;
		const vec4 *m =
			instance->palette[drawable->skin][primitive->joint[at]];

		for (int k = 0; k < 9; k++) {
			out[k / 3][k % 3] += (double)primitive->weight[at] *
				(double)m[k / 3][k % 3];
		}
	}
}

static void make_unit(double v[3], double sign)
{
	double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

	for (int i = 0; i < 3; i++) {
		v[i] *= sign / length;
	}
}

/* Cofactors are the inverse transpose times the determinant. */
static void transform_normal(double m[3][3], const float n[3], double out[3])
{
	double determinant = 0;

	for (int row = 0; row < 3; row++) {
		int r = (row + 1) % 3, s = (row + 2) % 3;

		out[row] = 0;
		for (int column = 0; column < 3; column++) {
			const double *a = m[(column + 1) % 3];
			const double *b = m[(column + 2) % 3];

			double cofactor = a[r] * b[s] - a[s] * b[r];

			out[row] += cofactor * (double)n[column];
			determinant += cofactor * m[column][row];
		}
	}
	make_unit(out, determinant < 0 ? -1 : 1);
}

static void posed_normal(
	const struct drawable *drawable, int vertex, double out[3])
{
	const struct drawable_fixed *fixed = drawable->fixed;

	for (int i = 0; i < 3; i++) {
		out[i] = fixed
			? (&fixed->normal[fixed->inverse_order[vertex]].x)[i]
			: (double)drawable->normal[vertex][i];
	}
	make_unit(out, 1);
}

/* Between the normals and those of the mathematics, in degrees. */
struct angles {
	double worst_of_one; /* of vertices with one influence */
	double mean;         /* root of the mean square, of all vertices */
};

static struct angles measure(const struct instance *instance)
{
	struct angles angles = {0, 0};
	double sum = 0;
	int count = 0;

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct model_primitive *primitive = drawable->primitive;

		for (int v = 0;
			drawable->skin >= 0 && v < primitive->vertex_count; v++) {
			double want[3], got[3], matrix[3][3], angle;
			float weight =
				primitive->weight[v * primitive->influences];

			blend(instance, drawable, v, matrix);
			transform_normal(matrix, primitive->normal[v], want);
			posed_normal(drawable, v, got);
			angle = acos(fmin(1.0,
					want[0] * got[0] + want[1] * got[1] +
						want[2] * got[2])) /
				DEGREE;
			if (weight > 0.999f) {
				angles.worst_of_one =
					fmax(angles.worst_of_one, angle);
			}
			sum += angle * angle;
			count++;
		}
	}
	assert_true(count > 100);
	angles.mean = sqrt(sum / count);
	return angles;
}

/* Scales and turns every joint a little differently. */
static void deform(struct instance *instance, float factor)
{
	struct pose *pose = &instance->pose;

	pose_rest(pose, instance->model);
	for (int i = 0; i < pose->node_count; i++) {
		struct transform *local = &pose->local[i];
		float turn[4] = {0.2f * (float)(i % 3 - 1), 0.1f,
			0.15f * (float)(i % 2), 1};

		quat_normalize(turn);
		quat_multiply(local->rotation, turn, local->rotation);
		local->scale[i % 3] *= factor;
		pose->animated[i] = true;
	}
	instance_update(instance);
}

/*
 * Blended matrices give blended normals only approximately, even where all
 * joints are even (factor 1): then the mean difference is half a degree.
 */
static void test_normals_are_at_right_angles_below_uneven_joints(void **state)
{
	static const struct {
		float factor;
		double mean;
	} row[] = {{1, 0.6}, {1.003f, 0.6}, {0.9f, 0.6}, {0.7f, 0.8},
		{0.5f, 1.4}, {1.4f, 0.9}, {-1, 180}};
	struct instance_pair pair;

	(void)state;
	instance_pair_load(&pair, "assets/walker.glb");
	for (size_t i = 0; i < sizeof(row) / sizeof(row[0]); i++) {
		struct instance *both[] = {pair.exact, pair.fixed};

		for (int k = 0; k < 2; k++) {
			struct angles angles;

			deform(both[k], row[i].factor);
			angles = measure(both[k]);
			assert_near(angles.worst_of_one, 0, 0.5);
			assert_in_range((int)(1000 * angles.mean), 0,
				(int)(1000 * row[i].mean));
		}
	}
	instance_pair_end(&pair);
}

static void test_even_poses_use_one_palette(void **state)
{
	struct instance_pair pair;
	struct instance *instance;

	(void)state;
	instance_pair_load(&pair, "assets/walker.glb");
	instance = pair.fixed;
	for (int i = 0; i < 2; i++) {
		deform(instance, i == 0 ? 1.5f : 1);
		for (int k = 0; k < pair.model->skin_count; k++) {
			const mat4 *palette = (const mat4 *)instance->palette[k];

			assert_int_equal(
				instance->normal_palette[k] == palette, i);
		}
	}
	instance_pair_end(&pair);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_normals_are_at_right_angles_below_uneven_joints),
		cmocka_unit_test(test_even_poses_use_one_palette),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

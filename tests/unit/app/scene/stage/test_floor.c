#include "app/scene/stage/floor.h"
#include "platform/gl/gl_context.h"
#include "tests/support/test.h"

/* A point in a triangle, by two barycentric coordinates. */
static void mix(const struct floor *floor, const uint16_t *corner, float a,
	float b, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = a * floor->position[corner[0]][axis] +
			b * floor->position[corner[1]][axis] +
			(1.0f - a - b) * floor->position[corner[2]][axis];
	}
}

/*
 * The greatest distance of the opaque mesh from floor_height(), as a part of
 * the stated error there.
 */
static float find_sag(const struct floor *floor)
{
	float most = 0.0f;

	for (int i = 0; i < FLOOR_OPAQUE_INDICES; i += 3) {
		for (int n = 0; n < 10; n++) {
			float a = (float)(n % 4) / 3.0f,
			      b = (float)(n / 4) / 3.0f;
			float at[3], off;

			mix(floor, floor->index + i, a, b * (1.0f - a), at);
			off = at[1] - floor_height(floor, at[0], at[2]);
			off = off < 0.0f ? -off : off;
			off /= floor_mesh_error(floor, at[0], at[2]);
			most = off > most ? off : most;
		}
	}
	return most;
}

/* A floor as large as the walker's. */
static void test_ground_is_drawn_where_it_is(void **state)
{
	const struct bounds bounds = {
		.low = {-0.5f, 0.0f, -0.4f}, .high = {0.6f, 1.9f, 0.8f}};
	struct log log = log_to_nowhere();
	struct gl_context *context;
	struct floor floor;
	float most = 0.0f;

	(void)state;
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &context),
		0);
	assert_int_equal(floor_init(&floor, &context->gl, &bounds, 4.8f,
				 PIXELS_RGB565, &log),
		0);
	floor_set_wave_height(&floor, 0.2f);
	for (int i = 0; i < 60; i++) {
		float sag = find_sag(&floor);

		most = sag > most ? sag : most;
		assert_true(sag < 1.0f);
		floor_scroll(&floor, 0.07f, 0.11f);
	}
	/* The stated error is not much larger than the measured one. */
	assert_true(2.0f * most > 1.0f);
	floor_finish(&floor, &context->gl);
	context->driver->destroy(context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_is_drawn_where_it_is),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

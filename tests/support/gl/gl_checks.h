/*
 * Tests that every GL driver must pass. They take the driver's name as their
 * prestate and draw small pictures whose pixels are known.
 *
 *	const struct CMUnitTest tests[] = {GL_CHECKS("osmesa")};
 */
#ifndef TESTS_SUPPORT_GL_GL_CHECKS_H
#define TESTS_SUPPORT_GL_GL_CHECKS_H

#include "platform/gl/gl_context.h"
#include "tests/support/test.h"

enum {
	GL_CANVAS_WIDTH = 32,
	GL_CANVAS_HEIGHT = 24
};

/* A context of GL and the picture that it draws into. */
struct gl_canvas {
	struct gl_context *context;
	struct gl *gl;
	struct pixels pixels;
};

/*
 * Opens the driver of that name and begins a frame of GL_CANVAS_WIDTH x
 * GL_CANVAS_HEIGHT, cleared to black. If the driver cannot be opened, the
 * running test ends: as skipped on an ARM machine without the driver's library,
 * otherwise as failed.
 */
struct gl_canvas gl_canvas_open(const char *driver, enum pixel_format format);

/* Ends the frame; fails the test when GetError() reports an error. */
void gl_canvas_end_frame(struct gl_canvas *canvas);

void gl_canvas_close(struct gl_canvas *canvas);

void gl_canvas_end_and_close(struct gl_canvas *canvas);

/* Fails unless each channel (0..255) of the pixel is within tolerance of this. */
void gl_canvas_expect(const struct gl_canvas *canvas, int x, int y, int red,
	int green, int blue, int tolerance);

/* Draws a rectangle as two triangles, in clip space (-1..1) at depth z. */
void gl_canvas_draw_rectangle(struct gl *gl, float left, float bottom,
	float right, float top, float z);

/* Draws a rectangle that covers the picture, at depth 0. */
void gl_canvas_draw_all(struct gl *gl);

/* Binds and enables a texture of 2x2: red green, above it blue white. */
GLuint gl_canvas_make_texture(struct gl *gl);

/*
 * Enables lighting with one light, number 0: directional, from (0, 0, 1) in eye
 * space, white and diffuse alone. Every other colour of light is black.
 */
void gl_canvas_set_up_light(struct gl *gl);

/*
 * Draws a scene with light, a texture, fog and blending, which uses most calls
 * of GL, and ends the frame. It serves to compare drivers.
 */
void gl_canvas_draw_scene(struct gl_canvas *canvas);

void gl_check_top_row_comes_first(void **state);
void gl_check_a_triangle_covers_its_pixels(void **state);
void gl_check_colours_run_between_vertices(void **state);
void gl_check_flat_triangles_have_their_last_corners_colour(void **state);
void gl_check_the_nearer_hides_the_farther(void **state);
void gl_check_a_texture_lies_the_right_way_up(void **state);
void gl_check_light_falls_off_with_the_angle(void **state);
void gl_check_shininess_and_position_light_count(void **state);
void gl_check_a_spot_lights_what_it_points_at(void **state);
void gl_check_fog_is_linear_between_start_and_end(void **state);
void gl_check_matrices_are_fixed_point(void **state);
void gl_check_the_frustum_shrinks_the_far(void **state);
void gl_check_arrays_of_every_type_draw_the_same(void **state);
void gl_check_elements_of_both_index_types_draw(void **state);
void gl_check_alpha_blends_and_is_tested(void **state);
void gl_check_the_combiner_scales(void **state);
void gl_check_the_stencil_masks(void **state);
void gl_check_565_pictures_are_drawn(void **state);
void gl_check_only_the_pictures_pixels_are_written(void **state);
void gl_check_the_size_may_change_between_frames(void **state);
void gl_check_contexts_may_follow_each_other(void **state);
void gl_check_another_format_is_refused(void **state);

#define GL_CHECK(driver, name) \
	cmocka_unit_test_prestate(gl_check_##name, (void *)(uintptr_t)(driver))
#define GL_CHECKS(driver)                                               \
	GL_CHECK(driver, top_row_comes_first),                          \
		GL_CHECK(driver, a_triangle_covers_its_pixels),         \
		GL_CHECK(driver, colours_run_between_vertices),         \
		GL_CHECK(driver,                                        \
			flat_triangles_have_their_last_corners_colour), \
		GL_CHECK(driver, the_nearer_hides_the_farther),         \
		GL_CHECK(driver, a_texture_lies_the_right_way_up),      \
		GL_CHECK(driver, light_falls_off_with_the_angle),       \
		GL_CHECK(driver, shininess_and_position_light_count),   \
		GL_CHECK(driver, a_spot_lights_what_it_points_at),      \
		GL_CHECK(driver, fog_is_linear_between_start_and_end),  \
		GL_CHECK(driver, matrices_are_fixed_point),             \
		GL_CHECK(driver, the_frustum_shrinks_the_far),          \
		GL_CHECK(driver, arrays_of_every_type_draw_the_same),   \
		GL_CHECK(driver, elements_of_both_index_types_draw),    \
		GL_CHECK(driver, alpha_blends_and_is_tested),           \
		GL_CHECK(driver, the_combiner_scales),                  \
		GL_CHECK(driver, the_stencil_masks),                    \
		GL_CHECK(driver, 565_pictures_are_drawn),               \
		GL_CHECK(driver, only_the_pictures_pixels_are_written), \
		GL_CHECK(driver, the_size_may_change_between_frames),   \
		GL_CHECK(driver, contexts_may_follow_each_other),       \
		GL_CHECK(driver, another_format_is_refused)

#endif

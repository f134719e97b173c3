#include "tests/support/gl/image_scene.h"

#include "tests/support/test.h"

extern const struct display_driver display_driver_image;

int image_scene_open_at(struct image_scene *scene, const char *path,
	int frame_count, double rate_hz)
{
	const struct display_options options = {
		.width = IMAGE_SCENE_WIDTH,
		.height = IMAGE_SCENE_HEIGHT,
		.output = path,
		.frame_count = frame_count,
		.rate_hz = rate_hz,
		.log = &scene->log,
	};

	scene->driver = &display_driver_image;
	scene->display = NULL;
	return scene->driver->create(&options, &scene->display);
}

void image_scene_open(struct image_scene *scene, const char *name,
	int frame_count, double rate_hz)
{
	scene->directory = temp_dir_make();
	scene->path = path_join(&scene->directory, name);
	scene->log = log_capture_begin(&scene->capture);
	assert_int_equal(image_scene_open_at(
				 scene, scene->path.text, frame_count, rate_hz),
		0);
}

void image_scene_close(struct image_scene *scene)
{
	scene->driver->destroy(scene->display);
	temp_dir_remove(&scene->directory);
}

void image_scene_color(int frame, int x, int y, uint8_t rgb[3])
{
	bool square = x >= 2 * frame && x < 2 * frame + 5 && y >= 5 && y < 10;

	rgb[0] = square ? 250 : (uint8_t)(6 * x);
	rgb[1] = square ? 10 : (uint8_t)(12 * y);
	rgb[2] = square ? 20 : 60;
}

int image_scene_draw(struct image_scene *scene, int frame)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	assert_int_equal(pixels.format, PIXELS_RGBA8888);
	assert_int_equal(pixels.width, IMAGE_SCENE_WIDTH);
	assert_int_equal(pixels.height, IMAGE_SCENE_HEIGHT);
	for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
		for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
			uint8_t *pixel =
				pixels.data + y * pixels.stride_bytes + 4 * x;

			image_scene_color(frame, x, y, pixel);
			/* The display ignores alpha. */
			pixel[3] = (uint8_t)(x + frame);
		}
	}
	return scene->driver->end_frame(scene->display);
}

void image_scene_draw_all(struct image_scene *scene, int count)
{
	for (int i = 0; i < count; i++) {
		assert_int_equal(image_scene_draw(scene, i), 0);
	}
	assert_int_equal(scene->driver->finish(scene->display), 0);
	assert_int_equal(scene->capture.count, 0);
}

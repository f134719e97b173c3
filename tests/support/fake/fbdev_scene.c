#include "tests/support/fake/fbdev_scene.h"

#include "tests/support/gl/paint.h"
#include "tests/support/test.h"

#include <linux/kd.h>

extern const struct display_driver display_driver_fbdev;

const struct pixel_layout fbdev_scene_layout_565 = {
	.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};
const struct pixel_layout fbdev_scene_layout_8888 = {
	.bits = 32, .red = {16, 8}, .green = {8, 8}, .blue = {0, 8}};

void fbdev_scene_begin_565(int pages)
{
	fake_fb_begin(FBDEV_SCENE_WIDTH, FBDEV_SCENE_HEIGHT,
		FBDEV_SCENE_HEIGHT * pages, FBDEV_SCENE_HEIGHT,
		FBDEV_SCENE_WIDTH * 2, fbdev_scene_layout_565);
}

int fbdev_scene_open(struct fbdev_scene *scene)
{
	scene->driver = &display_driver_fbdev;
	scene->log = log_capture_begin(&scene->capture);
	scene->options.log = &scene->log;
	scene->display = NULL;
	return fbdev_create_on(&fake_fb_calls, &scene->options, &scene->display);
}

void fbdev_scene_expect_closed(void)
{
	assert_int_equal(fake_fb.open_count, 0);
	assert_int_equal(fake_fb.map_count, 0);
	assert_int_equal(fake_fb.console_mode, KD_TEXT);
}

void fbdev_scene_close(struct fbdev_scene *scene)
{
	scene->driver->destroy(scene->display);
	fbdev_scene_expect_closed();
}

struct pixels fbdev_scene_draw(struct fbdev_scene *scene)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	paint_all(&pixels, 132, 132, 132);
	paint_pixel(&pixels, 0, 0, 255, 0, 0);
	paint_pixel(&pixels, pixels.width - 1, 0, 0, 255, 0);
	paint_pixel(&pixels, 0, pixels.height - 1, 0, 0, 255);
	paint_pixel(&pixels, pixels.width - 1, pixels.height - 1, 255, 255, 255);
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
	return pixels;
}

void fbdev_scene_expect_corners(
	uint32_t red, uint32_t green, uint32_t blue, uint32_t white)
{
	assert_int_equal(fake_fb_seen(0, 0), red);
	assert_int_equal(fake_fb_seen(FBDEV_SCENE_WIDTH - 1, 0), green);
	assert_int_equal(fake_fb_seen(0, FBDEV_SCENE_HEIGHT - 1), blue);
	assert_int_equal(
		fake_fb_seen(FBDEV_SCENE_WIDTH - 1, FBDEV_SCENE_HEIGHT - 1),
		white);
}

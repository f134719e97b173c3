#include "app/scene/stage/live.h"

#include "platform/base/scalar.h"

#include <string.h>

/* Mean difference of two images' luma, of 255, at which the level is 1. */
static const float full_motion = 6.0f;
/* Time constants with which smooth_level rises and falls. */
static const float rise_s = 0.08f, fall_s = 0.45f;

static const char *const names[LIVE_USES] = {
	[LIVE_BACKGROUND] = "background",
	[LIVE_SCREEN] = "screen",
	[LIVE_MOTION] = "motion",
	[LIVE_OFF] = "off",
};

enum live_use live_use_find(const char *name)
{
	int use = 0;

	while (use < LIVE_USES && strcmp(name, names[use]) != 0) {
		use++;
	}
	return (enum live_use)use;
}

int live_init(struct live *live, const struct camera_feed *feed,
	enum live_use use, bool smooth, const struct gl *gl,
	const struct log *log)
{
	int error = 0;

	live->use = use;
	live->showing = false;
	if (feed && feed->driver) {
		error = live_texture_init(&live->texture, gl, smooth, log);
		live->feed = error ? NULL : feed;
	}
	return error;
}

void live_set_stage(struct live *live, const struct stage *stage, float aspect)
{
	live->yaw_rad = stage->camera.yaw_rad;
	live->pitch_rad = stage->camera.pitch_rad;
	monitor_init(&live->monitor);
	monitor_place(&live->monitor, &stage->camera, aspect, stage->floor.y);
}

/*
 * Places the monitor anew, because the camera may frame another box by now. The
 * user's orbits and zooms are undone for this: they do not move the monitor.
 */
static void place_monitor(
	struct live *live, const struct stage *stage, float aspect)
{
	struct camera home = stage->camera;

	camera_orbit(&home, live->yaw_rad - home.yaw_rad,
		live->pitch_rad - home.pitch_rad);
	camera_zoom(&home, 1.0f / home.fit.zoom);
	monitor_place(&live->monitor, &home, aspect, stage->floor.y);
}

void live_finish(struct live *live, const struct gl *gl)
{
	if (live->feed) {
		live_texture_finish(&live->texture, gl);
		live->feed = NULL;
	}
}

static void use_image(struct live *live, const struct gl *gl,
	const struct camera_image *image, int width, int height)
{
	if (live->use == LIVE_BACKGROUND) {
		live_texture_update(&live->texture, gl, image, width, height);
	} else if (live->use == LIVE_SCREEN) {
		live_texture_update(&live->texture, gl, image, 4, 3);
	} else if (live->use == LIVE_MOTION) {
		float change =
			(float)camera_motion_feed(&live->seen, image) / 256.0f;

		live->level = scalar_clamp(
			scalar_sqrt(change / full_motion), 0.0f, 1.0f);
	}
}

static void smooth_motion(struct live *live, float step_s)
{
	float change = live->level - live->smooth_level;
	float time_s = change > 0.0f ? rise_s : fall_s;

	live->smooth_level += change * (1.0f - scalar_exp(-step_s / time_s));
}

static void show_on_stage(const struct live *live, struct stage *stage)
{
	bool filled = live->showing && live->texture.width > 0;
	const struct live_texture *picture = filled ? &live->texture : NULL;

	stage->backdrop = live->use == LIVE_BACKGROUND ? picture : NULL;
	stage->monitor = live->use == LIVE_SCREEN ? &live->monitor : NULL;
	stage->monitor_picture = picture;
}

void live_update(struct live *live, const struct gl *gl, struct stage *stage,
	double time_s, int width, int height)
{
	struct camera_image image;
	enum camera_status news;

	if (!live->feed) {
		return;
	}
	news = live->feed->driver->take(
		live->feed->source, (int64_t)(time_s * 1000.0), &image);
	if (news == CAMERA_NEW) {
		use_image(live, gl, &image, width, height);
		live->feed->driver->give_back(live->feed->source);
	}
	live->showing = news != CAMERA_NONE;
	if (!live->showing) {
		live->level = 0.0f;
		camera_motion_reset(&live->seen);
	}
	smooth_motion(live, (float)(time_s - live->now_s));
	live->now_s = time_s;
	if (live->use == LIVE_SCREEN) {
		place_monitor(live, stage, (float)width / (float)height);
	}
	show_on_stage(live, stage);
}

void live_next_use(struct live *live)
{
	live->use = (enum live_use)((live->use + 1) % LIVE_USES);
	/* The image in the texture has another use's aspect. */
	live->texture.width = live->texture.height = 0;
	live->level = 0.0f;
	camera_motion_reset(&live->seen);
}

bool live_controls_motion(const struct live *live)
{
	return live->feed && live->use == LIVE_MOTION;
}

int live_label_rows(const struct live *live)
{
	if (!live->feed) {
		return 0;
	}
	return live_controls_motion(live) && live->showing ? 2 : 1;
}

void live_label(const struct live *live, struct hud *hud)
{
	struct hud_group group;

	if (!live->feed) {
		return;
	}
	group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
	if (live_controls_motion(live) && live->showing) {
		hud_group_weight(
			&group, "motion", live->smooth_level, hud_color_amber);
		hud_group_end(&group);
		return;
	}
	hud_group_text(&group, "live",
		live->use == LIVE_OFF || live->showing ? names[live->use]
						       : "no picture");
	hud_group_end(&group);
}

#include "app/demo/live.h"

#include <string.h>

static const char *const names[LIVE_USES] = {
	[LIVE_BACKGROUND] = "background",
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

const char *live_use_name(enum live_use use)
{
	return (unsigned int)use < LIVE_USES ? names[use] : NULL;
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
	}
}

void live_update(struct live *live, const struct gl *gl, struct stage *stage,
	double time_s, int width, int height)
{
	struct camera_image image;
	enum camera_news news;

	if (!live->feed) {
		return;
	}
	news = live->feed->driver->take(
		live->feed->source, (int64_t)(time_s * 1000.0), &image);
	if (news == CAMERA_NEW) {
		use_image(live, gl, &image, width, height);
		live->feed->driver->give_back(live->feed->source);
	}
	live->showing = news != CAMERA_NONE && live->texture.width > 0;
	stage->backdrop = live->showing && live->use == LIVE_BACKGROUND
		? &live->texture
		: NULL;
}

void live_next_use(struct live *live)
{
	live->use = (enum live_use)((live->use + 1) % LIVE_USES);
	/* What the texture holds was cut for another use. */
	live->texture.width = live->texture.height = 0;
}

void live_label(const struct live *live, struct hud *hud)
{
	struct hud_group group;

	if (!live->feed) {
		return;
	}
	group = hud_group_begin(hud, HUD_BOTTOM_RIGHT, NULL);
	hud_group_text(&group, "camera",
		live->use == LIVE_OFF || live->showing ? names[live->use]
						       : "no picture");
	hud_group_end(&group);
}

/*
 * What a demo does with a camera's picture: background, a screen on the stage,
 * or a motion that somebody makes before the camera.
 *
 * Without a camera, and while it has no picture, everything is as if there
 * were none, but for the screen, which is dark.
 */
#ifndef APP_DEMO_LIVE_H
#define APP_DEMO_LIVE_H

#include "app/scene/draw/live_texture.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/stage/monitor.h"
#include "app/scene/stage/stage.h"
#include "platform/camera/camera.h"
#include "platform/camera/motion.h"

enum live_use {
	LIVE_BACKGROUND,
	LIVE_SCREEN,
	LIVE_MOTION,
	LIVE_OFF,
	LIVE_USES,
};

struct live {
	const struct camera_feed *feed; /* not owned; NULL: no camera */
	enum live_use use;
	bool showing; /* there is a picture */
	struct live_texture texture;
	struct monitor monitor;
	struct camera_motion seen;
	float level;        /* how much moves now, 0..1 */
	float smooth_level; /* the same, smoothed: quick to rise, slow to fall */
	double now_s;
};

/* "background" and so on; LIVE_USES and NULL for what is none. */
enum live_use live_use_find(const char *name);
const char *live_use_name(enum live_use use);

/*
 * feed may be NULL. 0, or -ENOMEM after
 * a sentence with nothing left.
 */
int live_init(struct live *live, const struct camera_feed *feed,
	enum live_use use, bool smooth, const struct gl *gl,
	const struct log *log);

/* Finds room for a screen on the stage, seen in pictures of this aspect. */
void live_set_stage(struct live *live, const struct stage *stage, float aspect);

/* Once without an effect. */
void live_finish(struct live *live, const struct gl *gl);

/*
 * Takes the newest picture for the frame of this time and this size, and tells
 * the stage what to show of it. No allocation, no waiting.
 */
void live_update(struct live *live, const struct gl *gl, struct stage *stage,
	double time_s, int width, int height);

/* The next use of the picture, and after the last one none. */
void live_next_use(struct live *live);

/* Whether what moves before the camera shall move the figure. */
bool live_controls_motion(const struct live *live);

/* Says on the picture what it is used for, if there is a camera. */
void live_label(const struct live *live, struct hud *hud);

#endif

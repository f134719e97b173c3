/*
 * A demo's use of a video camera: its image is the background or is shown on a
 * monitor on the stage, or its motion moves the figure.
 *
 * Without a camera, or while it has no image, everything is as usual, except
 * that the monitor is dark.
 */
#ifndef APP_SCENE_STAGE_LIVE_H
#define APP_SCENE_STAGE_LIVE_H

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
	const struct camera_feed *feed; /* not owned; NULL without a camera */
	enum live_use use;
	bool showing; /* the camera has an image */
	struct live_texture texture;
	struct monitor monitor;
	float yaw_rad, pitch_rad; /* of the camera that the monitor faces */
	struct camera_motion seen;
	float level;        /* of motion in the last image, 0..1 */
	float smooth_level; /* rises quickly and falls slowly */
	double now_s;
};

/* Returns the use of that name, such as "background", or LIVE_USES. */
enum live_use live_use_find(const char *name);

/*
 * Prepares the use of a camera; feed may be NULL. Returns 0, or -ENOMEM after
 * logging an error; then nothing is left to release.
 */
int live_init(struct live *live, const struct camera_feed *feed,
	enum live_use use, bool smooth, const struct gl *gl,
	const struct log *log);

/*
 * Places the monitor on the stage for pictures of this aspect. live_update()
 * keeps it beside what the camera frames, wherever the camera orbits to.
 */
void live_set_stage(struct live *live, const struct stage *stage, float aspect);

/* Releases the texture; may be called again. */
void live_finish(struct live *live, const struct gl *gl);

/*
 * Takes the camera's newest image for the frame at time_s with this size, and
 * sets the stage's backdrop and monitor. It neither allocates nor waits.
 */
void live_update(struct live *live, const struct gl *gl, struct stage *stage,
	double time_s, int width, int height);

/* Selects the next use; "off" is one of them. */
void live_next_use(struct live *live);

/* Returns true if motion before the camera moves the figure. */
bool live_controls_motion(const struct live *live);

/* The rows that the label takes, of which a bar is one; 0 without a camera. */
int live_label_rows(const struct live *live);

/* Adds a label that names the use, if there is a camera. */
void live_label(const struct live *live, struct hud *hud);

#endif

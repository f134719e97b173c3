/*
 * Demos: programs of motion that buttons steer.
 *
 * A demo owns what it shows and draws it on a stage. It sees time and buttons
 * as inputs and nothing of the display, so the same run gives the same frames
 * anywhere. One file a demo; demo.c holds the list.
 */
#ifndef APP_DEMO_DEMO_H
#define APP_DEMO_DEMO_H

#include "app/anim/clip.h"
#include "app/anim/kernel/kernel.h"
#include "app/demo/live.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/instance/influence_cap.h"
#include "app/scene/instance/lod.h"
#include "platform/base/log.h"
#include "platform/buttons/buttons.h"
#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

struct demo;

/* What a demo is given; all of it outlives the demo. */
struct demo_env {
	const struct log *log;
	const struct gl *gl;
	enum pixel_format target;
	const struct kernel *kernel;
	int width, height;      /* of the picture, at the start */
	const char *model_path; /* the file to show */
	const char *clip;       /* name or number to begin with, or NULL */
	enum clip_interpolation interpolation;
	enum clip_repeat repeat;            /* of the user's model's clips */
	float speed;                        /* likewise, negative: backwards */
	struct influence_cap influence_cap; /* influences a vertex */
	struct lod lod;                     /* triangles */
	int walkers;                        /* of a crowd; 0: as it likes */
	bool follow_file;        /* show the model anew when it changes */
	int64_t (*now_ns)(void); /* measures; NULL where times must repeat */
	bool unattended;         /* nobody will press a button: show things */
	const struct camera_feed *camera; /* live pictures, or NULL */
	enum live_use camera_use;         /* at the start */
	bool smooth;                      /* blend enlarged live pictures */
};

/* What a demo shows, for whoever measures. */
struct demo_facts {
	const char *technique; /* "Skeletal" */
	long triangles;        /* of models, each once, as they are drawn */
};

/* Something a button does. */
struct demo_action {
	enum button button;
	const char *summary;
	void (*run)(struct demo *demo, bool down);
};

struct demo_driver {
	const char *name;
	const char *summary;
	const char *asset; /* a file of assets/, or NULL: the user's model */
	const struct demo_action *action; /* a NULL run ends it */

	/* Of the demo's own struct, which begins with a struct demo_base. */
	size_t size;

	/*
	 * The act's actor is loaded, all else is zero: prepares the rest and,
	 * last, sets the stage. 0, or -errno after a sentence.
	 */
	int (*prepare)(struct demo *demo, const struct demo_env *env);

	/* Releases what prepare() and presses took. Optional. */
	void (*finish)(struct demo *demo);

	/* Moves on to time_s, which never runs backwards. No allocation. */
	void (*update)(struct demo *demo, double time_s);

	/* Draws a frame of this size. No allocation. */
	void (*draw)(struct demo *demo, int width, int height);

	/* Seconds after which it repeats: how long an animation file runs. */
	double (*period_s)(const struct demo *demo);

	/* Says on the picture what runs: technique, clip, time, weight. */
	void (*label)(const struct demo *demo, struct hud *hud);

	/* Optional: NULL where the actor is all there is. */
	void (*get_facts)(const struct demo *demo, struct demo_facts *out);
};

/* All demos, NULL at the end; the first is the default. */
extern const struct demo_driver *const demo_registry[];

/* Shows any model; not in the registry because it needs a file's name. */
extern const struct demo_driver demo_driver_viewer;

/* The demo of that name, or NULL. */
const struct demo_driver *demo_find(const char *name);

/*
 * Loads the model, then prepares the demo. 0, or -errno after a sentence with
 * nothing left behind. Release with demo_destroy().
 */
int demo_create(const struct demo_driver *driver, const struct demo_env *env,
	struct demo **out);

/* NULL is fine. */
void demo_destroy(const struct demo_driver *driver, struct demo *demo);

/* What to leave out to keep a budget; all zero: nothing. */
struct demo_reduction {
	float error_px;     /* of coarser triangles, at least; 0: as it is */
	int max_influences; /* of any vertex; 0: all */
	bool hold_normals;  /* as they are */
};

/* From the next update on. */
void demo_set_reduction(
	struct demo *demo, const struct demo_reduction *reduction);

/* How many frames a second there are; 0: not known. For labels. */
void demo_set_rate(struct demo *demo, float frames_per_s);

/*
 * Looks at the camera, for the frame of this time and size; before draw(). A
 * demo without a camera is fine.
 */
void demo_update_live(struct demo *demo, double time_s, int width, int height);

/* The demo's own labels, and what the camera is for. */
void demo_label(const struct demo_driver *driver, const struct demo *demo,
	struct hud *hud);

/* What it shows now. */
struct demo_facts demo_get_facts(
	const struct demo_driver *driver, const struct demo *demo);

/* Runs the demo's action for this button, if it has one. */
void demo_press(const struct demo_driver *driver, struct demo *demo,
	const struct button_event *event);

/* The next of enum live_use; without a camera it does nothing. */
void demo_next_camera_use(struct demo *demo);

#endif

/*
 * What the program gives a demo: its environment when it is created, and
 * reductions of quality later.
 */
#ifndef APP_DEMO_DEMO_ENV_H
#define APP_DEMO_DEMO_ENV_H

#include "app/anim/clip.h"
#include "app/anim/kernel/kernel.h"
#include "app/character/character_open.h"
#include "app/scene/instance/influence_cap.h"
#include "app/scene/instance/lod.h"
#include "app/scene/overlay/overlay_kind.h"
#include "app/scene/stage/live.h"
#include "platform/base/log.h"
#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

/* What a demo is created with. Everything it points to outlives the demo. */
struct demo_env {
	const struct log *log;
	const struct gl *gl;
	enum pixel_format target;
	const struct kernel *kernel;
	int width, height;      /* of the picture, initially */
	bool no_labels;         /* the picture will have no labels */
	bool frame_times;       /* it will have the graph of frame times */
	const char *model_path; /* the model file to show */
	size_t memory_bytes;    /* budget of the model; 0: MODEL_MEMORY_BYTES */
	const char *character;  /* a character file, "none", or NULL: the one
				   beside the model if there is one */
	const char *clip;       /* name or index of the first clip, or NULL */
	enum clip_interpolation interpolation;
	enum clip_repeat repeat; /* viewer only */
	bool all_loop;           /* the user has asked for CLIP_LOOP */
	float speed;             /* viewer only; below 0: backwards */
	struct influence_cap influence_cap; /* most influences a vertex */
	struct lod lod;                     /* level of detail */
	int walkers;      /* of the crowd; 0: the demo's default */
	bool follow_file; /* reload the model when its file changes */
	bool may_save;    /* a button may write a file, such as presets */
	int64_t (*now_ns)(
		void);   /* clock to measure times; NULL: do not measure */
	bool unattended; /* nobody presses buttons: show everything */
	const struct camera_feed *camera; /* video camera, or NULL */
	enum live_use camera_use;         /* initially */
	bool smooth;                      /* filter camera images linearly */
	struct overlay_choice overlays;   /* initially */
};

/* Returns the request for the character that env asks for. */
static inline struct character_request demo_env_request(
	const struct demo_env *env)
{
	return (struct character_request){.model_path = env->model_path,
		.file = env->character,
		.clip = env->clip,
		.rate = env->speed,
		.repeat = env->repeat,
		.all_loop = env->all_loop};
}

/* How a demo reduces quality to keep a frame budget; all zero: not at all. */
struct demo_reduction {
	float error_px;     /* error to allow for triangles; 0: unchanged */
	int max_influences; /* a vertex; 0: all */
	bool hold_normals;  /* see instance.hold_normals */
};

#endif

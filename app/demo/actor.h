/*
 * An actor is a loaded model with its instance and textures. struct demo_base
 * has the members that all demos share.
 */
#ifndef APP_DEMO_ACTOR_H
#define APP_DEMO_ACTOR_H

#include "app/anim/clip.h"
#include "app/demo/demo_env.h"
#include "app/scene/draw/texture.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/instance/instance.h"
#include "app/scene/overlay/overlay.h"
#include "app/scene/shadow/shadow_figure.h"
#include "app/scene/stage/framing.h"
#include "app/scene/stage/live.h"
#include "app/scene/stage/stage.h"

struct actor {
	struct model *model;
	struct instance *instance;
	struct texture_set textures;
	struct clip_cursor cursor;
	enum clip_interpolation interpolation;
	struct influence_cap influence_cap;
	int influence_limit; /* lowers a higher cap; 0: no limit */
	struct lod lod;
	float min_error_px; /* raises a smaller error of lod; 0: no effect */
	float extent;       /* longest side of the rest pose, scene units */
	struct shadow_ground ground; /* a ground that is part of the model */
	/* on that ground, in demos that show the instance itself; or NULL */
	struct shadow_figure *shadow;
};

/* Every demo's struct begins with this one. */
struct demo_base {
	const struct gl *gl;
	struct actor actor;
	struct stage stage;
	struct live live;
	struct demo_reduction reduction;
	float frames_per_s; /* 0 if unknown */
	int width, height;  /* of the pictures that the camera frames */
	struct framing framing;

	struct log log;
	struct overlay *overlay;        /* NULL before any is shown */
	unsigned overlays_of_old_model; /* kinds to show for the new model */
	struct framing_below below; /* rows of labels below the figure now */
	float room_below; /* part of the region's bottom that small pictures cover */
	unsigned held; /* a bit for each enum button that is down */
};

/*
 * Loads the model that env names. Returns 0, or -errno after logging an error;
 * then nothing is left to release. Release it with actor_unload().
 */
int actor_load(struct actor *actor, const struct demo_env *env);

void actor_unload(struct actor *actor, const struct gl *gl);

/* Leaves out of the actor what base->reduction says. */
void actor_reduce(struct demo_base *base);

/*
 * Makes a stage whose camera frames bounds (scene units) in the part of the
 * picture that framing_region() leaves free, and keeps framing in base. The
 * aspect and region of framing->camera are ignored. unit is that of
 * floor_init(). Returns 0, or -errno after logging an error.
 */
int actor_init_stage(struct demo_base *base, const struct demo_env *env,
	const struct bounds *bounds, float unit, const struct framing *framing,
	struct stage *stage);

/*
 * Frames the same figures in pictures of this size, beside the current labels.
 * A camera whose framing has follow unset stays as it is.
 */
void actor_reframe_stage(struct demo_base *base, int width, int height);

/*
 * Computes the instance's vertices and chooses its triangles for a picture of
 * this height in pixels, as influence_cap and lod say.
 */
void actor_update(
	struct actor *actor, const struct camera *camera, int picture_height);

#endif

/*
 * An actor is a loaded model with its instance and textures. struct demo_base
 * is what every demo consists of besides its own state.
 */
#ifndef APP_DEMO_ACTOR_H
#define APP_DEMO_ACTOR_H

#include "app/anim/clip.h"
#include "app/demo/demo_env.h"
#include "app/scene/draw/texture.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/instance/instance.h"
#include "app/scene/overlay/overlay.h"
#include "app/scene/shadow/shadow_ground.h"
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
	int influence_limit; /* overrides a higher cap; 0: no limit */
	struct lod lod;
	float min_error_px; /* overrides a smaller error of lod; 0: none */
	float extent;       /* in the rest pose, scene units */
	struct shadow_ground ground; /* of the model's own */
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
	unsigned overlays_of_old_model; /* kinds to show for the new one */
	struct framing_below below;     /* that labels show now */
	float room_below; /* raises the region's bottom for what stands there */
};

/*
 * Loads the model that env names. Returns 0, or -errno after logging an error;
 * then nothing is left to release. Release it with actor_unload().
 */
int actor_load(struct actor *actor, const struct demo_env *env);

void actor_unload(struct actor *actor, const struct gl *gl);

/*
 * Makes a stage that frames the box in framing_region() of a picture of the
 * base's size, and keeps the framing. Its camera's aspect and region are
 * ignored. Returns 0, or -errno after logging an error.
 */
int actor_init_stage(struct demo_base *base, const struct demo_env *env,
	const struct bounds *bounds, const struct framing *framing,
	struct stage *stage);

/*
 * Frames the same figures in pictures of this size, beside what labels show
 * now. Cameras that do not follow stay as they are.
 */
void actor_reframe_stage(struct demo_base *base, int width, int height);

/*
 * Updates the instance for a picture of this height, with the influences and
 * triangles that influence_cap and lod allow.
 */
void actor_update(
	struct actor *actor, const struct camera *camera, int picture_height);

#endif

/*
 * A model on stage: file, instance and textures together, and what every demo
 * has beside it.
 */
#ifndef APP_DEMO_ACTOR_H
#define APP_DEMO_ACTOR_H

#include "app/anim/clip.h"
#include "app/anim/fade.h"
#include "app/demo/demo.h"
#include "app/demo/live.h"
#include "app/scene/draw/texture.h"
#include "app/scene/instance/instance.h"
#include "app/scene/stage/stage.h"

struct actor {
	struct model *model;
	struct instance *instance;
	struct texture_set textures;
	struct clip_cursor cursor;
	enum clip_interpolation interpolation;
	struct fade fade; /* for whoever changes clips */
	struct influence_cap influence_cap;
	int influence_limit; /* whatever lod says; 0: no limit */
	struct lod lod;
	float min_error_px; /* whatever lod says; 0: as it says */
	float extent;       /* at rest, scene units */
};

/* What every demo's struct begins with. */
struct demo_base {
	const struct gl *gl;
	struct actor actor;
	struct stage stage;
	struct live live;
	struct demo_reduction reduction;
	float frames_per_s; /* 0: not known */
};

/* Loads env's model. 0, or -errno after a sentence with nothing left behind. */
int actor_load(struct actor *actor, const struct demo_env *env);

void actor_unload(struct actor *actor, const struct gl *gl);

/*
 * A stage that frames the box, see bounds_of_clip(). The framing's aspect is
 * filled in from env. 0, or -errno after a sentence.
 */
int actor_init_stage(const struct demo_env *env, const struct bounds *bounds,
	struct camera_framing framing, struct stage *stage);

/* A whole frame with only this actor on the stage, shadow included. */
void actor_draw(const struct actor *actor, const struct stage *stage,
	const struct gl *gl, int width, int height);

/*
 * The frame's work for a picture of this height: influences and triangles as
 * many as the levels of detail say, and instance_update().
 */
void actor_update(
	struct actor *actor, const struct camera *camera, int picture_height);

/* Triangles alone, for whoever does not update the instance. */
void actor_choose_lod(
	struct actor *actor, const struct camera *camera, int picture_height);

/* Says how many influences are used where some are left out. */
void actor_label_lod(const struct actor *actor, struct hud_group *group);

/* The technique that moves most of it: "Skeletal" and so on. */
const char *actor_technique(const struct instance *instance);

/* The node of that name. 0, or -EINVAL after a sentence. */
int actor_find_bone(const struct model *model, const char *name,
	const struct log *log, int *out);

/* Puts the pose at a clip's time, nodes without a channel at rest. */
void actor_pose(struct actor *actor, int clip, float time_s);

#endif

/*
 * Draws a character on its stage, with its shadows, its cape and the balls of
 * targets.
 */
#ifndef APP_CHARACTER_SHOW_CHARACTER_DRAW_H
#define APP_CHARACTER_SHOW_CHARACTER_DRAW_H

#include "app/character/show/character_bounds.h"
#include "app/scene/draw/texture.h"
#include "app/scene/instance/reach.h"
#include "app/scene/shadow/shadow_drape.h"
#include "app/scene/shadow/shadow_ground.h"
#include "app/scene/stage/ball.h"
#include "app/scene/stage/stage.h"

struct character_drawing {
	const struct character *character; /* not owned */
	struct character_bounds bounds;
	struct ball ball;
	struct shadow_ground ground; /* ground that the model has itself */
	/* If the ground may be uneven: */
	bool may_wave;
	struct reach reach;
	struct shadow_drape drape;  /* also if the model's own ground is */
	struct shadow_cloth *cloth; /* [character->cape_count], of the drape */
};

/*
 * Measures the character and prepares its shadow; see character_bounds_init().
 * ground is what shadow_ground_find() found of the character's instance.
 * Memory comes from the instance's arena. Returns 0, or -ENOMEM after logging
 * an error.
 */
int character_draw_init(struct character_drawing *drawing,
	struct character *character, const struct shadow_ground *ground,
	const struct log *log);

/* Lays the shadow of the updated instance upon uneven ground. */
void character_draw_update(
	struct character_drawing *drawing, const struct stage *stage);

/*
 * Returns the boxes, a little larger than needed, of what character_draw() will
 * draw after the last update. On ground that is always level, the content is
 * not bounded.
 */
struct floor_content character_draw_content(
	const struct character_drawing *drawing, const struct stage *stage);

/* Draws what stands on the stage; call stage_begin() before. */
void character_draw(const struct character_drawing *drawing,
	const struct stage *stage, const struct texture_set *textures,
	const struct gl *gl);

#endif

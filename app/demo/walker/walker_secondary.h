/*
 * The walker's secondary motion: the ponytail, a chain of springs, and the
 * cape, a cloth.
 */
#ifndef APP_DEMO_WALKER_WALKER_SECONDARY_H
#define APP_DEMO_WALKER_WALKER_SECONDARY_H

#include "app/anim/procedural/cloth.h"
#include "app/anim/procedural/spring.h"
#include "app/scene/draw/draw.h"
#include "app/scene/instance/instance.h"

enum {
	CAPE_COLUMNS = 13,
	CAPE_ROWS = 10,
	CAPE_INDICES = 6 * (CAPE_COLUMNS - 1) * (CAPE_ROWS - 1),
	BODY_CAPSULES = 8,
};

struct walker_secondary {
	struct capsule body[BODY_CAPSULES];
	struct spring ponytail;
	struct cloth cape;
	uint16_t cape_index[CAPE_INDICES];
};

/*
 * Finds the bones of an instance in its rest pose. Memory comes from the
 * instance's arena. Returns 0, or -errno after logging an error, which names a
 * missing bone.
 */
int walker_secondary_init(struct walker_secondary *secondary,
	struct instance *instance, const struct log *log);

/*
 * Moves on by step_s in the head wind of a forward speed. ponytail_weight,
 * 0..1, blends the ponytail's bones from the pose to their swing. The cape is
 * only simulated if with_cape is true. Leaves the world matrices up to date.
 */
void walker_secondary_update(struct walker_secondary *secondary,
	struct instance *instance, float speed_m_per_s, float ponytail_weight,
	bool with_cape, float step_s);

/* Resets the cape to its shape at rest, as when it is put on. */
void walker_secondary_reset_cape(struct walker_secondary *secondary);

/*
 * Draws the cape, for DRAW_SHADED with two-sided lighting and as opaque as its
 * weight, 0..1.
 */
void walker_secondary_draw_cape(const struct walker_secondary *secondary,
	const struct gl *gl, enum draw_pass pass, float weight);

#endif

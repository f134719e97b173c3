/*
 * What trails behind the walker: the ponytail and a cape.
 */
#ifndef APP_DEMO_WALKER_WALKER_SECONDARY_H
#define APP_DEMO_WALKER_WALKER_SECONDARY_H

#include "app/anim/procedural/cloth.h"
#include "app/anim/procedural/spring.h"
#include "app/scene/draw/draw.h"
#include "app/scene/instance/instance.h"

enum {
	CAPE_COLUMNS = 9,
	CAPE_ROWS = 11,
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
 * The instance stands at rest; memory for the cape is its arena's. 0, or
 * -errno after a sentence that names a missing bone.
 */
int walker_secondary_init(struct walker_secondary *secondary,
	struct instance *instance, const struct log *log);

/*
 * Goes on by step_s in the wind of a forward speed. The ponytail's bones are
 * turned by as much as hair says, 0..1; the cape costs nothing while it is
 * not worn. World matrices stay up to date.
 */
void walker_secondary_update(struct walker_secondary *secondary,
	struct instance *instance, float speed_m_per_s, float hair, bool caped,
	float step_s);

/* The cape starts anew at rest, as when it is put on. */
void walker_secondary_reset_cape(struct walker_secondary *secondary);

/* The cape, lit from both sides, or as a shape in the current colour. */
void walker_secondary_draw_cape(const struct walker_secondary *secondary,
	const struct gl *gl, enum draw_pass pass);

#endif

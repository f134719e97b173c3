/*
 * The operation of a cape (effects.h).
 */
#include "app/character/run/effects.h"

/* Air pushes with the square of the speed: a cape hangs while walking. */
static const float wind_s_per_m = 0.17f;

void character_cape_run(struct character *character, void *what)
{
	struct character_cape *cape = what;
	struct capsule_world body[CHARACTER_CAPE_BODIES];
	const float *ground = character->motion.velocity;
	mat4 *world = character->instance->world;
	float speed =
		scalar_sqrt(ground[0] * ground[0] + ground[1] * ground[1]) /
		character->metre;

	if (cape->is.now == 0) {
		cape->worn = false;
		return;
	}
	if (!cape->worn) {
		cloth_reset(&cape->cloth);
		cape->worn = true;
	}
	capsule_to_world(
		cape->body, cape->body_count, (const mat4 *)world, body);
	/* The figure moves on the spot, so the air moves instead. */
	cape->cloth.settings.wind[0] = -ground[0] * speed * wind_s_per_m;
	cape->cloth.settings.wind[2] = -ground[1] * speed * wind_s_per_m;
	cloth_update(&cape->cloth, character->step_s, body, cape->body_count,
		(const mat4 *)world);
}

/*
 * Operations that move bones without a clip, each with its switch and fade.
 */
#ifndef APP_CHARACTER_RUN_EFFECTS_H
#define APP_CHARACTER_RUN_EFFECTS_H

#include "app/anim/procedural/breath.h"
#include "app/anim/procedural/cloth.h"
#include "app/anim/procedural/ik.h"
#include "app/anim/procedural/lookat.h"
#include "app/anim/procedural/muscle.h"
#include "app/anim/procedural/procedural.h"
#include "app/anim/procedural/spring.h"
#include "app/character/character_data.h"

enum {
	CHARACTER_BONES_MAX = 8
};

/* All begin with their switch. */
struct character_shake {
	struct character_switch is;
	struct procedural swing;
	float delay_s;
	int preset_count; /* presets of the file; 0: there is no file */
	struct procedural_preset *preset;

	/* Changes: */
	int chosen; /* index in preset */
};

/* Bones that share a look: each of them turns by its share of what is left. */
struct character_look {
	struct character_switch is;
	struct character_target *target;
	int bone_count;
	struct lookat bone[CHARACTER_BONES_MAX];
	float share[CHARACTER_BONES_MAX];
};

struct character_reach {
	struct character_switch is;
	struct character_target *target;
	bool is_chain;
	struct ik_limb limb;
	struct ik_chain chain;
	float short_m; /* the tip stops this far before the target */
	bool has_pole;
	float pole[3]; /* from the target; the middle joint bends towards it */
	bool has_grip;
	float grip[3]; /* the target's place in the tip's frame */
};

/* Bones that turn about an axis, such as fingers that close. */
struct character_turn {
	struct character_switch is;
	int bone_count;
	int bone[CHARACTER_BONES_MAX];
	float axis[3]; /* unit, of the model at rest */
	float bone_axis[CHARACTER_BONES_MAX][3]; /* the same for each bone */
	float angle_rad;
	enum {
		CHARACTER_FROM_CLIP,
		CHARACTER_FROM_REST
	} from; /* the rotation from which they turn */
};

struct character_spring {
	struct character_switch is;
	struct spring spring;
	float gravity[3]; /* without the wind of the figure's motion */
	int body_count;
	struct capsule body[CHARACTER_BONES_MAX];
};

struct character_breath {
	struct character_switch is;
	struct breath breath;
};

struct character_muscle {
	struct character_switch is;
	struct muscle muscle;
	float swell[3]; /* at weight 1 */
};

enum {
	CHARACTER_CAPES_MAX = 4,
	CHARACTER_CAPE_BODIES = 12
};

/* A cloth that hangs from a bone, with its shape at rest in metres. */
struct character_cape {
	struct character_switch is;
	int bone;
	float place[3]; /* the middle of its upper edge, of the model at rest */
	float width, length;
	float flare; /* width of the hem / width of the upper edge */
	float pleat; /* depth of its pleats at the hem */
	/* How far the ends of the upper edge are below and before its middle. */
	float shoulders[2];
	float radius; /* distance that is kept from bodies */
	float color[3];
	struct cloth cloth;
	uint16_t *index; /* of its triangles */
	int index_count;
	int body_count;
	struct capsule body[CHARACTER_CAPE_BODIES];

	/* Changes: */
	bool worn; /* the cape was shown in the last frame */
};

void character_shake_run(struct character *character, void *shake);
void character_look_run(struct character *character, void *look);
void character_reach_run(struct character *character, void *reach);
void character_turn_run(struct character *character, void *turn);
void character_spring_run(struct character *character, void *spring);
void character_breath_run(struct character *character, void *breath);
void character_muscle_run(struct character *character, void *muscle);
void character_cape_run(struct character *character, void *cape);

/* Makes a shake use another one of its presets: an action CHARACTER_PRESET. */
void character_shake_use(
	struct character *character, const struct character_action *action);

/* Computes where the targets are. World matrices must be up to date. */
void character_targets_update(struct character *character);

#endif

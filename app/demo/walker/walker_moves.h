/*
 * Which clips the walker plays.
 *
 * A gait fills the pose; changing it fades from whatever is shown. A jump
 * takes its place for as long as it lasts. A wave is a layer over either: its
 * own clip on one arm alone, by a mask.
 */
#ifndef APP_DEMO_WALKER_WALKER_MOVES_H
#define APP_DEMO_WALKER_WALKER_MOVES_H

#include "app/anim/clip.h"
#include "app/anim/fade.h"
#include "app/scene/instance/instance.h"

/* Gaits first, from slow to fast. */
enum walker_move {
	MOVE_IDLE,
	MOVE_WALK,
	MOVE_RUN,
	MOVE_JUMP,
	MOVE_WAVE,
	MOVE_COUNT,
	GAIT_COUNT = MOVE_RUN + 1,
};

struct walker_moves {
	int clip[MOVE_COUNT];
	enum walker_move gait, move;
	double move_s; /* since the move began */
	float ground_m_per_s;
	struct fade fade;
	struct clip_cursor cursor[2];
	struct pose before; /* what was shown, before any layer */

	double wave_s; /* since the wave began; negative: none */
	struct pose wave;
	float *wave_mask;
	float wave_weight;
};

/*
 * Finds the clips; memory is the instance's arena's. 0, or -errno after a
 * sentence that names a missing clip or bone.
 */
int walker_moves_init(struct walker_moves *moves, struct instance *instance,
	enum walker_move gait, const struct log *log);

/* Changes the gait, jumps or waves. */
void walker_moves_begin(struct walker_moves *moves, enum walker_move move);

/* The gait that is so many steps faster, if there is one. */
void walker_moves_change_gait(struct walker_moves *moves, int step);

/* Goes on by step_s and writes the instance's pose. */
void walker_moves_update(
	struct walker_moves *moves, struct instance *instance, float step_s);

/* The clip under way and its time. */
const struct model_clip *walker_moves_clip(const struct walker_moves *moves,
	const struct model *model, float *time_s);

#endif

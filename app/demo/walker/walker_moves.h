/*
 * The walker's clips.
 *
 * A gait sets the pose; a change of gait fades from the pose that is shown. A
 * jump replaces the gait until the jump's clip ends. A wave is a layer above
 * them: a mask restricts its clip to one arm and the head.
 */
#ifndef APP_DEMO_WALKER_WALKER_MOVES_H
#define APP_DEMO_WALKER_WALKER_MOVES_H

#include "app/anim/clip.h"
#include "app/anim/fade.h"
#include "app/scene/instance/instance.h"

/* Gaits come first, from slow to fast. */
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
	struct pose before; /* the last pose without the wave */

	double wave_s; /* since the wave began; negative: no wave */
	struct pose wave;
	float *wave_mask;
	float wave_weight;
};

/*
 * Finds the clips. Memory comes from the instance's arena. Returns 0, or -errno
 * after logging an error, which names a missing clip or bone.
 */
int walker_moves_init(struct walker_moves *moves, struct instance *instance,
	enum walker_move gait, const struct log *log);

/* Starts a gait, a jump or a wave. */
void walker_moves_begin(struct walker_moves *moves, enum walker_move move);

/* Starts the gait that is step gaits faster, if there is one. */
void walker_moves_change_gait(struct walker_moves *moves, int step);

/* Moves on by step_s and sets the instance's pose. */
void walker_moves_update(
	struct walker_moves *moves, struct instance *instance, float step_s);

/* Returns the clip of the current move and its time. */
const struct model_clip *walker_moves_clip(const struct walker_moves *moves,
	const struct model *model, float *time_s);

#endif

/*
 * One technique of the duel: it shows the clip in its own way, is timed, and
 * is held against the reference.
 */
#ifndef APP_DEMO_DUEL_CONTENDER_H
#define APP_DEMO_DUEL_CONTENDER_H

#include "app/compare/candidate.h"
#include "app/demo/demo.h"
#include "app/demo/duel/duel_rigid.h"
#include "app/demo/vertex_tint.h"

enum contender_kind {
	CONTENDER_SKIN,
	CONTENDER_MORPH,
	CONTENDER_RIGID,
	CONTENDER_KINDS
};

struct contender {
	enum contender_kind kind;
	const struct reference *reference;
	struct candidate candidate; /* its bytes; a morph's work */
	struct duel_rigid rigid;    /* of CONTENDER_RIGID */
	struct instance *shown;
	struct clip_cursor cursor;
	struct vertex_tint heat;
	int64_t (*now_ns)(void); /* or NULL */

	float ms; /* a frame, mean of the last ones; below 0: not known */
	float gathered_ms;
	int gathered;
	float peak_px, mean_px; /* now */
};

/*
 * Bakes the reference's clip; morphs keep within bound_px. 0, or -errno after
 * a sentence. Release with contender_finish() in any case.
 */
int contender_init(struct contender *contender, enum contender_kind kind,
	const struct reference *reference, const struct screen_view *screen,
	float bound_px, const struct demo_env *env);

void contender_finish(struct contender *contender);

/* The technique's work of a frame, timed. */
void contender_pose(struct contender *contender, float time_s);

/*
 * Holds what it shows against a frame of the reference, and paints each vertex
 * by its distance, full_px being red.
 */
void contender_judge(struct contender *contender,
	const struct screen_view *screen, int frame, float full_px);

#endif

/*
 * One technique of the duel: plays the clip, measures the time of posing, and
 * compares the vertices with the reference.
 */
#ifndef APP_DEMO_DUEL_CONTENDER_H
#define APP_DEMO_DUEL_CONTENDER_H

#include "app/compare/candidate/candidate.h"
#include "app/compare/measure/time_grid.h"
#include "app/demo/demo.h"
#include "app/scene/overlay/overlay_heat.h"
#include "app/scene/shadow/shadow_figure.h"

enum contender_kind {
	CONTENDER_SKIN, /* the model as it is; most have a skin */
	CONTENDER_MORPH,
	CONTENDER_RIGID,
	CONTENDER_KINDS
};

struct contender {
	enum contender_kind kind;
	const char *title; /* the technique's name */
	struct reference *reference;
	struct candidate candidate; /* for its counts of bytes */
	int key_count;              /* of the morph, else 0 */
	struct model *baked;        /* NULL: the model itself is shown */
	struct instance *shown;
	struct shadow_figure *shadow;  /* on ground of its own, or NULL */
	const struct model_clip *clip; /* in the shown model */
	struct clip_cursor cursor;
	struct overlay_heat heat;
	int64_t (*now_ns)(void); /* NULL: not timed */

	float ms; /* mean time of posing a frame; negative: unknown */
	float sum_ms;
	int sum_frames;
	float peak_px; /* the largest error of the current pose */
};

/*
 * Takes all memory of the model's budget that the technique needs, so that a
 * model that needs too much is refused at once. The reference must outlive the
 * contender. Returns 0, or -errno after logging an error. Call
 * contender_finish() in either case.
 */
int contender_init(struct contender *contender, enum contender_kind kind,
	struct reference *reference, const struct screen_view *screen,
	const struct time_grid *grid, const struct demo_env *env);

/*
 * Takes, and gives back, the memory that contender_bake() takes for a while:
 * that of export_load(). Call it after contender_init() of all. Returns 0, or
 * -errno after logging an error.
 */
int contender_try_export(
	const struct reference *reference, const struct log *log);

/*
 * Converts the reference's clip to the technique, which may take seconds; the
 * error of a morph is at most bound_px. Returns 0, or -errno after logging an
 * error.
 */
int contender_bake(struct contender *contender,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, const struct demo_env *env);

void contender_finish(struct contender *contender);

/* Poses the technique at time_s and measures how long that takes. */
void contender_pose(struct contender *contender, float time_s);

/*
 * Compares the pose with the reference's last pose, sets peak_px, and paints
 * each vertex by its distance in pixels, red from full_px on.
 */
void contender_measure_error(struct contender *contender,
	const struct screen_view *screen, float full_px);

#endif

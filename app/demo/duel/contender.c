#include "app/demo/duel/contender.h"

#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/export/export.h"
#include "app/demo/actor.h"
#include "app/scene/overlay/overlay_heat.h"
#include "platform/base/scalar.h"

#include <errno.h>

enum {
	FRAMES_A_MEAN = 16,
	FIT_BYTES = 64 * 1024 * 1024 /* of poses, while keys are fitted */
};

static const double rate_hz = 60.0; /* playback rate */

/*
 * Makes the morph's candidate with these keys. It is there for its counts of
 * bytes alone, so it keeps no key frames.
 */
static int make_morph(struct contender *contender,
	const struct screen_view *screen, const struct fit_keys *keys,
	const struct demo_env *env)
{
	const struct fixed_placement placement =
		candidate_morph_placement(&screen->box);

	return candidate_morph(&contender->candidate, contender->reference,
		env->kernel, &placement, keys, 0, env->log);
}

static int bake_morph(struct contender *contender,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, const struct demo_env *env, struct fit_keys *keys)
{
	int error = fit_keys_within(
		contender->reference, screen, grid, bound_px, FIT_BYTES, keys);

	if (error == -EINTR) {
		return error;
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory to fit key frames",
			env->model_path);
		return error;
	}
	contender->key_count = keys->count;
	candidate_destroy(&contender->candidate);
	return make_morph(contender, screen, keys, env);
}

/*
 * Loads the file that `limber compare --export` would write for the technique.
 */
static int load_baked(struct contender *contender,
	const struct screen_view *screen, const struct fit_keys *keys,
	const struct demo_env *env)
{
	struct reference *reference = contender->reference;
	struct comparison_clip clip = {.clip = reference->clip_index};
	struct comparison_cell cell = {.keys = *keys};
	const struct comparison comparison = {.model = reference->model,
		.box = screen->box,
		.clip_count = 1,
		.clip = &clip};
	const struct comparison_row row = {
		.kind = contender->kind == CONTENDER_MORPH ? COMPARISON_MORPH
							   : COMPARISON_RIGID,
		.cell = &cell,
		.total.key_count = keys->count};
	int error = export_load(&comparison, &row, env->log, &contender->baked);

	if (!error) {
		contender->clip = &contender->baked->clip[0];
	}
	return error;
}

/* Prepares the instance that is shown. Returns 0, or -errno after logging it. */
static int prepare_shown(struct contender *contender, const struct demo_env *env)
{
	struct instance *shown = contender->shown;
	struct shadow_ground ground;
	int error;

	shown->normal_mapping = false;
	error = clip_cursor_init(
		&contender->cursor, shown->model, &shown->arena);
	if (!error) {
		error = overlay_heat_init(
			&contender->heat, shown, &shown->arena);
	}
	if (!error) {
		error = shadow_ground_find(&ground, shown);
	}
	if (error) {
		return memory_budget_fail(
			shown->arena.budget, env->model_path, env->log);
	}
	return shadow_figure_create(
		shown, &ground, env->log, &contender->shadow);
}

/* Makes the instance of a model that is shown. */
static int show(struct contender *contender, const struct model *model,
	const struct demo_env *env)
{
	int error = instance_create(
		model, env->kernel, env->log, &contender->shown);

	return error ? error : prepare_shown(contender, env);
}

int contender_init(struct contender *contender, enum contender_kind kind,
	struct reference *reference, const struct screen_view *screen,
	const struct time_grid *grid, const struct demo_env *env)
{
	/* A fit chooses some of the moments. */
	const struct fit_keys most = {
		.count = grid->count, .time_s = grid->time_s};
	int error;

	*contender = (struct contender){.kind = kind,
		.title = kind == CONTENDER_MORPH  ? "Morphing"
			: kind == CONTENDER_RIGID ? "Hierarchical"
			: reference->model->skin_count > 0
			? "Skeletal"
			: instance_technique(reference->instance),
		.reference = reference,
		.clip = reference->clip,
		.now_ns = env->now_ns,
		.ms = -1.0f};
	if (kind == CONTENDER_MORPH) {
		return make_morph(contender, screen, &most, env);
	}
	if (kind == CONTENDER_RIGID) {
		return candidate_rigid(
			&contender->candidate, reference, env->log);
	}
	error = candidate_original(&contender->candidate, reference,
		env->kernel, 0, true, rate_hz, env->log);
	return error ? error : show(contender, reference->model, env);
}

int contender_try_export(
	const struct reference *reference, const struct log *log)
{
	struct candidate candidate = {.reference = NULL};
	struct reference *again;
	int error = reference_create(
		reference->model, reference->clip_index, log, &again);

	if (!error) {
		error = candidate_rigid(&candidate, again, log);
		candidate_destroy(&candidate);
		reference_destroy(again);
	}
	return error;
}

int contender_bake(struct contender *contender, const struct screen_view *screen,
	const struct time_grid *grid, float bound_px, const struct demo_env *env)
{
	struct fit_keys keys = {0};
	int error = 0;

	if (contender->kind == CONTENDER_SKIN) {
		return 0;
	}
	if (contender->kind == CONTENDER_MORPH) {
		error = bake_morph(
			contender, screen, grid, bound_px, env, &keys);
	}
	if (!error) {
		error = load_baked(contender, screen, &keys, env);
	}
	if (!error) {
		error = show(contender, contender->baked, env);
	}
	fit_keys_release(&keys);
	return error;
}

void contender_finish(struct contender *contender)
{
	instance_destroy(contender->shown);
	model_destroy(contender->baked);
	candidate_destroy(&contender->candidate);
}

static void count_time(struct contender *contender, int64_t ns)
{
	contender->sum_ms += (float)ns * 1e-6f;
	contender->sum_frames++;
	if (contender->sum_frames == FRAMES_A_MEAN || contender->ms < 0.0f) {
		contender->ms = contender->sum_ms / (float)contender->sum_frames;
		contender->sum_ms = 0.0f;
		contender->sum_frames = 0;
	}
}

void contender_pose(struct contender *contender, float time_s)
{
	int64_t begun_ns = contender->now_ns ? contender->now_ns() : 0;

	clip_pose(contender->clip, time_s, CLIP_AUTO, &contender->cursor,
		&contender->shown->pose);
	instance_update(contender->shown);
	if (contender->now_ns) {
		count_time(contender, contender->now_ns() - begun_ns);
	}
}

/* The vertices of the reference that a drawable shows. */
struct sources {
	int first;
	const int *vertex; /* vertex[first + i] is i's; NULL: first + i is */
};

/* The drawable's rigid part: the parts of a node are its mesh's primitives. */
static struct sources rigid_sources(
	const struct contender *contender, const struct drawable *drawable)
{
	const struct rigid_bake *rigid =
		candidate_rigid_bake(&contender->candidate);
	int part = 0, before = drawable->primitive_index;

	while (rigid->part[part].node != drawable->node || before-- > 0) {
		part++;
	}
	return (struct sources){rigid->part[part].first_vertex, rigid->source};
}

/*
 * Finds a drawable's sources. The morph's only mesh has a primitive for each
 * part of the reference.
 */
static struct sources sources_of(const struct contender *contender, int drawable)
{
	const struct reference *reference = contender->reference;
	const struct drawable *shown = &contender->shown->drawable[drawable];
	int part = 0;

	if (contender->kind == CONTENDER_RIGID) {
		return rigid_sources(contender, shown);
	}
	if (contender->kind == CONTENDER_MORPH) {
		part = shown->primitive_index;
	}
	while (contender->kind == CONTENDER_SKIN &&
		reference->part[part].drawable != drawable) {
		part++;
	}
	return (struct sources){reference->part[part].first_vertex, NULL};
}

/* The state of contender_measure_error(). */
struct measurement {
	struct contender *contender;
	const struct screen_view *screen;
	float full_px;
	int drawable; /* of the last vertex; -1: none yet */
	struct sources from;
};

static void measure_vertex(void *user, int drawable, int vertex, uint8_t rgb[3])
{
	struct measurement *measurement = user;
	struct contender *contender = measurement->contender;
	const struct instance *shown = contender->shown;
	const struct sources *from = &measurement->from;
	int source;
	float at[3], px;

	if (measurement->drawable != drawable) {
		measurement->drawable = drawable;
		measurement->from = sources_of(contender, drawable);
	}
	source = from->first + vertex;
	source = from->vertex ? from->vertex[source] : source;
	instance_world_vertex(shown, &shown->drawable[drawable], vertex, at);
	px = screen_view_distance_px(measurement->screen, at,
		contender->reference->position[source]);
	contender->peak_px = scalar_max(px, contender->peak_px);
	overlay_heat_ramp(px / measurement->full_px, rgb);
}

void contender_measure_error(struct contender *contender,
	const struct screen_view *screen, float full_px)
{
	struct measurement measurement = {
		contender, screen, full_px, -1, {0, NULL}};

	contender->peak_px = 0.0f;
	overlay_heat_paint(&contender->heat, measure_vertex, &measurement);
}

#include "app/demo/duel/contender.h"

#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/export/export.h"
#include "app/demo/actor.h"
#include "app/scene/instance/batch.h"
#include "app/scene/overlay/overlay_heat.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	FRAMES_A_MEAN = 16,
	KEPT_BYTES = 64 * 1024 * 1024 /* of key frames, for all of them */
};

static const double rate_hz = 60.0; /* of the playback */

static int init_morph(struct contender *contender,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, const struct demo_env *env)
{
	struct reference *reference = contender->reference;
	struct fixed_placement placement =
		candidate_morph_placement(&screen->box);
	struct fit_keys keys;
	int error = fit_keys_within(
		reference, screen, grid, bound_px, KEPT_BYTES, &keys);

	if (error) {
		log_error(env->log,
			"%s: there is not enough memory to fit key frames",
			env->model_path);
		return error;
	}
	contender->key_count = keys.count;
	error = candidate_morph(&contender->candidate, reference, env->kernel,
		&placement, &keys, KEPT_BYTES, env->log);
	fit_keys_release(&keys);
	/* show_morph() writes vertices in float. */
	return error ? error
		     : instance_create(reference->model, &kernel_float,
			       env->log, &contender->shown);
}

/* Shows what `limber compare --export` writes of the rigid parts. */
static int init_rigid(struct contender *contender, const struct demo_env *env)
{
	struct reference *reference = contender->reference;
	struct comparison_clip clip = {.clip = reference->clip_index};
	const struct comparison comparison = {
		.model = reference->model, .clip_count = 1, .clip = &clip};
	const struct comparison_row row = {.kind = COMPARISON_RIGID};
	int error = candidate_rigid(&contender->candidate, reference, env->log);

	if (!error) {
		error = export_load(
			&comparison, &row, env->log, &contender->parts);
	}
	if (error) {
		return error;
	}
	contender->clip = &contender->parts->clip[0];
	return instance_create(
		contender->parts, env->kernel, env->log, &contender->shown);
}

static int init_technique(struct contender *contender,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, const struct demo_env *env)
{
	struct reference *reference = contender->reference;
	int error;

	switch (contender->kind) {
	case CONTENDER_MORPH:
		return init_morph(contender, screen, grid, bound_px, env);
	case CONTENDER_RIGID:
		return init_rigid(contender, env);
	default:
		/* The candidate counts bytes as `limber compare` does. */
		error = candidate_original(&contender->candidate, reference,
			env->kernel, 0, true, rate_hz, env->log);
		return error ? error
			     : instance_create(reference->model, env->kernel,
				       env->log, &contender->shown);
	}
}

/*
 * Lets rigid drawables show vertices of their own, which are in world space
 * while all nodes stay at the origin. Skinned ones have such vertices already.
 */
static int own_vertices(struct contender *contender)
{
	struct instance *shown = contender->shown;

	for (int i = 0; i < shown->model->node_count; i++) {
		glm_mat4_identity(shown->world[i]);
	}
	for (int i = 0; i < shown->drawable_count; i++) {
		struct drawable *drawable = &shown->drawable[i];
		size_t count = (size_t)drawable->primitive->vertex_count;
		float(*position)[3], (*normal)[3];

		if (drawable->skin >= 0) {
			continue;
		}
		position = arena_alloc(&shown->arena, count, sizeof(float[3]));
		normal = arena_alloc(&shown->arena, count, sizeof(float[3]));
		if (!position || !normal) {
			return -ENOMEM;
		}
		instance_use_vertices(drawable, position, normal);
	}
	return 0;
}

/* Memory for the morph's vertices. */
static int init_vectors(struct contender *contender)
{
	struct arena *arena = &contender->shown->arena;
	size_t count = (size_t)contender->reference->vertex_count;

	if (contender->kind != CONTENDER_MORPH) {
		return 0;
	}
	contender->position = arena_alloc(arena, count, sizeof(float[3]));
	contender->normal = arena_alloc(arena, count, sizeof(float[3]));
	return contender->position && contender->normal ? own_vertices(contender)
							: -ENOMEM;
}

int contender_init(struct contender *contender, enum contender_kind kind,
	struct reference *reference, const struct screen_view *screen,
	const struct time_grid *grid, float bound_px, const struct demo_env *env)
{
	struct instance *shown;
	int error;

	*contender = (struct contender){.kind = kind,
		.title = kind == CONTENDER_MORPH  ? "Morphing"
			: kind == CONTENDER_RIGID ? "Hierarchical"
			: reference->model->skin_count > 0
			? "Skeletal"
			: actor_technique(reference->instance),
		.reference = reference,
		.clip = reference->clip,
		.now_ns = env->now_ns,
		.ms = -1.0f};
	error = init_technique(contender, screen, grid, bound_px, env);
	if (error) {
		return error;
	}
	shown = contender->shown;
	shown->normal_mapping = false;
	error = init_vectors(contender);
	if (!error) {
		error = clip_cursor_init(
			&contender->cursor, shown->model, &shown->arena);
	}
	if (!error) {
		error = overlay_heat_init(
			&contender->heat, shown, &shown->arena);
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory to compare the techniques",
			env->model_path);
	}
	return error;
}

void contender_finish(struct contender *contender)
{
	instance_destroy(contender->shown);
	model_destroy(contender->parts);
	candidate_destroy(&contender->candidate);
}

static void run(struct contender *contender, float time_s)
{
	struct instance *shown = contender->shown;

	if (contender->kind == CONTENDER_MORPH) {
		candidate_pose(&contender->candidate, time_s);
		return;
	}
	clip_pose(contender->clip, time_s, CLIP_AUTO, &contender->cursor,
		&shown->pose);
	instance_update(shown);
}

/* Copies the morph's vertices to the drawables that show them. */
static void show_morph(struct contender *contender)
{
	const struct reference *reference = contender->reference;
	float unit = reference->instance->unit_scale;

	contender->candidate.take(
		&contender->candidate, contender->position, contender->normal);
	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];
		struct drawable *drawable =
			&contender->shown->drawable[part->drawable];
		float scale =
			drawable->skin >= 0 ? unit : drawable->vertex_scale;

		for (int v = 0; v < part->vertex_count; v++) {
			const float *from =
				contender->position[part->first_vertex + v];

			for (int axis = 0; axis < 3; axis++) {
				drawable->position[v][axis] = from[axis] * scale;
			}
		}
		if (drawable->normal) {
			memcpy(drawable->normal,
				contender->normal + part->first_vertex,
				(size_t)part->vertex_count *
					sizeof(*drawable->normal));
		}
		batch_gather(drawable);
	}
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

	run(contender, time_s);
	if (contender->now_ns) {
		count_time(contender, contender->now_ns() - begun_ns);
	}
	if (contender->kind == CONTENDER_MORPH) {
		show_morph(contender);
	}
}

/* Which vertices of the reference a drawable shows. */
struct sources {
	int first;
	const int *vertex; /* of those from first on; NULL: in their order */
};

/* The parts that a node moves are its mesh's primitives. */
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

static struct sources sources_of(const struct contender *contender, int drawable)
{
	const struct reference *reference = contender->reference;
	int part = 0;

	if (contender->kind == CONTENDER_RIGID) {
		return rigid_sources(
			contender, &contender->shown->drawable[drawable]);
	}
	while (reference->part[part].drawable != drawable) {
		part++;
	}
	return (struct sources){reference->part[part].first_vertex, NULL};
}

/* What painting the errors needs. */
struct measurement {
	struct contender *contender;
	const struct screen_view *screen;
	float full_px;
	int drawable; /* the last one; -1: none */
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
	contender->peak_px = px > contender->peak_px ? px : contender->peak_px;
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

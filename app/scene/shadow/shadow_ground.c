#include "app/scene/shadow/shadow_ground.h"

#include "app/anim/math/vec.h"
#include "app/model/model_deltas.h"
#include "app/scene/draw/draw.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>

/* Parts of the model's extent, except wide_part. */
/* greatest height of ground above the model's bottom */
static const float flat_part = 0.1f;
/* least width of ground, as a part of each side of the model */
static const float wide_part = 0.8f;
/* least height of the rest above the ground */
static const float above_part = 0.05f;
/* greatest height of uneven ground above the model's bottom */
static const float hill_part = 0.5f;
/* greatest error of its relief */
static const float relief_part = 0.05f;
/* heights that differ by less count as equal */
static const float level_part = 0.001f;

/* The least part of its surface that faces upwards, and by how much. */
static const float upward_part = 0.9f, upward = 0.1f;

/* A drawable that may be ground. */
struct candidate {
	int drawable;
	struct bounds box;
};

struct search {
	struct instance *instance;
	struct bounds all;
	float extent;
	bool *moving; /* [node_count]: whether a clip moves the node */
	struct candidate *candidate; /* the highest ones first */
	int count;
};

/* Marks the nodes that a clip moves, and all their descendants. */
static void find_moving(const struct model *model, bool *moving)
{
	for (int c = 0; c < model->clip_count; c++) {
		const struct model_clip *clip = &model->clip[c];

		for (int i = 0; i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];

			if (!channel->constant &&
				channel->path != MODEL_WEIGHTS) {
				moving[channel->node] = true;
			}
		}
	}
	for (int n = 0; n < model->node_count; n++) {
		/* stands before its children */
		int parent = model->node[n].parent;

		moving[n] = moving[n] || (parent >= 0 && moving[parent]);
	}
}

static struct bounds box_of(
	const struct instance *instance, const struct drawable *drawable)
{
	struct bounds box = bounds_empty();

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float point[3];

		instance_world_vertex(instance, drawable, v, point);
		for (int axis = 0; axis < 3; axis++) {
			point[axis] *= instance->unit_scale;
		}
		bounds_add(&box, point);
	}
	return box;
}

/* The heights that the box around a drawable without a skin spans now. */
static struct shadow_ground_span span_of(
	const struct instance *instance, const struct drawable *drawable)
{
	const vec4 *world = (const vec4 *)instance->world[drawable->node];
	float middle = world[3][1], half = 0.0f;

	for (int i = 0; i < 3; i++) {
		middle += world[i][1] * drawable->box_middle[i];
		half += scalar_abs(world[i][1]) * drawable->box_half[i];
	}
	return (struct shadow_ground_span){
		(middle - half) * instance->unit_scale,
		(middle + half) * instance->unit_scale};
}

/* Whether all vertices are at the box's top or bottom. */
static bool is_level(const struct search *search,
	const struct drawable *drawable, const struct bounds *box)
{
	float near = level_part * search->extent;

	for (int v = 0; v < drawable->primitive->vertex_count; v++) {
		float point[3], y;

		instance_world_vertex(search->instance, drawable, v, point);
		y = point[1] * search->instance->unit_scale;
		if (y > box->low[1] + near && y < box->high[1] - near) {
			return false;
		}
	}
	return true;
}

static bool moves_vertices(
	const struct model_deltas *deltas, int vertex_count, float near)
{
	for (int v = 0; v < vertex_count; v++) {
		float moved[3];

		model_deltas_get(deltas, v, moved);
		if (vec_length(moved) > near) {
			return true;
		}
	}
	return false;
}

/*
 * Returns true if a morph target moves a vertex. It looks at the displacements,
 * because in files of key frames every drawable has targets.
 */
static bool is_bent(const struct search *search, const struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;
	int targets = drawable_target_count(search->instance, drawable);
	float near = level_part * search->extent / search->instance->unit_scale;

	for (int t = 0; t < targets; t++) {
		if (moves_vertices(&primitive->target[t].position,
			    primitive->vertex_count, near)) {
			return true;
		}
	}
	return false;
}

static bool is_solid(
	const struct search *search, const struct drawable *drawable)
{
	const struct model *model = search->instance->model;

	return drawable->skin < 0 &&
		model->material[drawable->primitive->material].alpha ==
		MODEL_OPAQUE;
}

static bool may_be_ground(const struct search *search,
	const struct drawable *drawable, const struct bounds *box)
{
	return !search->moving[drawable->node] && !bounds_is_empty(box) &&
		box->high[1] - search->all.low[1] <= flat_part * search->extent &&
		is_level(search, drawable, box) && !is_bent(search, drawable);
}

/* Together, the surfaces have to be nearly as wide as the model. */
static bool is_wide(const struct search *search, const struct bounds *ground)
{
	const struct bounds *all = &search->all;

	for (int axis = 0; axis < 3; axis += 2) {
		if (ground->high[axis] - ground->low[axis] <
			wide_part * (all->high[axis] - all->low[axis])) {
			return false;
		}
	}
	return all->high[1] > ground->high[1] + above_part * search->extent;
}

static int compare_heights(const void *left, const void *right)
{
	const struct candidate *a = left, *b = right;

	int order = (a->box.high[1] < b->box.high[1]) -
		(a->box.high[1] > b->box.high[1]);

	return order ? order : a->drawable - b->drawable;
}

static void find_candidates(struct search *search)
{
	const struct instance *instance = search->instance;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		struct bounds box = is_solid(search, drawable)
			? box_of(instance, drawable)
			: bounds_empty();

		if (may_be_ground(search, drawable, &box)) {
			search->candidate[search->count++] =
				(struct candidate){i, box};
		}
	}
	qsort(search->candidate, (size_t)search->count,
		sizeof(*search->candidate), compare_heights);
}

/* Returns how many candidates, from this one on, are about as high as it. */
static int count_level(const struct search *search, int first)
{
	float least = search->candidate[first].box.high[1] -
		level_part * search->extent;
	int i = first;

	while (i < search->count && search->candidate[i].box.high[1] >= least) {
		i++;
	}
	return i - first;
}

/*
 * Chooses the highest level at which the candidates together are wide enough,
 * because it hides those below.
 */
static void choose(struct shadow_ground *ground, const struct search *search)
{
	int count;

	for (int first = 0; first < search->count; first += count) {
		struct bounds together = bounds_empty();

		count = count_level(search, first);
		for (int i = 0; i < count; i++) {
			const struct candidate *candidate =
				&search->candidate[first + i];

			ground->drawable[i] = candidate->drawable;
			ground->span[i] = span_of(search->instance,
				&search->instance->drawable[candidate->drawable]);
			bounds_join(&together, &candidate->box);
		}
		if (is_wide(search, &together)) {
			ground->count = count;
			ground->y = together.high[1];
			ground->level = level_part * search->extent;
			return;
		}
	}
}

/* Returns true if nearly all of a drawable's surface faces upwards. */
static bool faces_upwards(
	const struct instance *instance, const struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;
	float sign = instance_is_mirrored(instance, drawable) ? -1.0f : 1.0f;
	float up = 0.0f, all = 0.0f;

	for (int k = 0; k + 2 < primitive->index_count; k += 3) {
		float corner[3][3], side[2][3], normal[3], area;

		for (int i = 0; i < 3; i++) {
			instance_world_vertex(instance, drawable,
				(int)primitive->index[k + i], corner[i]);
		}
		vec_subtract(corner[1], corner[0], side[0]);
		vec_subtract(corner[2], corner[0], side[1]);
		vec_cross(side[0], side[1], normal);
		area = vec_length(normal);
		all += area;
		up += sign * normal[1] > upward * area ? area : 0.0f;
	}
	return all > 0.0f && up >= upward_part * all;
}

static bool may_be_hill(const struct search *search,
	const struct drawable *drawable, const struct bounds *box)
{
	const struct bounds *all = &search->all;

	return !search->moving[drawable->node] && !bounds_is_empty(box) &&
		box->high[1] - all->low[1] <= hill_part * search->extent &&
		!is_bent(search, drawable) &&
		faces_upwards(search->instance, drawable);
}

/* Finds uneven ground. Returns 0 or -ENOMEM. */
static int find_hills(struct shadow_ground *ground, const struct search *search)
{
	struct instance *instance = search->instance;
	struct bounds together = bounds_empty();
	int count = 0, error;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		struct bounds box = is_solid(search, drawable)
			? box_of(instance, drawable)
			: bounds_empty();

		if (may_be_hill(search, drawable, &box)) {
			ground->drawable[count] = i;
			ground->span[count++] = span_of(instance, drawable);
			bounds_join(&together, &box);
		}
	}
	if (count == 0 || count == instance->drawable_count ||
		!is_wide(search, &together)) {
		return 0;
	}
	error = shadow_relief_make(
		&ground->relief, instance, ground->drawable, count);
	if (!error && ground->relief.height &&
		ground->relief.error <= relief_part * search->extent) {
		ground->count = count;
		ground->level = level_part * search->extent;
	} else {
		ground->relief.height = NULL;
	}
	return error;
}

/* Whether a triangle lies in the model's lowest plane and faces upwards. */
static bool lies_below(const struct search *search,
	const struct drawable *drawable, bool mirrored, const uint32_t index[3])
{
	float most = search->all.low[1] + level_part * search->extent;
	float corner[3][3], side[2][3], normal[3];

	for (int i = 0; i < 3; i++) {
		instance_world_vertex(
			search->instance, drawable, (int)index[i], corner[i]);
		if (corner[i][1] * search->instance->unit_scale > most) {
			return false;
		}
	}
	vec_subtract(corner[1], corner[0], side[0]);
	vec_subtract(corner[2], corner[0], side[1]);
	vec_cross(side[0], side[1], normal);
	return (mirrored ? -normal[1] : normal[1]) > 0.0f;
}

/*
 * Returns true if the model has a triangle in its lowest plane that faces
 * upwards. An example is a room whose floor and walls are one surface.
 */
static bool has_bottom(const struct search *search)
{
	const struct instance *instance = search->instance;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct model_primitive *primitive = drawable->primitive;
		bool mirrored = instance_is_mirrored(instance, drawable);

		for (int k = 0; k + 2 < primitive->index_count; k += 3) {
			if (lies_below(search, drawable, mirrored,
				    primitive->index + k)) {
				return true;
			}
		}
	}
	return false;
}

static int find(struct shadow_ground *ground, struct search *search)
{
	find_moving(search->instance->model, search->moving);
	search->all = bounds_of_clip(search->instance, -1);
	search->extent = bounds_extent(&search->all);
	find_candidates(search);
	choose(ground, search);
	ground->in_plane = ground->count > 0 || has_bottom(search);
	return ground->count > 0 ? 0 : find_hills(ground, search);
}

int shadow_ground_find(struct shadow_ground *ground, struct instance *instance)
{
	size_t count = (size_t)instance->drawable_count;
	struct search search = {
		.instance = instance,
		.moving = calloc((size_t)instance->model->node_count + 1, 1),
		.candidate = calloc(count + 1, sizeof(*search.candidate)),
	};
	int error = -ENOMEM;

	*ground = (struct shadow_ground){
		.drawable = ARENA_ARRAY(&instance->arena, int, count),
		.span = ARENA_ARRAY(
			&instance->arena, struct shadow_ground_span, count)};
	if (ground->drawable && ground->span && search.moving &&
		search.candidate) {
		error = find(ground, &search);
	}
	free(search.moving);
	free(search.candidate);
	return error;
}

/*
 * Finds how far the ground was lifted since it was found. Returns false if it
 * was tilted or if its drawables lie at different heights now.
 */
static bool find_lift(const struct shadow_ground *ground,
	const struct instance *instance, float *lift)
{
	*lift = 0.0f;
	for (int i = 0; i < ground->count; i++) {
		const struct shadow_ground_span *rest = &ground->span[i];
		struct shadow_ground_span now = span_of(
			instance, &instance->drawable[ground->drawable[i]]);
		float up = now.high - rest->high;

		*lift = i == 0 ? up : *lift;
		if (!(scalar_abs(up - *lift) <= ground->level &&
			    scalar_abs(now.low - rest->low - up) <=
				    ground->level)) {
			return false;
		}
	}
	return true;
}

bool shadow_ground_begin(const struct shadow_ground *ground,
	const struct stage *stage, const struct gl *gl, const float light[3],
	struct instance *instance, const struct texture_set *textures)
{
	float lift;

	if (ground->count == 0 || !stage->has_stencil ||
		!find_lift(ground, instance, &lift) ||
		(ground->relief.height && scalar_abs(lift) > ground->level)) {
		return false;
	}
	stage_ground_begin(gl);
	for (int i = 0; i < ground->count; i++) {
		struct drawable *drawable =
			&instance->drawable[ground->drawable[i]];

		draw_instance_part(
			gl, instance, drawable, textures, DRAW_SHADED);
		drawable->hidden = true;
	}
	if (ground->relief.height) {
		gl->Disable(GL_STENCIL_TEST);
	} else {
		stage_ground_end(gl, light, ground->y + lift);
	}
	return true;
}

void shadow_ground_hide(const struct shadow_ground *ground,
	struct instance *instance, bool hidden)
{
	for (int i = 0; i < ground->count; i++) {
		instance->drawable[ground->drawable[i]].hidden = hidden;
	}
}

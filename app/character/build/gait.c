#include "app/character/build/gait.h"

#include "app/anim/clip.h"
#include "app/anim/math/vec.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <string.h>

enum {
	/* samples of all clips together, if there are few clips */
	POSES_MAX = 200,
	STEPS_LEAST = 6
};

/*
 * Points below this height, as a part of the figure's height, touch the ground.
 */
static const float touching = 0.03f;
/* A figure carried less far than this, in heights, moves on the spot. */
static const float on_the_spot = 0.15f;
/* Figures that are slower than this, in their own lengths a second, stand. */
static const float standing = 0.12f;
/* A figure whose feet end farther up or down than this, in heights, climbs. */
static const float climbing = 0.5f;
/* tan() of the angle to an axis up to which a clip goes along it. */
static const float straight = 0.2f;

/* The body at a time of a clip. */
struct sample {
	float at[GAIT_POINTS_MAX][3];
	float low[3], high[3], mean[3];
};

/* Returns the mesh that the scene shows at a node, or NULL. */
static const struct model_mesh *mesh_at(const struct model *model, int node)
{
	const struct model_node *of = &model->node[node];

	return model_node_shows_mesh(of) ? &model->mesh[of->mesh] : NULL;
}

static int count_vertices(const struct model *model)
{
	int count = 0;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_mesh *mesh = mesh_at(model, n);

		for (int i = 0; mesh && i < mesh->primitive_count; i++) {
			count += mesh->primitive[i].vertex_count;
		}
	}
	return count;
}

static struct gait_point point_at(const struct model *model, int node,
	const struct model_primitive *primitive, int vertex)
{
	return (struct gait_point){
		.node = node,
		.vertex = vertex,
		.primitive = primitive,
		.sole = character_sole_of_vertex(model, node, primitive, vertex,
			primitive->position[vertex]),
	};
}

void gait_body_make(struct gait_body *body, const struct model *model)
{
	int stride = count_vertices(model) / GAIT_POINTS_MAX + 1, skip = 0;

	body->count = 0;
	for (int n = 0; n < model->node_count; n++) {
		const struct model_mesh *mesh = mesh_at(model, n);

		for (int i = 0; mesh && i < mesh->primitive_count; i++) {
			const struct model_primitive *primitive =
				&mesh->primitive[i];
			int v = skip;

			for (; v < primitive->vertex_count; v += stride) {
				body->point[body->count++] =
					point_at(model, n, primitive, v);
			}
			skip = v - primitive->vertex_count;
		}
	}
}

int gait_steps_for(int clip_count)
{
	int steps = POSES_MAX / (2 * (clip_count + 1));

	return steps < STEPS_LEAST        ? STEPS_LEAST
		: steps > GAIT_STEPS_MOST ? GAIT_STEPS_MOST
					  : steps;
}

/* The morph targets of a node's mesh that have a weight: first to end - 1. */
struct active {
	int node, first, end;
};

/* There may be a thousand targets, of which key frames use two at a time. */
static struct active find_active(const struct instance *instance, int node)
{
	const struct model *model = instance->model;
	const struct model_node *of = &model->node[node];
	const float *weight = &instance->pose.weight[of->weight_offset];
	struct active active = {.node = node};

	for (int i = 0; i < model->mesh[of->mesh].target_count; i++) {
		if (weight[i] != 0.0f) {
			active.first = active.end == 0 ? i : active.first;
			active.end = i + 1;
		}
	}
	return active;
}

/* Computes where a point is in the world, moved by morph targets too. */
static void place_point(const struct gait_point *point,
	const struct active *active, const struct instance *instance,
	float out[3])
{
	const struct model *model = instance->model;
	const struct model_primitive *primitive = point->primitive;
	const float *weight =
		&instance->pose.weight[model->node[point->node].weight_offset];
	struct character_sole sole = point->sole;
	float at[3], way[3];

	memcpy(at, primitive->position[point->vertex], sizeof(at));
	for (int i = active->first; i < active->end; i++) {
		model_deltas_get(
			&primitive->target[i].position, point->vertex, way);
		vec_add_scaled(at, way, weight[i], at);
	}
	if (active->end > 0) {
		sole = character_sole_of_vertex(
			model, point->node, primitive, point->vertex, at);
	}
	character_sole_place(&sole, instance, out);
}

static void take(const struct gait_body *body, struct instance *instance,
	int clip, float time_s, struct sample *sample)
{
	struct clip_cursor none = {0};
	struct active active = {.node = -1};

	pose_rest(&instance->pose, instance->model);
	clip_sample(
		&instance->model->clip[clip], time_s, &none, &instance->pose);
	instance_update_nodes(instance);
	memset(sample->mean, 0, sizeof(sample->mean));
	for (int i = 0; i < body->count; i++) {
		float *at = sample->at[i];

		if (body->point[i].node != active.node) {
			active = find_active(instance, body->point[i].node);
		}
		place_point(&body->point[i], &active, instance, at);
		for (int axis = 0; axis < 3; axis++) {
			float *low = &sample->low[axis],
			      *high = &sample->high[axis];

			*low = i == 0 || at[axis] < *low ? at[axis] : *low;
			*high = i == 0 || at[axis] > *high ? at[axis] : *high;
			sample->mean[axis] += at[axis] / (float)body->count;
		}
	}
}

/*
 * Returns the point that is lowest, measured by the greater of its heights at
 * both times, which becomes *height.
 */
static int lowest(int count, const struct sample *a, const struct sample *b,
	float *height)
{
	int found = 0;

	for (int i = 0; i < count; i++) {
		float y = scalar_max(a->at[i][1], b->at[i][1]);

		if (i == 0 || y < *height) {
			*height = y;
			found = i;
		}
	}
	return found;
}

/*
 * Adds the way of the lowest point from a to b if it touches the ground. sum[0]
 * and sum[1] are along x and z; sum[2] counts.
 */
static void add_step(int count, const struct sample *a, const struct sample *b,
	float ground, float sum[3])
{
	float height = 0.0f;
	int point = lowest(count, a, b, &height);

	if (height <= ground + touching * (a->high[1] - a->low[1])) {
		sum[0] += b->at[point][0] - a->at[point][0];
		sum[1] += b->at[point][2] - a->at[point][2];
		sum[2] += 1.0f;
	}
}

/* Returns the mean distance of points at both times, whatever drifts. */
static float gap_between(
	int count, const struct sample *a, const struct sample *b)
{
	float sum = 0.0f;

	for (int i = 0; i < count; i++) {
		float square = 0.0f;

		for (int axis = 0; axis < 3; axis++) {
			float way = b->at[i][axis] - a->at[i][axis] -
				b->mean[axis] + a->mean[axis];

			square += way * way;
		}
		sum += scalar_sqrt(square);
	}
	return sum / (float)count;
}

static float extent_of(const struct sample *sample)
{
	float extent = 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		float side = sample->high[axis] - sample->low[axis];

		extent = scalar_max(side, extent);
	}
	return extent;
}

/* Sets a velocity below least to 0, and a component far below the other one. */
static void straighten(float velocity[2], float least)
{
	float x = scalar_abs(velocity[0]), z = scalar_abs(velocity[1]);

	if (x * x + z * z < least * least) {
		velocity[0] = velocity[1] = 0.0f;
	} else if (x < straight * z) {
		velocity[0] = 0.0f;
	} else if (z < straight * x) {
		velocity[1] = 0.0f;
	}
}

/*
 * Takes the start of the clip into first, and the gait's rise. Returns the
 * height of the ground: that of the lowest point at any time.
 */
static float measure_heights(const struct gait_body *body,
	struct instance *instance, int clip, int steps, struct sample *first,
	struct gait *gait)
{
	float duration_s = instance->model->clip[clip].duration_s;
	float ground, height;
	struct sample now;

	take(body, instance, clip, 0.0f, first);
	ground = first->low[1];
	for (int i = 1; i <= steps; i++) {
		take(body, instance, clip, duration_s * (float)i / (float)steps,
			&now);
		gait->rise[i] = now.low[1] - first->low[1];
		ground = scalar_min(now.low[1], ground);
	}
	height = first->high[1] - first->low[1];
	gait->steps = steps;
	if (!(scalar_abs(gait->rise[steps]) > climbing * height)) {
		gait->steps = 0;
		memset(gait->rise, 0, sizeof(gait->rise));
	}
	return ground;
}

struct gait gait_measure(const struct gait_body *body,
	struct instance *instance, int clip, int steps)
{
	float duration_s =
		clip >= 0 ? instance->model->clip[clip].duration_s : 0.0f;
	float ground, sum[3] = {0.0f, 0.0f, 0.0f};
	struct gait gait = {.steps = 0};
	struct sample sample[2], first;

	if (duration_s <= 0.0f || body->count == 0) {
		return gait;
	}
	ground = measure_heights(body, instance, clip, steps, &first, &gait);
	sample[0] = first;
	for (int i = 1; i <= steps; i++) {
		struct sample *now = &sample[i % 2];

		take(body, instance, clip, duration_s * (float)i / (float)steps,
			now);
		add_step(body->count, &sample[(i + 1) % 2], now, ground, sum);
	}
	for (int i = 0; i < 2; i++) {
		float drift = sample[steps % 2].mean[2 * i] - first.mean[2 * i];
		float height = first.high[1] - first.low[1];

		gait.drift[i] =
			scalar_abs(drift) > on_the_spot * height ? drift : 0.0f;
		gait.velocity[i] = gait.drift[i] / duration_s;
		if (sum[2] > 0.0f) {
			gait.velocity[i] -=
				sum[i] * (float)steps / (sum[2] * duration_s);
		}
	}
	gait.extent = extent_of(&first);
	gait.gap = gap_between(body->count, &first, &sample[steps % 2]);
	straighten(gait.velocity, standing * gait.extent);
	return gait;
}

#include "app/demo/gait.h"

#include "app/anim/clip.h"
#include "platform/base/scalar.h"

#include <string.h>

enum {
	VERTICES_MAX = 512 /* that are looked at, evenly spread */
};

/* Of the figure's height: what is lower touches the ground. */
static const float touching = 0.03f;
/* A figure that its clip carries less far, in heights, moves on the spot. */
static const float on_the_spot = 0.15f;

struct sample {
	int count;
	float at[VERTICES_MAX][3];
	float low, high, mean[2];
};

static int count_vertices(const struct instance *instance)
{
	int count = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		count += instance->drawable[i].primitive->vertex_count;
	}
	return count;
}

static void add(struct sample *sample, const float at[3])
{
	float *to = sample->at[sample->count++];

	memcpy(to, at, sizeof(float[3]));
	if (sample->count == 1 || to[1] < sample->low) {
		sample->low = to[1];
	}
	if (sample->count == 1 || to[1] > sample->high) {
		sample->high = to[1];
	}
	sample->mean[0] += to[0];
	sample->mean[1] += to[2];
}

static void take(struct instance *instance, int clip, float time_s,
	struct sample *sample)
{
	const struct model_clip *played = &instance->model->clip[clip];
	struct clip_cursor none = {0};
	int stride = count_vertices(instance) / VERTICES_MAX + 1, skip = 0;

	pose_rest(&instance->pose, instance->model);
	clip_sample(played, time_s, &none, &instance->pose);
	instance_update(instance);
	sample->count = 0;
	sample->low = sample->high = sample->mean[0] = sample->mean[1] = 0.0f;
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		int v = skip;

		for (; v < drawable->primitive->vertex_count; v += stride) {
			float at[3];

			instance_world_vertex(instance, drawable, v, at);
			for (int axis = 0; axis < 3; axis++) {
				at[axis] *= instance->unit_scale;
			}
			add(sample, at);
		}
		skip = v - drawable->primitive->vertex_count;
	}
	for (int axis = 0; axis < 2 && sample->count > 0; axis++) {
		sample->mean[axis] /= (float)sample->count;
	}
}

/* The vertex that is lowest at both times, and its higher height of the two. */
static int lowest(const struct sample *a, const struct sample *b, float *height)
{
	int found = 0;

	for (int i = 0; i < a->count; i++) {
		float y = a->at[i][1] > b->at[i][1] ? a->at[i][1] : b->at[i][1];

		if (i == 0 || y < *height) {
			*height = y;
			found = i;
		}
	}
	return found;
}

/* The steps of the vertices that touch the ground; sum[2] counts them. */
static void add_step(const struct sample *a, const struct sample *b,
	float ground, float sum[3])
{
	float height = 0.0f;
	int vertex = lowest(a, b, &height);

	if (a->count > 0 && height <= ground + touching * (a->high - a->low)) {
		sum[0] += b->at[vertex][0] - a->at[vertex][0];
		sum[1] += b->at[vertex][2] - a->at[vertex][2];
		sum[2] += 1.0f;
	}
}

static float find_ground(
	struct instance *instance, int clip, int steps, struct sample *sample)
{
	float duration_s = instance->model->clip[clip].duration_s;
	float ground = 0.0f;

	for (int i = 0; i <= steps; i++) {
		take(instance, clip, duration_s * (float)i / (float)steps,
			sample);
		ground = i == 0 || sample->low < ground ? sample->low : ground;
	}
	return ground;
}

struct gait gait_measure(struct instance *instance, int clip, int steps)
{
	float duration_s = instance->model->clip[clip].duration_s;
	struct sample sample[2];
	float ground = find_ground(instance, clip, steps, &sample[0]);
	float sum[3] = {0.0f, 0.0f, 0.0f}, start[2], height;
	struct gait gait = {{0.0f, 0.0f}, {0.0f, 0.0f}};

	take(instance, clip, 0.0f, &sample[0]);
	memcpy(start, sample[0].mean, sizeof(start));
	height = sample[0].high - sample[0].low;
	for (int i = 1; i <= steps; i++) {
		struct sample *now = &sample[i % 2],
			      *before = &sample[(i + 1) % 2];

		take(instance, clip, duration_s * (float)i / (float)steps, now);
		add_step(before, now, ground, sum);
	}
	for (int axis = 0; axis < 2; axis++) {
		float drift = sample[steps % 2].mean[axis] - start[axis];

		gait.drift[axis] =
			scalar_abs(drift) > on_the_spot * height ? drift : 0.0f;
		gait.velocity[axis] = gait.drift[axis] / duration_s;
		if (sum[2] > 0.0f) {
			gait.velocity[axis] -= sum[axis] * (float)steps /
				(sum[2] * duration_s);
		}
	}
	return gait;
}

float gait_speed(const struct gait *gait)
{
	return scalar_sqrt(gait->velocity[0] * gait->velocity[0] +
		gait->velocity[1] * gait->velocity[1]);
}

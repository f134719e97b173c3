#include "app/anim/kernel/run/fixed_keys_run.h"

#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/run/fixed_lerp.h"

#include <errno.h>

enum {
	WEIGHT_MAX = 1024,
	CHUNK = 64
};

/* How far the sum of two weights may be from 1 for the loop of a lerp. */
static const float sum_tolerance = 1e-5f;

int fixed_keys_find(const struct fixed_keys *keys, const float *weight,
	struct fixed_keys_frame *out)
{
	int key[2] = {0, 0}, count = 0;
	float sum = 0.0f;
	bool within = true;

	for (int t = 0; t < keys->target_count; t++) {
		if (weight[t] == 0.0f) {
			continue;
		}
		if (!(scalar_abs(weight[t]) <= WEIGHT_MAX)) {
			return -ERANGE;
		}
		within = within && weight[t] > 0.0f && weight[t] <= 1.0f;
		key[count > 0] = 1 + t;
		sum += weight[t];
		count++;
	}
	if (count == 1) {
		key[1] = key[0];
		key[0] = 0;
	}
	*out = (struct fixed_keys_frame){
		.mixed = !within || count > 2 ||
			(count == 2 && scalar_abs(sum - 1.0f) > sum_tolerance),
		.source = key[0],
		.destiny = key[1],
		.weights = fixed_lerp_weights(
			count > 0 ? weight[key[1] - 1] : 0.0f),
		.weight = weight,
	};
	return 0;
}

/* sum += key * weight. Keys hold their numbers times -2. */
static void add(
	int count, const struct fixed_key *key, float weight, float (*sum)[3])
{
	weight *= -0.5f;
	for (int i = 0; i < count; i++) {
		sum[i][0] += (float)key[i].x * weight;
		sum[i][1] += (float)key[i].y * weight;
		sum[i][2] += (float)key[i].z * weight;
	}
}

static void mix_chunk(const struct fixed_keys *keys,
	const struct fixed_key *first, int count, const float *weight,
	struct fixed_vector *out)
{
	float sum[CHUNK][3] = {{0}};
	float rest = 1.0f;

	for (int t = 0; t < keys->target_count; t++) {
		if (weight[t] != 0.0f) {
			add(count,
				first + (size_t)(1 + t) * (size_t)keys->stride,
				weight[t], sum);
			rest -= weight[t];
		}
	}
	add(count, first, rest, sum);
	for (int i = 0; i < count; i++) {
		out[i] = (struct fixed_vector){0, fixed_round(sum[i][0]),
			fixed_round(sum[i][1]), fixed_round(sum[i][2])};
	}
}

void fixed_keys_run(const struct fixed_keys *keys,
	const struct fixed_loops *loops, const struct fixed_keys_frame *frame,
	enum fixed_attribute attribute, struct fixed_vector *out)
{
	const struct fixed_key *key = keys->key[attribute];
	size_t stride = (size_t)keys->stride;
	int count = keys->vertex_count;

	if (!frame->mixed) {
		loops->lerp_keys(count, key + (size_t)frame->source * stride,
			key + (size_t)frame->destiny * stride, frame->weights,
			out);
		return;
	}
	for (int first = 0; first < count; first += CHUNK) {
		int left = count - first < CHUNK ? count - first : CHUNK;

		mix_chunk(keys, key + first, left, frame->weight, out + first);
	}
}

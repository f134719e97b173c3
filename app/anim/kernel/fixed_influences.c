#include "app/anim/kernel/fixed_influences.h"

enum {
	WIDTH = SKIN_INFLUENCES_MAX
};

/* By descending weight, in float, ties in the file's order; at least one. */
static void gather(const struct model_primitive *primitive, uint32_t vertex,
	float weight[WIDTH], struct fixed_influences *out)
{
	size_t width = (size_t)primitive->influences;
	const float *from = primitive->weight + vertex * width;
	const uint16_t *joint = primitive->joint + vertex * width;

	out->count = 0;
	for (size_t i = 0; i < width && i < WIDTH; i++) {
		int place = out->count;

		if (!(from[i] > 0.0f)) {
			continue;
		}
		while (place > 0 && weight[place - 1] < from[i]) {
			weight[place] = weight[place - 1];
			out->joint[place] = out->joint[place - 1];
			place--;
		}
		weight[place] = from[i];
		out->joint[place] = joint[i];
		out->count++;
	}
	if (out->count == 0) {
		weight[0] = 1.0f;
		out->joint[0] = joint[0];
		out->count = 1;
	}
}

/* Rounded down, then up where most was lost, until the sum is right. */
static void quantize(struct fixed_influences *out, const float weight[WIDTH])
{
	float lost[WIDTH];
	float sum = 0.0f;
	int left = FIXED_WEIGHT_ONE_Q14;

	for (int i = 0; i < out->count; i++) {
		sum += weight[i];
	}
	for (int i = 0; i < out->count; i++) {
		float exact = weight[i] / sum * FIXED_WEIGHT_ONE_Q14;

		out->weight_q14[i] = (int16_t)exact;
		if (out->weight_q14[i] > left) {
			out->weight_q14[i] = (int16_t)left;
		}
		lost[i] = exact - (float)out->weight_q14[i];
		left -= out->weight_q14[i];
	}
	while (left > 0) {
		int most = 0;

		for (int i = 1; i < out->count; i++) {
			most = lost[i] > lost[most] ? i : most;
		}
		out->weight_q14[most]++;
		lost[most] -= 1.0f;
		left--;
	}
}

void fixed_influences_gather(const struct model_primitive *primitive,
	uint32_t vertex, int cap, struct fixed_influences *out)
{
	float weight[WIDTH];

	gather(primitive, vertex, weight, out);
	quantize(out, weight);
	while (out->count > 1 && out->weight_q14[out->count - 1] == 0) {
		out->count--;
	}
	if (cap > 0 && out->count > cap) {
		out->count = cap;
		quantize(out, weight);
	}
}

void fixed_influences_by_joint(struct fixed_influences *v)
{
	for (int i = 1; i < v->count; i++) {
		uint16_t joint = v->joint[i];
		int16_t weight = v->weight_q14[i];
		int place = i;

		for (; place > 0 && v->joint[place - 1] > joint; place--) {
			v->joint[place] = v->joint[place - 1];
			v->weight_q14[place] = v->weight_q14[place - 1];
		}
		v->joint[place] = joint;
		v->weight_q14[place] = weight;
	}
}

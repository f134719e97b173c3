#include "app/anim/kernel/layout/fixed_influences.h"

/*
 * Converts weights to Q14: rounds all of them down, then rounds up those with
 * the largest remainders until the sum is exactly 1.
 */
static void quantize(
	struct fixed_influences *out, const struct skin_influence *in)
{
	float lost[SKIN_INFLUENCES_MAX];
	float sum = 0.0f;
	int left = FIXED_WEIGHT_ONE_Q14;

	for (int i = 0; i < out->count; i++) {
		sum += in[i].weight;
	}
	for (int i = 0; i < out->count; i++) {
		float exact = in[i].weight / sum * FIXED_WEIGHT_ONE_Q14;

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
	struct skin_influence in[SKIN_INFLUENCES_MAX];

	out->count = skin_gather_influences(primitive, vertex, in);
	for (int i = 0; i < out->count; i++) {
		out->joint[i] = in[i].joint;
	}
	quantize(out, in);
	while (out->count > 1 && out->weight_q14[out->count - 1] == 0) {
		out->count--;
	}
	if (cap > 0 && out->count > cap) {
		out->count = cap;
		quantize(out, in);
	}
}

void fixed_influences_by_joint(struct fixed_influences *v)
{
	for (int i = 1; i < v->count; i++) {
		uint16_t joint = v->joint[i];
		int16_t weight = v->weight_q14[i];
		int to = i;

		for (; to > 0 && v->joint[to - 1] > joint; to--) {
			v->joint[to] = v->joint[to - 1];
			v->weight_q14[to] = v->weight_q14[to - 1];
		}
		v->joint[to] = joint;
		v->weight_q14[to] = weight;
	}
}

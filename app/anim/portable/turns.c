#include "app/anim/turns.h"

#include "app/anim/math/transform_inline.h"

/* Where a time lies among a turn's keys. */
struct moment {
	const float *time_s;
	int key;
	float u; /* 0..1 from this key to the next one */
};

/* The key at or before time_s, 0..last - 1. */
static int find_key(const struct turn *turn, float time_s)
{
	int low = 0, high = turn->last;

	while (high - low > 1) {
		int middle = (low + high) / 2;

		if (turn->time_s[middle] <= time_s) {
			low = middle;
		} else {
			high = middle;
		}
	}
	return low;
}

static struct moment find(struct turn *turn, float time_s)
{
	const float *at = turn->time_s + turn->key;

	if (!(time_s >= at[0] && time_s < at[1])) {
		turn->key = find_key(turn, time_s);
		at = turn->time_s + turn->key;
	}
	time_s = time_s < at[0] ? at[0] : time_s;
	time_s = time_s > at[1] ? at[1] : time_s;
	return (struct moment){
		turn->time_s, turn->key, (time_s - at[0]) / (at[1] - at[0])};
}

static void sample(
	struct turn *turn, float time_s, struct moment *moment, float out[4])
{
	const float *from;

	if (turn->time_s != moment->time_s) {
		*moment = find(turn, time_s);
	}
	from = turn->value + moment->key * 4;
	inline_quat_slerp(from, from + 4, moment->u, out);
}

static float *rotation_of(const struct turn *turn, struct transform *local)
{
	return (float *)((char *)local + turn->offset);
}

void turns_set(
	struct turn *turn, int count, float time_s, struct transform *local)
{
	struct moment moment = {NULL, 0, 0};

	for (int i = 0; i < count; i++) {
		sample(&turn[i], time_s, &moment, rotation_of(&turn[i], local));
	}
}

void turns_mix(struct turn *turn, int count, float time_s,
	struct transform *local, float amount)
{
	struct moment moment = {NULL, 0, 0};

	for (int i = 0; i < count; i++) {
		float *q = rotation_of(&turn[i], local);
		float to[4];

		sample(&turn[i], time_s, &moment, to);
		inline_quat_mix(q, to, turn[i].weight * amount);
	}
}

#include "app/scene/instance/influence_cap.h"

#include <stdlib.h>
#include <string.h>

enum {
	BUDGET_MAX = 100000000,
	/* Below these heights a cap of 2 or 1 moves no vertex visibly. */
	TWO_BELOW_PX = 160,
	ONE_BELOW_PX = 64,
};

static bool read_number(const char *text, long high, int *out)
{
	char *end;
	long value = strtol(text, &end, 10);

	if (end == text || *end || value < 1 || value > high) {
		return false;
	}
	*out = (int)value;
	return true;
}

bool influence_cap_parse(const char *text, struct influence_cap *out)
{
	static const char budget[] = "budget:";

	if (strcmp(text, "auto") == 0) {
		*out = (struct influence_cap){.kind = INFLUENCE_CAP_DISTANCE};
		return true;
	}
	if (strncmp(text, budget, sizeof(budget) - 1) == 0) {
		out->kind = INFLUENCE_CAP_BUDGET;
		return read_number(
			text + sizeof(budget) - 1, BUDGET_MAX, &out->value);
	}
	out->kind = INFLUENCE_CAP_FIXED;
	return read_number(text, SKIN_INFLUENCES_MAX, &out->value);
}

int influence_cap_for_height(float height_px)
{
	return height_px < ONE_BELOW_PX ? 1 : height_px < TWO_BELOW_PX ? 2 : 0;
}

long influence_cap_cost(const struct instance *instance, int max_influences)
{
	long cost = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->skin >= 0 && !drawable->hidden) {
			cost += max_influences
				? drawable->stream.capped[max_influences]
				: drawable->stream.influence_count;
		}
	}
	return cost;
}

static int for_budget(const struct instance *instance, long budget)
{
	int cap = SKIN_INFLUENCES_MAX;

	while (cap > 1 && influence_cap_cost(instance, cap) > budget) {
		cap--;
	}
	return cap == SKIN_INFLUENCES_MAX ? 0 : cap;
}

int influence_cap_choose(const struct influence_cap *cap,
	const struct instance *instance, const struct camera *camera,
	float extent, int picture_height)
{
	float seen;

	switch (cap->kind) {
	case INFLUENCE_CAP_FIXED:
		return cap->value;
	case INFLUENCE_CAP_BUDGET:
		return for_budget(instance, cap->value);
	case INFLUENCE_CAP_DISTANCE:
		break;
	}
	seen = 2.0f * camera->distance * camera_tan_half(camera->yfov_rad);
	return influence_cap_for_height(extent / seen * (float)picture_height);
}

#include "app/character/show/character_bounds.h"

#include "platform/base/scalar.h"

#include <stdlib.h>

/* Parts of the model's extent. */
/* heights of clips that differ by less count as equal */
static const float near_part = 0.03f;
/* depth to which a clip may be below the ground */
static const float sunk_part = 0.15f;

static int compare_heights(const void *left, const void *right)
{
	const float *a = left, *b = right;

	return (*a > *b) - (*a < *b);
}

/*
 * Returns the least of these heights, which rise, near which most clips stand;
 * the rest pose counts half.
 */
static float most_stood_on(
	const struct character_bounds *bounds, const float *low, int count)
{
	float near = near_part * bounds->extent;
	float deepest = low[0] + sunk_part * bounds->extent;
	float ground = low[0], most = 0.0f;
	int first = 0, end = 0;

	for (int i = 0; i < count && low[i] <= deepest; i++) {
		bool rests = scalar_abs(bounds->rest.low[1] - low[i]) <= near;
		float standing;

		while (low[i] - low[first] > near) {
			first++;
		}
		while (end < count && low[end] - low[i] <= near) {
			end++;
		}
		standing = (float)(end - first) + (rests ? 0.5f : 0.0f);
		if (standing > most) {
			most = standing;
			ground = low[i];
		}
	}
	return ground;
}

float character_bounds_ground(
	const struct character_bounds *bounds, int clip_count)
{
	float *low = bounds->height;
	float ground = clip_count > 0 ? bounds->rest.low[1] : bounds->all.low[1];
	int count = 0;

	for (int i = 0; i < clip_count; i++) {
		if (bounds->is_played[i]) {
			low[count++] = bounds->clip[i].low[1];
		}
	}
	if (count > 0) {
		qsort(low, (size_t)count, sizeof(*low), compare_heights);
		ground = most_stood_on(bounds, low, count);
	}
	return ground;
}

#include "app/model/clip/key_times.h"

#include <math.h>

/*
 * Times below this are 0 to a clip. Floats next to them could be denormal, and
 * a processor that takes those for 0 would divide by an interval of 0.
 */
static const float SOONEST_S = 1e-30f;

struct key_times key_times_separate(float *time_s, int count)
{
	struct key_times result = {0, 0, 0};

	for (int i = 1; i < count; i++) {
		if (!(time_s[i] >= time_s[i - 1])) {
			result.wrong = i;
			return result;
		}
		if (time_s[i] == time_s[i - 1]) {
			result.equal++;
			result.first =
				fabsf(time_s[i]) < SOONEST_S ? i : result.first;
		}
	}
	for (int i = count - 1; result.equal > 0 && i > result.first; i--) {
		if (time_s[i - 1] >= time_s[i]) {
			time_s[i - 1] = nextafterf(time_s[i], -INFINITY);
		}
	}
	return result;
}

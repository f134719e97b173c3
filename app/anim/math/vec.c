#include "app/anim/math/vec.h"

float vec_normalize(float v[3])
{
	float length = vec_length(v);
	float scale;

	if (!(length > 1e-18f)) {
		return 0;
	}
	scale = 1 / length;
	for (int i = 0; i < 3; i++) {
		v[i] *= scale;
	}
	return length;
}

#include "tests/support/model/scattered.h"

#include "app/anim/math/vec.h"

#include <math.h>

float scattered(int i)
{
	return (float)(fmod(i * 0.754877666 + 0.3, 1) * 2 - 1);
}

void scattered_point(int v, float position[3], float normal[3])
{
	for (int k = 0; k < 3; k++) {
		position[k] = scattered(v * 3 + k);
		normal[k] = scattered(v * 5 + k + 400);
	}
	vec_normalize(normal);
}

void scattered_direction(int i, float out[3])
{
	const double golden_angle_rad = 2.399963;
	double z = (double)scattered(i);

	out[0] = (float)(sqrt(1 - z * z) * cos(golden_angle_rad * i));
	out[1] = (float)(sqrt(1 - z * z) * sin(golden_angle_rad * i));
	out[2] = (float)z;
}

void scattered_influences(
	int v, int count, int joints, uint16_t *joint, float *weight)
{
	float sum = 0;

	for (int i = 0; i < count; i++) {
		joint[i] = (uint16_t)((v + i * 3) % joints);
		weight[i] = 1.1f + scattered(v * 8 + i);
		sum += weight[i];
	}
	for (int i = 0; i < count; i++) {
		weight[i] /= sum;
	}
}

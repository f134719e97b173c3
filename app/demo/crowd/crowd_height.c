#include "app/demo/crowd/crowd_height.h"

#include "platform/base/scalar.h"

float crowd_height_px(const struct camera *camera,
	const struct crowd_position *position, float height_m,
	int picture_height)
{
	float eye[3], dx, dz, seen;

	camera_eye(camera, eye);
	dx = eye[0] - position->x;
	dz = eye[2] - position->z;
	seen = 2.0f * camera_tan_half(camera->yfov_rad) *
		scalar_sqrt(dx * dx + dz * dz + eye[1] * eye[1]);
	return height_m / seen * (float)picture_height;
}

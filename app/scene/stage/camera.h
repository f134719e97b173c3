/*
 * A camera that circles a point and frames what is there.
 */
#ifndef APP_SCENE_STAGE_CAMERA_H
#define APP_SCENE_STAGE_CAMERA_H

#include "app/scene/instance/bounds.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl.h"

struct camera {
	float target[3]; /* scene units */
	float distance;
	float yaw_rad;   /* 0 looks along -Z, at a model's front */
	float pitch_rad; /* above the horizon */
	float yfov_rad;
	float radius;  /* radius around target that must not be clipped */
	float shift_x; /* how far right of the middle the target is shown, in
			half widths of the picture */
};

/* From the front, a little to the side and from above; 30 degrees high. */
struct camera camera_default(void);

/* How a camera is to look at a box. */
struct camera_framing {
	float aspect; /* of the picture: width / height */
	float yaw_rad, pitch_rad;
	float turn_rad; /* the yaw may turn so far to either side */
	float margin;   /* 1.1 leaves a tenth free around the box */
	float shift_x;  /* as the camera's */
};

/*
 * Moves the camera so that the box fits, wherever the yaw is turned.
 */
void camera_frame(struct camera *camera, const struct bounds *bounds,
	const struct camera_framing *framing);

/* Turns it; pitch stays between the floor and straight down. */
void camera_orbit(struct camera *camera, float yaw_rad, float pitch_rad);

/* Of half an angle; for a field of view, how far it reaches a unit away. */
float camera_tan_half(float angle_rad);

/* Where the eye is, in scene units. */
void camera_eye(const struct camera *camera, float out[3]);

/* Its x, y, z times a place's plus the last is positive beyond it. */
void camera_near_plane(const struct camera *camera, float out[4]);

/* World to eye. */
void camera_view(const struct camera *camera, mat4 out);

/* What Frustumx() gets, 16.16, for a picture of this size. */
struct camera_frustum {
	fx16_t left, right, bottom, top; /* in the near plane */
	fx16_t near, far;
};
struct camera_frustum camera_frustum(
	const struct camera *camera, int width, int height);

/* Loads projection and model-view for a picture of this size. */
void camera_apply(const struct camera *camera, const struct gl *gl, int width,
	int height);

#endif

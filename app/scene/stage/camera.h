/*
 * A camera that orbits a target point and frames a box.
 */
#ifndef APP_SCENE_STAGE_CAMERA_H
#define APP_SCENE_STAGE_CAMERA_H

#include "app/scene/instance/bounds.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl.h"

struct camera {
	float target[3]; /* scene units */
	float distance;  /* from the target to the eye */
	float yaw_rad;   /* 0 looks along -Z, at a model's front */
	float pitch_rad; /* above the horizon */
	float yfov_rad;
	float radius;  /* around the target; nothing in it may be clipped */
	float shift_x; /* how far right of the picture's middle the target
			  appears, in halves of the picture's width */
};

/* Looks from the front, a little from the side and from above; 30 degrees. */
struct camera camera_default(void);

/* How camera_frame() shows a box. */
struct camera_framing {
	float aspect; /* of the picture: width / height */
	float yaw_rad, pitch_rad;
	float margin;  /* 1.1 leaves a tenth free around the box */
	float shift_x; /* as camera.shift_x */
};

/* Moves the camera so that the box fits the picture at every yaw. */
void camera_frame(struct camera *camera, const struct bounds *bounds,
	const struct camera_framing *framing);

/*
 * Adds to yaw and pitch. The pitch is clamped between the horizon and straight
 * down.
 */
void camera_orbit(struct camera *camera, float yaw_rad, float pitch_rad);

/* tan(angle / 2): half the extent that a field of view has at distance 1. */
float camera_tan_half(float angle_rad);

/* Returns the position of the eye in scene units. */
void camera_eye(const struct camera *camera, float out[3]);

/*
 * Returns the near plane's equation (a, b, c, d): a x + b y + c z + d is the
 * distance of (x, y, z) beyond the plane, negative in front of it.
 */
void camera_near_plane(const struct camera *camera, float out[4]);

/* Returns the matrix from world space to eye space. */
void camera_view(const struct camera *camera, mat4 out);

/* The arguments of Frustumx() for a picture of this size, 16.16. */
struct camera_frustum {
	fx16_t left, right, bottom, top; /* in the near plane */
	fx16_t near, far;
};
struct camera_frustum camera_frustum(
	const struct camera *camera, int width, int height);

/*
 * Loads the projection and model-view matrices for a picture of this size and
 * leaves the matrix mode at GL_MODELVIEW.
 */
void camera_apply(const struct camera *camera, const struct gl *gl, int width,
	int height);

#endif

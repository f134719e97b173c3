/*
 * A camera that orbits a target point and frames a box.
 */
#ifndef APP_SCENE_STAGE_CAMERA_H
#define APP_SCENE_STAGE_CAMERA_H

#include "app/scene/instance/bounds.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl.h"

#include <stdbool.h>

/*
 * Scene units. Matrices and frustums reach GL in 16.16 fixed point, so
 * distances stay below 32768.
 */
#define CAMERA_REACH 2000.0f

/* A rectangle of the picture; -1 is its left or lower edge, 1 the other one. */
struct camera_region {
	float left, right, bottom, top;
};

/* Keeps a box in a region of the picture while the camera orbits. */
struct camera_fit {
	bool on;
	float half[3]; /* half the box's sides, scene units */
	/* which the box fills; the margin is already taken off */
	struct camera_region region;
	float aspect; /* of the picture */
	float zoom;   /* factor of the distance; 1 shows the whole box */
};

struct camera {
	float target[3]; /* scene units */
	float distance;  /* from the target to the eye */
	float yaw_rad;   /* 0 looks along -Z, at a model's front */
	float pitch_rad; /* above the horizon */
	float yfov_rad;
	float radius; /* around the target; nothing in it may be clipped */
	/*
	 * How far the target has risen above its first place. The ground that
	 * the picture shows is farther away, and so is the far plane.
	 */
	float rise;
	/*
	 * How far right of and above the picture's middle the target appears,
	 * in halves of the picture's width and height.
	 */
	float shift_x, shift_y;
	struct camera_fit fit;
};

/*
 * Returns a camera that looks from the front, a little from the side and from
 * above, with a vertical field of view of 30 degrees.
 */
struct camera camera_default(void);

/*
 * Returns the pitch from which a box shows its form: a little above the horizon
 * or, if it lies flat, as a map, a tray or a dial on a table, from well above.
 */
float camera_pitch_for(const struct bounds *bounds);

/* How camera_frame() shows a box. */
struct camera_framing {
	float aspect; /* of the picture: width / height */
	float yaw_rad, pitch_rad;
	float margin; /* 1.1 leaves a tenth free around the box */
	struct camera_region region; /* empty: the whole picture */
	/*
	 * If true, the box fills the region as well as it can at each yaw and
	 * pitch, for which the distance changes when the camera orbits. If
	 * false, the distance is one at which the box fits at every yaw.
	 */
	bool follow;
};

/*
 * Moves the camera so that the whole box is in the region of the picture. A box
 * that extends farther than CAMERA_REACH from its centre is cut at that.
 */
void camera_frame(struct camera *camera, const struct bounds *bounds,
	const struct camera_framing *framing);

/*
 * Shows another box in the same region: its centre and sides go this fraction
 * of the way, 0 to 1. The radius in which nothing is clipped stays. Only for a
 * camera that follows.
 */
void camera_ease_to(
	struct camera *camera, const struct bounds *bounds, float fraction);

/*
 * Shows the same box in another region of a picture with this aspect. margin is
 * that of camera_framing.
 */
void camera_set_region(struct camera *camera,
	const struct camera_region *region, float margin, float aspect);

/*
 * Returns the rectangle around the box as the camera sees it now, which may
 * extend beyond the picture. For a camera that does not follow, it is the
 * region.
 */
struct camera_region camera_covered(const struct camera *camera);

/*
 * Multiplies the distance; the factor also holds when the camera orbits. All
 * factors together are kept between 1/32 and 32, where GL still has numbers for
 * the picture.
 */
void camera_zoom(struct camera *camera, float factor);

/* Returns the greatest distance at any yaw; ground has to reach that far. */
float camera_farthest(const struct camera *camera);

/*
 * Adds to yaw and pitch. The pitch is clamped between the horizon and straight
 * down.
 */
void camera_orbit(struct camera *camera, float yaw_rad, float pitch_rad);

/* Returns tan(angle / 2), half the extent of a field of view at distance 1. */
float camera_tan_half(float angle_rad);

/* Returns the position of the eye in scene units. */
void camera_eye(const struct camera *camera, float out[3]);

/* Returns the matrix from world space to eye space. */
void camera_view(const struct camera *camera, mat4 out);

/*
 * Returns how far rounding in this matrix, which GL gets in 16.16, may displace
 * what is about as far away as the target, in scene units.
 */
float camera_view_error(const struct camera *camera);

/*
 * How far ahead, as a multiple of camera.rise, ground adds to the picture: from
 * there on it is less than 10 degrees below the horizon.
 */
#define CAMERA_RISE_AHEAD 6.0f

/* The arguments of Frustumx() for a picture of this size, 16.16. */
struct camera_frustum {
	fx16_t left, right, bottom, top; /* in the near plane, up to +-16000 */
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

/*
 * Where the walkers of a crowd are: on rings, each ring with something to do.
 *
 * Places are filled from the middle outwards and, on a ring, far from each
 * other first, so that any number of walkers is spread well.
 */
#ifndef APP_DEMO_CROWD_CROWD_ROUTE_H
#define APP_DEMO_CROWD_CROWD_ROUTE_H

enum {
	CROWD_MAX = 50
};

struct crowd_route {
	const char *clip;
	float phase;      /* of the clip, 0 to 1 */
	float radius_m;   /* of the ring */
	float angle_rad;  /* on it, at time 0 */
	float speed_m_s;  /* along it, backwards if negative */
	float facing_rad; /* of who stands: added to the angle */
};

/* The place of walker number 0 to CROWD_MAX - 1. */
struct crowd_route crowd_route(int number);

/* The radius of a circle around so many of them, metres. */
float crowd_radius_m(int count);

/* Where the walker is at a time, on the ground, and the yaw it looks along. */
struct crowd_position {
	float x, z;
	float yaw_rad; /* 0 looks along +Z */
};

struct crowd_position crowd_position_at(
	const struct crowd_route *route, double time_s);

#endif

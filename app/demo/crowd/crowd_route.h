/*
 * The walkers' routes: concentric rings, each with a clip and a speed.
 *
 * Rings are filled from the middle outwards. The first walkers of a ring are
 * far from each other, so that any number of walkers is spread evenly.
 */
#ifndef APP_DEMO_CROWD_CROWD_ROUTE_H
#define APP_DEMO_CROWD_CROWD_ROUTE_H

#include <cglm/types.h>

enum {
	CROWD_MAX = 50
};

enum crowd_gait {
	CROWD_STANDS,
	CROWD_WALKS,
	CROWD_RUNS
};

struct crowd_route {
	enum crowd_gait gait;
	const char *clip; /* its name in limber's walker.glb */
	float phase;      /* offset in the clip, 0 to 1 */
	float radius_m;   /* radius of the ring; 0: the middle */
	float angle_rad;  /* on the ring at time 0 */
	float speed_m_s;  /* along the ring; negative: the other way round */
	float facing_rad; /* added to the angle if the speed is 0 */
	float size;       /* factor of the figure's height, near 1 */
};

/* Returns the route of a walker, number 0 to CROWD_MAX - 1. */
struct crowd_route crowd_route(int number);

/* Returns the radius of a circle that contains the first count walkers. */
float crowd_radius_m(int count);

/* A walker's position on the ground in metres and its heading. */
struct crowd_position {
	float x, z;
	float yaw_rad;  /* 0 faces +Z */
	float lean_rad; /* to its left (+X), into the ring */
};

struct crowd_position crowd_position_at(
	const struct crowd_route *route, double time_s);

/*
 * Writes the matrix that scales a figure at the origin by route->size and moves
 * it to its place in the crowd.
 */
void crowd_matrix(const struct crowd_route *route,
	const struct crowd_position *position, mat4 out);

#endif

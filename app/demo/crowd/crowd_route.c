#include "app/demo/crowd/crowd_route.h"

#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

struct ring {
	enum crowd_gait gait;
	int count; /* places on the ring */
	int step;  /* places from one walker to the next one added */
	float radius_m;
	float speed_m_s;     /* of the clip's feet; negative: clockwise */
	const char *clip[4]; /* of walkers in turn; NULL: clip[0] */
	float facing_rad;
};

/* Steps are coprime to their ring's count, so all places are filled. */
static const struct ring rings[] = {
	{CROWD_STANDS, 1, 1, 0.0f, 0.0f, {"wave"}, 0.45f},
	{CROWD_WALKS, 5, 2, 1.15f, 1.03f, {"walk"}, 0.0f},
	{CROWD_RUNS, 10, 3, 2.2f, -2.6f, {"run"}, 0.0f},
	{CROWD_WALKS, 14, 5, 3.3f, 1.03f, {"walk"}, 0.0f},
	{CROWD_STANDS, 20, 7, 4.4f, 0.0f, {"idle", "wave", "jump", "idle"},
		SCALAR_PI},
};

static const float golden = 0.618034f;
static const float gravity_m_s2 = 9.81f;
static const float body_m = 0.4f; /* a walker's own radius */

/* Returns one of twelve sizes, which repeat and are not in order. */
static float size_of(int number)
{
	return 0.90f + 0.18f * (float)((number * 5 + 7) % 12) / 11.0f;
}

/* The lean at which gravity balances the ring's centrifugal force. */
static float lean_of(const struct crowd_route *route)
{
	float speed = route->speed_m_s;
	float lean = scalar_atan2(speed * speed, gravity_m_s2 * route->radius_m);

	return speed > 0.0f ? lean : -lean;
}

struct crowd_route crowd_route(int number)
{
	const struct ring *ring = rings;
	int slot = number;
	const char *clip;
	float fraction = (float)number * golden;

	while (slot >= ring->count && ring < rings + ARRAY_COUNT(rings) - 1) {
		slot -= ring->count;
		ring++;
	}
	clip = ring->clip[slot % (int)ARRAY_COUNT(ring->clip)];
	return (struct crowd_route){
		.gait = ring->gait,
		.clip = clip ? clip : ring->clip[0],
		.phase = fraction - (float)(int)fraction,
		.radius_m = ring->radius_m,
		.angle_rad = (float)(slot * ring->step % ring->count) *
			(2.0f * SCALAR_PI / (float)ring->count),
		.speed_m_s = ring->speed_m_s,
		.facing_rad = ring->facing_rad,
		.size = size_of(number),
	};
}

float crowd_radius_m(int count)
{
	return crowd_route(count > 0 ? count - 1 : 0).radius_m + body_m;
}

struct crowd_position crowd_position_at(
	const struct crowd_route *route, double time_s)
{
	float angle = route->angle_rad;
	float facing = route->facing_rad;
	float lean = 0.0f;

	if (route->speed_m_s != 0.0f) {
		double turns = time_s * (double)route->speed_m_s /
			(2.0 * (double)SCALAR_PI * (double)route->radius_m);

		turns -= (double)(long)turns;
		angle += (float)turns * 2.0f * SCALAR_PI;
		facing = route->speed_m_s > 0.0f ? 0.5f * SCALAR_PI
						 : -0.5f * SCALAR_PI;
		lean = lean_of(route);
	}
	return (struct crowd_position){
		.x = route->radius_m * scalar_sin(angle),
		.z = route->radius_m * scalar_cos(angle),
		.yaw_rad = angle + facing,
		.lean_rad = lean,
	};
}

void crowd_matrix(const struct crowd_route *route,
	const struct crowd_position *position, mat4 out)
{
	float cy = scalar_cos(position->yaw_rad);
	float sy = scalar_sin(position->yaw_rad);
	float cl = scalar_cos(position->lean_rad);
	float sl = scalar_sin(position->lean_rad);
	/* Rotates about z by lean_rad, then about y by yaw_rad. */
	const float column[4][4] = {{cl * cy, -sl, -cl * sy, 0.0f},
		{sl * cy, cl, -sl * sy, 0.0f}, {sy, 0.0f, cy, 0.0f},
		{position->x, 0.0f, position->z, 1.0f}};

	for (int c = 0; c < 4; c++) {
		for (int r = 0; r < 4; r++) {
			out[c][r] = column[c][r] * (c < 3 ? route->size : 1.0f);
		}
	}
}

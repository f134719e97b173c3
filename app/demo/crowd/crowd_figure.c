#include "app/demo/crowd/crowd_figure.h"

#include "platform/base/scalar.h"

/* The room of a person, in metres: to each side, to the front, upwards. */
static const float person_side_m = 0.4f, person_front_m = 0.6f,
		   person_height_m = 1.72f;
/* A model is not scaled by factors between 1 / as_it_is and as_it_is. */
static const float as_it_is = 1.25f;
static const float upright = 1.8f;   /* height / side of a person, at least */
static const float corner_m = 0.25f; /* added to the radius for a wide figure */
static const float fastest_m_s = 4.0f;
static const float viewer_rad = 0.45f; /* where figures that only stand look */

/* The larger of the distances from center to both sides of the box. */
static float reach(const struct bounds *bounds, int axis, float center)
{
	float low = center - bounds->low[axis];
	float high = bounds->high[axis] - center;

	return scalar_max(low, high);
}

/* The box of all motions, without the way that clips move the figure. */
static struct bounds measure(
	struct instance *instance, const struct motions *motions)
{
	struct bounds all = bounds_empty();

	for (int i = 0; i < MOTION_ROLES; i++) {
		struct bounds one = motion_bounds(instance, &motions->role[i]);

		bounds_join(&all, &one);
	}
	return all;
}

/*
 * Finds the point that stands on the route: on the ground below the origin or,
 * where the box does not contain the origin along x or z, below its middle.
 */
static void find_center(const struct bounds *bounds, float center[3])
{
	float height = bounds->high[1] - bounds->low[1];

	for (int axis = 0; axis < 3; axis++) {
		bool beside =
			bounds->low[axis] > 0.0f || bounds->high[axis] < 0.0f;

		center[axis] = axis != 1 && beside
			? 0.5f * (bounds->low[axis] + bounds->high[axis])
			: 0.0f;
	}
	center[1] = bounds_ground(bounds);
	if (scalar_abs(bounds->low[1]) <= 0.03f * height) {
		center[1] -= bounds->low[1];
	}
}

static float lesser_ratio(float ratio, float most, float size)
{
	return size > 0.0f && most / size < ratio ? most / size : ratio;
}

static void fit(struct crowd_figure *figure, const struct bounds *bounds)
{
	float side = reach(bounds, 0, figure->center[0]);
	float front = reach(bounds, 2, figure->center[2]);
	float height = bounds->high[1] - figure->center[1];
	float scale = 1e9f;

	scale = lesser_ratio(scale, person_side_m, side);
	scale = lesser_ratio(scale, person_front_m, front);
	scale = lesser_ratio(scale, person_height_m, height);
	figure->scale = scale < as_it_is && scale > 1.0f / as_it_is ? 1.0f
		: scale >= 1e9f                                     ? 1.0f
								    : scale;
	figure->beyond_m = height > upright * side ? 0.0f : corner_m;
}

/*
 * Finds the clips of walkers that stand, by their names. Such a clip may move
 * the figure, as a jump does.
 */
static void find_named(struct crowd_figure *figure, struct instance *instance)
{
	int count = 0;

	for (int number = 0; number < CROWD_MAX; number++) {
		struct crowd_route route = crowd_route(number);
		int clip = route.gait == CROWD_STANDS
			? model_find_clip(instance->model, route.clip)
			: -1;
		int at = 0;

		while (at < count && figure->named[at].clip != clip) {
			at++;
		}
		if (clip >= 0 && at == count && count < CROWD_NAMED_MAX) {
			figure->named[count++] = motion_of_clip(instance, clip);
		}
		figure->named_clip[number] = clip >= 0 && at < count ? at : -1;
	}
}

int crowd_figure_make(struct crowd_figure *figure, const struct demo_env *env,
	struct actor *actor)
{
	const struct character_request request = demo_env_request(env);
	int error = motions_find(
		&request, actor->instance, env->log, &figure->motions);
	struct bounds bounds;

	if (error) {
		return error;
	}
	figure->one_clip = env->clip;
	find_named(figure, actor->instance);
	figure->front_rad = figure->motions.role[MOTION_WALK].facing_rad;
	bounds = measure(actor->instance, &figure->motions);
	if (!bounds_is_empty(&bounds)) {
		find_center(&bounds, figure->center);
	}
	fit(figure, &bounds);
	return 0;
}

struct crowd_route crowd_figure_route(
	const struct crowd_figure *figure, int number, struct motion *motion)
{
	static const enum motion_role roles[] = {
		[CROWD_STANDS] = MOTION_STAND,
		[CROWD_WALKS] = MOTION_WALK,
		[CROWD_RUNS] = MOTION_RUN,
	};
	struct crowd_route route = crowd_route(number);
	int named = figure->one_clip ? -1 : figure->named_clip[number];
	bool stood = route.speed_m_s == 0.0f;
	float speed;

	*motion = figure->motions.role[roles[route.gait]];
	if (named >= 0) {
		*motion = figure->named[named];
		motion->speed = 0.0f;
	}
	speed = scalar_clamp(motion->speed * figure->scale, 0.0f, fastest_m_s);
	if (route.radius_m == 0.0f) {
		speed = 0.0f;
	}
	route.speed_m_s = route.speed_m_s < 0.0f ? -speed : speed;
	if (!stood && speed == 0.0f) {
		route.facing_rad = viewer_rad - route.angle_rad;
	}
	return route;
}

void crowd_figure_matrix(const struct crowd_figure *figure,
	const struct crowd_route *route, const struct crowd_position *position,
	const float drift[3], mat4 out)
{
	struct crowd_route sized = *route;
	struct crowd_position turned = *position;
	const float offset[3] = {figure->center[0] + drift[0],
		figure->center[1] + drift[1], figure->center[2] + drift[2]};

	sized.size *= figure->scale;
	turned.yaw_rad -= figure->front_rad;
	crowd_matrix(&sized, &turned, out);
	for (int axis = 0; axis < 3; axis++) {
		for (int row = 0; row < 3; row++) {
			out[3][row] -= out[axis][row] * offset[axis];
		}
	}
}

#include "app/character/run/parameters.h"

#include "platform/base/scalar.h"

enum {
	MOVES_AFTER = 3 /* changes in a row after which a goal moves */
};

/* The time to ease to a goal, in time constants of the decay. */
static const float decays_an_ease = 3;

void character_parameter_set(struct character_parameter *parameter, float goal)
{
	goal = scalar_clamp(goal, parameter->range[0], parameter->range[1]);
	if (goal != parameter->goal) {
		parameter->goal = goal;
		parameter->from = parameter->value;
		parameter->elapsed_s = 0;
	}
}

void character_parameter_step(struct character_parameter *parameter, int steps)
{
	int count = parameter->stop_count, at = 0;

	/*
	 * A goal between two stops counts as the stop that lies opposite to the
	 * step's direction; one outside of all stops as one before the first or
	 * behind the last.
	 */
	if (steps > 0) {
		at = -1;
		while (at + 1 < count &&
			parameter->stop[at + 1] <= parameter->goal) {
			at++;
		}
	} else {
		while (at < count && parameter->stop[at] < parameter->goal) {
			at++;
		}
	}
	at += steps;
	at = at < 0 ? 0 : at < count ? at : count - 1;
	character_parameter_set(parameter, parameter->stop[at]);
}

static float source_value(const struct character *character,
	const struct character_parameter *parameter)
{
	float low = parameter->range[0], high = parameter->range[1];
	double time_s = character->now_s;
	double turns;

	switch (parameter->source) {
	case CHARACTER_SOURCE_TIME:
		return (float)time_s * parameter->scale + parameter->offset;
	case CHARACTER_SOURCE_SINE:
		turns = time_s / (double)parameter->scale +
			(double)parameter->offset;
		/* Whole turns are taken off before float loses them. */
		turns -= (double)(int64_t)turns;
		return low +
			(high - low) *
			(0.5f + 0.5f * scalar_sin(2 * SCALAR_PI * (float)turns));
	case CHARACTER_SOURCE_MOTION:
		return low + (high - low) * character->motion_level;
	case CHARACTER_SOURCE_PARAMETER:
		return *parameter->other * parameter->scale + parameter->offset;
	default:
		return parameter->goal;
	}
}

/* Counts the frames in which the goal keeps moving, as by a held button. */
static bool has_moving_goal(struct character_parameter *parameter)
{
	bool changed = parameter->goal != parameter->last_goal;

	parameter->last_goal = parameter->goal;
	parameter->changes = !changed              ? 0
		: parameter->changes < MOVES_AFTER ? parameter->changes + 1
						   : MOVES_AFTER;
	return parameter->changes == MOVES_AFTER;
}

/*
 * The way to a goal begins slowly, so that one which began anew in every frame
 * would get nowhere: behind a goal that moves, the value decays towards it. The
 * goal changed in this frame then, so its time began anew.
 */
static void ease(struct character_parameter *parameter, float step_s)
{
	float u;

	if (has_moving_goal(parameter) && parameter->ease_s > 0) {
		parameter->value += (parameter->goal - parameter->value) *
			(1 -
				scalar_exp(-decays_an_ease * step_s /
					parameter->ease_s));
		parameter->from = parameter->value;
		return;
	}
	parameter->elapsed_s += step_s;
	if (parameter->elapsed_s >= parameter->ease_s) {
		parameter->value = parameter->goal;
		return;
	}
	u = ease_at(EASE_CUBIC, parameter->elapsed_s / parameter->ease_s);
	parameter->value =
		parameter->from + (parameter->goal - parameter->from) * u;
}

void character_parameters_update(struct character *character)
{
	for (int i = 0; i < character->parameter_count; i++) {
		struct character_parameter *parameter = &character->parameter[i];

		character_parameter_set(
			parameter, source_value(character, parameter));
		ease(parameter, character->step_s);
	}
}

void character_switches_update(struct character *character)
{
	for (int i = 0; i < character->switch_count; i++) {
		struct character_switch *is = character->switches[i];
		float step = is->fade_s > 0 ? character->step_s / is->fade_s : 1;

		is->level = scalar_clamp(
			is->level + (is->is_on ? step : -step), 0, 1);
		is->now = ease_at(EASE_CUBIC, is->level) * *is->weight;
	}
}

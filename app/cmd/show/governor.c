#include "app/cmd/show/governor.h"

#include "app/scene/hud/hud_group.h"

#include <stdio.h>

enum {
	SETTLING_FRAMES = 8 /* frames before the mean is used */
};

static const float newest_weight = 0.15f; /* the newest frame's, in the mean */
/*
 * A step is taken back if frames would then take less than this of the budget.
 */
static const float restore_fraction = 0.9f;
/*
 * A longer frame that takes many times as long as the one before tells nothing
 * of the work: the process was stopped. If the next one is as long, it counts.
 */
static const float stopped_ms = 1000.0f, stopped_times = 8.0f;
static const double over_limit_s = 0.2;
static const double wait_min_s = 1.0, wait_max_s = 30.0;
/*
 * If no step is taken for this long after one was taken back, wait_s is reset.
 */
static const double lasting_s = 5.0;

static const struct {
	struct demo_reduction reduction;
	unsigned frames_a_pose;
	const char *text;
} levels[GOVERNOR_STEPS + 1] = {
	{{0.0f, 0, false}, 1, NULL},
	{{2.0f, 0, false}, 1, "triangles to 2 px"},
	{{4.0f, 0, false}, 1, "triangles to 4 px"},
	{{4.0f, 2, false}, 1, "2 influences"},
	{{4.0f, 1, false}, 1, "1 influence"},
	{{4.0f, 1, true}, 1, "normals held"},
	{{4.0f, 1, true}, 2, "half the poses"},
	{{4.0f, 1, true}, 4, "a quarter of poses"},
};

static void reset_mean(struct governor *governor)
{
	governor->frames = 0;
	governor->over_s = governor->under_s = -1.0;
}

struct governor governor_begin(float budget_ms)
{
	struct governor governor = {
		.budget_ms = budget_ms,
		.wait_s = wait_min_s,
		.restored_s = -lasting_s,
	};

	reset_mean(&governor);
	return governor;
}

static void average(struct governor *governor, float work_ms)
{
	/* The first frames have equal weights. */
	float fraction = 1.0f / (float)(governor->frames + 1);

	fraction = fraction > newest_weight ? fraction : newest_weight;
	governor->mean_ms = (governor->frames ? governor->mean_ms : 0.0f) *
			(1.0f - fraction) +
		work_ms * fraction;
	governor->frames++;
}

static bool was_stopped(struct governor *governor, float work_ms)
{
	float before_ms = governor->last_ms;

	governor->last_ms = work_ms;
	return work_ms > stopped_ms && work_ms > stopped_times * before_ms;
}

static void measure_saving(struct governor *governor)
{
	float saved_ms = governor->before_ms - governor->mean_ms;

	if (governor->measuring) {
		governor->saved_ms[governor->level] =
			saved_ms > 0.0f ? saved_ms : 0.0f;
		governor->measuring = false;
	}
}

static void reduce(struct governor *governor, double now_s)
{
	bool lasted = now_s - governor->restored_s > lasting_s;
	double longer_s = 2.0 * governor->wait_s;

	governor->wait_s = lasted       ? wait_min_s
		: longer_s < wait_max_s ? longer_s
					: wait_max_s;
	governor->before_ms = governor->mean_ms;
	governor->measuring = true;
	governor->level++;
	reset_mean(governor);
}

static void restore(struct governor *governor, double now_s)
{
	governor->restored_s = now_s;
	governor->level--;
	reset_mean(governor);
}

/* Returns the time since which the condition holds, or -1. */
static double since(bool is, double begun_s, double now_s)
{
	return !is ? -1.0 : begun_s < 0.0 ? now_s : begun_s;
}

bool governor_feed(struct governor *governor, double now_s, float work_ms)
{
	int level = governor->level;
	float restored_ms;

	if (governor->budget_ms <= 0.0f || was_stopped(governor, work_ms)) {
		return false;
	}
	average(governor, work_ms);
	if (governor->frames < SETTLING_FRAMES) {
		return false;
	}
	measure_saving(governor);
	restored_ms = governor->mean_ms + governor->saved_ms[level];
	governor->over_s = since(level < GOVERNOR_STEPS &&
			governor->mean_ms > governor->budget_ms,
		governor->over_s, now_s);
	governor->under_s = since(level > 0 &&
			restored_ms < restore_fraction * governor->budget_ms,
		governor->under_s, now_s);
	if (governor->over_s >= 0.0 && now_s - governor->over_s >= over_limit_s) {
		reduce(governor, now_s);
	} else if (governor->under_s >= 0.0 &&
		now_s - governor->under_s >= governor->wait_s) {
		restore(governor, now_s);
	}
	return governor->level != level;
}

struct demo_reduction governor_reduction(const struct governor *governor)
{
	return levels[governor->level].reduction;
}

bool governor_poses(struct governor *governor)
{
	return governor->turn++ % levels[governor->level].frames_a_pose == 0;
}

const char *governor_text(const struct governor *governor)
{
	return levels[governor->level].text;
}

void governor_label(const struct governor *governor, struct hud *hud)
{
	const char *text = governor_text(governor);
	struct hud_group group;
	char label[32], value[32];

	if (governor->budget_ms <= 0.0f) {
		return;
	}
	group = hud_group_begin(hud, HUD_BOTTOM_LEFT, NULL);
	snprintf(label, sizeof(label), "budget %.3g ms",
		(double)governor->budget_ms);
	snprintf(value, sizeof(value), "%.1f", (double)governor->mean_ms);
	hud_group_bar(&group, label, value,
		governor->mean_ms / governor->budget_ms,
		governor->mean_ms > governor->budget_ms ? hud_color_rose
							: hud_color_green);
	hud_group_mark(&group, text ? text : "nothing left out", "",
		text ? hud_color_rose : hud_color_green);
	hud_group_end(&group);
}

/*
 * Sections [motion], [target], [output] and [scene].
 */
#include "app/character/build/build.h"
#include "app/scene/instance/bounds.h"
#include "platform/base/scalar.h"
#include "platform/buttons/gpio_output.h"

#include <errno.h>
#include <string.h>

static const struct character_section *only_section(
	const struct character_build *build, const char *kind)
{
	return character_text_find(build->text->first, kind);
}

/* foot = LEFT RIGHT */
static int read_feet(struct character_words *words,
	const struct character_key *key, void *member)
{
	int *foot = member;
	int error = character_read_node(words, key, &foot[0]);

	return error ? error : character_read_node(words, key, &foot[1]);
}

static const struct character_key motion_keys[] = {
	{"root", character_read_node, offsetof(struct character_motion, root),
		.right = "the node that clips move over the ground"},
	{"feet", read_feet, offsetof(struct character_motion, foot),
		.right = "the nodes of both feet, such as foot.L foot.R"},
	{"speed", character_read_value, offsetof(struct character_motion, speed),
		.right = "m/s, or a parameter"},
	{"clips", character_read_switch,
		offsetof(struct character_motion, by_clips),
		.right = "yes or no"},
	{0},
};

/* The largest side of a skeleton that is likely to be in metres, and a human's. */
static const float size_least_m = 0.3f, size_most_m = 10, human_m = 1.65f;

/* The size of the skeleton at rest, over all nodes. */
static void measure(struct character_build *build)
{
	struct character *character = build->character;
	struct bounds box = bounds_empty();
	float size, height;

	for (int i = 0; i < build->model->node_count; i++) {
		bounds_add(&box, character->instance->world[i][3]);
	}
	size = bounds_extent(&box);
	height = scalar_max(box.high[1] - box.low[1], 0);
	character->motion.height_m = height;
	character->motion.near_m = 0.025f * height;
	character->metre =
		size <= 0 || (size >= size_least_m && size <= size_most_m)
		? 1
		: size / human_m;
}

int character_build_motion(struct character_build *build)
{
	struct character_motion *motion = &build->character->motion;
	const struct character_section *section = only_section(build, "motion");
	int error;

	*motion = (struct character_motion){.root = -1,
		.foot = {-1, -1},
		.low_m = {1e9f, 1e9f},
		.planted = -1};
	error = section
		? character_read_section(build, section, motion_keys, motion)
		: 0;
	measure(build);
	return error;
}

/* place = X Y Z, each a number or a parameter. */
static int read_place(struct character_words *words,
	const struct character_key *key, void *member)
{
	const float **place = member;
	int error = 0;

	for (int i = 0; i < 3 && !error; i++) {
		error = character_read_value(words, key, &place[i]);
	}
	return error;
}

static const struct character_key target_keys[] = {
	{"place", read_place, offsetof(struct character_target, place),
		.right = "x y z, each a number of metres or a parameter"},
	{"node", character_read_node, offsetof(struct character_target, node),
		.right = "the name of a node"},
	{"camera", character_read_switch,
		offsetof(struct character_target, is_camera),
		.right = "yes or no"},
	{"radius", character_read_number,
		offsetof(struct character_target, radius_m), 0,
		CHARACTER_LENGTH_MAX,
		.right = "metres of the ball that shows the target; 0 shows none"},
	{"color", character_read_numbers3,
		offsetof(struct character_target, color), 0, 1,
		.right = "red, green and blue from 0 to 1"},
	{0},
};

static int read_target(struct character_build *build,
	const struct character_section *section, void *one)
{
	static const float zero = 0;
	struct character_target *target = one;

	*target = (struct character_target){
		.name = section->name,
		.place = {&zero, &zero, &zero},
		.node = -1,
		.color = {0.95f, 0.35f, 0.2f},
	};
	return character_read_section(build, section, target_keys, target);
}

int character_build_targets(struct character_build *build)
{
	static const struct character_kind kind = {
		"target", sizeof(struct character_target), read_target};

	return character_read_kind(build, &kind,
		&build->character->target_count, &build->character->target);
}

/*
 * The GPIO driver checks the line; its message is dropped, because the one here
 * names the file and the key.
 */
static int read_gpio_line(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct log nowhere = log_to_nowhere();
	const char *line = character_next_word(words);
	struct character_output *output = member;

	output->line = line;
	output->file = words->line->file;
	output->number = words->line->number;
	return line && gpio_output_check(line, &nowhere) == 0
		? 0
		: character_fail(words, "%s names no line: give %s",
			  line ? line : ",", key->right);
}

static const struct character_key output_keys[] = {
	{"line", read_gpio_line,
		.right = "a GPIO line as --buttons names it, such as gpiochip0/18"},
	{0},
};

int character_build_outputs(struct character_build *build)
{
	struct character *character = build->character;
	const struct character_section *section = only_section(build, "output");
	int error = 0;

	for (; section && !error;
		section = character_text_find(section->next, "output")) {
		struct character_output *output;

		if (character->output_count == CHARACTER_OUTPUTS_MAX) {
			return character_fail_section(build, section,
				"a character has at most %d outputs",
				CHARACTER_OUTPUTS_MAX);
		}
		output = &character->output[character->output_count++];
		output->name = section->name;
		error = character_read_section(
			build, section, output_keys, output);
		if (!error && !output->line) {
			error = character_fail_missing(build, section,
				"line = CHIP/LINE, such as gpiochip0/18");
		}
	}
	return error;
}

/* A tour presses a button for a moment: what is held does nothing then. */
static int check_press(struct character_words *words, enum button button)
{
	const struct character_binding *one = words->build->character->binding;

	while (one &&
		(one->button != button || one->gesture != CHARACTER_PRESS)) {
		one = one->next;
	}
	return one
		? 0
		: character_fail(words,
			  "%s does nothing when it is pressed for a moment: give actions instead, such as %s",
			  button_name(button), "1 move Arm pitch 0.5");
}

/*
 * tour = SECONDS BUTTON, or SECONDS ACTION, ACTION ... The lines may stand in
 * any order, as a file may add to those of one that it includes.
 */
static int read_tour(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_tour **last = member;
	struct character_tour *tour =
		ARENA_NEW(words->build->arena, struct character_tour);
	struct character_action *action = NULL;
	float time_s;
	int error;

	if (!tour) {
		return character_fail_memory(words->build);
	}
	if (!character_take_number(words, &time_s) || time_s < 0) {
		return character_fail(words,
			"a line begins with its time in seconds: give %s",
			key->right);
	}
	while (*last && (*last)->time_s <= (double)time_s) {
		last = &(*last)->next;
	}
	tour->time_s = (double)time_s;
	tour->button = BUTTON_COUNT;
	for (int i = 0; i < BUTTON_COUNT && tour->button == BUTTON_COUNT; i++) {
		if (character_take(words, button_name((enum button)i))) {
			tour->button = (enum button)i;
		}
	}
	if (tour->button != BUTTON_COUNT) {
		error = check_press(words, tour->button);
	} else {
		do {
			error = character_read_action(words, &action, NULL);
		} while (!error && character_take(words, ","));
	}
	tour->action = action;
	tour->next = *last;
	*last = tour;
	return error;
}

static int read_period(struct character_words *words,
	const struct character_key *key, void *member)
{
	float period_s = 0;
	int error = character_read_number(words, key, &period_s);

	*(double *)member = (double)period_s;
	return error;
}

/* yes, no or a value that shows something while it is above 0. */
static int read_shown(struct character_words *words,
	const struct character_key *key, void *member)
{
	static const float yes = 1, no = 0;

	if (character_take(words, "yes")) {
		*(const float **)member = &yes;
		return 0;
	}
	if (character_take(words, "no")) {
		*(const float **)member = &no;
		return 0;
	}
	return character_read_value(words, key, member);
}

static const char *const labels[] = {"left", "right", "none", NULL};

#define SCENE(name) offsetof(struct character_scene, name)

static const struct character_key scene_keys[] = {
	{"waves", character_read_value, SCENE(wave_m), 0, CHARACTER_LENGTH_MAX,
		.right = "metres of uneven ground, 0 or more, or a parameter"},
	{"yaw", character_read_angle, SCENE(yaw_rad), -360, 360,
		.right = "degrees from -360 to 360"},
	{"pitch", character_read_angle, SCENE(pitch_rad), 0, 89,
		.right = "degrees from 0 to 89"},
	{"margin", character_read_number, SCENE(margin), 0.2f, 10,
		.right = "a factor from 0.2 to 10; 1.1 leaves a tenth free"},
	{"zoom", character_read_number, SCENE(zoom), 0.04f, 1,
		.right = "a factor from 0.04 to 1, of the distance at which all is seen"},
	{"shadow", read_shown, SCENE(shadow), 0, 1,
		.right = "yes, no or a parameter"},
	{"relief", read_shown, SCENE(relief), 0, 1,
		.right = "yes, no or a parameter"},
	{"labels", character_read_choice, SCENE(labels), .choice = labels,
		.right = "left, right or none"},
	{"period", read_period, SCENE(tour_s), 0.1f, 3600,
		.right = "seconds after which the tour begins again"},
	{"tour", read_tour, SCENE(tour),
		.right = "a time and a button or actions, such as 2.2 LEFT or 2.2 go run"},
	{0},
};

/*
 * A tour without a period begins again a little after its last line. Lines
 * after the period would never act.
 */
static void end_tour(const struct character_build *build,
	const struct character_section *section, struct character_scene *scene)
{
	const double rest_s = 2.0;
	const struct character_tour *last = scene->tour;

	while (last && last->next) {
		last = last->next;
	}
	if (last && scene->tour_s == 0.0) {
		scene->tour_s = last->time_s + rest_s;
	} else if (last && last->time_s > scene->tour_s) {
		log_warning(build->log,
			"%s:%d: [scene] tour: the line at %g s never acts, as the tour begins again after period = %g: give a longer period",
			section->file, section->number, last->time_s,
			scene->tour_s);
	}
}

int character_build_scene(struct character_build *build)
{
	static const float level = 0, shown = 1;
	struct character_scene *scene = &build->character->scene;
	const struct character_section *section = only_section(build, "scene");
	int error;

	*scene = (struct character_scene){
		.wave_m = &level,
		.yaw_rad = 0.45f,
		.pitch_rad = -1,
		.margin = 1.15f,
		.zoom = 1,
		.shadow = &shown,
		.relief = &shown,
	};
	error = section
		? character_read_section(build, section, scene_keys, scene)
		: 0;
	end_tour(build, section, scene);
	return error;
}

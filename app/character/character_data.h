/*
 * The data of a character: what its file says, compiled for one instance.
 *
 * app/character/build makes it from the text and resolves all names, so that a
 * frame looks up nothing: an input is the address of a number, and what a frame
 * does to the pose is a flat list of operations. All memory comes from one
 * arena within the model's budget. Frames change only the members below
 * "Changes:".
 */
#ifndef APP_CHARACTER_CHARACTER_DATA_H
#define APP_CHARACTER_CHARACTER_DATA_H

#include "app/anim/clip.h"
#include "app/anim/ease.h"
#include "app/character/character_morph.h"
#include "app/character/character_part.h"
#include "app/character/state/inertia.h"
#include "app/character/text/character_text.h"
#include "app/scene/instance/instance.h"
#include "platform/buttons/buttons.h"

/* Where a parameter's goal comes from. */
enum character_source {
	CHARACTER_SOURCE_ACTIONS, /* set, add and toggle */
	CHARACTER_SOURCE_TIME,    /* seconds times scale */
	CHARACTER_SOURCE_SINE,    /* over the range, in scale seconds */
	CHARACTER_SOURCE_MOTION,  /* motion before the video camera, 0..1 */
	CHARACTER_SOURCE_PARAMETER,
};

enum {
	CHARACTER_STOPS_MAX = 32
};

/* A named number. Its value eases from where it is to its goal. */
struct character_parameter {
	const char *name;
	float range[2];
	float start;
	float ease_s;
	enum character_source source;
	/* the number that CHARACTER_SOURCE_PARAMETER follows */
	const float *other;
	/* of the source: factor and summand, or a sine's period and phase */
	float scale, offset;
	int choice_count; /* 0: it is no choice */
	/* [choice_count], names of the values 0, 1 ... */
	const char *const *choice;
	int stop_count; /* values of CHARACTER_STEP */
	float stop[CHARACTER_STOPS_MAX];
	bool unlabelled; /* labels do not show it */

	/* Changes: */
	/* value eases from .from to .goal, elapsed_s after goal has changed */
	float value, goal, from, elapsed_s;
	float last_goal; /* in the last frame */
	int changes;     /* frames in a row in which the goal has changed */
};

/* What an action does. */
enum character_verb {
	CHARACTER_SET,    /* parameter index = amount */
	CHARACTER_ADD,    /* parameter index += amount */
	CHARACTER_STEP,   /* parameter index: amount stops on */
	CHARACTER_TOGGLE, /* parameter index: low or high end of its range */
	CHARACTER_SWITCH, /* switch index: amount 1 on, 0 off, -1 toggles it */
	CHARACTER_GO,     /* to state index */
	CHARACTER_NEXT,   /* amount states on, in the order of the file */
	CHARACTER_ROW,    /* plays all states in a row, or stops */
	CHARACTER_PLAY,   /* layer index, from its start */
	/* morph index: to key detail or, if -1, amount keys on */
	CHARACTER_MORPH,
	CHARACTER_PACE,   /* morph index: amount times as fast */
	CHARACTER_CURVE,  /* morph index: the next of its curves */
	CHARACTER_TIMING, /* morph index: over time or by frames */
	/* shake index: to preset detail or, if -1, amount presets on */
	CHARACTER_PRESET,
	CHARACTER_MOVE,   /* part index: degree of freedom detail by amount */
	CHARACTER_RUN,    /* sequence index */
	CHARACTER_REPEAT, /* sequence index, again and again */
	CHARACTER_STOP,   /* sequence index */
	/*
	 * part index: to node detail, if the part is at most amount metres from
	 * place or if amount is 0; detail -1: back to its place in the model
	 */
	CHARACTER_ATTACH,
	CHARACTER_DROP,   /* part index, onto node detail or the ground below */
	CHARACTER_KEYS,   /* shows or hides what the buttons do */
	CHARACTER_LINE,   /* writes text to standard output */
	CHARACTER_OUTPUT, /* output index: on for amount ms; 0 off, -1 on */
	CHARACTER_TURN,   /* the camera, amount radians */
	CHARACTER_TILT,
	CHARACTER_ZOOM,   /* the camera, by amount of its distance */
	CHARACTER_PAUSE,  /* pauses or goes on */
	CHARACTER_TOUR,   /* begins or ends the tour */
	CHARACTER_LABELS, /* shows or hides the labels */
};

/* The meaning of index, detail and amount depends on the verb. */
struct character_action {
	enum character_verb verb;
	int index, detail;
	float amount;
	bool has_place;
	float place[3]; /* in the node's frame */
	const char *text;
	struct character_action *next; /* or NULL */
};

/* A time of a clip at which actions run. */
struct character_event {
	float time_s;
	const struct character_action *action;
	struct character_event *next;
};

enum {
	CHARACTER_MARKS_MAX = 16,
	CHARACTER_SAMPLES = 48 /* of a clip, at even distances in time */
};

/* What the file says about a clip beyond the model. */
struct character_clip {
	const struct model_clip *clip; /* NULL: the rest pose */
	int mark_count; /* 0: the clip is not kept in phase with others */
	/* [mark_count], increasing seconds that blended clips pass together */
	float mark[CHARACTER_MARKS_MAX];
	/* how far the motion's root goes in the clip, in its parent's frame */
	float travel[3];
	float carried_m[2]; /* the same in the world along x and z */
	/* the figure's speed over the ground along x and z */
	float ground_m_per_s[2];
	/*
	 * [pairs of feet][CHARACTER_SAMPLES], heights of the lower sole; NULL
	 * without [feet]
	 */
	float (*sole_m)[CHARACTER_SAMPLES];
	struct character_event *event;
};

/* A clip as a state plays it. */
struct character_entry {
	const struct character_clip *of;
	float at; /* the parameter's value at which only this clip plays */
	struct clip_cursor *cursor; /* of a layer, or of the state that plays */
	/* Changes: */
	/* since the clip began; below 0 and beyond its end unless it plays once */
	double time_s;
	double before_s; /* time_s in the last frame */
	float shown_s;   /* the time in the clip that is shown; -1: none yet */
	float weight;
	/* another clip of the blend causes the events: it has no less weight */
	bool follows;
};

/* How a state or a transition takes over from the shown pose. */
struct character_fade {
	float duration_s;
	int frames; /* if above 0, the duration in frames of the clip before */
	enum inertia_curve curve;
};

struct character_state {
	const char *name;
	int entry_count;
	struct character_entry *entry; /* sorted by .at */
	uint8_t *paths; /* [node_count], changed: bits 1 << enum model_path */
	const float *position; /* the value that chooses between the entries */
	const float *rate;
	enum clip_repeat repeat;
	int next;      /* the state after the end, or -1 */
	float pause_s; /* how long the end is shown before the next state */
	struct character_fade fade;
	const struct character_action *enter, *leave;
};

/* One of a list of comparisons, all of which have to hold. */
struct character_condition {
	const float *left, *right;
	enum {
		CHARACTER_ABOVE,
		CHARACTER_BELOW,
		CHARACTER_EQUAL
	} is;
	struct character_condition *next;
};

/* Actions that run when comparisons begin to hold, and when they cease to. */
struct character_trigger {
	struct character_condition *when;
	const struct character_action *then, *otherwise;

	/* Changes: */
	bool held; /* the comparisons held in the last frame */
};

/* When a transition that runs may be replaced by another one. */
enum character_interrupt {
	CHARACTER_INTERRUPT_ALWAYS,
	CHARACTER_INTERRUPT_HIGHER, /* by one of a higher priority */
	CHARACTER_INTERRUPT_NEVER,
};

struct character_transition {
	int from, to;                     /* from -1: any state */
	struct character_condition *when; /* NULL: only by an action */
	/* the fraction of the clip after which the transition may begin */
	float exit;
	float priority;
	enum character_interrupt interrupt;
	struct character_fade fade;
};

/* The state that is playing. */
struct character_machine {
	int state_count, transition_count;
	struct character_state *state;
	struct character_transition *transition; /* by falling priority */
	struct inertia inertia;
	struct clip_cursor *cursor; /* one for each clip of a state */
	/* Changes: */
	int current;
	int wanted;   /* a state that an action asked for, or -1 */
	int running;  /* the transition under way, or -1 */
	double phase; /* of all clips with marks, counted in marks */
	float done;   /* fraction of the clip, 0..1 */
	int loops;    /* how often the clip's end has been passed */
	float held_s; /* since the end of a clip that plays once */
	bool fresh;   /* the state began in this frame */
	bool in_row;  /* all states play in the order of the file */
};

/* See run/feet.h and run/effects.h. */
struct character_feet;
struct character_cape;
struct character_shake;

/* A switch that fades. Layers, expressions and effects begin with one. */
struct character_switch {
	const char *name;
	const char *kind;
	const float *weight; /* from 0 to 1 */
	float fade_s;
	bool on;         /* at the start */
	bool unlabelled; /* labels do not show it */

	/* Changes: */
	bool is_on;
	float level; /* of the fade, 0 (off) to 1 (on) */
	float now;   /* eased level times *weight */
};

/* The order of operations in a frame. */
enum character_stage {
	CHARACTER_STAGE_LAYER,
	CHARACTER_STAGE_MORPH,
	CHARACTER_STAGE_SEQUENCE,
	CHARACTER_STAGE_PART,
	CHARACTER_STAGE_BONE, /* changes bones by the pose alone */
	/*
	 * from here on operations read world matrices and keep them up to date
	 */
	CHARACTER_STAGE_WORLD,
	CHARACTER_STAGE_ATTACHED,
	CHARACTER_STAGE_CLOTH,
};

/* An operation of a frame; it changes the pose. */
struct character;
struct character_op {
	enum character_stage stage;
	void (*run)(struct character *character, void *what);
	void *what;
};

/* A layer above the states. */
struct character_layer {
	struct character_switch is;
	struct character_entry entry;
	const float *rate;
	bool additive;
	/* plays when an action says so and fades at the clip's ends */
	bool once;
	float *mask;           /* [node_count], or NULL */
	struct pose reference; /* of an additive layer: the clip's start */

	/* Changes: */
	bool playing; /* if once */
};

/* Morph weights that a parameter mixes in. */
struct character_expression {
	struct character_switch is;
	int count;
	int *target;   /* indices of the pose's weights */
	float *amount; /* at weight 1 */
};

/* A point to look at or to reach. */
struct character_target {
	const char *name;
	const float *place[3]; /* metres */
	/* the place is counted from its origin; -1: from the world's */
	int node;
	bool is_camera;
	float radius_m; /* of the ball that shows it; 0: nothing */
	float color[3];
	bool has_users; /* effects look at it or reach for it */

	/* Changes: */
	float point[3];
	/* an effect that is switched on uses it, or it has no users */
	bool used;
};

/* What a press of buttons does. */
enum character_gesture {
	CHARACTER_PRESS,
	CHARACTER_RELEASE,
	CHARACTER_HOLD,
	CHARACTER_LONG,
	CHARACTER_TOGETHER,
};

struct character_binding {
	const struct character_condition *when; /* NULL: always */
	const struct character_line *line;      /* of the file, which says so */
	bool unlabelled;            /* shown only in the list of all buttons */
	enum button button, second; /* second: of CHARACTER_TOGETHER */
	enum character_gesture gesture;
	const char *label; /* what it does, for people */
	/*
	 * The same for pictures: where their font lacks the letters, the line's
	 * actions or a number.
	 */
	const char *shown;
	const struct character_action *action;
	/* of CHARACTER_HOLD: undoes the actions at the release */
	const struct character_action *after;
	struct character_binding *next;

	/* Changes: */
	bool held; /* of CHARACTER_HOLD: its actions have run in this press */
};

enum {
	CHARACTER_LONG_MS = 700,
	CHARACTER_TOGETHER_MS = 120,
};

struct character_button {
	bool joins; /* some CHARACTER_TOGETHER has it */
	bool has_long;

	/* Changes: */
	bool down;
	bool pending; /* the press waits for another button, or for its end */
	bool used; /* this press was taken by a long press or by two together */
	double since_s;
};

/* A line of the tour. */
struct character_tour {
	double time_s;
	enum button button; /* to press, or BUTTON_COUNT */
	const struct character_action *action;
	struct character_tour *next; /* not earlier */
};

enum {
	CHARACTER_OUTPUTS_MAX = 8
};

/* A GPIO output line. */
struct character_output {
	const char *name;
	const char *line; /* as --buttons names one: gpiochip0/18 */
	const char *file; /* the character file that names it, in line number */
	int number;

	/* Changes: */
	bool on;
	double until_s; /* it goes off then, also in a pause; below 0: never */
};

/* Which side of the picture labels take. */
enum character_labels {
	CHARACTER_LABELS_LEFT,
	CHARACTER_LABELS_RIGHT,
	CHARACTER_LABELS_NONE,
};

struct character_scene {
	const float *wave_m;                    /* height of uneven ground */
	float yaw_rad, pitch_rad, margin, zoom; /* pitch -1: found */
	const float *shadow;                    /* above 0: there is one */
	const float *relief; /* above 0: normal maps are used */
	enum character_labels labels;
	double tour_s; /* the tour's period; 0: no tour */
	struct character_tour *tour;
};

/* How the ground moves under the character. */
struct character_motion {
	/* the node whose translation carries the figure away, or -1 */
	int root;
	/* nodes that the ground follows while they stand on it, or -1 */
	int foot[2];
	const float *speed; /* or NULL */
	/* the ground moves as the lowest vertices of each clip do */
	bool by_clips;
	float low_m[2]; /* the feet's lowest heights in the clips */
	float near_m;   /* a foot below low_m + near_m is planted */
	float height_m; /* of the skeleton at rest */

	/* Changes: */
	/* the feet's places in the last frame, valid if begun is true */
	float before[2][3];
	bool begun;
	/* how far the figure goes over the ground in this frame, x and z */
	float scroll[2];
	/* of the figure over the ground, m/s along x and z */
	float velocity[2];
	int planted; /* the foot on the ground, or -1 */
};

enum {
	CHARACTER_PENDING_MAX = 64
};

struct character {
	struct arena arena;
	struct instance *instance;  /* not owned */
	struct character_text text; /* names point into it */
	/* Drives an output line; NULL: nothing does. */
	void (*drive)(void *user, int output, bool on);
	void *drive_user;

	int parameter_count, clip_count, layer_count, expression_count;
	int morph_count, part_count, sequence_count, target_count;
	int switch_count, output_count, op_count, trigger_count;
	struct character_trigger *trigger;
	struct character_parameter *parameter;
	struct character_clip *clip;
	struct character_machine machine;
	struct character_layer *layer;
	struct character_expression *expression;
	struct character_morph *morph;
	struct character_part *part;
	struct character_sequence *sequence;
	struct character_target *target;
	int cape_count;
	struct character_cape *cape;
	struct character_feet *feet; /* the first pair, or NULL */
	int shake_count;
	struct character_shake **shake;     /* in the order of the file */
	struct character_switch **switches; /* of layers, expressions, effects */
	struct character_output output[CHARACTER_OUTPUTS_MAX];
	struct character_op *op;
	struct character_binding *binding;
	struct character_button button[BUTTON_COUNT];
	struct character_scene scene;
	struct character_motion motion;
	enum clip_interpolation interpolation; /* of the keys of all clips */
	/* scratch: for the clips of additive layers; still: the rest pose */
	struct pose scratch, still;
	float ground_m; /* the height of level ground */
	/*
	 * The length of a metre in the model's units, for gravity and for
	 * lengths that the file leaves out: 1 if the skeleton has a likely size
	 * in metres, else what makes a human of it.
	 */
	float metre;
	/* The height of the ground above that; NULL: it is level. */
	float (*ground_height)(void *user, float x, float z);
	void *ground_user;

	/* Changes: */
	double seen_s;  /* the time of the last frame */
	double now_s;   /* without pauses */
	float real_s;   /* since the last frame */
	float step_s;   /* the same, or 0 while paused */
	double exact_s; /* the same as a double, for sums over months */
	float motion_level;
	float eye[3];
	float camera_turn, camera_tilt, camera_zoom; /* in this frame */
	bool paused, touring, labels_hidden, keys_shown;
	bool seen_triggers; /* triggers were compared in an earlier frame */
	double tour_from_s;
	const struct character_tour *tour_next;
	int pending_count;
	struct {
		const struct character_action *action;
		float times; /* a factor for the action's amount */
	} pending[CHARACTER_PENDING_MAX];
};

#endif

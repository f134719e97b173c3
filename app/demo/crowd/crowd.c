/*
 * The crowd: walkers that share one model, each with its own clip and phase.
 *
 * Each walker is an instance. Walkers that appear small cost less: they have
 * fewer triangles and influences, and are posed at half or a third of the frame
 * rate. figures.md lists what a frame costs.
 */
#include "app/demo/actor.h"
#include "app/demo/crowd/crowd_dress.h"
#include "app/demo/crowd/crowd_figure.h"
#include "app/demo/demo.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdio.h>

enum {
	DEFAULT_COUNT = 12,
	STRIDE = 5, /* walkers added or removed by RIGHT and LEFT */
	/* The heights on the screen below which a walker costs less. */
	HALF_RATE_BELOW_PX = 170,
	THIRD_RATE_BELOW_PX = 85,
	COARSE_BELOW_PX = 240, /* levels of detail may be off by more */
	FAR_BELOW_PX = 170,
	RATES = 3
};

static const float coarse_error_px = 2.0f, far_error_px = 4.0f;
static const float first_yaw_rad = 0.45f;
static const float turn_rad_per_s = 0.9f;
static const float drift_rad_per_s = 0.08f;
static const float ease_per_s = 3.0f; /* of the camera's easing */
static const double period_s = 8.0;

/*
 * The box's diagonal lies across the picture: its length is the diameter of the
 * circle around the box, so the circle fits the picture from all sides.
 */
static const struct framing framing = {.camera = {.yaw_rad = 0.25f * SCALAR_PI,
					       .pitch_rad = 0.42f,
					       .margin = 1.04f,
					       .follow = true},
	.label_rows = 2,
	.label_bars = 2};

struct walker {
	struct instance *instance;
	struct clip_cursor cursor;
	struct shadow_figure *shadow; /* on ground of its own, or NULL */
	struct crowd_route route;
	struct motion motion;
	float drift[3]; /* of the last pose, see crowd_figure_matrix() */
	struct crowd_position position;
	float height_px; /* on the screen */
	int frames_a_pose;
};

struct demo {
	struct demo_base base;
	const struct log *log;
	const struct kernel *kernel;
	float aspect;
	struct crowd_figure figure;
	struct camera_region region; /* the part that labels leave free */
	int height;                  /* of the picture */
	int count;
	bool out_of_memory; /* adding a walker has failed */
	struct walker walker[CROWD_MAX];
	unsigned frame;
	double now_s;
	float turn;
	bool drifting;
	bool shadowless;
	bool reducing;            /* small walkers cost less */
	int count_at_rate[RATES]; /* walkers posed at full, half, third rate */
};

/* Adds a walker. The first one shows the actor's instance, others their own. */
static int add_walker(struct demo *demo)
{
	const struct model *model = demo->base.actor.model;
	struct walker *walker = &demo->walker[demo->count];
	int error = 0;

	*walker = (struct walker){.frames_a_pose = 1};
	walker->route =
		crowd_figure_route(&demo->figure, demo->count, &walker->motion);
	if (demo->count == 0) {
		walker->instance = demo->base.actor.instance;
	} else {
		error = instance_create_for_drawing(
			model, demo->kernel, demo->log, &walker->instance);
	}
	if (error) {
		return error;
	}
	error = clip_cursor_init(
		&walker->cursor, model, &walker->instance->arena);
	if (!error) {
		error = crowd_dress(walker->instance, demo->count);
	}
	if (!error) {
		error = shadow_figure_create(walker->instance,
			&demo->base.actor.ground, demo->log, &walker->shadow);
	}
	if (error) {
		log_error(demo->log,
			"crowd: there is not enough memory for %d walkers",
			demo->count + 1);
		if (demo->count > 0) {
			instance_destroy(walker->instance);
		}
		return error;
	}
	/* Normal mapping lights an unturned figure, but GL turns walkers. */
	walker->instance->normal_mapping = false;
	demo->count++;
	return 0;
}

static void remove_walker(struct demo *demo)
{
	if (demo->count > 1) {
		demo->count--;
		instance_destroy(demo->walker[demo->count].instance);
		demo->walker[demo->count] = (struct walker){0};
		demo->out_of_memory = false;
	}
}

static void change_count(struct demo *demo, int by)
{
	for (; by > 0 && demo->count < CROWD_MAX && !demo->out_of_memory; by--) {
		demo->out_of_memory = add_walker(demo) != 0;
	}
	for (; by < 0; by++) {
		remove_walker(demo);
	}
}

static struct bounds bounds_of_crowd(const struct demo *demo, int count)
{
	float r = 0.7071f * (crowd_radius_m(count) + demo->figure.beyond_m);

	return (struct bounds){
		.low = {-r, 0.0f, -r},
		.high = {r, demo->base.actor.extent * demo->figure.scale, r},
	};
}

/* Returns the camera that shows this number of walkers from any side. */
static struct camera camera_for(const struct demo *demo, int count)
{
	struct bounds bounds = bounds_of_crowd(demo, count);
	struct camera camera = camera_default();
	struct camera_framing wanted = framing.camera;

	wanted.aspect = demo->aspect;
	wanted.region = demo->region;
	camera_frame(&camera, &bounds, &wanted);
	camera.fit.on = false;
	camera.yaw_rad = first_yaw_rad;
	return camera;
}

/*
 * Finds the region that labels leave free, if the picture's size has changed.
 */
static void find_region(struct demo *demo)
{
	int width = demo->base.width, height = demo->base.height;
	float aspect = (float)width / (float)height;
	struct bounds bounds = bounds_of_crowd(demo, CROWD_MAX);

	if (height != demo->height || aspect != demo->aspect) {
		demo->height = height;
		demo->aspect = aspect;
		demo->region = framing_region(
			&demo->base.framing, &bounds, width, height);
	}
}

static int crowd_prepare(struct demo *demo, const struct demo_env *env)
{
	int wanted = env->walkers > 0 ? env->walkers : DEFAULT_COUNT;
	struct bounds bounds;
	int error = crowd_figure_make(&demo->figure, env, &demo->base.actor);

	demo->log = env->log;
	demo->kernel = env->kernel;
	demo->drifting = env->unattended;
	demo->reducing = true;
	while (!error && demo->count < wanted && demo->count < CROWD_MAX) {
		error = add_walker(demo);
	}
	if (error) {
		return error;
	}
	/* The floor is made for the largest crowd. */
	bounds = bounds_of_crowd(demo, CROWD_MAX);
	error = actor_init_stage(
		&demo->base, env, &bounds, 1.0f, &framing, &demo->base.stage);
	find_region(demo);
	demo->base.stage.camera = camera_for(demo, demo->count);
	return error;
}

static void crowd_finish(struct demo *demo)
{
	for (int i = 1; i < demo->count; i++) {
		instance_destroy(demo->walker[i].instance);
	}
}

static void move_camera(struct demo *demo, float step_s)
{
	struct camera *camera = &demo->base.stage.camera;
	struct camera goal = camera_for(demo, demo->count);
	float fraction = 1.0f - scalar_exp(-ease_per_s * step_s);
	float drift = demo->drifting ? drift_rad_per_s : 0.0f;

	camera->distance += (goal.distance - camera->distance) * fraction;
	camera->radius += (goal.radius - camera->radius) * fraction;
	camera->shift_x = goal.shift_x;
	camera->shift_y = goal.shift_y;
	camera->fit = goal.fit;
	camera_orbit(
		camera, (demo->turn * turn_rad_per_s + drift) * step_s, 0.0f);
}

static int influences_of(const struct demo *demo, const struct walker *walker)
{
	const struct influence_cap *wanted = &demo->base.actor.influence_cap;
	int cap = demo->reducing ? influence_cap_for_height(walker->height_px)
				 : 0;
	int limit = demo->base.reduction.max_influences;

	if (wanted->kind == INFLUENCE_CAP_FIXED && wanted->value > 0) {
		cap = wanted->value;
	}
	return limit > 0 && (cap == 0 || limit < cap) ? limit : cap;
}

static int choose_rate(const struct demo *demo, float height)
{
	if (!demo->reducing || height >= HALF_RATE_BELOW_PX) {
		return 1;
	}
	return height >= THIRD_RATE_BELOW_PX ? 2 : 3;
}

/* The time in the clip: smaller walkers take shorter steps, so play faster. */
static float clip_time_of(const struct demo *demo, const struct walker *walker)
{
	const struct model_clip *clip =
		&demo->base.actor.model->clip[walker->motion.clip];

	return clip_round_time(clip,
		demo->now_s / (double)walker->route.size +
			(double)(walker->route.phase * clip->duration_s),
		CLIP_LOOP);
}

static void pose_walker(struct demo *demo, struct walker *walker)
{
	struct instance *instance = walker->instance;
	const struct model *model = demo->base.actor.model;

	instance->max_influences = influences_of(demo, walker);
	instance->hold_normals = demo->base.reduction.hold_normals;
	if (walker->motion.clip >= 0) {
		float at_s = clip_time_of(demo, walker);

		clip_pose(&model->clip[walker->motion.clip], at_s,
			demo->base.actor.interpolation, &walker->cursor,
			&instance->pose);
		motion_drift_at(&walker->motion, model, at_s, walker->drift);
	}
	instance_update(instance);
}

static void choose_lod(struct demo *demo, struct walker *walker)
{
	static const struct lod all = {.kind = LOD_ALL};
	const struct actor *actor = &demo->base.actor;
	float error_px = walker->height_px < FAR_BELOW_PX ? far_error_px
		: walker->height_px < COARSE_BELOW_PX     ? coarse_error_px
							  : 0.0f;
	struct lod lod =
		lod_relax(&actor->lod, glm_max(actor->min_error_px, error_px));

	lod_choose(walker->instance, demo->reducing ? &lod : &all,
		walker->height_px / actor->extent);
}

/* Returns the height of a walker on the screen, in pixels. */
static float height_px(const struct demo *demo, const struct walker *walker)
{
	const struct camera *camera = &demo->base.stage.camera;
	float eye[3], dx, dz, distance;

	camera_eye(camera, eye);
	dx = eye[0] - walker->position.x;
	dz = eye[2] - walker->position.z;
	distance = scalar_sqrt(dx * dx + dz * dz + eye[1] * eye[1]);
	return demo->base.actor.extent * demo->figure.scale *
		walker->route.size *
		lod_px_per_unit_at(camera, distance, demo->height);
}

static void crowd_update(struct demo *demo, double time_s)
{
	float step_s = (float)(time_s - demo->now_s);

	demo->now_s = time_s;
	find_region(demo);
	move_camera(demo, step_s);
	for (int rate = 0; rate < RATES; rate++) {
		demo->count_at_rate[rate] = 0;
	}
	for (int i = 0; i < demo->count; i++) {
		struct walker *walker = &demo->walker[i];
		bool first = walker->height_px == 0.0f;

		walker->position = crowd_position_at(&walker->route, time_s);
		walker->height_px = height_px(demo, walker);
		walker->frames_a_pose = choose_rate(demo, walker->height_px);
		demo->count_at_rate[walker->frames_a_pose - 1]++;
		choose_lod(demo, walker);
		/*
		 * Walkers are posed in turn, so that frames take equally long.
		 */
		if (first || instance_is_stale(walker->instance) ||
			(demo->frame + (unsigned)i) %
					(unsigned)walker->frames_a_pose ==
				0) {
			pose_walker(demo, walker);
		}
	}
	demo->frame++;
}

static bool crowd_casts_shadow(const struct demo *demo)
{
	return !demo->shadowless;
}

static bool crowd_get_figure(
	const struct demo *demo, int number, struct overlay_figure *out)
{
	const struct walker *walker;

	if (number >= demo->count) {
		return false;
	}
	walker = &demo->walker[number];
	out->instance = walker->instance;
	out->shadow = walker->shadow;
	crowd_figure_matrix(&demo->figure, &walker->route, &walker->position,
		walker->drift, out->place);
	return true;
}

static void crowd_get_motion(const struct demo *demo, struct overlay_motion *out)
{
	const struct walker *walker = &demo->walker[0];

	out->clip = walker->motion.clip;
	if (walker->motion.clip >= 0) {
		out->time_s = clip_time_of(demo, walker);
		out->interpolation = demo->base.actor.interpolation;
	}
}

static double crowd_period_s(const struct demo *demo)
{
	(void)demo;
	return period_s;
}

static void crowd_label(const struct demo *demo, struct hud *hud)
{
	static const char *const rate[RATES] = {
		"full rate", "half rate", "a third"};
	struct hud_group group;
	char text[48];
	int length = snprintf(text, sizeof(text), "%d walker%s", demo->count,
		demo->count == 1 ? "" : "s");

	if (demo->base.frames_per_s > 0.0f) {
		snprintf(text + length, sizeof(text) - (size_t)length,
			", %.0f fps", (double)demo->base.frames_per_s);
	}
	group = hud_group_begin(hud, HUD_TOP_LEFT, text);
	for (int i = 0; i < RATES; i++) {
		snprintf(text, sizeof(text), "%d", demo->count_at_rate[i]);
		if (demo->count_at_rate[i] > 0) {
			hud_group_bar(&group, rate[i], text,
				(float)demo->count_at_rate[i] /
					(float)demo->count,
				hud_color_blue);
		}
	}
	if (demo->out_of_memory) {
		hud_group_text(&group, "no memory for more", "");
	}
	hud_group_end(&group);
}

static void turn(struct demo *demo, int direction)
{
	demo->turn = (float)direction;
}

static const struct demo_action crowd_actions[] = {
	DEMO_PRESS(UP, "add a walker", change_count, 1),
	DEMO_PRESS(DOWN, "remove a walker", change_count, -1),
	DEMO_PRESS(RIGHT, "add five walkers", change_count, STRIDE),
	DEMO_PRESS(LEFT, "remove five walkers", change_count, -STRIDE),
	DEMO_HOLD(ENTER, "turn the camera (hold)", turn, 1),
	DEMO_INVERT(F6, "leave out the shadows, or not", shadowless),
	DEMO_INVERT(F8, "draw small figures in less detail, or not", reducing),
	DEMO_INVERT(F9, "turn the camera slowly, or not", drifting),
	{0},
};

const struct demo_driver demo_driver_crowd = {
	.name = "crowd",
	.summary = "skeletal: walkers that share a model, as many as you like",
	.asset = "walker.glb",
	.any_model = true,
	.action = crowd_actions,
	.size = sizeof(struct demo),
	.prepare = crowd_prepare,
	.finish = crowd_finish,
	.update = crowd_update,
	.casts_shadow = crowd_casts_shadow,
	.period_s = crowd_period_s,
	.label = crowd_label,
	.get_figure = crowd_get_figure,
	.get_motion = crowd_get_motion,
};

#include "app/demo/demo_overlay.h"

#include "app/demo/demo_figures.h"
#include "app/scene/hud/hud_graph.h"
#include "app/scene/stage/light.h"
#include "platform/base/scalar.h"

enum {
	FIGURES_MAX = 64
};

static const float least_side = 0.2f; /* region's height; a picture has 2 */

static struct overlay_motion motion_of(
	const struct demo_driver *driver, const struct demo *demo)
{
	struct overlay_motion motion = overlay_motion_none();

	if (driver->get_motion) {
		driver->get_motion(demo, &motion);
	}
	return motion;
}

int demo_overlay_make(const struct demo_driver *driver, struct demo *demo,
	const struct overlay_choice *choice)
{
	struct demo_base *base = (struct demo_base *)demo;
	struct overlay_subject subject = {
		.textures = &base->actor.textures,
		.extent = base->actor.extent,
	};
	struct overlay_figure first;

	overlay_destroy(base->overlay);
	base->overlay = NULL;
	demo_find_figure(driver, demo, 0, &first);
	subject.instance = first.instance;
	return overlay_create(
		&subject, base->gl, choice, &base->log, &base->overlay);
}

/* Makes the overlays for a reloaded model; shows none if there is no memory. */
static void follow_model(const struct demo_driver *driver, struct demo *demo)
{
	struct demo_base *base = (struct demo_base *)demo;

	const struct overlay_choice choice = {
		.kinds = base->overlays_of_old_model};

	if (choice.kinds) {
		base->overlays_of_old_model = 0;
		(void)demo_overlay_make(driver, demo, &choice);
	}
}

void demo_overlay_release(struct demo_base *base)
{
	if (base->overlay) {
		base->overlays_of_old_model = base->overlay->kinds;
		overlay_destroy(base->overlay);
		base->overlay = NULL;
	}
}

/* Moves the figures up, above the row of small pictures, if that is shown. */
static void make_room(struct demo_base *base, int width, int height)
{
	const struct overlay *overlay = base->overlay;
	struct camera *camera = &base->stage.camera;
	struct camera_region region = camera->fit.region;
	float bottom = region.bottom - base->room_below;
	float most = region.top - bottom - least_side;
	float room = 0.0f;

	if (overlay && overlay_shows(overlay, OVERLAY_KEYS) &&
		overlay->chooses_target) {
		struct overlay_row row = overlay_row_of(overlay, width, height);

		room = 2.0f * (float)row.height / (float)height;
	}
	room = room < most ? room : scalar_max(most, 0.0f);
	if (room != base->room_below) {
		region.bottom = bottom + room;
		base->room_below = room;
		camera_set_region(camera, &region, 1.0f, camera->fit.aspect);
	}
}

static void draw_over(const struct demo_driver *driver, struct demo *demo,
	const struct overlay_motion *motion, int width, int height)
{
	struct overlay *overlay = ((struct demo_base *)demo)->overlay;
	struct overlay_figure figure;

	for (int i = 0;
		i < FIGURES_MAX && demo_find_figure(driver, demo, i, &figure);
		i++) {
		overlay_draw_surface(overlay, &figure, height);
		if (i == 0) {
			overlay_draw_keys(
				overlay, motion, &figure, width, height);
		}
	}
	overlay_clear_depth(overlay);
	for (int i = 0;
		i < FIGURES_MAX && demo_find_figure(driver, demo, i, &figure);
		i++) {
		overlay_draw_bones(overlay, &figure, height);
	}
}

void demo_draw(const struct demo_driver *driver, struct demo *demo, int width,
	int height)
{
	struct demo_base *base = (struct demo_base *)demo;
	struct overlay_motion motion;

	follow_model(driver, demo);
	if (width != base->width || height != base->height ||
		base->below.keys != base->framing.below.keys ||
		base->below.switches != base->framing.below.switches) {
		actor_reframe_stage(base, width, height);
	}
	make_room(base, width, height);
	if (!base->overlay || !base->overlay->kinds) {
		demo_draw_stage(driver, demo, width, height);
		return;
	}
	motion = motion_of(driver, demo);
	overlay_begin(base->overlay, &motion, &base->stage.camera);
	demo_draw_stage(driver, demo, width, height);
	overlay_end(base->overlay);
	camera_apply(&base->stage.camera, base->gl, width, height);
	light_apply(base->gl);
	draw_over(driver, demo, &motion, width, height);
}

void demo_show_next_overlay(const struct demo_driver *driver, struct demo *demo)
{
	struct demo_base *base = (struct demo_base *)demo;
	struct overlay_motion motion = motion_of(driver, demo);
	const struct overlay_choice none = {0};

	follow_model(driver, demo);
	/* If this fails, nothing is shown; an error has been logged. */
	if (base->overlay || demo_overlay_make(driver, demo, &none) == 0) {
		overlay_show_next(base->overlay, &motion);
	}
}

void demo_choose_joint(struct demo *demo, int step)
{
	struct overlay *overlay = ((struct demo_base *)demo)->overlay;

	if (overlay) {
		overlay_choose(overlay, step);
	}
}

struct hud_place demo_overlay_place(
	const struct demo *demo, const struct hud *hud)
{
	const struct camera_region taken =
		camera_covered(&((const struct demo_base *)demo)->stage.camera);
	const int *stacked = hud->stacked_px;
	int column = hud_group_extent_of(hud->width, hud->height, 0, 0).column;
	float half_width = 0.5f * (float)hud->width;
	float half_height = 0.5f * (float)hud->height;
	struct hud_place place = {HUD_BOTTOM_LEFT, hud->height};
	int above = (int)((1.0f - taken.top) * half_height);
	int below = (int)((taken.bottom + 1.0f) * half_height) -
		stacked[HUD_BOTTOM_LEFT];

	if ((int)((taken.left + 1.0f) * half_width) + 1 >= column) {
		return place;
	}
	if ((int)((1.0f - taken.right) * half_width) + 1 >= column) {
		place.corner = HUD_BOTTOM_RIGHT;
		return place;
	}
	place.room = below;
	if (2 * column <= hud->width && above - stacked[HUD_TOP_RIGHT] > below) {
		place = (struct hud_place){
			HUD_TOP_RIGHT, above - stacked[HUD_TOP_RIGHT]};
	} else if (above - stacked[HUD_TOP_LEFT] > below) {
		place = (struct hud_place){
			HUD_TOP_LEFT, above - stacked[HUD_TOP_LEFT]};
	}
	return place;
}

struct hud_place demo_times_place(const struct demo *demo, const struct hud *hud)
{
	const struct demo_base *base = (const struct demo_base *)demo;
	const struct camera_region taken = camera_covered(&base->stage.camera);
	struct hud_place place = demo_overlay_place(demo, hud);
	const int *stacked = hud->stacked_px;
	int least = hud_graph_room(hud->width, hud->height, HUD_GRAPH_RATE);
	int column = hud_group_extent_of(hud->width, hud->height, 0, 0).column;
	bool is_narrow = 2 * column > hud->width;

	if (place.corner == HUD_BOTTOM_LEFT && !is_narrow &&
		hud->height - stacked[HUD_TOP_LEFT] - stacked[HUD_BOTTOM_LEFT] <
			least) {
		place.corner = HUD_BOTTOM_RIGHT;
		place.room = (int)((taken.bottom + 1.0f) * 0.5f *
				     (float)hud->height) -
			stacked[HUD_BOTTOM_RIGHT];
	}
	if (is_narrow && base->framing.frame_times && place.room < least) {
		place = (struct hud_place){HUD_BOTTOM_LEFT, least};
	}
	return place;
}

bool demo_overlay_label(const struct demo_driver *driver,
	const struct demo *demo, struct overlay *overlay, struct hud *hud)
{
	struct overlay_motion motion = motion_of(driver, demo);
	struct hud_place place = demo_overlay_place(demo, hud);
	int least = hud_group_extent_of(hud->width, hud->height, 1, 1).top;

	if (place.room < least) {
		return false;
	}
	return overlay_label(overlay, &motion, &place, hud) &&
		!hud_groups_overlap(hud);
}

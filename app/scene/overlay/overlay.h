/*
 * Overlays show how a figure is animated: its skeleton, the weights of a joint,
 * its triangles, key frames, pivots, curves and layers, as the figures of
 * AN4044 do.
 *
 *	overlay_begin()          before the figures are drawn as always
 *	overlay_end()            after that
 *	overlay_draw_surface()   for each figure
 *	overlay_draw_keys()      for the first figure
 *	overlay_clear_depth()
 *	overlay_draw_bones()     for each figure
 *	overlay_label()          on the head-up display
 *
 * All memory is taken when an overlay is created; frames allocate nothing.
 * Everything is drawn by calls of GL ES 1.1, with the camera's model-view
 * matrix and the lights loaded.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_H
#define APP_SCENE_OVERLAY_OVERLAY_H

#include "app/anim/clip.h"
#include "app/scene/hud/hud_group.h"
#include "app/scene/hud/hud_name.h"
#include "app/scene/overlay/overlay_ghost.h"
#include "app/scene/overlay/overlay_heat.h"
#include "app/scene/overlay/overlay_kind.h"
#include "app/scene/overlay/overlay_sketch.h"
#include "app/scene/stage/camera.h"

struct shadow_figure;

enum {
	OVERLAY_LAYERS_MAX = 8
};

/* A layer of a pose. */
struct overlay_layer {
	const char *name;
	/* what labels call it if the font lacks the name's letters */
	const char *kind;
	int number;
	float weight;
	const float *mask; /* [node_count], 0..1; NULL: all nodes */
};

/* What moves the figures at this moment. */
struct overlay_motion {
	int clip; /* or -1 */
	float time_s;
	enum clip_interpolation interpolation; /* of the clip's keys */
	/*
	 * If not NULL, the clip moves a node this far and the figures leave
	 * that out of it.
	 */
	const float *travel;
	int traveller; /* the node */

	/* A morph between two key frames, if morphing is true. */
	bool morphing;
	int node;     /* the node that has the morph targets */
	int from, to; /* targets; -1: the base */
	float omega;
	float wave; /* height of the sinusoidal part in the graph, 0: none */
	/* The morph's progress, 0..1, by Omega; NULL: a straight line. */
	float (*shape)(const void *shape_user, float omega);
	const void *shape_user;

	int layer_count;
	struct overlay_layer layer[OVERLAY_LAYERS_MAX];
};

/* One of the figures that a demo shows. */
struct overlay_figure {
	struct instance *instance; /* its world matrices are read */
	/* the matrices do not follow the figure, so its bones are not drawn */
	bool unposed_nodes;
	mat4 place;        /* from the instance's scene units to the stage's */
	bool among_others; /* the camera shows more than this figure */
	/* on ground of its own; NULL: it casts none there */
	struct shadow_figure *shadow;
};

/* The instance that is painted and whose key frames are shown. */
struct overlay_subject {
	struct instance *instance;
	const struct texture_set *textures;
	float extent; /* scene units */
};

struct overlay {
	const struct gl *gl;
	struct log log;
	struct overlay_subject subject;
	/* the overlays that are shown, a bit 1 << kind for each */
	unsigned kinds;

	/* Private. */
	const struct camera *camera; /* of this frame; not owned */
	struct arena arena;
	uint8_t *is_bone;  /* [node_count] */
	float *node_value; /* [node_count], values that are painted as heat */
	float *sample;     /* room for a value of the model's widest channel */
	int chosen;        /* a node or, if chooses_target, a morph target */
	bool chooses_target;
	int target_count; /* the largest number of targets of any mesh */
	bool painting;
	const float *painted_mask;
	int painted_choice; /* the item that was painted last; -1: none */
	struct overlay_heat heat;
	struct overlay_ghost ghost;
	struct overlay_sketch sketch;
};

/* No clip, no morph, no layers. */
struct overlay_motion overlay_motion_none(void);

/*
 * Makes the overlays of a subject and shows those that are chosen. Onion skins
 * need a second instance of the model. Returns 0, -ENOMEM, or -EINVAL when the
 * model has no joint of the chosen name, after logging an error. Release it
 * with overlay_destroy().
 */
int overlay_create(const struct overlay_subject *subject, const struct gl *gl,
	const struct overlay_choice *choice, const struct log *log,
	struct overlay **out);

/* Releases an overlay; NULL is allowed. */
void overlay_destroy(struct overlay *overlay);

static inline bool overlay_shows(
	const struct overlay *overlay, enum overlay_kind kind)
{
	return overlay->kinds >> kind & 1;
}

/*
 * Shows the next overlay alone, or none after the last one. Overlays that have
 * nothing to show for this motion are left out.
 */
void overlay_show_next(
	struct overlay *overlay, const struct overlay_motion *motion);

/* Chooses the next (step 1) or previous (-1) joint, part or morph target. */
void overlay_choose(struct overlay *overlay, int step);

/* Returns the name of what is chosen, for labels; "none" without any node. */
const char *overlay_chosen_name(
	const struct overlay *overlay, char number[HUD_NAME_BYTES]);

/*
 * Begins a frame seen by this camera, which must remain until the frame's end.
 */
void overlay_begin(struct overlay *overlay, const struct overlay_motion *motion,
	const struct camera *camera);
void overlay_end(struct overlay *overlay);

/* Draws the wireframe. height is the picture's. */
void overlay_draw_surface(struct overlay *overlay,
	const struct overlay_figure *figure, int height);

/*
 * Pushes the model-view matrix and multiplies it by the figure's place; the
 * caller pops it. nearer moves the figure by this part of its extent towards
 * the eye, or away from it if negative, along the lines of sight, so that only
 * depths change. GL's polygon offset would have another effect with each
 * driver's depth buffer.
 */
void overlay_push_place(const struct overlay *overlay,
	const struct overlay_figure *figure, float nearer);

/*
 * Draws key frames: those of a clip as onion skins around the present pose, and
 * the shapes of a morphed model as a row of small pictures below it.
 */
void overlay_draw_keys(struct overlay *overlay,
	const struct overlay_motion *motion,
	const struct overlay_figure *figure, int width, int height);

/* A row of small pictures of the base and the morph targets. */
struct overlay_row {
	int count;
	int width, height; /* of each, pixels; the row begins at the left */
};
struct overlay_row overlay_row_of(
	const struct overlay *overlay, int width, int height);

/* Keeps the labels that are added from now on above the row, if it is shown. */
void overlay_reserve_row(const struct overlay *overlay, struct hud *hud);

/*
 * Returns the camera of the row's pictures: it sees the box that the figure's
 * camera frames from the same side, but fills the picture with it. A camera
 * that does not follow stays where it is. A figure among others has a camera of
 * its own, which shows it alone.
 */
struct camera overlay_row_camera(
	const struct overlay_row *row, const struct camera *camera);

/* Clears depths if bones follow, so that these are drawn over the figures. */
void overlay_clear_depth(struct overlay *overlay);

/* Draws the skeleton and the pivots. height is the picture's. */
void overlay_draw_bones(struct overlay *overlay,
	const struct overlay_figure *figure, int height);

/*
 * Adds labels, curves and weights in this order: the chosen joint or target,
 * the marks of the keys, the pivots' axes, the curve, the layers. What has no
 * room is left out. Returns false if that leaves the title alone.
 */
bool overlay_label(struct overlay *overlay, const struct overlay_motion *motion,
	const struct hud_place *place, struct hud *hud);

#endif

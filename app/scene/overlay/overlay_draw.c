/*
 * Draws the overlays that lie on a figure: weights and masks as heat, the
 * wireframe, bones and pivots (overlay.h).
 */
#include "app/scene/overlay/overlay.h"
#include "app/scene/overlay/overlay_bones.h"
#include "platform/base/fixed.h"

#include <string.h>

enum {
	LINE_PX_PER_HEIGHT = 640 /* a line is a pixel wide at this height */
};

/* How much nearer edges are than their surfaces, see overlay_push_place(). */
static const float edges_nearer = 0.003f;

static const float *first_mask(const struct overlay_motion *motion)
{
	for (int i = 0; i < motion->layer_count; i++) {
		if (motion->layer[i].mask) {
			return motion->layer[i].mask;
		}
	}
	return NULL;
}

static void paint_choice(struct overlay *overlay)
{
	const struct model *model = overlay->subject.instance->model;

	if (overlay->painted_choice == overlay->chosen) {
		return;
	}
	overlay->painted_choice = overlay->chosen;
	overlay->painted_mask = NULL;
	if (overlay->chooses_target) {
		overlay_heat_paint_target(&overlay->heat, overlay->chosen);
		return;
	}
	for (int n = 0; n < model->node_count; n++) {
		overlay->node_value[n] = n == overlay->chosen ? 1.0f : 0.0f;
	}
	overlay_heat_paint_nodes(&overlay->heat, overlay->node_value);
}

static void paint_mask(struct overlay *overlay, const float *mask)
{
	if (overlay->painted_mask != mask) {
		overlay->painted_mask = mask;
		overlay->painted_choice = -1;
		overlay_heat_paint_nodes(&overlay->heat, mask);
	}
}

void overlay_begin(struct overlay *overlay, const struct overlay_motion *motion,
	const struct camera *camera)
{
	const float *mask = first_mask(motion);
	bool weights = overlay_shows(overlay, OVERLAY_WEIGHTS);

	overlay->camera = camera;
	overlay->painting =
		weights || (overlay_shows(overlay, OVERLAY_LAYERS) && mask);
	if (weights) {
		paint_choice(overlay);
	} else if (overlay->painting) {
		paint_mask(overlay, mask);
	}
	overlay_heat_switch(&overlay->heat, overlay->painting);
}

void overlay_end(struct overlay *overlay)
{
	overlay_heat_switch(&overlay->heat, false);
	overlay->painting = false;
}

static void set_line_width(const struct gl *gl, int height)
{
	int width = height / LINE_PX_PER_HEIGHT;

	gl->LineWidthx((width < 1 ? 1 : width) * FX16_ONE);
}

void overlay_draw_surface(struct overlay *overlay,
	const struct overlay_figure *figure, int height)
{
	const struct gl *gl = overlay->gl;

	if (!overlay_shows(overlay, OVERLAY_WIREFRAME)) {
		return;
	}
	overlay_push_place(overlay, figure, edges_nearer);
	/* Called only for the GL state that it sets; the sketch stays empty. */
	overlay_sketch_begin(&overlay->sketch, gl, GL_LINES);
	gl->DepthFunc(GL_LEQUAL);
	gl->DepthMask(GL_FALSE);
	set_line_width(gl, height);
	gl->Color4x(FX16_ONE / 20, FX16_ONE / 14, FX16_ONE / 9, FX16_ONE / 2);
	draw_instance(
		gl, figure->instance, overlay->subject.textures, DRAW_EDGES);
	gl->LineWidthx(FX16_ONE);
	gl->DepthMask(GL_TRUE);
	gl->DepthFunc(GL_LESS);
	gl->Disable(GL_BLEND);
	gl->PopMatrix();
}

void overlay_clear_depth(struct overlay *overlay)
{
	if (overlay_shows(overlay, OVERLAY_SKELETON) ||
		overlay_shows(overlay, OVERLAY_PIVOTS)) {
		overlay->gl->DepthMask(GL_TRUE);
		overlay->gl->Clear(GL_DEPTH_BUFFER_BIT);
	}
}

static void draw_pivots(
	struct overlay *overlay, const struct overlay_bones *bones, int height)
{
	set_line_width(overlay->gl, height);
	overlay_sketch_begin(&overlay->sketch, overlay->gl, GL_LINES);
	overlay_bones_links(bones, &overlay->sketch);
	overlay_sketch_end(&overlay->sketch);
	overlay->gl->LineWidthx(FX16_ONE);
	overlay_sketch_begin(&overlay->sketch, overlay->gl, GL_TRIANGLES);
	overlay_bones_axes(bones, &overlay->sketch);
	overlay_sketch_end(&overlay->sketch);
}

void overlay_draw_bones(struct overlay *overlay,
	const struct overlay_figure *figure, int height)
{
	const struct overlay_subject *subject = &overlay->subject;
	const struct overlay_bones bones = {.instance = figure->instance,
		.is_bone = overlay->is_bone,
		.chosen = overlay->chooses_target ? -1 : overlay->chosen,
		.extent = subject->extent};

	/* Only models with the same nodes have these bones. */
	if (figure->unposed_nodes ||
		figure->instance->model->node_count !=
			subject->instance->model->node_count) {
		return;
	}
	overlay_push_place(overlay, figure, 0.0f);
	if (overlay_shows(overlay, OVERLAY_PIVOTS)) {
		draw_pivots(overlay, &bones, height);
	}
	if (overlay_shows(overlay, OVERLAY_SKELETON)) {
		overlay_sketch_begin(
			&overlay->sketch, overlay->gl, GL_TRIANGLES);
		overlay_bones_skeleton(&bones, &overlay->sketch);
		overlay_sketch_end(&overlay->sketch);
	}
	overlay->gl->PopMatrix();
}

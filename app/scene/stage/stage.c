#include "app/scene/stage/stage.h"

#include "app/anim/math/vec.h"
#include "app/scene/draw/draw.h"
#include "app/scene/draw/matrix_gl.h"
#include "app/scene/stage/light.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <string.h>

#include <cglm/cglm.h>

enum {
	/*
	 * Marks in the stencil of surfaces that shadows lie on; elsewhere the
	 * stencil counts to 1 at most. The other one is STAGE_GROUND_MARK.
	 */
	TOP_MARK = 128
};

/* How far the floor is lowered, as a part of the model's extent. */
static const float lowered_part = 0.001f;

/* The background's gradient, sRGB. The floor fades into its lower part. */
static const uint8_t sky_color[3] = {58, 68, 84};
static const uint8_t middle_color[3] = {146, 158, 172};
static const uint8_t ground_color[3] = {104, 114, 128};

int stage_init(struct stage *stage, const struct gl *gl,
	const struct bounds *bounds, float unit,
	const struct camera_framing *framing, enum pixel_format target,
	const struct log *log)
{
	GLint stencil_bits = 0;

	*stage = (struct stage){.camera = camera_default()};
	camera_frame(&stage->camera, bounds, framing);
	gl->GetIntegerv(GL_STENCIL_BITS, &stencil_bits);
	stage->has_stencil = stencil_bits > 0;
	/* The floor extends to below the camera. */
	return floor_init(&stage->floor, gl, bounds, unit,
		1.1f * camera_farthest(&stage->camera), target, log);
}

void stage_finish(struct stage *stage, const struct gl *gl)
{
	floor_finish(&stage->floor, gl);
}

void stage_follow(struct stage *stage, const float moved[3], const float way[3])
{
	vec_add_scaled(stage->camera.target, moved, 1.0f, stage->camera.target);
	stage->floor.way[0] = way[0];
	stage->floor.way[1] = way[2];
	stage->camera.rise = scalar_max(way[1], 0.0f);
}

static void use_plain_state(const struct gl *gl)
{
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_ALPHA_TEST);
	gl->Disable(GL_BLEND);
	gl->Disable(GL_CULL_FACE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->ShadeModel(GL_SMOOTH);
}

/*
 * The rows of the gradient from the upper edge to the lower one, which are 3
 * and -3. Where the ground ends far below the middle of the picture, so does
 * the sky: there would be a dark strip between them.
 */
static void find_rows(int end_px, int height, fx16_t row[4])
{
	fx16_t end = (fx16_t)((int64_t)6 * FX16_ONE * end_px / height) -
		3 * FX16_ONE;
	fx16_t moved = 2 * end + FX16_ONE / 2;
	fx16_t middle = moved > 0 ? 0 : moved > end ? moved : end;

	row[0] = 3 * FX16_ONE;
	row[1] = middle;
	row[2] = middle - FX16_ONE;
	row[3] = middle - 3 * FX16_ONE;
}

/* A vertical gradient, which is lightest in the middle of the picture. */
static void draw_background(const struct gl *gl, int end_px, int height)
{
	static const int16_t usual[8][2] = {{-1, 3}, {1, 3}, {-1, 0}, {1, 0},
		{-1, -1}, {1, -1}, {-1, -3}, {1, -3}};
	fx16_t row[4], position[8][2];
	uint8_t color[8][4];

	find_rows(end_px, height, row);
	for (int i = 0; i < 8; i++) {
		const uint8_t *from = i < 2 ? sky_color
			: i < 4             ? middle_color
					    : ground_color;

		position[i][0] = i % 2 ? FX16_ONE : -FX16_ONE;
		position[i][1] = row[i / 2];
		memcpy(color[i], from, 3);
		color[i][3] = 255;
	}
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Orthox(-FX16_ONE, FX16_ONE, -3 * FX16_ONE, 3 * FX16_ONE, -FX16_ONE,
		FX16_ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	gl->Disable(GL_DEPTH_TEST);
	if (row[1] == 0) {
		gl->VertexPointer(2, GL_SHORT, 0, usual);
	} else {
		gl->VertexPointer(2, GL_FIXED, 0, position);
	}
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 8);
	gl->Enable(GL_DEPTH_TEST);
}

/*
 * Clears depth and draws the background, except in the lowest covered_px rows,
 * where opaque ground will set both colour and depth.
 */
static void draw_behind(const struct stage *stage, const struct gl *gl,
	int width, int height, int covered_px)
{
	gl->Enable(GL_SCISSOR_TEST);
	gl->Scissor(0, covered_px, width, height - covered_px);
	gl->Clear(GL_DEPTH_BUFFER_BIT);
	if (stage->backdrop) {
		backdrop_draw(stage->backdrop, gl);
	} else {
		draw_background(gl, stage->sight.strips.end_px, height);
	}
	gl->Disable(GL_SCISSOR_TEST);
}

/* Only rows below the horizon can hold flat shadows. */
static void clear_stencil(const struct gl *gl, int width, int rows)
{
	gl->ClearStencil(0);
	gl->Enable(GL_SCISSOR_TEST);
	gl->Scissor(0, 0, width, rows);
	gl->Clear(GL_STENCIL_BUFFER_BIT);
	gl->Disable(GL_SCISSOR_TEST);
}

void stage_begin(struct stage *stage, const struct gl *gl, int width, int height)
{
	/* A camera's image takes the place of level ground, not of hills. */
	bool ground = !stage->backdrop || stage->floor.wave_height != 0.0f;
	static const struct floor_content anything = {.bounded = false};
	struct floor_sight *sight = &stage->sight;

	floor_find_sight(&stage->floor, &stage->camera, width, height,
		stage->monitor ? &anything : &stage->content, sight);
	gl->Viewport(0, 0, width, height);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->DepthMask(GL_TRUE);
	gl->ClearDepthx(FX16_ONE);
	gl->DepthFunc(GL_LESS);
	gl->CullFace(GL_BACK);
	gl->FrontFace(GL_CCW);
	use_plain_state(gl);
	if (stage->has_stencil) {
		clear_stencil(gl, width, sight->strips.horizon_px);
	}
	draw_behind(stage, gl, width, height,
		ground ? sight->strips.covered_px : 0);
	camera_apply(&stage->camera, gl, width, height);
	light_apply(gl);
	if (ground) {
		floor_draw(&stage->floor, sight, gl);
	}
	if (stage->monitor && stage->floor.wave_height != 0.0f) {
		monitor_draw(stage->monitor, stage->monitor_picture, gl);
	}
}

bool stage_may_hide(const struct stage *stage, const struct bounds *box)
{
	const struct floor *floor = &stage->floor;
	float eye[3];

	camera_eye(&stage->camera, eye);
	return stage->monitor ||
		floor_mesh_may_hide(&stage->sight.mesh, floor->index, eye, box);
}

/* Projects along the light: p - light * (p.y - y) / light.y. */
static void shadow_matrix(const float light[3], float y, mat4 out)
{
	glm_mat4_identity(out);
	out[1][0] = -light[0] / light[1];
	out[1][1] = 0.0f;
	out[1][2] = -light[2] / light[1];
	out[3][0] = y * light[0] / light[1];
	out[3][1] = y;
	out[3][2] = y * light[2] / light[1];
}

/* Darkens each pixel whose stencil is ref once, even where triangles overlap. */
static void begin_shadow(const struct gl *gl, const float light[3], float y,
	bool has_stencil, GLint ref)
{
	mat4 flatten;

	use_plain_state(gl);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->Disable(GL_DEPTH_TEST); /* the shadow lies in the surface's plane */
	draw_set_shadow_color(gl, DRAW_SHADOW_ALPHA);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->DepthMask(GL_FALSE);
	if (has_stencil) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, ref, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	}
	shadow_matrix(light, y, flatten);
	gl->PushMatrix();
	matrix_gl_multiply(gl, (const vec4 *)flatten);
}

void stage_top_end(const struct gl *gl)
{
	gl->PopMatrix();
	gl->Disable(GL_STENCIL_TEST);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
}

void stage_shadow_begin(const struct stage *stage, const struct gl *gl)
{
	float light[3];

	light_direction(light);
	begin_shadow(gl, light, stage->floor.y, stage->has_stencil, 0);
	if (stage->monitor) {
		monitor_draw_geometry(stage->monitor, gl);
	}
}

void stage_shadow_end(const struct stage *stage, const struct gl *gl)
{
	stage_top_end(gl);
	stage_draw_monitor(stage, gl);
}

/*
 * Marks in the stencil where the rectangle is seen. It is drawn a little higher
 * for this, so that the surface it lies on does not hide it.
 */
void stage_top_begin(
	const struct stage *stage, const struct gl *gl, float corner[4][3])
{
	float lifted[4][3], lift = 0.001f * stage->camera.distance;
	float light[3];

	for (int i = 0; i < 4; i++) {
		memcpy(lifted[i], corner[i], sizeof(lifted[i]));
		lifted[i][1] += lift;
	}
	use_plain_state(gl);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, TOP_MARK, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
	gl->VertexPointer(3, GL_FLOAT, 0, lifted);
	gl->DrawArrays(GL_TRIANGLE_FAN, 0, 4);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	light_direction(light);
	begin_shadow(gl, light, corner[0][1], true, TOP_MARK);
}

void stage_ground_begin(const struct gl *gl)
{
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, STAGE_GROUND_MARK, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
}

void stage_ground_end(const struct gl *gl, const float light[3], float y)
{
	begin_shadow(gl, light, y, true, STAGE_GROUND_MARK);
}

void stage_lower_floor(struct stage *stage, const struct bounds *box)
{
	stage->floor.y -= lowered_part * bounds_extent(box);
}

void stage_draw_monitor(const struct stage *stage, const struct gl *gl)
{
	if (stage->monitor && stage->floor.wave_height == 0.0f) {
		monitor_draw(stage->monitor, stage->monitor_picture, gl);
		use_plain_state(gl);
	}
}

#include "app/scene/stage.h"

#include "app/scene/light.h"
#include "app/scene/matrix_gl.h"
#include "app/scene/texture.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include <cglm/cglm.h>

enum {
	TILE_TEXELS = 64
};

/* Studio backdrop, sRGB. The floor fades into the lower part of it. */
static const uint8_t sky_color[3] = {58, 68, 84};
static const uint8_t middle_color[3] = {146, 158, 172};
static const uint8_t ground_color[3] = {104, 114, 128};
static const uint8_t floor_near[3] = {206, 208, 208};

/* A tile with soft joints and two shades, so that motion shows. */
static int make_floor_texture(
	struct stage *stage, const struct gl *gl, enum pixel_format target)
{
	const struct model_texture sampling = {
		.wrap_s = MODEL_REPEAT, .wrap_t = MODEL_REPEAT, .mipmap = true};
	struct model_image image = {
		.width = TILE_TEXELS, .height = TILE_TEXELS, .opaque = true};

	image.rgba = malloc(TILE_TEXELS * TILE_TEXELS * 4);
	if (!image.rgba) {
		return -ENOMEM;
	}
	for (int i = 0; i < TILE_TEXELS * TILE_TEXELS; i++) {
		int x = i % TILE_TEXELS, y = i / TILE_TEXELS;
		int half = TILE_TEXELS / 2;
		bool joint = x % half == 0 || y % half == 0;
		bool dark = (x < half) != (y < half);
		int shade = joint ? 196 : dark ? 226 : 250;

		memset(image.rgba + i * 4, shade, 3);
		image.rgba[i * 4 + 3] = 255;
	}
	stage->floor_texture = texture_upload(gl, &image, &sampling, target);
	free(image.rgba);
	return stage->floor_texture ? 0 : -ENOMEM;
}

/* A disc of rings around a centre; its rim is fully see-through. */
static void make_floor_mesh(struct stage *stage)
{
	uint16_t *index = stage->floor_index;

	for (int i = 0; i <= STAGE_RINGS * STAGE_SPOKES; i++) {
		int ring = i ? (i - 1) / STAGE_SPOKES + 1 : 0;
		float share = (float)ring / STAGE_RINGS;
		float angle = (float)((i + STAGE_SPOKES - 1) % STAGE_SPOKES) *
			(2.0f * SCALAR_PI / STAGE_SPOKES);
		float radius = stage->floor_radius * share * share;
		float *p = stage->floor_position[i];
		float fade = 1.0f - share * share;

		p[0] = stage->floor_center[0] + radius * scalar_cos(angle);
		p[1] = stage->floor_y;
		p[2] = stage->floor_center[1] + radius * scalar_sin(angle);
		stage->floor_texcoord[i][0] = p[0] / stage->tile;
		stage->floor_texcoord[i][1] = p[2] / stage->tile;
		memcpy(stage->floor_color[i], floor_near, 3);
		stage->floor_color[i][3] = (uint8_t)(255.0f * fade + 0.5f);
	}
	for (int spoke = 0; spoke < STAGE_SPOKES; spoke++) {
		int next = (spoke + 1) % STAGE_SPOKES;

		*index++ = 0;
		*index++ = (uint16_t)(1 + next);
		*index++ = (uint16_t)(1 + spoke);
		for (int ring = 1; ring < STAGE_RINGS; ring++) {
			int in = 1 + (ring - 1) * STAGE_SPOKES;
			int out = in + STAGE_SPOKES;

			*index++ = (uint16_t)(in + spoke);
			*index++ = (uint16_t)(in + next);
			*index++ = (uint16_t)(out + spoke);
			*index++ = (uint16_t)(out + spoke);
			*index++ = (uint16_t)(in + next);
			*index++ = (uint16_t)(out + next);
		}
	}
}

/* 1, 2 or 5 times a power of ten near the size. */
static float round_size(float size)
{
	float step = 1.0f;

	while (step * 10.0f <= size) {
		step *= 10.0f;
	}
	while (step > size) {
		step *= 0.1f;
	}
	return size >= step * 5.0f    ? step * 5.0f
		: size >= step * 2.0f ? step * 2.0f
				      : step;
}

int stage_init(struct stage *stage, const struct gl *gl,
	const struct bounds *bounds, float aspect, enum pixel_format target,
	const struct log *log)
{
	float center[3], extent = bounds_extent(bounds);
	GLint stencil_bits = 0;

	*stage = (struct stage){.camera = camera_default()};
	camera_frame(&stage->camera, bounds, aspect);
	bounds_center(bounds, center);
	extent = extent > 0.0f ? extent : 1.0f;
	stage->floor_y = bounds_is_empty(bounds) ? 0.0f : bounds->low[1];
	stage->floor_center[0] = center[0];
	stage->floor_center[1] = center[2];
	stage->floor_radius = 2.2f * extent;
	stage->tile = round_size(0.5f * extent);
	gl->GetIntegerv(GL_STENCIL_BITS, &stencil_bits);
	stage->has_stencil = stencil_bits > 0;
	make_floor_mesh(stage);
	if (make_floor_texture(stage, gl, target) != 0) {
		log_error(log, "floor: not enough memory for its texture");
		return -ENOMEM;
	}
	return 0;
}

void stage_finish(struct stage *stage, const struct gl *gl)
{
	if (stage->floor_texture) {
		gl->DeleteTextures(1, &stage->floor_texture);
		stage->floor_texture = 0;
	}
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

/* A vertical gradient behind everything, horizon at a third. */
static void draw_background(const struct gl *gl)
{
	static const int16_t position[8][2] = {{-1, 3}, {1, 3}, {-1, 0}, {1, 0},
		{-1, -1}, {1, -1}, {-1, -3}, {1, -3}};
	uint8_t color[8][4];

	for (int i = 0; i < 8; i++) {
		const uint8_t *from = i < 2 ? sky_color
			: i < 4             ? middle_color
			: i < 6             ? ground_color
					    : ground_color;

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
	gl->VertexPointer(2, GL_SHORT, 0, position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 8);
	gl->Enable(GL_DEPTH_TEST);
}

static void draw_floor(const struct stage *stage, const struct gl *gl)
{
	gl->BindTexture(GL_TEXTURE_2D, stage->floor_texture);
	gl->Enable(GL_TEXTURE_2D);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	gl->Translatex(fx16_from_float(stage->floor_offset[0] / stage->tile),
		fx16_from_float(stage->floor_offset[1] / stage->tile), 0);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->DepthMask(GL_FALSE);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, stage->floor_position);
	gl->TexCoordPointer(2, GL_FLOAT, 0, stage->floor_texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, stage->floor_color);
	gl->DrawElements(GL_TRIANGLES, (int)ARRAY_COUNT(stage->floor_index),
		GL_UNSIGNED_SHORT, stage->floor_index);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
	gl->Disable(GL_TEXTURE_2D);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void stage_begin(
	const struct stage *stage, const struct gl *gl, int width, int height)
{
	gl->Viewport(0, 0, width, height);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->DepthMask(GL_TRUE);
	gl->ClearDepthx(FX16_ONE);
	gl->ClearStencil(0);
	gl->Clear(GL_DEPTH_BUFFER_BIT |
		(stage->has_stencil ? GL_STENCIL_BUFFER_BIT : 0));
	gl->DepthFunc(GL_LESS);
	gl->CullFace(GL_BACK);
	gl->FrontFace(GL_CCW);
	use_plain_state(gl);
	draw_background(gl);
	camera_apply(&stage->camera, gl, width, height);
	light_apply(gl);
	if (stage->floor_radius > 0.0f) {
		draw_floor(stage, gl);
	}
}

/* Projects along the light onto the floor: p - light * (p.y - floor) / light.y */
static void shadow_matrix(const struct stage *stage, mat4 out)
{
	float light[3], lift = stage->floor_y;

	light_direction(light);
	glm_mat4_identity(out);
	out[1][0] = -light[0] / light[1];
	out[1][1] = 0.0f;
	out[1][2] = -light[2] / light[1];
	out[3][0] = lift * light[0] / light[1];
	out[3][1] = lift;
	out[3][2] = lift * light[2] / light[1];
}

void stage_shadow_begin(const struct stage *stage, const struct gl *gl)
{
	mat4 flatten;

	use_plain_state(gl);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->Color4x(
		FX16_ONE / 16, FX16_ONE / 16, FX16_ONE / 12, FX16_ONE * 3 / 8);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->DepthMask(GL_FALSE);
	if (stage->has_stencil) {
		/* Each pixel is darkened once, however often it is covered. */
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	}
	shadow_matrix(stage, flatten);
	gl->PushMatrix();
	matrix_gl_multiply(gl, (const vec4 *)flatten);
}

void stage_shadow_end(const struct stage *stage, const struct gl *gl)
{
	gl->PopMatrix();
	if (stage->has_stencil) {
		gl->Disable(GL_STENCIL_TEST);
	}
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
}

#include "app/scene/stage/ball.h"

#include "app/anim/math/vec.h"
#include "app/scene/draw/triangle_list.h"
#include "app/scene/stage/light.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

enum {
	SHADOW_CORNERS = 16
};

void ball_init(struct ball *ball)
{
	uint16_t *next = ball->index;

	for (int i = 0; i < BALL_VERTICES; i++) {
		float down = (float)(i / (BALL_SPOKES + 1)) *
			(SCALAR_PI / BALL_RINGS);
		float round = (float)(i % (BALL_SPOKES + 1)) *
			(2.0f * SCALAR_PI / BALL_SPOKES);

		ball->normal[i][0] = scalar_sin(down) * scalar_cos(round);
		ball->normal[i][1] = scalar_cos(down);
		ball->normal[i][2] = scalar_sin(down) * scalar_sin(round);
	}
	for (uint32_t ring = 0; ring < BALL_RINGS; ring++) {
		for (uint32_t spoke = 0; spoke < BALL_SPOKES; spoke++) {
			uint32_t at = ring * (BALL_SPOKES + 1) + spoke;
			uint32_t below = at + BALL_SPOKES + 1;

			next = triangle_list_add(next, at, at + 1, below);
			next = triangle_list_add(next, below, at + 1, below + 1);
		}
	}
}

/*
 * Finds where the line from a point along the light meets the floor, by
 * iteration on uneven ground.
 */
static void fall_on_floor(const struct floor *floor, const float light[3],
	const float from[3], float out[3])
{
	float height = floor_height(floor, from[0], from[2]);

	for (int i = 0; i < 3; i++) {
		float fall = (from[1] - height) / light[1];

		out[0] = from[0] - light[0] * fall;
		out[1] = height;
		out[2] = from[2] - light[2] * fall;
		height = floor_height(floor, out[0], out[2]);
	}
	out[1] = height;
}

/* Projects the ball's outline, as the light sees it, onto the floor. */
static void find_shadow(const struct floor *floor, const float eye[3],
	const float center[3], float radius, float out[SHADOW_CORNERS][3])
{
	float light[3], side[3], up[3];
	const float above[3] = {0.0f, 1.0f, 0.0f};

	light_direction(light);
	vec_cross(above, light, side);
	vec_normalize(side);
	vec_cross(light, side, up);
	for (int i = 0; i < SHADOW_CORNERS; i++) {
		float round = (float)i * (2.0f * SCALAR_PI / SHADOW_CORNERS);
		float at[3];

		vec_add_scaled(center, side, radius * scalar_cos(round), at);
		vec_add_scaled(at, up, radius * scalar_sin(round), at);
		fall_on_floor(floor, light, at, out[i]);
		floor_lift(floor, eye, out[i]);
	}
}

void ball_draw_shadow(const struct gl *gl, const float center[3], float radius,
	const struct stage *stage)
{
	float corner[SHADOW_CORNERS][3], eye[3];

	camera_eye(&stage->camera, eye);
	find_shadow(&stage->floor, eye, center, radius, corner);
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_CULL_FACE);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->DepthMask(GL_FALSE);
	gl->Color4x(
		FX16_ONE / 16, FX16_ONE / 16, FX16_ONE / 12, FX16_ONE * 3 / 8);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, corner);
	gl->DrawArrays(GL_TRIANGLE_FAN, 0, SHADOW_CORNERS);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
}

void ball_draw(const struct ball *ball, const struct gl *gl,
	const float center[3], float radius, const float color[3])
{
	GLfixed scale = fx16_from_float(radius);

	light_set_material(gl, color, 0.5f, 40);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, ball->normal);
	gl->NormalPointer(GL_FLOAT, 0, ball->normal);
	gl->PushMatrix();
	gl->Translatex(fx16_from_float(center[0]), fx16_from_float(center[1]),
		fx16_from_float(center[2]));
	gl->Scalex(scale, scale, scale);
	gl->DrawElements(
		GL_TRIANGLES, BALL_INDICES, GL_UNSIGNED_SHORT, ball->index);
	gl->PopMatrix();
}

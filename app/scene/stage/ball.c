#include "app/scene/stage/ball.h"

#include "app/scene/draw/triangle_list.h"
#include "app/scene/stage/light.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

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

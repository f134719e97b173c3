#include "app/scene/stage/backdrop.h"

#include "platform/base/fixed.h"

static const int8_t corner[4][2] = {{-1, 1}, {-1, -1}, {1, 1}, {1, -1}};
static const int8_t texcoord[4][2] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};

void backdrop_draw(const struct live_texture *texture, const struct gl *gl)
{
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	live_texture_bind(texture, gl);
	/* Some drivers modulate by white faster than they replace. */
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->Color4x(FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE);
	gl->Disable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(2, GL_BYTE, 0, corner);
	gl->TexCoordPointer(2, GL_BYTE, 0, texcoord);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	live_texture_unbind(gl);
	gl->Enable(GL_DEPTH_TEST);
}

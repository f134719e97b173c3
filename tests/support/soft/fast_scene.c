#include "tests/support/soft/fast_scene.h"

#include "platform/base/fixed.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

static void make_texture(const struct gl *gl, uint32_t seed)
{
	uint8_t texels[FAST_SIDE * FAST_SIDE * 3];
	GLuint name;

	for (size_t i = 0; i < sizeof(texels); i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, FAST_SIDE, FAST_SIDE, 0,
		GL_RGB, GL_UNSIGNED_BYTE, texels);
}

struct soft_scene *fast_scene_open(uint32_t seed)
{
	struct soft_scene *scene = soft_scene_open();

	scene->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	make_texture(scene->gl, seed);
	return scene;
}

void fast_scene_make_triangles(struct soft_corner *corner, uint32_t seed,
	enum fast_kind kind, int size)
{
	for (int i = 0; i < FAST_TRIANGLES; i++) {
		float x = (float)random_between(&seed, -1100, 1100) / 1000.0f;
		float y = (float)random_between(&seed, -1100, 1100) / 1000.0f;

		for (int k = 0; k < 3; k++) {
			struct soft_corner *c = &corner[i * 3 + k];
			int gray = random_between(&seed, 0, 255);

			c->position[0] = x +
				(float)random_between(&seed, -size, size) /
					1000.0f;
			c->position[1] = y +
				(float)random_between(&seed, -size, size) /
					1000.0f;
			c->position[2] =
				(float)random_between(&seed, -900, 900) /
				1000.0f;
			for (int n = 0; n < 3; n++) {
				c->color[n] = (uint8_t)(kind == FAST_TEXTURED
						? gray
						: random_between(&seed, 0, 255));
			}
			c->color[3] = 255;
			c->texcoord[0] =
				(float)random_between(&seed, -40, 40) / 64.0f;
			c->texcoord[1] =
				(float)random_between(&seed, -40, 40) / 64.0f;
		}
	}
}

void fast_scene_set_state(struct soft_scene *scene,
	const struct soft_corner *corner, enum fast_kind kind, bool long_way)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	soft_scene_use(scene, long_way);
	gl->Enable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	if (kind == FAST_TEXTURED) {
		gl->Enable(GL_TEXTURE_2D);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	}
	if (kind == FAST_SHADOW) {
		gl->Disable(GL_DEPTH_TEST);
		gl->DisableClientState(GL_COLOR_ARRAY);
		gl->Color4x(FX16_ONE, FX16_ONE / 2, 0, FX16_ONE * 3 / 8);
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
		gl->Clear(GL_STENCIL_BUFFER_BIT);
	}
}

void fast_scene_draw(struct soft_scene *scene, const struct soft_corner *corner,
	enum fast_kind kind, bool long_way)
{
	fast_scene_set_state(scene, corner, kind, long_way);
	scene->gl->DrawArrays(GL_TRIANGLES, 0, FAST_CORNERS);
}

void fast_scene_compare(const struct soft_scene *a, const struct soft_scene *b)
{
	const struct buffers *left = &a->soft->buffers;
	const struct buffers *right = &b->soft->buffers;
	const uint16_t *p = a->pixel, *q = b->pixel;

	assert_memory_equal(left->depth, right->depth,
		SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT * 2);
	if (left->stencil) {
		assert_memory_equal(left->stencil, right->stencil,
			SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT);
	}
	for (int i = 0; i < SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT; i++) {
		if (soft_scene_steps(p[i], q[i]) > 1) {
			fail_msg("pixel %d,%d is %04x, the long way %04x",
				i % SOFT_SCENE_WIDTH, i / SOFT_SCENE_WIDTH,
				p[i], q[i]);
		}
	}
}

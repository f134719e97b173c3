#include "tests/support/soft/span_scene.h"

#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <stdlib.h>

struct span_scene *span_scene_open(enum pixel_format format)
{
	const struct log log = {0};
	struct span_scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->picture = (struct pixels){
		.width = SPAN_WIDTH,
		.height = SPAN_HEIGHT,
		.stride_bytes = SPAN_WIDTH * pixel_bytes(format),
		.format = format,
		.data = scene->bytes,
	};
	assert_int_equal(
		gl_open("soft",
			&(struct gl_request){.format = format, .log = &log},
			&scene->context),
		0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	return scene;
}

void span_scene_close(struct span_scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	free(scene);
}

void span_scene_fog(const struct gl *gl)
{
	static const GLfixed color[] = {20000, 50000, 9000, 65536};

	gl->Enable(GL_FOG);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * 65536);
	gl->Fogx(GL_FOG_END, 6 * 65536);
	gl->Fogxv(GL_FOG_COLOR, color);
}

static void draw(const struct gl *gl, const struct span_corner *corner,
	int count, bool joined)
{
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*corner), corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	for (GLenum unit = 0; unit < 2; unit++) {
		gl->ClientActiveTexture(GL_TEXTURE0 + unit);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, sizeof(*corner),
			corner->texcoord[joined ? 0 : unit]);
	}
	gl->DrawArrays(GL_TRIANGLES, 0, count);
}

void span_scene_draw(
	const struct gl *gl, const struct span_corner *corner, int count)
{
	draw(gl, corner, count, false);
}

void span_scene_draw_joined(
	const struct gl *gl, const struct span_corner *corner, int count)
{
	draw(gl, corner, count, true);
}

struct span_scene *span_scene_begin(enum pixel_format format, bool reference)
{
	struct span_scene *scene = span_scene_open(format);
	const struct gl *gl = scene->gl;

	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	reference_use(scene->soft, reference);
	gl->ClearDepthx(60000);
	gl->Enable(GL_STENCIL_TEST);
	gl->Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
	gl->Disable(GL_STENCIL_TEST);
	for (size_t i = 0; i < sizeof(scene->bytes); i++) {
		scene->bytes[i] = (uint8_t)(i * 37 ^ i >> 5);
	}
	return scene;
}

static int distance(int a, int b)
{
	return abs(a - b);
}

bool span_scene_is_near(
	const struct span_scene *a, int i, const struct span_scene *b, int k)
{
	if (a->soft->format == PIXELS_RGBA8888) {
		for (int n = 0; n < 4; n++) {
			if (distance(a->bytes[4 * i + n], b->bytes[4 * k + n]) >
				8) {
				return false;
			}
		}
		return true;
	}
	int p = a->bytes[2 * i] | a->bytes[2 * i + 1] << 8;
	int q = b->bytes[2 * k] | b->bytes[2 * k + 1] << 8;

	return distance(p >> 11, q >> 11) <= 1 &&
		distance(p >> 5 & 63, q >> 5 & 63) <= 2 &&
		distance(p & 31, q & 31) <= 1;
}

int span_scene_compare(
	const struct span_scene *a, const struct span_scene *b, uint32_t seed)
{
	const struct buffers *x = &a->soft->buffers, *y = &b->soft->buffers;
	int drawn = 0;

	assert_memory_equal(x->depth, y->depth, SPAN_PIXELS * 2);
	assert_memory_equal(x->stencil, y->stencil, SPAN_PIXELS);
	for (int i = 0; i < SPAN_PIXELS; i++) {
		if (!span_scene_is_near(a, i, b, i)) {
			const uint8_t *p = a->bytes, *q = b->bytes;
			int at = i * pixel_bytes(a->soft->format);

			fail_msg("seed %u: pixel %d,%d: %02x%02x%02x%02x, by "
				 "fragments %02x%02x%02x%02x, finish %d",
				seed, i % SPAN_WIDTH, i / SPAN_WIDTH, p[at],
				p[at + 1], p[at + 2], p[at + 3], q[at],
				q[at + 1], q[at + 2], q[at + 3],
				(int)a->soft->draw->spans.finish);
		}
		drawn += x->depth[i] != x->depth[0];
	}
	return drawn;
}

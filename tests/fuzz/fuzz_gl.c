/*
 * Takes any bytes as calls of GL and makes them with the soft driver: right and
 * wrong ones, in any order, with arrays and pictures of sizes that are valid.
 */
#include "tests/fuzz/fuzz_gl_calls.h"

#include "tests/fuzz/fuzz_expect.h"

#include <string.h>

static void draw(struct scene *scene)
{
	const struct gl *gl = scene->gl;
	struct reader *from = scene->from;
	GLenum mode = PICK(from, GL_TRIANGLES, GL_TRIANGLE_STRIP,
		GL_TRIANGLE_FAN, GL_TRIANGLES, GL_LINES, GL_LINE_STRIP,
		GL_LINE_LOOP, GL_POINTS);
	GLsizei count = (GLsizei)(byte(from) % 64);

	if (byte(from) & 1) {
		gl->DrawArrays(mode, (GLint)(byte(from) % 128), count);
	} else {
		gl->DrawElements(mode, count,
			PICK(from, GL_UNSIGNED_SHORT, GL_UNSIGNED_BYTE),
			scene->index + byte(from) % 64);
	}
}

static void clear(struct scene *scene)
{
	GLfixed v[4];

	values(scene->from, v, 4);
	scene->gl->ClearColorx(v[0], v[1], v[2], v[3]);
	scene->gl->ClearDepthx(v[1]);
	scene->gl->ClearStencil(v[2]);
	scene->gl->Clear(byte(scene->from) << 8 &
		(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
			GL_STENCIL_BUFFER_BIT));
}

static void new_frame(struct scene *scene)
{
	const struct gl_driver *driver = scene->context->driver;

	fuzz_expect(driver->end_frame(scene->context) == 0);
	scene->target.width = 1 + (int)(byte(scene->from) % SIDE_MAX);
	scene->target.height = 1 + (int)(byte(scene->from) % SIDE_MAX);
	fuzz_expect(driver->begin_frame(scene->context, &scene->target) == 0);
}

static void call(struct scene *scene)
{
	switch (byte(scene->from) % 16) {
	case 0:
	case 1:
		fuzz_gl_matrix(scene);
		break;
	case 2:
		fuzz_gl_light(scene);
		break;
	case 3:
	case 4:
		fuzz_gl_fragment(scene);
		break;
	case 5:
	case 6:
		fuzz_gl_texture(scene);
		break;
	case 7:
	case 8:
		fuzz_gl_arrays(scene);
		break;
	case 9:
		scene->gl->Enable(capability(scene->from));
		break;
	case 10:
		scene->gl->Disable(capability(scene->from));
		break;
	case 11:
		clear(scene);
		break;
	case 12:
		if (byte(scene->from) % 8 == 0) {
			new_frame(scene);
		}
		break;
	default:
		draw(scene);
		break;
	}
}

/* Small numbers of 16 bits, so that most vertices are near the picture. */
static void fill(struct scene *scene)
{
	uint32_t state = 1;

	for (size_t i = 0; i + 1 < POOL_BYTES; i += 2) {
		int16_t value;

		state = state * 1664525u + 1013904223u;
		value = (int16_t)((int)(state >> 20) - 2048);
		value = state % 97 == 0 ? INT16_MAX : value;
		memcpy(scene->pool + i, &value, sizeof(value));
	}
	for (int i = 0; i < VERTICES; i++) {
		state = state * 1664525u + 1013904223u;
		scene->index[i] = (uint16_t)(state >> 24);
	}
}

static bool open_scene(struct scene *scene)
{
	struct log log = log_to_nowhere();
	enum pixel_format format =
		byte(scene->from) & 1 ? PIXELS_RGB565 : PIXELS_RGBA8888;
	struct gl_request request = {.format = format, .log = &log};

	scene->pool = malloc(POOL_BYTES);
	if (!scene->pool ||
		pixels_alloc(&scene->target, SIDE_MAX, SIDE_MAX, format, &log) ||
		gl_open("soft", &request, &scene->context) != 0) {
		return false;
	}
	scene->gl = &scene->context->gl;
	fill(scene);
	scene->gl->GenTextures(TEXTURES, scene->texture);
	scene->gl->VertexPointer(3, GL_SHORT, 0, scene->pool);
	scene->gl->NormalPointer(GL_SHORT, 0, scene->pool);
	scene->gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, scene->pool);
	scene->gl->ClientActiveTexture(GL_TEXTURE1);
	scene->gl->TexCoordPointer(2, GL_SHORT, 0, scene->pool);
	scene->gl->ClientActiveTexture(GL_TEXTURE0);
	scene->gl->TexCoordPointer(2, GL_SHORT, 0, scene->pool);
	scene->gl->EnableClientState(GL_VERTEX_ARRAY);
	scene->gl->Scalex(32, 32, 32);
	return scene->context->driver->begin_frame(
		       scene->context, &scene->target) == 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	struct reader from = {data, data + size};
	struct scene scene = {.from = &from};

	if (open_scene(&scene)) {
		for (int i = 0; i < CALLS_MAX && from.at < from.end; i++) {
			call(&scene);
		}
		(void)scene.gl->GetError();
		scene.context->driver->end_frame(scene.context);
		scene.gl->DeleteTextures(TEXTURES, scene.texture);
	}
	if (scene.context) {
		scene.context->driver->destroy(scene.context);
	}
	free(scene.target.data);
	free(scene.pool);
	return 0;
}

/*
 * The two scenes that software GLs are measured with: a lit sphere of 4,096
 * triangles, unindexed, RGB565 with 16-bit depth, 480x640.
 *
 *	gl_scenes SCENE FRAMES [DRIVER [PICTURE.ppm]]
 *
 * SCENE is A (Gouraud, orthographic) or B (nearest texture, perspective),
 * followed by c (back faces culled) or g (tiny: the geometry alone), or the
 * word clear. For the timing model (tests/arm1136) the last frame is region 1.
 * Else the cost of a frame is (instructions of 9 frames - instructions of 1
 * frame) / 8.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "tests/arm1136/marker.h"
#include "tests/bench/bench_picture.h"

enum {
	WIDTH = 480,
	HEIGHT = 640,
	AROUND = 64,
	DOWN = 32,
	VERTICES = AROUND * DOWN * 6,
	TEXTURE_SIDE = 256,
};

struct scene {
	bool textured, culled, clear_only;
	float radius;
};

struct vertex {
	float position[3], normal[3], texcoord[2];
};

static void set_vertex(struct vertex *v, int i, int j, float radius)
{
	double a = i * 2.0 * 3.14159265358979 / AROUND;
	double b = j * 3.14159265358979 / DOWN;

	v->normal[0] = (float)(cos(a) * sin(b));
	v->normal[1] = (float)cos(b);
	v->normal[2] = (float)(sin(a) * sin(b));
	for (int k = 0; k < 3; k++) {
		v->position[k] = v->normal[k] * radius;
	}
	v->texcoord[0] = (float)i / AROUND;
	v->texcoord[1] = (float)j / DOWN;
}

static void make_sphere(struct vertex *out, float radius)
{
	static const int corner[6][2] = {
		{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};

	for (int quad = 0; quad < AROUND * DOWN; quad++) {
		for (int k = 0; k < 6; k++) {
			set_vertex(out++, quad % AROUND + corner[k][0],
				quad / AROUND + corner[k][1], radius);
		}
	}
}

static void make_texture(const struct gl *gl)
{
	static uint8_t texels[TEXTURE_SIDE][TEXTURE_SIDE][3];
	GLuint name;

	for (int y = 0; y < TEXTURE_SIDE; y++) {
		for (int x = 0; x < TEXTURE_SIDE; x++) {
			bool differ = (x >> 5 & 1) != (y >> 5 & 1);
			uint8_t *t = texels[y][x];

			t[0] = (uint8_t)(differ ? 230 : x);
			t[1] = (uint8_t)(differ ? y : 200);
			t[2] = (uint8_t)(differ ? 60 : 255 - x);
		}
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, TEXTURE_SIDE, TEXTURE_SIDE, 0,
		GL_RGB, GL_UNSIGNED_BYTE, texels);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->Enable(GL_TEXTURE_2D);
}

static void set_projection(const struct gl *gl, bool perspective)
{
	static const GLfixed mirror_z[16] = {65536, 0, 0, 0, 0, 65536, 0, 0, 0,
		0, -65536, 0, 0, 0, 0, 65536};
	GLfixed half = fx16_from_float(2.0f * 0.2582f / 0.6515f);

	gl->MatrixMode(GL_PROJECTION);
	if (perspective) {
		gl->LoadIdentity();
		gl->Frustumx(
			-half, half, -half, half, 2 * FX16_ONE, 6 * FX16_ONE);
	} else {
		gl->LoadMatrixx(mirror_z);
	}
	gl->MatrixMode(GL_MODELVIEW);
}

static void set_up(const struct gl *gl, const struct scene *scene,
	const struct vertex *vertex)
{
	/* (1, 1, 2) / sqrt 6 */
	static const GLfixed towards[4] = {26755, 26755, 53510, 0};

	set_projection(gl, scene->textured);
	if (scene->textured) {
		make_texture(gl);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(
			2, GL_FLOAT, sizeof(*vertex), vertex->texcoord);
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*vertex), vertex->position);
	gl->NormalPointer(GL_FLOAT, sizeof(*vertex), vertex->normal);
	gl->LoadIdentity();
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, towards);
	gl->Enable(GL_DEPTH_TEST);
	gl->Disable(GL_DITHER);
	if (scene->culled) {
		gl->Enable(GL_CULL_FACE);
		gl->FrontFace(GL_CCW);
	}
	gl->ClearColorx(
		FX16_ONE / 10, FX16_ONE / 5, FX16_ONE * 3 / 10, FX16_ONE);
}

static void draw_frame(const struct gl *gl, const struct scene *scene, int frame)
{
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	if (scene->clear_only) {
		return;
	}
	gl->LoadIdentity();
	if (scene->textured) {
		gl->Translatex(0, 0, -4 * FX16_ONE);
	}
	gl->Rotatex(frame * FX16_ONE, 0, FX16_ONE, 0);
	gl->DrawArrays(GL_TRIANGLES, 0, VERTICES);
}

static bool parse(const char *name, struct scene *out)
{
	*out = (struct scene){.radius = 0.9f};
	if (strcmp(name, "clear") == 0) {
		out->clear_only = true;
		return true;
	}
	if (name[0] != 'A' && name[0] != 'B') {
		return false;
	}
	out->textured = name[0] == 'B';
	out->radius = out->textured ? 1.0f : 0.9f;
	out->culled = name[1] == 'c';
	out->radius *= name[1] == 'g' ? 0.002f : 1.0f;
	return true;
}

int main(int argc, char **argv)
{
	static struct vertex vertex[VERTICES];
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl_context *context;
	struct pixels pixels;
	struct scene scene;
	int frames = argc > 2 ? atoi(argv[2]) : 0;

	if (frames < 1 || !parse(argv[1], &scene)) {
		fprintf(stderr,
			"usage: %s A|Ac|Ag|B|Bc|Bg|clear FRAMES [DRIVER "
			"[PICTURE.ppm]]\n",
			argv[0]);
		return 2;
	}
	if (pixels_alloc(&pixels, WIDTH, HEIGHT, PIXELS_RGB565, &log) != 0 ||
		gl_open(argc > 3 ? argv[3] : "soft",
			&(struct gl_request){
				.format = PIXELS_RGB565, .log = &log},
			&context) != 0) {
		return EXIT_FAILURE;
	}
	make_sphere(vertex, scene.radius);
	for (int frame = 0; frame < frames; frame++) {
		if (context->driver->begin_frame(context, &pixels) != 0) {
			return EXIT_FAILURE;
		}
		if (frame == 0) {
			set_up(&context->gl, &scene, vertex);
		}
		if (frame == frames - 1) {
			MARKER_BEGIN(1);
		}
		draw_frame(&context->gl, &scene, frame);
		context->driver->end_frame(context);
		MARKER_END(1);
	}
	if (argc > 4) {
		bench_picture_write(argv[4], &pixels);
	}
	context->driver->destroy(context);
	free(pixels.data);
	return EXIT_SUCCESS;
}

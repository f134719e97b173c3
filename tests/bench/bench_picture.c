#include "tests/bench/bench_picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"

void bench_picture_project(const struct gl *gl)
{
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-FX16_ONE * 3 / 8, FX16_ONE * 3 / 8, -FX16_ONE / 2,
		FX16_ONE / 2, FX16_ONE, 10 * FX16_ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
}

static void write_pixel(FILE *file, const struct pixels *pixels, int i)
{
	uint16_t p;

	if (pixels->format != PIXELS_RGB565) {
		fwrite(pixels->data + 4 * i, 1, 3, file);
		return;
	}
	memcpy(&p, pixels->data + 2 * i, sizeof(p));
	fputc((p >> 11) * 255 / 31, file);
	fputc((p >> 5 & 63) * 255 / 63, file);
	fputc((p & 31) * 255 / 31, file);
}

void bench_picture_write(const char *path, const struct pixels *pixels)
{
	FILE *file = fopen(path, "wb");

	if (!file) {
		perror(path);
		exit(EXIT_FAILURE);
	}
	fprintf(file, "P6 %d %d 255\n", pixels->width, pixels->height);
	for (int i = 0; i < pixels->width * pixels->height; i++) {
		write_pixel(file, pixels, i);
	}
	if (fclose(file) != 0) {
		perror(path);
		exit(EXIT_FAILURE);
	}
}

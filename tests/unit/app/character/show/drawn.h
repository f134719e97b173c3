/* A character that is drawn with a GL that records, for tests of drawing. */
#ifndef TESTS_UNIT_APP_CHARACTER_SHOW_DRAWN_H
#define TESTS_UNIT_APP_CHARACTER_SHOW_DRAWN_H

#include "app/character/show/character_draw.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

static const float unit = 0.5f; /* scene units a metre */

struct shown {
	struct acting acting;
	struct gl gl;
	struct texture_set textures;
	struct character_drawing drawing;
	struct stage stage;
};

/* The model stands on level ground at height 0. */
static inline void begin(
	struct shown *shown, const char *model, const char *text)
{
	const struct shadow_ground none = {0};
	struct log log = log_to_stderr(LOG_WARNING);

	memset(shown, 0, sizeof(*shown));
	acting_begin(&shown->acting, model);
	shown->acting.instance->unit_scale = unit;
	acting_expect(&shown->acting, text);
	shown->gl = gl_recorder_begin();
	assert_int_equal(
		texture_set_create(&shown->textures, shown->acting.model,
			&shown->gl, PIXELS_RGB565, &log),
		0);
	shown->stage.camera = camera_default();
	shown->stage.has_stencil = true;
	assert_int_equal(character_draw_init(&shown->drawing,
				 shown->acting.character, &none, &log),
		0);
}

static inline void end(struct shown *shown)
{
	texture_set_destroy(&shown->textures, &shown->gl);
	acting_end(&shown->acting);
}

/* Draws the character, and returns how many draw calls that takes. */
static inline int draw(struct shown *shown)
{
	gl_recorder_clear();
	character_draw(
		&shown->drawing, &shown->stage, &shown->textures, &shown->gl);
	assert_int_equal(gl_recorder_result()->depth, 0);
	return gl_recorder_result()->draw_count;
}

/* What VertexPointer was given last. */
static const float *array;

static inline void note_array(
	GLint size, GLenum type, GLsizei stride, const void *at)
{
	(void)size;
	(void)type;
	(void)stride;
	array = at;
}

#endif

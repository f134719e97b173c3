#include "tests/support/gl/gl_state.h"

#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <string.h>

static const GLenum capabilities[] = {GL_LIGHTING, GL_LIGHT0, GL_LIGHT1,
	GL_COLOR_MATERIAL, GL_NORMALIZE, GL_TEXTURE_2D, GL_BLEND, GL_DEPTH_TEST,
	GL_CULL_FACE, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_FOG, GL_VERTEX_ARRAY,
	GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
	GL_STATE_DEPTH_WRITES};

static struct {
	struct gl recorder;
	struct gl_state_draw now, draw[GL_STATE_DRAWS];
	int draws;
	const char *position;
	GLsizei stride;
	int size; /* of a position of floats; 0 for other types */
} follower;

static uint32_t bit_of(GLenum capability)
{
	for (size_t i = 0; i < ARRAY_COUNT(capabilities); i++) {
		if (capabilities[i] == capability) {
			return 1u << i;
		}
	}
	return 0;
}

static void turn(GLenum capability, bool on)
{
	uint32_t bit = bit_of(capability);

	follower.now.on = on ? follower.now.on | bit : follower.now.on & ~bit;
}

static void turn_on(GLenum capability)
{
	turn(capability, true);
}

static void turn_off(GLenum capability)
{
	turn(capability, false);
}

static void set_depth_mask(GLboolean on)
{
	turn(GL_STATE_DEPTH_WRITES, on);
}

static void set_color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed color[4] = {red, green, blue, alpha};

	for (int i = 0; i < 4; i++) {
		follower.now.color[i] = color[i] / 65536.0;
	}
}

static void set_position(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	follower.size = type == GL_FLOAT ? size : 0;
	follower.stride = stride ? stride : size * (GLsizei)sizeof(float);
	follower.position = pointer;
	follower.recorder.VertexPointer(size, type, stride, pointer);
}

static void note_draw(
	GLenum mode, GLint first, GLsizei count, const uint16_t *index)
{
	struct gl_state_draw *draw = &follower.draw[follower.draws];
	int kept = count < GL_STATE_VERTICES ? count : GL_STATE_VERTICES;

	assert_true(follower.draws < GL_STATE_DRAWS);
	*draw = follower.now;
	draw->mode = mode;
	draw->count = count;
	for (int i = 0; follower.size > 0 && i < kept; i++) {
		ptrdiff_t at = index ? index[i] : first + i;

		memcpy(draw->vertex[i], follower.position + at * follower.stride,
			(size_t)follower.size * sizeof(float));
	}
	follower.draws++;
}

static void draw_arrays(GLenum mode, GLint first, GLsizei count)
{
	note_draw(mode, first, count, NULL);
	follower.recorder.DrawArrays(mode, first, count);
}

static void draw_elements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	note_draw(mode, 0, count, indices);
	follower.recorder.DrawElements(mode, count, type, indices);
}

struct gl gl_state_begin(bool enabled)
{
	struct gl gl = gl_recorder_begin();

	memset(&follower, 0, sizeof(follower));
	follower.recorder = gl;
	follower.now.on = enabled ? UINT32_MAX : 0;
	gl.Enable = gl.EnableClientState = turn_on;
	gl.Disable = gl.DisableClientState = turn_off;
	gl.DepthMask = set_depth_mask;
	gl.Color4x = set_color;
	gl.VertexPointer = set_position;
	gl.DrawArrays = draw_arrays;
	gl.DrawElements = draw_elements;
	return gl;
}

const struct gl_state_draw *gl_state_drawn(int number)
{
	assert_in_range(number, 0, follower.draws - 1);
	return &follower.draw[number];
}

const struct gl_state_draw *gl_state_last(void)
{
	return gl_state_drawn(follower.draws - 1);
}

bool gl_state_has(const struct gl_state_draw *draw, GLenum capability)
{
	return (draw ? draw : &follower.now)->on & bit_of(capability);
}

void gl_state_expect_on(const struct gl_state_draw *draw, const GLenum *list)
{
	for (; *list; list++) {
		assert_true(gl_state_has(draw, *list));
	}
}

void gl_state_expect_off(const struct gl_state_draw *draw, const GLenum *list)
{
	for (; *list; list++) {
		assert_false(gl_state_has(draw, *list));
	}
}

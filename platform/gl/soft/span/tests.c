#include "platform/gl/soft/span/tests.h"

#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"

static uint8_t apply_stencil(
	const struct stencil *stencil, GLenum action, uint8_t old)
{
	uint8_t value = old;

	switch (action) {
	case GL_ZERO:
		value = 0;
		break;
	case GL_REPLACE:
		value = stencil->reference;
		break;
	case GL_INCR:
		value = old < 255 ? (uint8_t)(old + 1) : old;
		break;
	case GL_DECR:
		value = old > 0 ? (uint8_t)(old - 1) : old;
		break;
	case GL_INVERT:
		value = (uint8_t)~old;
		break;
	default:
		break;
	}
	return (uint8_t)((old & ~stencil->write_mask) |
		(value & stencil->write_mask));
}

static uint32_t count_equal(const uint8_t *value, uint32_t count)
{
	const uint32_t four = value[0] * 0x01010101u;
	uint32_t equal = 0;

	while (equal + 4 <= count && load_32(value + equal) == four) {
		equal += 4;
	}
	while (equal < count && value[equal] == value[0]) {
		equal++;
	}
	return equal;
}

/* Those pass of which the function is true, or if inverted those of the others. */
static ALWAYS_INLINE bool test_by(GLenum function, bool inverted,
	const struct soft_tested *tested, const uint16_t *depth,
	uint16_t *passes)
{
	uint32_t z = tested->z, any = 0;

	for (uint32_t i = 0; i < tested->count; i++, z += tested->z_right) {
		uint32_t own = z >> 16, there = depth[i];
		uint32_t near = inverted ^
			(function == GL_LESS                    ? own < there
					: function == GL_LEQUAL ? own <= there
								: own == there);

		passes[i] = (uint16_t)-near;
		any |= near;
	}
	return any != 0;
}

/* The depth test of fragments that the stencil lets through. */
static bool test_depths(const struct fragment_state *state,
	const struct soft_tested *tested, const uint16_t *depth,
	uint16_t *passes)
{
	const GLenum function =
		state->depth_test ? state->depth_function : GL_ALWAYS;
	/* GL_GREATER to GL_ALWAYS are the opposites of GL_LEQUAL to GL_NEVER. */
	const bool inverted = function >= GL_GREATER;

	switch (inverted ? GL_NEVER + GL_ALWAYS - function : function) {
	case GL_LESS:
		return test_by(GL_LESS, inverted, tested, depth, passes);
	case GL_LEQUAL:
		return test_by(GL_LEQUAL, inverted, tested, depth, passes);
	case GL_EQUAL:
		return test_by(GL_EQUAL, inverted, tested, depth, passes);
	default:
		memset(passes, inverted ? 0xFF : 0,
			tested->count * sizeof(*passes));
		return inverted;
	}
}

/* Of fragments whose stencil values are equal; false where none passes. */
static bool test_stencil(struct soft *soft, const struct soft_tested *tested,
	uint8_t *stencil, uint16_t *passes)
{
	const struct fragment_state *state = &soft->fragment;
	const struct stencil *s = &state->stencil;
	const uint8_t old = *stencil;
	bool any;

	if (!soft_compares(s->function, s->reference & s->mask, old & s->mask)) {
		memset(stencil, apply_stencil(s, s->fail, old), tested->count);
		memset(passes, 0, tested->count * sizeof(*passes));
		return false;
	}
	any = test_depths(
		state, tested, soft->buffers.depth + tested->place, passes);
	if (s->pass != GL_KEEP || s->depth_fail != GL_KEEP) {
		const uint8_t near = apply_stencil(s, s->pass, old);
		const uint8_t far = apply_stencil(s, s->depth_fail, old);

		for (uint32_t i = 0; i < tested->count; i++) {
			stencil[i] = passes[i] ? near : far;
		}
	}
	return any;
}

bool soft_test(
	struct soft *soft, const struct soft_tested *tested, uint16_t *passes)
{
	const struct fragment_state *state = &soft->fragment;
	uint8_t *stencil = soft->buffers.stencil;
	struct soft_tested piece = *tested;
	bool any = false;

	if (!state->stencil.enabled || !stencil) {
		return test_depths(state, tested,
			soft->buffers.depth + tested->place, passes);
	}
	for (uint32_t left = tested->count; left > 0; left -= piece.count) {
		uint8_t *at = stencil + piece.place;

		piece.count = count_equal(at, left);
		any |= test_stencil(soft, &piece, at, passes);
		passes += piece.count;
		piece.place += piece.count;
		piece.z += piece.z_right * piece.count;
	}
	return any;
}

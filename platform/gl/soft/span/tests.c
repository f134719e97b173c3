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

/* The depth test of fragments that the stencil lets through. */
static ALWAYS_INLINE uint32_t test_by(GLenum function,
	const struct soft_tested *tested, const uint16_t *depth,
	uint16_t *passes)
{
	uint32_t z = tested->z, any = 0;

	for (uint32_t i = 0; i < tested->count; i++, z += tested->z_right) {
		uint32_t own = z >> 16, there = depth[i];
		bool near = function == GL_LESS ? own < there
			: function == GL_LEQUAL
			? own <= there
			: soft_compares(function, own, there);

		passes[i] = (uint16_t)-near;
		any |= near;
	}
	return any;
}

static uint32_t test_depths(const struct fragment_state *state,
	const struct soft_tested *tested, const uint16_t *depth,
	uint16_t *passes)
{
	const GLenum function =
		state->depth_test ? state->depth_function : GL_ALWAYS;

	switch (function) {
	case GL_ALWAYS:
		memset(passes, 0xFF, tested->count * sizeof(*passes));
		return 1;
	case GL_LESS:
		return test_by(GL_LESS, tested, depth, passes);
	case GL_LEQUAL:
		return test_by(GL_LEQUAL, tested, depth, passes);
	default:
		return test_by(function, tested, depth, passes);
	}
}

/* Of fragments whose stencil values are equal; 0 where none passes. */
static uint32_t test_stencil(struct soft *soft,
	const struct soft_tested *tested, uint8_t *stencil, uint16_t *passes)
{
	const struct fragment_state *state = &soft->fragment;
	const struct stencil *s = &state->stencil;
	const uint8_t old = *stencil;
	uint32_t any;

	if (!soft_stencil_passes(s, old)) {
		memset(stencil, apply_stencil(s, s->fail, old), tested->count);
		memset(passes, 0, tested->count * sizeof(*passes));
		return 0;
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

bool soft_stencil_keeps(const struct soft *soft, size_t place, uint32_t count)
{
	const struct stencil *s = &soft->fragment.stencil;
	const uint8_t *stencil = soft->buffers.stencil;

	return !stencil ||
		(s->pass == GL_KEEP && s->depth_fail == GL_KEEP &&
			soft_stencil_passes(s, stencil[place]) &&
			count_equal(stencil + place, count) == count);
}

bool soft_test(
	struct soft *soft, const struct soft_tested *tested, uint16_t *passes)
{
	const struct fragment_state *state = &soft->fragment;
	uint8_t *stencil = soft->buffers.stencil;
	struct soft_tested piece = *tested;
	uint32_t any = 0;

	if (!state->stencil.enabled || !stencil) {
		return test_depths(state, tested,
			       soft->buffers.depth + tested->place, passes) != 0;
	}
	for (uint32_t left = tested->count; left > 0; left -= piece.count) {
		uint8_t *at = stencil + piece.place;

		piece.count = count_equal(at, left);
		any |= test_stencil(soft, &piece, at, passes);
		passes += piece.count;
		piece.place += piece.count;
		piece.z += piece.z_right * piece.count;
	}
	return any != 0;
}

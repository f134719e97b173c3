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

/* Makes the depth test; false if no fragment passes. */
static bool test_depths(const struct fragment_state *state,
	const struct soft_tested *tested, const uint16_t *depth,
	uint16_t *passes)
{
	const GLenum function =
		state->depth_test ? state->depth_function : GL_ALWAYS;
	uint32_t z = tested->z, any = 0;

	for (uint32_t i = 0; i < tested->count; i++, z += tested->z_right) {
		bool near = soft_compares(function, z >> 16, depth[i]);

		passes[i] = near ? UINT16_MAX : 0;
		any |= near;
	}
	return any;
}

/* Makes the stencil test of fragments whose depth test is in passes. */
static bool test_stencils(const struct stencil *s, uint8_t *stencil,
	uint32_t count, uint16_t *passes)
{
	uint8_t old = 0, far = 0, near = 0; /* far, near: depth fails, passes */
	uint16_t through = 0, any = 0;

	for (uint32_t i = 0; i < count; i++) {
		if (i == 0 || stencil[i] != old) {
			bool is_through;

			old = stencil[i];
			is_through = soft_compares(s->function,
				s->reference & s->mask, old & s->mask);
			through = is_through ? UINT16_MAX : 0;
			far = apply_stencil(
				s, is_through ? s->depth_fail : s->fail, old);
			near = apply_stencil(
				s, is_through ? s->pass : s->fail, old);
		}
		stencil[i] = passes[i] ? near : far;
		passes[i] &= through;
		any |= passes[i];
	}
	return any != 0;
}

bool soft_test(
	struct soft *soft, const struct soft_tested *tested, uint16_t *passes)
{
	const struct fragment_state *state = &soft->fragment;
	uint8_t *stencil = soft->buffers.stencil;
	bool any = test_depths(
		state, tested, soft->buffers.depth + tested->place, passes);

	return state->stencil.enabled && stencil
		? test_stencils(&state->stencil, stencil + tested->place,
			  tested->count, passes)
		: any;
}

#include "platform/gl/soft/span/tests.h"

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

/* Whether the stencil lets a fragment through that passes the depth test or not. */
static bool test_stencil(const struct stencil *s, bool near, uint8_t *stencil)
{
	bool through = soft_compares(
		s->function, s->reference & s->mask, *stencil & s->mask);
	GLenum action = !through ? s->fail : near ? s->pass : s->depth_fail;

	if (action != GL_KEEP) {
		*stencil = apply_stencil(s, action, *stencil);
	}
	return through;
}

void soft_test(struct soft *soft, const struct soft_tested *tested, bool *passes)
{
	const struct fragment_state *state = &soft->fragment;
	const struct stencil *s = &state->stencil;
	uint16_t *depth = soft->buffers.depth + tested->place;
	uint8_t *stencil = s->enabled && soft->buffers.stencil
		? soft->buffers.stencil + tested->place
		: NULL;
	uint32_t z = tested->z;

	for (uint32_t i = 0; i < tested->count; i++, z += tested->z_right) {
		bool near = !state->depth_test ||
			soft_compares(state->depth_function, z >> 16, depth[i]);

		passes[i] = stencil ? test_stencil(s, near, stencil + i) && near
				    : near;
		if (passes[i] && state->depth_test && state->depth_mask) {
			depth[i] = (uint16_t)(z >> 16);
		}
	}
}

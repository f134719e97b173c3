#include "platform/gl/soft/span/tests.h"

#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"

static uint8_t apply_stencil(
	const struct stencil *stencil, GLenum action, uint8_t old)
{
	const int value = action == GL_KEEP ? old
		: action == GL_ZERO         ? 0
		: action == GL_REPLACE      ? stencil->reference
		: action == GL_INCR         ? old + (old < 255)
		: action == GL_DECR         ? old - (old > 0)
					    : ~old; /* GL_INVERT */

	return (uint8_t)((old & ~stencil->write_mask) |
		(value & stencil->write_mask));
}

/* How many of a row's depths from the first one on pass, or fail. */
static ALWAYS_INLINE uint32_t count_alike(GLenum function, bool passes,
	const struct soft_row *row, uint32_t count, uint32_t z_right)
{
	const uint16_t *at = row->depth, *const end = at + count;
	uint32_t z = row->z;

	do {
		at++;
		z += z_right;
	} while (at < end && soft_compares(function, z >> 16, *at) == passes);
	return (uint32_t)(at - row->depth);
}

/* As many of a row's depths from the first one on as give the same result. */
static ALWAYS_INLINE struct soft_stretch compare(GLenum function,
	const struct soft_row *row, uint32_t count, uint32_t z_right)
{
	if (soft_compares(function, row->z >> 16, *row->depth)) {
		return (struct soft_stretch){
			count_alike(function, true, row, count, z_right), true};
	}
	return (struct soft_stretch){
		count_alike(function, false, row, count, z_right), false};
}

static struct soft_stretch test_depths(GLenum function,
	const struct soft_row *row, uint32_t count, uint32_t z_right)
{
#define FUNCTION(name)                                     \
	if (function == (name)) {                          \
		return compare(name, row, count, z_right); \
	}
	FUNCTION(GL_LESS)
	FUNCTION(GL_LEQUAL)
	FUNCTION(GL_EQUAL)
	FUNCTION(GL_NOTEQUAL)
	FUNCTION(GL_GREATER)
	FUNCTION(GL_GEQUAL)
#undef FUNCTION
	return (struct soft_stretch){count, function == GL_ALWAYS};
}

static ALWAYS_INLINE void write_passing(
	GLenum function, const struct soft_run *run)
{
	const struct soft_row *row = run->rows, *end = row + run->row_count;

	for (; row < end; row++) {
		uint16_t *depth = row->depth, *const last = depth + row->count;
		uint32_t z = row->z;

		for (; depth < last; depth++, z += run->z_right) {
			if (soft_compares(function, z >> 16, *depth)) {
				*depth = (uint16_t)(z >> 16);
			}
		}
	}
}

void soft_write_depths(GLenum function, const struct soft_run *run)
{
	if (function == GL_LESS) {
		write_passing(GL_LESS, run);
	} else {
		write_passing(function, run);
	}
}

/* How many bytes from the first one on are equal. */
static uint32_t count_equal(const uint8_t *first, uint32_t count)
{
	const uint8_t *at = first, *const end = first + count;
	const uint32_t four = *first * 0x01010101u;

	while (end - at >= 4 && load_32(at) == four) {
		at += 4;
	}
	while (at < end && *at == *first) {
		at++;
	}
	return (uint32_t)(at - first);
}

struct soft_stretch soft_test(const struct soft *soft,
	const struct soft_row *row, uint32_t count, uint32_t z_right,
	bool compared)
{
	const struct fragment_state *state = &soft->fragment;
	const struct stencil *s = &state->stencil;
	uint8_t *stencil = NULL;
	struct soft_stretch out = {count, true};
	bool through = true;
	uint8_t old = 0, far = 0, near = 0; /* far, near: depth fails, passes */

	/* Without memory for a stencil, all fragments pass its test. */
	if (s->enabled && soft->buffers.stencil) {
		stencil = soft->buffers.stencil +
			(row->depth - soft->buffers.depth);
		old = *stencil;
		count = out.count = count_equal(stencil, count);
		through = soft_compares(
			s->function, s->reference & s->mask, old & s->mask);
		far = apply_stencil(s, through ? s->depth_fail : s->fail, old);
		near = through ? apply_stencil(s, s->pass, old) : far;
	}
	if (through && state->depth_test && (compared || far != near)) {
		out = test_depths(state->depth_function, row, count, z_right);
	}
	if (stencil && (out.passes ? near : far) != old) {
		memset(stencil, out.passes ? near : far, out.count);
	}
	out.passes &= through;
	return out;
}

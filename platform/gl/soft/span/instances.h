/*
 * Names and makes a picture format's span functions, and lists them: for each
 * texel format and filter a function a finish and a depth test, for runs anywhere
 * and inside of the level.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_INSTANCES_H
#define PLATFORM_GL_SOFT_SPAN_INSTANCES_H

#include "platform/gl/soft/span/template.h"

/*
 * The texels' part of a kind is known to a function of its own, which the
 * compiler makes short before it copies it for each finish and depth test.
 */
#define SOFT_KIND(name, ...)                                                \
	static ALWAYS_INLINE void name(const struct soft_run *run,          \
		const enum soft_finish finish_, const bool lequal_)         \
	{                                                                   \
		soft_draw_run(run,                                          \
			(struct soft_kind){.finish = finish_,               \
				.lequal = lequal_, __VA_ARGS__});           \
	}                                                                   \
	SOFT_FINISH_FUNCTIONS(name, name, false)                            \
	SOFT_FINISH_FUNCTIONS(name##_lequal, name, true)

#define SOFT_SPAN_FUNCTION(name, kind, finish, lequal)                      \
	static void name(const struct soft_run *run)                        \
	{                                                                   \
		kind(run, finish, lequal);                                  \
	}

#define SOFT_FINISH_FUNCTIONS(name, kind, lequal)                           \
	SOFT_SPAN_FUNCTION(name##_opaque, kind, SOFT_OPAQUE, lequal)        \
	SOFT_SPAN_FUNCTION(name##_tested, kind, SOFT_TESTED, lequal)        \
	SOFT_SPAN_FUNCTION(name##_blended, kind, SOFT_BLENDED, lequal)      \
	SOFT_SPAN_FUNCTION(name##_opaque_fog, kind, SOFT_OPAQUE_FOG, lequal) \
	SOFT_SPAN_FUNCTION(name##_tested_fog, kind, SOFT_TESTED_FOG, lequal) \
	SOFT_SPAN_FUNCTION(                                                 \
		name##_blended_fog, kind, SOFT_BLENDED_FOG, lequal)         \
	SOFT_SPAN_FUNCTION(name##_mixed, kind, SOFT_MIXED, lequal)

#define SOFT_BOTH_FUNCTIONS(name, texels, is_linear, is_wide)               \
	SOFT_KIND(name, .textured = true, .format = texels,                 \
		.linear = is_linear, .wide = is_wide)                       \
	SOFT_KIND(name##_inside, .textured = true, .format = texels,        \
		.linear = is_linear, .wide = is_wide, .inside = true)

#define SOFT_SPAN_FUNCTIONS(is_wide)                                        \
	SOFT_KIND(plain, .wide = is_wide)                                   \
	SOFT_BOTH_FUNCTIONS(nearest_565, TEXEL_565, false, is_wide)         \
	SOFT_BOTH_FUNCTIONS(nearest_4444, TEXEL_4444, false, is_wide)       \
	SOFT_BOTH_FUNCTIONS(nearest_5551, TEXEL_5551, false, is_wide)       \
	SOFT_BOTH_FUNCTIONS(nearest_8888, TEXEL_8888, false, is_wide)       \
	SOFT_BOTH_FUNCTIONS(nearest_l8, TEXEL_L8, false, is_wide)           \
	SOFT_BOTH_FUNCTIONS(nearest_a8, TEXEL_A8, false, is_wide)           \
	SOFT_BOTH_FUNCTIONS(nearest_la88, TEXEL_LA88, false, is_wide)       \
	SOFT_BOTH_FUNCTIONS(linear_565, TEXEL_565, true, is_wide)           \
	SOFT_BOTH_FUNCTIONS(linear_4444, TEXEL_4444, true, is_wide)         \
	SOFT_BOTH_FUNCTIONS(linear_5551, TEXEL_5551, true, is_wide)         \
	SOFT_BOTH_FUNCTIONS(linear_8888, TEXEL_8888, true, is_wide)         \
	SOFT_BOTH_FUNCTIONS(linear_l8, TEXEL_L8, true, is_wide)             \
	SOFT_BOTH_FUNCTIONS(linear_a8, TEXEL_A8, true, is_wide)             \
	SOFT_BOTH_FUNCTIONS(linear_la88, TEXEL_LA88, true, is_wide)

/* clang-format off */
#define SOFT_FINISH_ROW(name, inside, finish)                               \
	{name##_##finish, inside##_##finish, name##_lequal_##finish,        \
		inside##_lequal_##finish}

#define SOFT_FINISH_ROWS(name, inside)                                      \
	{                                                                   \
		[SOFT_OPAQUE] = SOFT_FINISH_ROW(name, inside, opaque),      \
		[SOFT_TESTED] = SOFT_FINISH_ROW(name, inside, tested),      \
		[SOFT_BLENDED] = SOFT_FINISH_ROW(name, inside, blended),    \
		[SOFT_OPAQUE_FOG] =                                         \
			SOFT_FINISH_ROW(name, inside, opaque_fog),          \
		[SOFT_TESTED_FOG] =                                         \
			SOFT_FINISH_ROW(name, inside, tested_fog),          \
		[SOFT_BLENDED_FOG] =                                        \
			SOFT_FINISH_ROW(name, inside, blended_fog),         \
		[SOFT_MIXED] = SOFT_FINISH_ROW(name, inside, mixed),        \
	}

#define SOFT_TEXTURE_ROWS(name) SOFT_FINISH_ROWS(name, name##_inside)

#define SOFT_FORMAT_ROWS(filter, first)                                     \
	[first + TEXEL_565 - 1] = SOFT_TEXTURE_ROWS(filter##_565), \
	[first + TEXEL_4444 - 1] = SOFT_TEXTURE_ROWS(filter##_4444), \
	[first + TEXEL_5551 - 1] = SOFT_TEXTURE_ROWS(filter##_5551), \
	[first + TEXEL_8888 - 1] = SOFT_TEXTURE_ROWS(filter##_8888), \
	[first + TEXEL_L8 - 1] = SOFT_TEXTURE_ROWS(filter##_l8), \
	[first + TEXEL_A8 - 1] = SOFT_TEXTURE_ROWS(filter##_a8), \
	[first + TEXEL_LA88 - 1] = SOFT_TEXTURE_ROWS(filter##_la88)

#define SOFT_SPAN_TABLE                                                     \
	{                                                                   \
		[SOFT_NO_TEXTURE] = SOFT_FINISH_ROWS(plain, plain),         \
		SOFT_FORMAT_ROWS(nearest, SOFT_NEAREST),                    \
		SOFT_FORMAT_ROWS(linear, SOFT_LINEAR),                      \
	}
/* clang-format on */

#endif

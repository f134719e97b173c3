/*
 * Defines the span functions of a picture format and their table: one for each
 * texel format, filter, finish and depth test (LESS, LEQUAL), for runs anywhere
 * in the texture and for runs inside of the window.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_INSTANCES_H
#define PLATFORM_GL_SOFT_SPAN_INSTANCES_H

#define SOFT_BY_FOUR

#include "platform/gl/soft/span/template.h"

/*
 * A function for each texel format and filter, which the compiler simplifies
 * before it inlines a copy for each finish and depth test. each:
 * SOFT_EACH_FINISH, SOFT_EACH_SECOND or SOFT_EACH_SCALED.
 */
#define SOFT_KIND(name, each, ...)                                          \
	static ALWAYS_INLINE void name(const struct soft_run *run,          \
		const enum soft_finish finish_, const bool lequal_)         \
	{                                                                   \
		soft_draw_run(run,                                          \
			(struct soft_kind){.finish = finish_,               \
				.lequal = lequal_, __VA_ARGS__});           \
	}                                                                   \
	each(SOFT_FINISH_FUNCTIONS, name)

#define SOFT_EACH_FINISH(make, ...)                                         \
	make(opaque, SOFT_OPAQUE, __VA_ARGS__)                              \
	make(tested, SOFT_TESTED, __VA_ARGS__)                              \
	make(blended, SOFT_BLENDED, __VA_ARGS__)                            \
	make(opaque_fog, SOFT_FOGGED, __VA_ARGS__)                      \
	make(tested_fog, SOFT_FOGGED + SOFT_TESTED, __VA_ARGS__)                      \
	make(blended_fog, SOFT_FOGGED + SOFT_BLENDED, __VA_ARGS__)                    \
	make(mixed, SOFT_MIXED, __VA_ARGS__)

/* Finishes with a second texture, which only a few formats have. */
#define SOFT_EACH_SECOND(make, ...)                                         \
	SOFT_EACH_SCALED(make, __VA_ARGS__)                                 \
	make(summed, SOFT_SUMMED, __VA_ARGS__)                              \
	make(tested_summed, SOFT_SUMMED + SOFT_TESTED, __VA_ARGS__)                \
	make(blended_summed, SOFT_SUMMED + SOFT_BLENDED, __VA_ARGS__)

/* The one that RGBA8888 pictures have. */
#define SOFT_EACH_SCALED(make, ...) make(scaled, SOFT_SCALED, __VA_ARGS__)

#define SOFT_EACH_SHORT(make, ...)                                          \
	make(565, TEXEL_565, __VA_ARGS__) make(4444, TEXEL_4444, __VA_ARGS__)

/* By four, LEQUAL costs an addition, and both functions share one text. */
#if SOFT_LANES > 1
#define SOFT_BOTH_TESTS NEVER_INLINE
#else
#define SOFT_BOTH_TESTS ALWAYS_INLINE
#endif

#define SOFT_FINISH_FUNCTIONS(suffix, finish, name)                         \
	static SOFT_BOTH_TESTS void name##_both_##suffix(                   \
		const struct soft_run *run, const bool lequal)              \
	{                                                                   \
		name(run, finish, lequal);                                  \
	}                                                                   \
	static void name##_##suffix(const struct soft_run *run)             \
	{                                                                   \
		name##_both_##suffix(run, false);                           \
	}                                                                   \
	static void name##_lequal_##suffix(const struct soft_run *run)      \
	{                                                                   \
		name##_both_##suffix(run, true);                            \
	}

/* A format's functions; behind each, members of the kind. */
#define SOFT_FORMAT_FUNCTIONS(name, texels, each, ...)                      \
	SOFT_KIND(nearest_##name, each, .textured = true, .format = texels, \
		__VA_ARGS__)                                                \
	SOFT_KIND(nearest_##name##_inside, each, .textured = true,          \
		.format = texels, .inside = true, __VA_ARGS__)              \
	SOFT_KIND(linear_##name, each, .textured = true, .format = texels,  \
		.linear = true, __VA_ARGS__)                                \
	SOFT_KIND(linear_##name##_inside, each, .textured = true,           \
		.format = texels, .linear = true, .inside = true, __VA_ARGS__)

/* Functions of made texels; behind each, members of the kind. */
#define SOFT_MADE_FUNCTIONS(name, each, ...)                                \
	SOFT_KIND(name, each, .textured = true, .format = TEXEL_8888,       \
		.inside = true, .made = true, __VA_ARGS__)

#define SOFT_SPAN_FUNCTIONS(is_wide)                                        \
	SOFT_KIND(plain, SOFT_EACH_FINISH, .wide = is_wide)                 \
	SOFT_MADE_FUNCTIONS(made, SOFT_EACH_FINISH, .wide = is_wide)        \
	SOFT_MADE_FUNCTIONS(                                                \
		made_add, SOFT_EACH_FINISH, .wide = is_wide, .mode = GL_ADD) \
	SOFT_MADE_FUNCTIONS(made_decal, SOFT_EACH_FINISH, .wide = is_wide,  \
		.mode = GL_DECAL)                                           \
	SOFT_MADE_FUNCTIONS(made_blend, SOFT_EACH_FINISH, .wide = is_wide,  \
		.mode = GL_BLEND)                                           \
	SOFT_EACH_FORMAT(                                                   \
		SOFT_FORMAT_FUNCTIONS, SOFT_EACH_FINISH, .wide = is_wide)

/* clang-format off */
#define SOFT_FINISH_ROW(suffix, finish, name, inside)                       \
	[finish] = {name##_##suffix, inside##_##suffix,                     \
		name##_lequal_##suffix, inside##_lequal_##suffix},

#define SOFT_FORMAT_ROWS(name, texels, each)                                \
	[SOFT_NEAREST + texels - 1] = {each(SOFT_FINISH_ROW,                \
		nearest_##name, nearest_##name##_inside)},                  \
	[SOFT_LINEAR + texels - 1] = {each(SOFT_FINISH_ROW,                 \
		linear_##name, linear_##name##_inside)},

#define SOFT_MADE_ROW(source, name, each)                                   \
	[source] = {each(SOFT_FINISH_ROW, name, name)},

#define SOFT_SPAN_TABLE                                                     \
	{                                                                   \
		[SOFT_NO_TEXTURE] =                                         \
			{SOFT_EACH_FINISH(SOFT_FINISH_ROW, plain, plain)},  \
		SOFT_MADE_ROW(SOFT_MADE, made, SOFT_EACH_FINISH)            \
		SOFT_MADE_ROW(SOFT_MADE_ADD, made_add, SOFT_EACH_FINISH)    \
		SOFT_MADE_ROW(SOFT_MADE_DECAL, made_decal, SOFT_EACH_FINISH) \
		SOFT_MADE_ROW(SOFT_MADE_BLEND, made_blend, SOFT_EACH_FINISH) \
		SOFT_EACH_FORMAT(SOFT_FORMAT_ROWS, SOFT_EACH_FINISH)        \
	}
/* clang-format on */

#endif

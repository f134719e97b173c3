/*
 * The float loops. Every kernel's table has such loops, for primitives that do
 * not fit fixed point. struct kernel (kernel.h) states their contracts.
 */
#ifndef APP_ANIM_KERNEL_FLOAT_H
#define APP_ANIM_KERNEL_FLOAT_H

#include "app/anim/kernel/kernel.h"

void float_skin(const struct skin_stream *stream, const mat4 *palette,
	int max_influences, float (*position)[3], float (*normal)[3]);
void float_skin_directions(const struct skin_stream *stream,
	const float (*base)[4], const mat4 *palette, int max_influences,
	float (*direction)[3]);
void float_morph_lerp(int count, const float (*source)[3],
	const float (*destiny)[3], float omega, const float offset[3],
	float (*out)[3]);
void float_morph_targets(int count, const float (*base)[3],
	const struct morph_term *term, int term_count, bool use_normals,
	float (*out)[3]);
void float_normalize(int count, float (*vector)[3]);
void float_skin_morphed(const struct skin_stream *stream,
	const struct morph_input *input, const mat4 *palette,
	int max_influences, const struct skin_output *output);
void float_bitangents(int count, const float (*normal)[3],
	const float (*tangent)[3], const float (*attribute)[4],
	float (*bitangent)[3]);

#define FLOAT_LOOPS                                                         \
	.skin = float_skin, .morph_lerp = float_morph_lerp,                 \
	.morph_targets = float_morph_targets, .normalize = float_normalize, \
	.skin_directions = float_skin_directions,                           \
	.skin_morphed = float_skin_morphed, .bitangents = float_bitangents

#endif

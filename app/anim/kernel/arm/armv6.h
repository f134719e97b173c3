/* The fixed-point loops in assembly. struct fixed_loops has their contracts. */
#ifndef APP_ANIM_KERNEL_ARM_ARMV6_H
#define APP_ANIM_KERNEL_ARM_ARMV6_H

#include "app/anim/kernel/fixed.h"

void kernel_armv6_skin(const struct fixed_group *group, int group_count,
	const struct fixed_base *base, const struct fixed_matrix *palette,
	struct fixed_vector *out);
void kernel_armv6_lerp(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_vector *out);
void kernel_armv6_lerp_keys(int count, const struct fixed_key *source,
	const struct fixed_key *destiny, struct fixed_weights weights,
	struct fixed_vector *out);
void kernel_armv6_increment(int count, const struct fixed_vector *step,
	struct fixed_vector *vector);
void kernel_armv6_morph_pair(int count, const struct fixed_vector *base,
	const struct fixed_pair (*pair)[3], struct fixed_weights weights,
	struct fixed_vector *out);
void kernel_armv6_morph_begin(
	int count, const struct fixed_vector *base, struct fixed_sum *sum);
void kernel_armv6_morph_add(int count, const struct fixed_pair (*pair)[3],
	struct fixed_weights weights, struct fixed_sum *sum);
void kernel_armv6_morph_end(
	int count, const struct fixed_sum *sum, struct fixed_vector *out);
void kernel_armv6_rebase(int count, const struct fixed_rebase *rebase,
	const struct fixed_vector *delta, struct fixed_base *base);

#endif

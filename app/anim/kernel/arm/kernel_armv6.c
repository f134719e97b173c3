/*
 * The kernel whose fixed-point loops are in ARMv6 assembly.
 */
#include "app/anim/kernel/arm/armv6.h"
#include "app/anim/kernel/float.h"

static const struct fixed_loops loops = {
	.skin = kernel_armv6_skin,
	.lerp = kernel_armv6_lerp,
	.lerp_keys = kernel_armv6_lerp_keys,
	.increment = kernel_armv6_increment,
	.morph_pair = kernel_armv6_morph_pair,
	.morph_begin = kernel_armv6_morph_begin,
	.morph_add = kernel_armv6_morph_add,
	.morph_end = kernel_armv6_morph_end,
	.rebase = kernel_armv6_rebase,
};

const struct kernel kernel_armv6 = {
	.name = "armv6",
	.summary = "ARMv6 assembly in fixed point",
	.fixed = &loops,
	FLOAT_LOOPS,
};

#include "app/anim/kernel/fixed.h"
#include "app/anim/kernel/float.h"

const struct kernel kernel_fixed = {
	.name = "fixed",
	.summary = "plain C in fixed point",
	.fixed = &fixed_loops_c,
	FLOAT_LOOPS,
};

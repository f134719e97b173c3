/*
 * What the loops of the armv6 kernel cost on the board. `limber compare`
 * predicts times from these numbers.
 *
 * The numbers are for an ARM1136JF-S at 532 MHz with the data in memory and the
 * code in L1. The timing model of tests/arm1136 counted them: no hardware was
 * measured. `make bench-arm11-table` copies them from the armv6 cold rows of
 * tests/bench/arm11.figures into arm11_cost.c.
 */
#ifndef APP_ANIM_KERNEL_ARM11_COST_H
#define APP_ANIM_KERNEL_ARM11_COST_H

enum {
	ARM11_MHZ = 532
};

enum arm11_work {
	ARM11_SKIN_1, /* a vertex's position, by 1 influence */
	ARM11_SKIN_2,
	ARM11_SKIN_3,
	ARM11_SKIN_4,
	ARM11_SKIN_8,
	ARM11_SKIN_NORMALS_1, /* and its normal */
	ARM11_SKIN_NORMALS_2,
	ARM11_SKIN_NORMALS_4,
	ARM11_SKIN_NORMALS_8,
	ARM11_LERP,         /* a vertex's position, between two key frames */
	ARM11_LERP_NORMALS, /* and its normal */
	ARM11_TARGETS_2,    /* a vertex's position, by two weighted targets */
	ARM11_POSE_CESIUM,  /* a joint of CesiumMan: sampling, world matrix,
			       palette */
	ARM11_POSE_WALKER,  /* the same for the walker */
	ARM11_WORKS
};

struct arm11_cost {
	const char *row; /* name of the row in tests/bench/arm11.figures */
	float cycles, instructions;
};

extern const struct arm11_cost arm11_cost[ARM11_WORKS];

#endif

#include "app/anim/kernel/arm11_cost.h"

/* `make bench-arm11-table` writes the numbers. */
const struct arm11_cost arm11_cost[ARM11_WORKS] = {
	[ARM11_SKIN_1] = {"skin-1", 18.08f, 11.54f},
	[ARM11_SKIN_2] = {"skin-2", 29.81f, 21.80f},
	[ARM11_SKIN_3] = {"skin-3", 42.65f, 32.52f},
	[ARM11_SKIN_4] = {"skin-4", 55.18f, 42.69f},
	[ARM11_SKIN_NORMALS_1] = {"skin-normals-1", 32.58f, 23.07f},
	[ARM11_SKIN_NORMALS_2] = {"skin-normals-2", 56.43f, 43.59f},
	[ARM11_SKIN_NORMALS_4] = {"skin-normals-4", 106.72f, 85.37f},
	[ARM11_LERP] = {"lerp", 20.68f, 7.03f},
	[ARM11_LERP_NORMALS] = {"lerp-normals", 40.54f, 14.05f},
	[ARM11_TARGETS_2] = {"targets-2", 30.65f, 9.97f},
	[ARM11_POSE_CESIUM] = {"pose-cesiumman-0", 505.61f, 183.52f},
	[ARM11_POSE_WALKER] = {"pose-walker-walk", 489.12f, 175.97f},
};

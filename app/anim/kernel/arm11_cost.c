#include "app/anim/kernel/arm11_cost.h"

/* `make bench-arm11-table` writes the numbers. */
const struct arm11_cost arm11_cost[ARM11_WORKS] = {
	[ARM11_SKIN_1] = {"skin-1", 18.16f, 11.54f},
	[ARM11_SKIN_2] = {"skin-2", 29.92f, 21.80f},
	[ARM11_SKIN_3] = {"skin-3", 42.82f, 32.52f},
	[ARM11_SKIN_4] = {"skin-4", 55.03f, 42.69f},
	[ARM11_SKIN_8] = {"skin-8", 124.88f, 84.33f},
	[ARM11_SKIN_NORMALS_1] = {"skin-normals-1", 32.78f, 23.07f},
	[ARM11_SKIN_NORMALS_2] = {"skin-normals-2", 56.59f, 43.59f},
	[ARM11_SKIN_NORMALS_4] = {"skin-normals-4", 106.12f, 85.37f},
	[ARM11_SKIN_NORMALS_8] = {"skin-normals-8", 244.62f, 168.66f},
	[ARM11_LERP] = {"lerp", 20.68f, 7.03f},
	[ARM11_LERP_NORMALS] = {"lerp-normals", 40.52f, 14.05f},
	[ARM11_TARGETS_2] = {"targets-2", 30.68f, 9.97f},
	[ARM11_POSE_CESIUM] = {"pose-cesiumman-0", 505.63f, 185.77f},
	[ARM11_POSE_WALKER] = {"pose-walker-walk", 492.99f, 177.42f},
};

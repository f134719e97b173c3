#include "app/cmd/bench/bench_rows.h"

/*
 * In the demos' models, 15 to 150 of 1024 vertices have the same joints; in a
 * mesh with 24 sets of joints, 43 have. "scattered" has random joints, unlike
 * any real mesh.
 */
/* clang-format off */
const struct bench_row bench_rows[] = {
	{"skin-1", "skin positions, 1 influence", BENCH_SKIN, 1, 24},
	{"skin-2", "skin positions, 2 influences", BENCH_SKIN, 2, 24},
	{"skin-3", "skin positions, 3 influences", BENCH_SKIN, 3, 24},
	{"skin-4", "skin positions, 4 influences", BENCH_SKIN, 4, 24},
	{"skin-8", "skin positions, 8 influences", BENCH_SKIN, 8, 24},
	{"skin-2-scattered", "2 influences, joints at random", BENCH_SKIN, 2, 0},
	{"skin-normals-1", "skin with normals, 1 influence", BENCH_SKIN_NORMALS, 1, 24},
	{"skin-normals-2", "skin with normals, 2 influences", BENCH_SKIN_NORMALS, 2, 24},
	{"skin-normals-4", "skin with normals, 4 influences", BENCH_SKIN_NORMALS, 4, 24},
	{"skin-normals-8", "skin with normals, 8 influences", BENCH_SKIN_NORMALS, 8, 24},
	{"skin-tangents-2", "skin with tangents too, 2 influences", BENCH_SKIN_TANGENTS, 2, 24},
	{"lerp", "morph lerp, positions", BENCH_LERP, 1, 24},
	{"lerp-normals", "morph lerp, positions and normals", BENCH_LERP_NORMALS, 1, 24},
	{"lerp-keys", "morph lerp of targets, positions", BENCH_LERP_KEYS, 1, 24},
	{"targets-2", "morph two targets, positions", BENCH_TARGETS, 1, 24},
	{"by-frames", "morph by frames, positions", BENCH_BY_FRAMES, 1, 24},
	{0},
};

const struct bench_row bench_model_rows[] = {
	{"skin", "skin positions", BENCH_SKIN, 0, 0},
	{"skin-normals", "skin with normals", BENCH_SKIN_NORMALS, 0, 0},
	{"skin-tangents", "skin with tangents too", BENCH_SKIN_TANGENTS, 0, 0},
	{0},
};
/* clang-format on */

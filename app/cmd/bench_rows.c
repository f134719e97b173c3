#include "app/cmd/bench_rows.h"

/* clang-format off */
const struct bench_row bench_rows[] = {
	{"skin-1", "skin positions, 1 influence", BENCH_SKIN, 1},
	{"skin-2", "skin positions, 2 influences", BENCH_SKIN, 2},
	{"skin-3", "skin positions, 3 influences", BENCH_SKIN, 3},
	{"skin-4", "skin positions, 4 influences", BENCH_SKIN, 4},
	{"skin-normals-1", "skin with normals, 1 influence", BENCH_SKIN_NORMALS, 1},
	{"skin-normals-2", "skin with normals, 2 influences", BENCH_SKIN_NORMALS, 2},
	{"skin-normals-4", "skin with normals, 4 influences", BENCH_SKIN_NORMALS, 4},
	{"skin-tangents-2", "skin with normals, tangents, 2", BENCH_SKIN_TANGENTS, 2},
	{"lerp", "morph lerp, positions", BENCH_LERP, 1},
	{"lerp-normals", "morph lerp, positions and normals", BENCH_LERP_NORMALS, 1},
	{"targets-2", "morph two targets, positions", BENCH_TARGETS, 1},
	{"by-frames", "morph by frames, positions", BENCH_BY_FRAMES, 1},
	{0},
};
/* clang-format on */

/*
 * Runs AN4044's skinning loop between markers, with 1, 2, 3 and 4 influences a
 * vertex: with all data in L1 (regions 1-4) and with data from memory (regions
 * 5-8). The program uses no C library.
 */
#include "app/anim/kernel/an4044.h"
#include "tests/arm1136/marker.h"

#define VERTICES       64
#define JOINTS         16
#define MAX_INFLUENCES 4

static struct an4044_vertex vertex[VERTICES];
static struct an4044_joint_mat joint[JOINTS];
static float base[VERTICES * MAX_INFLUENCES][4];
static struct joint_weight weight[VERTICES * MAX_INFLUENCES];

static void fill(int influences)
{
	int left = influences;

	for (int i = 0; i < JOINTS * 12; i++) {
		joint[i / 12].mat[i % 12] = (float)(i % 7) * 0.125f;
	}
	for (int i = 0; i < VERTICES * influences; i++) {
		base[i][0] = (float)i;
		base[i][1] = 1;
		base[i][2] = 2;
		base[i][3] = 0.5f;
		weight[i].weight = 0.5f;
		weight[i].joint_offset = (i * 5 % JOINTS) * (int)sizeof(*joint);
		weight[i].next_vertex_offset = left * (int)sizeof(*weight);
		left = left > 1 ? left - 1 : influences;
	}
}

static void transform(void)
{
	an4044_transform(
		vertex, VERTICES, joint, (const float(*)[4])base, weight);
}

/* A macro, because a marker's number is part of its instruction. */
#define RUN(influences, warm, cold)        \
	do {                               \
		fill(influences);          \
		transform();               \
		transform();               \
		MARKER_BEGIN(warm);        \
		transform();               \
		MARKER_END(warm);          \
		MARKER_FLUSH(MARKER_DATA); \
		MARKER_BEGIN(cold);        \
		transform();               \
		MARKER_END(cold);          \
	} while (0)

static _Noreturn void leave(void)
{
	__asm__ volatile("mov r7, #1\n\tmov r0, #0\n\tsvc 0" ::: "r0", "r7");
	__builtin_unreachable();
}

_Noreturn void _start(void);
_Noreturn void _start(void)
{
	/* The model starts at the first marker, with empty caches. */
	MARKER_BEGIN(0);
	MARKER_END(0);
	RUN(1, 1, 5);
	RUN(2, 2, 6);
	RUN(3, 3, 7);
	RUN(4, 4, 8);
	leave();
}

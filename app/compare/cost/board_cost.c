#include "app/compare/cost/board_cost.h"

#include "app/anim/kernel/arm11_cost.h"

#include <stddef.h>
#include <stdint.h>

/*
 * Converting a joint's matrix to fixed point. The timing model has no row for
 * it: this is what cesium-normals and walker-normals cost beyond their loops.
 */
static const struct board_cost palette_joint = {270.0, 250.0};

static struct board_cost cost_of(enum arm11_work work, double count)
{
	return (struct board_cost){
		.cycles = count * (double)arm11_cost[work].cycles,
		.instructions = count * (double)arm11_cost[work].instructions,
	};
}

/* Interpolates linearly: a at t = 0, b at 1; it extrapolates above 1. */
static struct board_cost lerp_cost(
	enum arm11_work a, enum arm11_work b, double t)
{
	struct board_cost low = cost_of(a, 1.0 - t);
	struct board_cost high = cost_of(b, t);

	board_cost_add(&low, &high);
	return low;
}

double board_cost_us(const struct board_cost *cost)
{
	return cost->cycles / ARM11_MHZ;
}

void board_cost_add(struct board_cost *cost, const struct board_cost *more)
{
	cost->cycles += more->cycles;
	cost->instructions += more->instructions;
}

struct board_cost board_cost_joints(int count)
{
	struct board_cost cost = cost_of(ARM11_POSE_CESIUM, 0.5 * count);
	struct board_cost other = cost_of(ARM11_POSE_WALKER, 0.5 * count);

	board_cost_add(&cost, &other);
	return cost;
}

struct board_cost board_cost_pose(const struct model *model)
{
	int joints = 0;

	for (int i = 0; i < model->skin_count; i++) {
		joints += model->skin[i].joint_count;
	}
	return board_cost_joints(joints > 0 ? joints : model->node_count);
}

/* Of one vertex; each influence beyond four costs as much as the fourth. */
static struct board_cost vertex_cost(int influences, bool normals)
{
	static const enum arm11_work plain[] = {
		ARM11_SKIN_1, ARM11_SKIN_2, ARM11_SKIN_3, ARM11_SKIN_4};

	if (influences > 4) {
		return normals
			? lerp_cost(ARM11_SKIN_NORMALS_2, ARM11_SKIN_NORMALS_4,
				  0.5 * (influences - 2))
			: lerp_cost(ARM11_SKIN_3, ARM11_SKIN_4, influences - 3);
	}
	if (!normals) {
		return cost_of(plain[influences - 1], 1.0);
	}
	return influences < 2
		? cost_of(ARM11_SKIN_NORMALS_1, 1.0)
		: lerp_cost(ARM11_SKIN_NORMALS_2, ARM11_SKIN_NORMALS_4,
			  0.5 * (influences - 2));
}

/* The loops treat a vertex without weights as one with one influence. */
static int influences_of(
	const struct model_primitive *primitive, int vertex, int max_influences)
{
	const float *weight = primitive->weight +
		(size_t)vertex * (size_t)primitive->influences;
	int count = 0;

	for (int i = 0; i < primitive->influences; i++) {
		count += weight[i] > 0.0f;
	}
	if (max_influences > 0 && count > max_influences) {
		count = max_influences;
	}
	return count > 0 ? count : 1;
}

static int joints_of(const struct model_primitive *primitive)
{
	uint8_t seen[(UINT16_MAX + 1) / 8] = {0};
	int count = primitive->vertex_count * primitive->influences;
	int joints = 0;

	for (int i = 0; i < count; i++) {
		int joint = primitive->joint[i], bit = 1 << joint % 8;

		if (primitive->weight[i] > 0.0f && !(seen[joint / 8] & bit)) {
			seen[joint / 8] |= (uint8_t)bit;
			joints++;
		}
	}
	return joints;
}

struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences)
{
	int joints = joints_of(primitive);
	struct board_cost cost = {
		.cycles = joints * palette_joint.cycles,
		.instructions = joints * palette_joint.instructions,
	};

	for (int v = 0; v < primitive->vertex_count; v++) {
		struct board_cost vertex =
			vertex_cost(influences_of(primitive, v, max_influences),
				primitive->normal != NULL);

		board_cost_add(&cost, &vertex);
	}
	return cost;
}

struct board_cost board_cost_keys(int vertex_count, bool normals)
{
	return cost_of(normals ? ARM11_LERP_NORMALS : ARM11_LERP, vertex_count);
}

struct board_cost board_cost_targets(double moves, bool normals)
{
	return cost_of(ARM11_TARGETS_2, normals ? 2.0 * moves : moves);
}

#include "app/anim/kernel/layout/fixed_skin.h"

#include "app/anim/kernel/fixed_number.h"
#include "app/anim/kernel/layout/fixed_skin_parts.h"

#include <errno.h>

static void lay_out(struct fixed_skin *skin, int max_influences)
{
	skin->max_influences = max_influences;
	fixed_skin_measure_joints(skin);
	skin->scale[FIXED_NORMAL] = fixed_skin_scale_limit(skin, FIXED_NORMAL);
	skin->scale[FIXED_TANGENT] = fixed_skin_scale_limit(skin, FIXED_TANGENT);
	fixed_skin_write_streams(skin);
	fixed_skin_write_rebase(skin);
}

static bool positions_are_usable(const struct model_primitive *primitive)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			if (!fixed_can_use(primitive->position[v][axis])) {
				return false;
			}
		}
	}
	return true;
}

int fixed_skin_init(struct fixed_skin *skin,
	const struct model_primitive *primitive, unsigned streams,
	struct arena *arena)
{
	int error;

	*skin = (struct fixed_skin){
		.primitive = primitive,
		.vertex_count = primitive->vertex_count,
	};
	if (!positions_are_usable(primitive)) {
		return -ERANGE;
	}
	error = fixed_skin_list_joints(skin, arena);
	if (!error) {
		error = fixed_skin_init_streams(skin, streams, arena);
	}
	if (!error) {
		lay_out(skin, 0);
	}
	return error;
}

int fixed_skin_add_targets(
	struct fixed_skin *skin, int target_count, struct arena *arena)
{
	int error = fixed_skin_init_targets(skin, target_count, arena);

	if (!error) {
		lay_out(skin, skin->max_influences);
	}
	return error;
}

void fixed_skin_set_cap(struct fixed_skin *skin, int max_influences)
{
	int cap = max_influences < SKIN_INFLUENCES_MAX ? max_influences : 0;

	if (cap != skin->max_influences) {
		lay_out(skin, cap);
	}
}

void fixed_skin_extend_weights(struct fixed_skin *skin, float old_limit)
{
	struct fixed_skin_targets *targets = &skin->targets;
	float factor = targets->deltas.weight_limit / old_limit;

	for (int i = 0; i < targets->moved_count * 3; i++) {
		targets->extent[i / 3][i % 3] *= factor;
	}
	lay_out(skin, skin->max_influences);
}

int fixed_skin_group_count(const struct fixed_skin *skin, int level)
{
	return skin->group_count_to[fixed_skin_tier_of(skin, level)];
}

int fixed_skin_posed_count(const struct fixed_skin *skin, int level)
{
	return skin->vertex_count_to[fixed_skin_tier_of(skin, level)];
}

size_t fixed_skin_bytes(const struct fixed_skin *skin)
{
	size_t streams = 0;
	size_t bytes = 0;

	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		streams += skin->base[a] != NULL;
	}
	for (int g = 0; g < skin->group_count; g++) {
		size_t each = 1 + (size_t)skin->group[g].influences;

		bytes += each * (size_t)skin->group[g].run_count *
			sizeof(int32_t);
	}
	return bytes +
		(size_t)skin->influence_count * streams *
		sizeof(struct fixed_base) +
		(size_t)skin->vertex_count * 2 * sizeof(uint32_t) +
		(size_t)skin->joint_count * sizeof(struct fixed_joint);
}

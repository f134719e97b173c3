#include "app/anim/math/transform.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/transform_inline.h"
#include "app/anim/math/vec.h"

struct transform transform_identity(void)
{
	return (struct transform){
		.rotation = {0, 0, 0, 1},
		.scale = {1, 1, 1},
	};
}

void transform_to_matrix(const struct transform *transform, mat4 out)
{
	inline_transform_to_matrix(transform, out);
}

void transform_compose(const struct transform *parent,
	const struct transform *child, struct transform *out)
{
	struct transform result;
	float moved[3];

	for (int i = 0; i < 3; i++) {
		moved[i] = parent->scale[i] * child->translation[i];
		result.scale[i] = parent->scale[i] * child->scale[i];
	}
	quat_rotate(parent->rotation, moved, moved);
	vec_add_scaled(parent->translation, moved, 1, result.translation);
	quat_multiply(parent->rotation, child->rotation, result.rotation);
	*out = result;
}

void transform_mix(const struct transform *a, const struct transform *b,
	float t, struct transform *out)
{
	vec_mix(a->translation, b->translation, t, out->translation);
	vec_mix(a->scale, b->scale, t, out->scale);
	quat_slerp(a->rotation, b->rotation, t, out->rotation);
}

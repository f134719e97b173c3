#include "app/compare/optimize/build/optimize_build.h"

#include <errno.h>

int optimize_build_member(const struct optimize_build *build,
	const json_t *object, const char *key)
{
	const json_t *value = json_object_get(object, key);
	json_int_t index =
		json_is_integer(value) ? json_integer_value(value) : -1;

	return index >= 0 && index < gltf_document_array_count(build->document)
		? (int)index
		: -1;
}

void optimize_build_set(struct optimize_build *build, json_t *object,
	const char *key, int accessor)
{
	if (accessor >= 0 &&
		json_object_set_new(object, key, json_integer(accessor)) != 0) {
		build->output.glb.error = -ENOMEM;
	}
}

float optimize_build_unit(const struct optimize_build *build, const float *unit)
{
	return build->plan->positions ? *unit : 0.0f;
}

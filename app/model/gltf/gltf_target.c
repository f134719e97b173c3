#include "app/model/gltf/gltf_internal.h"
#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"

#include <errno.h>

/*
 * Packs deltas. Integers stay integers, and are kept in scratch memory until
 * the clips have been read (gltf_keep_targets()).
 */
static int pack(const struct gltf_at *at, const struct gltf_accessor *accessor,
	const float (*values)[3], struct model_deltas *out)
{
	enum gltf_component component = accessor->base.component;
	bool is_short = component == GLTF_I16, is_byte = component == GLTF_I8;
	bool is_integer = is_short || is_byte;
	float one = !accessor->normalized || !is_integer ? 1.0f
		: is_short                               ? 32767.0f
							 : 127.0f;
	int error = model_deltas_pack(out, values, accessor->count,
		is_short          ? MODEL_INT16
			: is_byte ? MODEL_INT8
				  : MODEL_FLOAT,
		one,
		is_integer ? &at->gltf->scratch : &at->gltf->model->targets);

	return error ? gltf_no_memory(at) : 0;
}

static int read_delta(const struct gltf_at *at, const char *key,
	int vertex_count, struct model_deltas *out)
{
	struct gltf_at member = gltf_member(at, key);
	const struct gltf_accessor *accessor;
	float *values;
	int error = gltf_read_attribute(
		at, key, "VEC3", vertex_count, &at->gltf->brief, &values);

	if (!error && values) {
		error = gltf_maybe_accessor(at, key, "VEC3", &accessor);
	}
	if (!error && values) {
		error = pack(&member, accessor, (const float(*)[3])values, out);
	}
	gltf_end_brief(at->gltf);
	return error;
}

/* Reads a target, without attributes that the primitive lacks. */
static int read_target(const struct gltf_at *at,
	const struct model_primitive *primitive, struct model_target *out)
{
	int count = primitive->vertex_count;
	int error = read_delta(at, "POSITION", count, &out->position);

	if (!error && primitive->normal) {
		error = read_delta(at, "NORMAL", count, &out->normal);
	}
	if (!error && primitive->tangent) {
		error = read_delta(at, "TANGENT", count, &out->tangent);
	}
	return error;
}

int gltf_read_targets(const struct gltf_at *primitive,
	const struct model_mesh *mesh, struct model_primitive *out)
{
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(primitive, "targets", &array, &count);

	if (error) {
		return error;
	}
	if (count != mesh->target_count) {
		return gltf_fail(primitive, -EINVAL,
			"has %d targets, but the mesh's first primitive has %d",
			count, mesh->target_count);
	}
	out->target = GLTF_KEEP(&array, struct model_target, count);
	if (!out->target) {
		return -ENOMEM;
	}
	for (i = 0; i < count && !error; i++) {
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_target(&item, out, &out->target[i]);
		}
	}
	return error;
}

/* Whether any node without a skin uses the mesh's targets as key frames. */
static bool is_shown_as_keys(const struct model *model, int mesh)
{
	for (int n = 0; n < model->node_count; n++) {
		if (model->node[n].mesh == mesh && model->node[n].skin < 0 &&
			model_has_key_frames(model, n)) {
			return true;
		}
	}
	return false;
}

static int keep_deltas(struct model_deltas *deltas, struct arena *arena)
{
	return deltas->vertex_count == 0 || deltas->number == MODEL_FLOAT ||
			deltas->base
		? 0
		: model_deltas_copy(deltas, deltas, arena);
}

/*
 * Moves deltas in integers from scratch memory to the model, as key frames if
 * possible and as_keys is set.
 */
static int keep_targets(struct model *model, struct model_primitive *primitive,
	int target_count, bool as_keys)
{
	struct arena *arena = &model->arena;
	bool tangents = model->material[primitive->material].normal_texture >= 0;
	int error = as_keys ? model_keys_store(primitive, target_count,
				      tangents, false, arena)
			    : 0;

	for (int t = 0; t < target_count && !error; t++) {
		struct model_target *target = &primitive->target[t];

		error = keep_deltas(&target->position, arena);
		error = error ? error : keep_deltas(&target->normal, arena);
		error = error ? error : keep_deltas(&target->tangent, arena);
	}
	return error;
}

int gltf_keep_targets(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at meshes = gltf_member(&gltf->root, "meshes");

	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];
		bool as_keys =
			mesh->target_count > 0 && is_shown_as_keys(model, m);

		for (int p = 0; p < mesh->primitive_count; p++) {
			if (keep_targets(model, &mesh->primitive[p],
				    mesh->target_count, as_keys) != 0) {
				return gltf_no_memory(&meshes);
			}
		}
	}
	return 0;
}

/*
 * Reads extras.targetNames, which is only a convention, and extras.keyFrames,
 * which is limber's own. So it is no error if one is malformed.
 */
static int read_names(const struct gltf_at *mesh, struct model_mesh *out)
{
	struct gltf_at extras = gltf_member(mesh, "extras");
	struct gltf_at names = gltf_member(&extras, "targetNames");
	int i;

	out->key_frames =
		json_is_true(json_object_get(extras.json, "keyFrames"));
	for (i = 0; i < out->target_count; i++) {
		const char *name = json_string_value(
			json_array_get(names.json, (size_t)i));
		int error = gltf_copy_string(
			&names, name ? name : "", &out->target_name[i]);

		if (error) {
			return error;
		}
	}
	return 0;
}

int gltf_read_target_names(const struct gltf_at *mesh,
	const struct gltf_at *primitives, struct model_mesh *out)
{
	struct gltf_at first, targets;
	int error;

	if (!json_array_size(primitives->json)) {
		return 0;
	}
	error = gltf_item(primitives, 0, &first);
	if (!error) {
		error = gltf_array(
			&first, "targets", &targets, &out->target_count);
	}
	if (error) {
		return error;
	}
	out->target_name = GLTF_KEEP(&targets, const char *, out->target_count);
	return out->target_name ? read_names(mesh, out) : -ENOMEM;
}

int gltf_read_weights(const struct gltf_at *at, int target_count, float **out)
{
	struct gltf_at member = gltf_member(at, "weights");

	*out = NULL;
	if (!member.json) {
		return 0;
	}
	*out = GLTF_SCRATCH(&member, float, target_count);
	return *out ? gltf_maybe_floats(at, "weights", *out, target_count)
		    : -ENOMEM;
}

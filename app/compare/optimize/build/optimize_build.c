#include "app/compare/optimize/build/optimize_build.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const char quantization[] = "KHR_mesh_quantization";

/* The factor that undoes the unit: 1 if positions stay as they are. */
static float enlargement(const struct optimize_build *build, const float *unit)
{
	float found = optimize_build_unit(build, unit);

	return found > 0.0f ? found : 1.0f;
}

static void enlarge(float *matrix, float unit)
{
	for (int i = 0; i < 12; i++) {
		matrix[i] *= i % 4 == 3 ? 1.0f : unit;
	}
}

static int put_matrices(struct optimize_build *build, json_t *skin,
	float *matrix, int count, float unit)
{
	const struct optimize_array array = {
		.count = count,
		.width = 16,
		.rows = 4,
		.component = GLB_FLOAT,
		.value = matrix,
	};

	for (int i = 0; i < count; i++) {
		enlarge(matrix + (size_t)i * 16, unit);
	}
	optimize_build_set(build, skin, "inverseBindMatrices",
		optimize_output_add(&build->output, OPTIMIZE_MATRICES, &array));
	return build->output.glb.error;
}

static int build_skin(struct optimize_build *build, json_t *skin, float unit)
{
	int accessor = optimize_build_member(build, skin, "inverseBindMatrices");
	int count = (int)json_array_size(json_object_get(skin, "joints"));
	float *matrix;
	int error = 0;

	if (accessor < 0 && unit == 1.0f) {
		return 0;
	}
	if (accessor >= 0) {
		count = gltf_document_array(build->document, accessor).count;
	}
	matrix = calloc((size_t)count * 16 + 1, sizeof(*matrix));
	if (!matrix) {
		build->output.glb.error = -ENOMEM;
		return -ENOMEM;
	}
	for (int i = 0; i < 4 * count; i++) {
		matrix[16 * (i / 4) + 5 * (i % 4)] = 1.0f;
	}
	if (accessor >= 0) {
		error = gltf_document_floats(build->document, accessor, matrix);
	}
	error = error ? error : put_matrices(build, skin, matrix, count, unit);
	free(matrix);
	return error;
}

int optimize_build_skins(struct optimize_build *build)
{
	json_t *skin;
	size_t i;
	int error = 0;

	json_array_foreach(json_object_get(build->root, "skins"), i, skin)
	{
		error = error
			? error
			: build_skin(build, skin,
				  enlargement(build, &build->scale->skin[i]));
	}
	return error;
}

static void enlarge_array(json_t *object, const char *key, float unit, int count)
{
	json_t *array = json_object_get(object, key);

	if (!array) {
		array = json_pack("[f, f, f]", 1.0, 1.0, 1.0);
		json_object_set_new(object, key, array);
	}
	for (int i = 0; i < count; i++) {
		double value =
			json_number_value(json_array_get(array, (size_t)i));

		json_array_set_new(array, (size_t)i,
			json_real(i % 4 == 3 ? value : value * (double)unit));
	}
}

/* Scales a node without a skin by the unit of its mesh. */
static void build_node(struct optimize_build *build, json_t *node)
{
	json_t *mesh = json_object_get(node, "mesh");
	json_t *extras = json_object_get(node, "extras");
	json_t *error_m = json_object_get(extras, "error_m");
	float unit;

	if (!mesh) {
		return;
	}
	unit = enlargement(build, &build->scale->mesh[json_integer_value(mesh)]);
	if (unit == 1.0f) {
		return;
	}
	if (json_is_number(error_m)) {
		json_object_set_new(extras, "error_m",
			json_real(json_number_value(error_m) / (double)unit));
	}
	if (json_object_get(node, "skin")) {
		return;
	}
	if (json_object_get(node, "matrix")) {
		enlarge_array(node, "matrix", unit, 12);
	} else {
		enlarge_array(node, "scale", unit, 3);
	}
}

/* Copies an accessor of EXT_mesh_gpu_instancing unchanged. */
static int copy_accessor(
	struct optimize_build *build, json_t *attributes, const char *name)
{
	int accessor = optimize_build_member(build, attributes, name);
	struct gltf_document_array from;
	struct optimize_array array;
	float *value;
	int error;

	if (accessor < 0) {
		return 0;
	}
	from = gltf_document_array(build->document, accessor);
	value = malloc((size_t)from.count * (size_t)from.width * sizeof(*value));
	if (!value) {
		build->output.glb.error = -ENOMEM;
		return -ENOMEM;
	}
	error = gltf_document_floats(build->document, accessor, value);
	array = (struct optimize_array){
		.count = from.count,
		.width = from.width,
		.rows = from.rows,
		.component = (enum glb_component)from.component,
		.normalized = from.normalized,
		.value = value,
	};
	optimize_build_set(build, attributes, name,
		optimize_output_add(&build->output, OPTIMIZE_DATA, &array));
	free(value);
	return error;
}

/* An attribute may have any name that begins with an underscore. */
static int copy_instances(struct optimize_build *build, json_t *attributes)
{
	const char *name;
	json_t *value;
	int error = 0;

	json_object_foreach(attributes, name, value)
	{
		error = error ? error : copy_accessor(build, attributes, name);
	}
	return error;
}

static int build_nodes(struct optimize_build *build)
{
	json_t *node;
	size_t i;
	int error = 0;

	json_array_foreach(json_object_get(build->root, "nodes"), i, node)
	{
		json_t *instancing =
			json_object_get(json_object_get(node, "extensions"),
				"EXT_mesh_gpu_instancing");

		build_node(build, node);
		error = error
			? error
			: copy_instances(build,
				  json_object_get(instancing, "attributes"));
	}
	return error;
}

static const char *mime_of(const uint8_t *data, size_t size)
{
	if (size >= 4 && memcmp(data, "\x89PNG", 4) == 0) {
		return "image/png";
	}
	if (size >= 3 && memcmp(data, "\xff\xd8\xff", 3) == 0) {
		return "image/jpeg";
	}
	return NULL;
}

/*
 * Stores images in the file. An image that is missing, or neither PNG nor JPEG,
 * keeps its URI.
 */
static int build_images(struct optimize_build *build)
{
	json_t *image;
	size_t i;

	json_array_foreach(json_object_get(build->root, "images"), i, image)
	{
		const uint8_t *data;
		size_t size;
		int error = gltf_document_image(
			(struct gltf_document *)build->document, (int)i, &data,
			&size);
		const char *mime = error ? NULL : mime_of(data, size);

		if (error == -ENOMEM) {
			return error;
		}
		if (error || (!mime && json_object_get(image, "uri"))) {
			continue;
		}
		json_object_del(image, "uri");
		json_object_set_new(image, "bufferView",
			json_integer(
				glb_add_view(&build->output.glb, data, size)));
		if (mime) {
			json_object_set_new(
				image, "mimeType", json_string(mime));
		}
	}
	return 0;
}

static void require(json_t *root, const char *list, const char *name)
{
	json_t *names = json_object_get(root, list);
	json_t *known;
	size_t i;

	if (!names) {
		names = json_array();
		json_object_set_new(root, list, names);
	}
	json_array_foreach(names, i, known)
	{
		if (json_is_string(known) &&
			strcmp(json_string_value(known), name) == 0) {
			return;
		}
	}
	json_array_append_new(names, json_string(name));
}

static void state_error(const struct optimize_build *build)
{
	json_t *asset = json_object_get(build->root, "asset");
	json_t *extras = json_object_get(asset, "extras");

	if (build->plan->stated_px < 0.0f) {
		return;
	}
	if (!json_is_object(extras)) {
		extras = json_object();
		json_object_set_new(asset, "extras", extras);
	}
	json_object_set_new(extras, "limber_error_px",
		json_real(optimize_decimal(build->plan->stated_px)));
}

static int build_all(struct optimize_build *build)
{
	static int (*const steps[])(struct optimize_build *) = {
		optimize_build_meshes,
		optimize_build_skins,
		build_nodes,
		optimize_build_animations,
		build_images,
	};
	int error = build->root ? 0 : -ENOMEM;

	for (size_t i = 0; i < sizeof(steps) / sizeof(steps[0]) && !error; i++) {
		error = steps[i](build);
	}
	return error;
}

static void move_root(struct optimize_build *build)
{
	static const char *const rewritten[] = {
		"accessors", "bufferViews", "buffers"};
	struct glb *glb = &build->output.glb;
	const char *key;
	json_t *value;

	for (size_t i = 0; i < 3; i++) {
		json_object_del(build->root, rewritten[i]);
	}
	if (glb->quantized) {
		require(build->root, "extensionsUsed", quantization);
		require(build->root, "extensionsRequired", quantization);
		glb->quantized = false;
	}
	state_error(build);
	json_object_foreach(build->root, key, value)
	{
		glb_set(glb, key, json_incref(value));
	}
}

int optimize_build(struct optimize_build *build, const char *path,
	const struct log *log, uint8_t **data, size_t *size)
{
	struct glb *glb = &build->output.glb;
	int error;

	optimize_output_begin(&build->output);
	build->root = json_deep_copy(gltf_document_json(build->document));
	error = build_all(build);
	optimize_output_end(&build->output);
	if (build->root) {
		move_root(build);
	}
	json_decref(build->root);
	build->root = NULL;
	/* Only errors of memory have not been logged yet. */
	if (error && error != -ENOMEM) {
		glb_discard(glb);
		return error;
	}
	glb->error = glb->error ? glb->error : error;
	return glb_write_memory(glb, path, log, data, size);
}

/*
 * Findings of limber doctor that only the file shows, because the loader
 * normalises such things.
 */
#include "app/model/gltf/gltf.h"
#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct examination {
	struct gltf *gltf;
	const struct examiner *examiner;
};

static json_t *member(const struct examination *at, const char *key)
{
	return json_object_get(at->gltf->json, key);
}

/*
 * The number of an accessor in a member of an object, or -1. Some exporters
 * write it with ".0".
 */
static int accessor_of(
	const struct examination *at, const json_t *object, const char *key)
{
	const json_t *number = json_object_get(object, key);
	double value = json_is_number(number) ? json_number_value(number) : -1;

	return value >= 0 && value < at->gltf->accessor_count ? (int)value : -1;
}

static void report_accessors(const struct examination *at)
{
	int empty = 0, sparse = 0, odd = 0;

	for (int i = 0; i < at->gltf->accessor_count; i++) {
		const struct gltf_accessor *accessor = &at->gltf->accessor[i];
		const struct gltf_elements *base = &accessor->base;

		empty += base->data == NULL;
		sparse += accessor->sparse_count > 0;
		odd += base->data && base->component == GLTF_F32 &&
			((uintptr_t)base->data % 4 != 0 ||
				base->stride % 4 != 0);
	}
	examine_count(at->examiner, empty, "accessors without a buffer view",
		"limber reads zeros where no sparse value replaces them");
	examine_count(at->examiner, sparse, "sparse accessors",
		"limber replaces the listed values of the base");
	examine_count(at->examiner, odd,
		"accessors of floats that are not aligned to 4 bytes",
		"some ARM processors fault on such floats, so limber copies them bytewise");
}

static void report_samplers(const struct examination *at)
{
	size_t i, k;
	json_t *clip, *sampler;
	int scaled = 0;

	json_array_foreach(member(at, "animations"), i, clip)
	{
		json_array_foreach(json_object_get(clip, "samplers"), k, sampler)
		{
			int output = accessor_of(at, sampler, "output");

			scaled += output >= 0 &&
				at->gltf->accessor[output].base.component !=
					GLTF_F32;
		}
	}
	examine_count(at->examiner, scaled, "samplers with integer outputs",
		"limber converts them to -1..1 or 0..1");
}

static void report_skins(const struct examination *at)
{
	size_t i;
	json_t *skin;
	int missing = 0;

	json_array_foreach(member(at, "skins"), i, skin)
	{
		missing += !json_object_get(skin, "inverseBindMatrices");
	}
	examine_count(at->examiner, missing,
		"skins without inverse bind matrices",
		"limber uses identity matrices");
}

static void report_nodes(const struct examination *at)
{
	size_t i, k;
	json_t *node, *child;
	int before = 0, own_weights = 0, cameras = 0;

	json_array_foreach(member(at, "nodes"), i, node)
	{
		json_array_foreach(json_object_get(node, "children"), k, child)
		{
			before += json_number_value(child) < (double)i;
		}
		own_weights += json_object_get(node, "weights") != NULL;
		cameras += json_object_get(node, "camera") != NULL;
	}
	examine_count(at->examiner, before,
		"nodes that come before their parents in the file",
		"limber sorts the nodes, so that a parent's matrix is always computed first");
	examine_count(at->examiner, own_weights,
		"nodes with morph weights of their own",
		"limber uses them instead of those of the mesh");
	examine_count(at->examiner, cameras, "cameras",
		"limber looks at the whole model from outside instead; [scene] of a character file says from which side");
}

static void report_scenes(const struct examination *at)
{
	int others = (int)json_array_size(member(at, "scenes")) - 1;

	examine_count(at->examiner, others,
		"scenes beside the one that is shown",
		"limber shows the file's default scene, or the first one if it names none");
}

/*
 * Adds the number of vertices whose weights are all 0 to *none, and the number
 * of those whose weights have another sum than 1 to *unequal. Returns 0 or
 * -ENOMEM.
 */
static int count_weights(const struct examination *at, const json_t *attributes,
	int *none, int *unequal)
{
	int index = accessor_of(at, attributes, "WEIGHTS_0");
	const struct gltf_accessor *accessor;
	float *weight;
	int error;

	if (index < 0 || json_object_get(attributes, "WEIGHTS_1")) {
		return 0;
	}
	accessor = &at->gltf->accessor[index];
	weight = GLTF_SCRATCH(&at->gltf->root, float, accessor->count * 4);
	if (!weight) {
		return -ENOMEM;
	}
	if (accessor->width != 4) {
		return 0;
	}
	error = gltf_unpack_floats(&at->gltf->root, accessor, weight);
	if (error) {
		return error == -ENOMEM ? error : 0;
	}
	for (int v = 0; v < accessor->count; v++) {
		const float *w = weight + (size_t)v * 4;
		float sum = w[0] + w[1] + w[2] + w[3];

		*none += !(sum > 0.0f);
		*unequal += sum > 0.0f && (sum < 0.999f || sum > 1.001f);
	}
	return 0;
}

/* Returns 0 or -ENOMEM. */
static int report_weights(const struct examination *at)
{
	size_t m, p;
	json_t *mesh, *primitive;
	int none = 0, unequal = 0, error = 0;

	json_array_foreach(member(at, "meshes"), m, mesh)
	{
		if (at->gltf->mesh_index[m] < 0) {
			continue; /* a level of detail, which shares its
				     vertices */
		}
		json_array_foreach(
			json_object_get(mesh, "primitives"), p, primitive)
		{
			error = error ? error
				      : count_weights(at,
						json_object_get(primitive,
							"attributes"),
						&none, &unequal);
		}
	}
	examine_count(at->examiner, none, "vertices without a weight above 0",
		"limber attaches them to their first joint, because they would collapse into the origin");
	examine_count(at->examiner, unequal,
		"vertices whose weights do not sum to 1",
		"limber divides them by their sum");
	return error;
}

/*
 * Whether limber ignores an extension. MSFT_lod is read if it meets the
 * conditions in README.md.
 */
static bool is_ignored(const char *name)
{
	return !gltf_knows_extension(name) && strcmp(name, "MSFT_lod") != 0;
}

static void report_extensions(const struct examination *at)
{
	char names[256] = "";
	int count = 0, length = 0;
	size_t i;
	json_t *used;

	json_array_foreach(member(at, "extensionsUsed"), i, used)
	{
		const char *name = json_string_value(used);

		if (!name || !is_ignored(name)) {
			continue;
		}
		if (length + (int)strlen(name) + 2 < (int)sizeof(names)) {
			length += snprintf(names + length,
				sizeof(names) - (size_t)length, "%s%s",
				length ? ", " : "", name);
		}
		count++;
	}
	if (count > 0) {
		examine_report(at->examiner,
			"extensions that limber ignores (%d), so that what they add is not shown: %s",
			count, names);
	}
}

static void report_transmission(const struct examination *at)
{
	int count = 0;
	size_t i;
	json_t *material;

	json_array_foreach(member(at, "materials"), i, material)
	{
		const json_t *glass =
			json_object_get(json_object_get(material, "extensions"),
				"KHR_materials_transmission");

		count += json_object_get(glass, "transmissionTexture") != NULL;
	}
	examine_count(at->examiner, count,
		"materials whose transmission has a texture",
		"limber draws them opaque; let them blend by alphaMode BLEND instead");
}

static void report_origin(const struct examination *at)
{
	const double *origin = at->gltf->model->origin;
	double away = sqrt(origin[0] * origin[0] + origin[1] * origin[1] +
		origin[2] * origin[2]);

	if (away > 0) {
		examine_report(at->examiner,
			"a place far from the origin (%.3g m): limber poses and draws the model near the origin, where floats are exact, and writes the file's coordinates",
			away);
	}
}

int gltf_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log)
{
	struct model *model = NULL;
	struct gltf gltf;
	int error = gltf_read(&gltf, source, true, log);

	if (!error) {
		const struct examination at = {&gltf, examiner};

		model = gltf.model;
		model_prepare_clips(model);
		error = examine_clips(model, examiner, log);
		error = error ? error : examine_skins(model, examiner, log);
		report_skins(&at);
		report_nodes(&at);
		report_scenes(&at);
		error = error ? error
			      : examine_still_clips(model, examiner, log);
		error = error ? error : examine_spare(model, examiner, log);
		error = error ? error : report_weights(&at);
		report_accessors(&at);
		report_samplers(&at);
		report_extensions(&at);
		report_transmission(&at);
		report_origin(&at);
	}
	/* First, since it gives memory back to the model's budget. */
	gltf_release(&gltf);
	model_destroy(model);
	return error;
}

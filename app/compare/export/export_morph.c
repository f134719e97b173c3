#include "app/compare/export/export_bake.h"

#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/export/export_levels.h"
#include "app/compare/measure/winding.h"
#include "app/scene/instance/lod.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The state of export_morph(), which poses one key after another. */
struct exporter {
	struct glb *glb;
	const struct comparison *comparison;
	const struct comparison_row *row;
	const struct log *log;
	struct fixed_placement placement;
	struct reference *reference; /* of the current clip */
	int16_t (*base)[3];          /* [vertex_count] */
	int8_t (*base_normal)[3];
	int16_t (*delta)[3];
	int8_t (*delta_normal)[3];
	/* [part_count]: how many key frames need the opposite winding; NULL:
	   all have that of the rest pose */
	int *mirrored;
	json_t *primitives;         /* each with an array "targets" */
	struct export_lists *lists; /* of each primitive */
};

static int allocate(struct exporter *exporter)
{
	size_t count = (size_t)exporter->reference->vertex_count + 1;

	exporter->base = malloc(count * sizeof(*exporter->base));
	exporter->base_normal = malloc(count * sizeof(*exporter->base_normal));
	exporter->delta = malloc(count * sizeof(*exporter->delta));
	exporter->delta_normal = malloc(count * sizeof(*exporter->delta_normal));
	exporter->lists = malloc((size_t)exporter->reference->part_count *
			sizeof(*exporter->lists) +
		1);
	if (exporter->lists && exporter->base && exporter->base_normal &&
		exporter->delta && exporter->delta_normal) {
		return 0;
	}
	log_error(exporter->log, "%s: there is not enough memory for key frames",
		exporter->comparison->model->path);
	return -ENOMEM;
}

/*
 * Makes the mesh itself: the rest pose, because the player frames it together
 * with the clips, as with the model. Its normals are the diagonals that
 * candidate_morph.h describes.
 */
static void take_base(struct exporter *exporter)
{
	const struct reference *reference = exporter->reference;

	for (int v = 0; v < reference->vertex_count; v++) {
		candidate_morph_position(&exporter->placement,
			reference->position[v], exporter->base[v]);
		for (int axis = 0; axis < 3; axis++) {
			exporter->base_normal[v][axis] =
				reference->normal[v][axis] < 0.0f
				? -MORPH_NORMAL_BASE
				: MORPH_NORMAL_BASE;
		}
	}
}

static void take_deltas(struct exporter *exporter)
{
	const struct reference *reference = exporter->reference;

	for (int v = 0; v < reference->vertex_count; v++) {
		int16_t position[3];
		int8_t normal[3];

		candidate_morph_position(
			&exporter->placement, reference->position[v], position);
		candidate_morph_normal(reference->normal[v], normal);
		for (int axis = 0; axis < 3; axis++) {
			exporter->delta[v][axis] = (int16_t)(position[axis] -
				exporter->base[v][axis]);
			exporter->delta_normal[v][axis] = (int8_t)(normal[axis] -
				exporter->base_normal[v][axis]);
		}
	}
}

static void add_vectors(struct exporter *exporter, json_t *to,
	const struct reference_part *part, const int16_t (*position)[3],
	const int8_t (*normal)[3])
{
	struct glb *glb = exporter->glb;

	export_attribute(to, "POSITION",
		glb_add_vectors(glb, position + part->first_vertex,
			part->vertex_count, GLB_SHORT, false));
	if (part->normals) {
		export_attribute(to, "NORMAL",
			glb_add_vectors(glb, normal + part->first_vertex,
				part->vertex_count, GLB_BYTE, true));
	}
}

/*
 * The length of the drawable's unit in the file's units, at rest: the file
 * shows the levels that the player would show of the model.
 */
static float unit_of(
	const struct exporter *exporter, const struct drawable *drawable)
{
	const struct instance *instance = exporter->reference->instance;

	return lod_error_units(instance, drawable) / instance->unit_scale /
		exporter->placement.scale;
}

/*
 * Positions in the file are in world space, where a mirrored drawable's
 * triangles have the opposite winding. If key frames differ, most of them are
 * right.
 */
static struct export_lists lists_of(const struct exporter *exporter, int part)
{
	const struct instance *instance = exporter->reference->instance;
	const struct drawable *drawable =
		&instance->drawable[exporter->reference->part[part].drawable];
	const struct model_primitive *primitive = drawable->primitive;

	return (struct export_lists){
		.index_count = primitive->index_count,
		.lod_count = primitive->lod_count,
		.lod = primitive->lod,
		.scale = unit_of(exporter, drawable),
		.mirrored = exporter->mirrored
			? 2 * exporter->mirrored[part] >
				exporter->row->total.key_count
			: instance_is_mirrored(instance, drawable),
	};
}

static void add_primitives(struct exporter *exporter)
{
	const struct reference *reference = exporter->reference;

	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];
		const struct drawable *drawable =
			&reference->instance->drawable[part->drawable];
		const struct model_primitive *primitive = drawable->primitive;
		json_t *attributes = json_object();
		struct export_lists *lists = &exporter->lists[i];

		*lists = lists_of(exporter, i);

		add_vectors(exporter, attributes, part,
			(const int16_t(*)[3])exporter->base,
			(const int8_t(*)[3])exporter->base_normal);
		export_attributes(exporter->glb, attributes, primitive,
			part->vertex_count, NULL);
		json_array_append_new(exporter->primitives,
			json_pack("{s:o, s:i, s:i, s:[]}", "attributes",
				attributes, "indices",
				export_triangles(exporter->glb, primitive->index,
					primitive->index_count, lists->mirrored),
				"material", primitive->material, "targets"));
	}
}

static void add_targets(struct exporter *exporter)
{
	const struct reference *reference = exporter->reference;

	for (int i = 0; i < reference->part_count; i++) {
		json_t *primitive =
			json_array_get(exporter->primitives, (size_t)i);
		json_t *target = json_object();

		add_vectors(exporter, target, &reference->part[i],
			(const int16_t(*)[3])exporter->delta,
			(const int8_t(*)[3])exporter->delta_normal);
		json_array_append_new(
			json_object_get(primitive, "targets"), target);
	}
}

static int count_mirrored(struct exporter *exporter, int clip)
{
	const struct comparison *comparison = exporter->comparison;
	const struct fit_keys *keys = &exporter->row->cell[clip].keys;
	struct reference *reference;
	int error = reference_create_scaled(comparison->model,
		comparison->clip[clip].clip, comparison->unit_scale,
		exporter->log, &reference);

	if (error) {
		return error;
	}
	if (!exporter->mirrored) {
		exporter->mirrored = calloc((size_t)reference->part_count,
			sizeof(*exporter->mirrored));
	}
	if (exporter->mirrored) {
		winding_count(reference, keys->time_s, keys->count,
			exporter->mirrored);
	} else {
		error = memory_budget_fail(comparison->model->budget,
			comparison->model->path, exporter->log);
	}
	reference_destroy(reference);
	return error;
}

/* Fills mirrored, if any clip may reverse the winding. */
static int find_mirrored(struct exporter *exporter)
{
	const struct comparison *comparison = exporter->comparison;
	const struct model *model = comparison->model;
	bool any = false;
	int error = 0;

	for (int c = 0; c < comparison->clip_count; c++) {
		any = any ||
			winding_may_change(
				model, &model->clip[comparison->clip[c].clip]);
	}
	for (int c = 0; any && !error && c < comparison->clip_count; c++) {
		error = count_mirrored(exporter, c);
	}
	return error;
}

static int export_keys(struct exporter *exporter, int clip)
{
	const struct fit_keys *keys = &exporter->row->cell[clip].keys;
	int error = reference_create_scaled(exporter->comparison->model,
		exporter->comparison->clip[clip].clip,
		exporter->comparison->unit_scale, exporter->log,
		&exporter->reference);

	if (error) {
		return error;
	}
	error = exporter->base ? 0 : allocate(exporter);
	for (int k = 0; !error && k < keys->count; k++) {
		if (json_array_size(exporter->primitives) == 0) {
			reference_rest(exporter->reference);
			take_base(exporter);
			add_primitives(exporter);
		}
		reference_pose(exporter->reference, keys->time_s[k], true);
		take_deltas(exporter);
		add_targets(exporter);
		error = interrupt_pending() ? -EINTR : 0;
	}
	reference_destroy(exporter->reference);
	return error;
}

/*
 * Adds a clip's weights: at each key, the key's own weight is 1 and all others
 * are 0. first is the index of the clip's first key among all keys.
 */
static int add_weights(
	struct exporter *exporter, const struct fit_keys *keys, int first)
{
	int total = exporter->row->total.key_count, accessor;
	uint32_t *one = malloc((size_t)keys->count * sizeof(*one));

	if (!one) {
		exporter->glb->error = -ENOMEM;
		return -1;
	}
	for (int k = 0; k < keys->count; k++) {
		one[k] = (uint32_t)k * (uint32_t)total + (uint32_t)(first + k);
	}
	accessor = glb_add_ones(
		exporter->glb, one, keys->count, keys->count * total);
	free(one);
	return accessor;
}

static void add_clips(struct exporter *exporter)
{
	const struct comparison *comparison = exporter->comparison;
	json_t *animations = json_array();
	int first = 0;

	for (int c = 0; c < comparison->clip_count; c++) {
		const struct fit_keys *keys = &exporter->row->cell[c].keys;
		const struct model_clip *clip =
			&comparison->model->clip[comparison->clip[c].clip];
		int times = glb_add_array(
			exporter->glb, keys->time_s, keys->count, 1, GLB_FLOAT);
		int weights = add_weights(exporter, keys, first);

		json_array_append_new(animations,
			json_pack(
				"{s:s, s:[{s:i, s:i}], s:[{s:i, s:{s:i, s:s}}]}",
				"name", clip->name, "samplers", "input", times,
				"output", weights, "channels", "sampler", 0,
				"target", "node", 0, "path", "weights"));
		first += keys->count;
	}
	glb_set(exporter->glb, "animations", animations);
}

static void add_meshes(struct exporter *exporter, json_t *levels)
{
	json_t *meshes = json_pack("[{s:O, s:{s:b}}]", "primitives",
		exporter->primitives, "extras", "keyFrames", 1);

	export_level_meshes(exporter->glb, meshes, 0, exporter->lists, levels);
	glb_set(exporter->glb, "meshes", meshes);
}

/*
 * Adds the node, whose scale and translation convert the quantized positions to
 * model units.
 */
static void add_nodes(struct exporter *exporter, const json_t *levels)
{
	const struct fixed_placement *placement = &exporter->placement;
	double scale = (double)placement->scale;
	struct glb *glb = exporter->glb;
	json_t *nodes = json_pack("[{s:i, s:o, s:[f, f, f]}]", "mesh", 0,
		"translation", glb_floats(placement->offset, 3), "scale", scale,
		scale, scale);

	export_level_nodes(
		glb, nodes, json_object_get(glb->root, "meshes"), levels);
	glb_set(glb, "nodes", nodes);
	glb_set(glb, "scenes", json_pack("[{s:[i]}]", "nodes", 0));
	glb_set(glb, "scene", json_integer(0));
}

int export_morph(struct glb *glb, const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log)
{
	struct exporter exporter = {
		.glb = glb,
		.comparison = comparison,
		.row = row,
		.log = log,
		.placement = candidate_morph_placement(&comparison->box),
		.primitives = json_array(),
	};
	json_t *levels = json_array();
	int error = find_mirrored(&exporter);

	for (int c = 0; !error && c < comparison->clip_count; c++) {
		error = export_keys(&exporter, c);
	}
	if (!error) {
		export_materials(glb, comparison->model);
		add_meshes(&exporter, levels);
		add_nodes(&exporter, levels);
		add_clips(&exporter);
	}
	json_decref(levels);
	json_decref(exporter.primitives);
	free(exporter.base);
	free(exporter.base_normal);
	free(exporter.delta);
	free(exporter.delta_normal);
	free(exporter.lists);
	free(exporter.mirrored);
	return error;
}

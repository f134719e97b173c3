#include "app/compare/export/export_levels.h"

#include "app/compare/export/export_bake.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

enum {
	/* The loader reads at most 16 levels of a mesh. */
	SHADED_MAX = 10,
	SHADOW_MAX = 6,
};

static const double worth = 0.2; /* a level must save this share */
/* Coverages are computed for a screen of so many pixels. */
static const double coverage_px = 640.0;

/* The state of export_level_meshes() for one mesh. */
struct leveler {
	struct glb *glb;
	json_t *meshes, *levels;
	int mesh, primitive_count;
	const struct export_lists *lists;
};

static uint32_t *turned(const uint32_t *index, int count)
{
	uint32_t *out = malloc((size_t)count * sizeof(*out) + 1);

	for (int i = 0; out && i + 2 < count; i += 3) {
		out[i] = index[i];
		out[i + 1] = index[i + 2];
		out[i + 2] = index[i + 1];
	}
	return out;
}

int export_triangles(
	struct glb *glb, const uint32_t *index, int count, bool mirrored)
{
	uint32_t *own = mirrored ? turned(index, count) : NULL;
	int accessor = -1;

	if (mirrored && !own) {
		glb->error = glb->error ? glb->error : -ENOMEM;
	} else {
		accessor = export_indices(glb, own ? own : index, count);
	}
	free(own);
	return accessor;
}

static float error_of(const struct export_lists *lists, int lod)
{
	return lists->lod[lod].error_m * lists->scale;
}

/*
 * Whether a list is written. Without normals, a reader would draw the triangles
 * of a level flat, which is right for those of a file alone; limber makes its
 * own anew.
 */
static bool is_kept(const struct model_lod *lod, bool shadow)
{
	return lod->shadow_only == shadow && !lod->corner;
}

/*
 * The index of a primitive's coarsest list with at most this error; -1: the
 * full list. Empty lists, which glTF does not allow, are passed over.
 */
static int coarsest(const struct export_lists *lists, bool shadow, float error)
{
	int found = -1;

	for (int i = 0; i < lists->lod_count; i++) {
		if (is_kept(&lists->lod[i], shadow) &&
			lists->lod[i].index_count > 0 &&
			error_of(lists, i) <= error) {
			found = i;
		}
	}
	return found;
}

static int index_count(const struct export_lists *lists, int lod)
{
	return lod < 0 ? lists->index_count : lists->lod[lod].index_count;
}

/* The number of corners of all triangles of the level with this error. */
static double count_corners(
	const struct leveler *leveler, bool shadow, float error)
{
	double sum = 0.0;

	for (int p = 0; p < leveler->primitive_count; p++) {
		const struct export_lists *lists = &leveler->lists[p];

		sum += index_count(lists, coarsest(lists, shadow, error));
	}
	return sum;
}

/* A level of the whole mesh. */
struct rung {
	float error;
	double corners; /* of all primitives' lists */
};

static int compare_errors(const void *left, const void *right)
{
	const struct rung *a = left, *b = right;

	return (a->error > b->error) - (a->error < b->error);
}

/* Appends a level with this error if it saves enough. Returns the new count. */
static int add_rung(const struct leveler *leveler, bool shadow, float error,
	struct rung *rung, int count)
{
	double finer = count > 0 ? rung[count - 1].corners
				 : count_corners(leveler, shadow, -1.0f);
	double corners = count_corners(leveler, shadow, error);

	if (corners <= (1.0 - worth) * finer) {
		rung[count++] = (struct rung){error, corners};
	}
	return count;
}

/*
 * Drops the level that saves the smallest share of the corners of the next
 * finer one. Returns the new count.
 */
static int drop_rung(double full, struct rung *rung, int count)
{
	double least = 1.0;
	int dropped = 0;

	for (int i = 0; i < count; i++) {
		double finer = i > 0 ? rung[i - 1].corners : full;
		double share = 1.0 - rung[i].corners / finer;

		if (share < least) {
			least = share;
			dropped = i;
		}
	}
	for (int i = dropped; i + 1 < count; i++) {
		rung[i] = rung[i + 1];
	}
	return count - 1;
}

/*
 * Chooses at most max levels, of shadows or of shaded meshes, from the errors
 * of all lists. The caller frees *out. Returns the number of levels.
 */
static int choose_rungs(
	const struct leveler *leveler, bool shadow, int max, struct rung **out)
{
	int lists = 0, errors = 0, count = 0;
	struct rung *rung;

	for (int p = 0; p < leveler->primitive_count; p++) {
		lists += leveler->lists[p].lod_count;
	}
	rung = malloc((size_t)lists * sizeof(*rung) + 1);
	*out = rung;
	if (!rung) {
		leveler->glb->error = -ENOMEM;
		return 0;
	}
	for (int p = 0; p < leveler->primitive_count; p++) {
		const struct export_lists *of = &leveler->lists[p];

		for (int i = 0; i < of->lod_count; i++) {
			if (is_kept(&of->lod[i], shadow)) {
				rung[errors++].error = error_of(of, i);
			}
		}
	}
	qsort(rung, (size_t)errors, sizeof(*rung), compare_errors);
	for (int i = 0; i < errors; i++) {
		count = add_rung(leveler, shadow, rung[i].error, rung, count);
	}
	while (count > max) {
		count = drop_rung(
			count_corners(leveler, shadow, -1.0f), rung, count);
	}
	return count;
}

/*
 * Makes the primitives of a level; those whose list does not change share the
 * finer level's indices.
 */
static json_t *level_primitives(const struct leveler *leveler,
	const json_t *finer, bool shadow, float finer_error, float error)
{
	json_t *primitives = json_array();

	for (int p = 0; p < leveler->primitive_count; p++) {
		const struct export_lists *lists = &leveler->lists[p];
		json_t *primitive = json_copy(json_array_get(finer, (size_t)p));
		int lod = coarsest(lists, shadow, error);

		if (lod >= 0 && lod != coarsest(lists, shadow, finer_error)) {
			json_object_set_new(primitive, "indices",
				json_integer(export_triangles(leveler->glb,
					lists->lod[lod].index,
					lists->lod[lod].index_count,
					lists->mirrored)));
		}
		json_array_append_new(primitives, primitive);
	}
	return primitives;
}

static void add_level(const struct leveler *leveler, json_t *primitives,
	bool shadow, float error)
{
	json_t *extras = json_pack("{s:f}", "error_m", (double)error);

	if (shadow) {
		json_object_set_new(extras, "shape", json_true());
	}
	json_array_append_new(leveler->levels,
		json_pack("{s:i, s:i, s:o}", "of", leveler->mesh, "mesh",
			(int)json_array_size(leveler->meshes), "extras", extras));
	json_array_append_new(
		leveler->meshes, json_pack("{s:o}", "primitives", primitives));
}

static void add_levels(const struct leveler *leveler, bool shadow, int max)
{
	struct rung *rung;
	int count = choose_rungs(leveler, shadow, max, &rung);
	const json_t *finer = json_object_get(
		json_array_get(leveler->meshes, (size_t)leveler->mesh),
		"primitives");
	float finer_error = -1.0f;

	for (int i = 0; i < count; i++) {
		json_t *primitives = level_primitives(
			leveler, finer, shadow, finer_error, rung[i].error);

		add_level(leveler, primitives, shadow, rung[i].error);
		finer = primitives;
		finer_error = rung[i].error;
	}
	free(rung);
}

void export_level_meshes(struct glb *glb, json_t *meshes, int mesh,
	const struct export_lists *lists, json_t *levels)
{
	const struct leveler leveler = {
		.glb = glb,
		.meshes = meshes,
		.levels = levels,
		.mesh = mesh,
		.primitive_count = (int)json_array_size(json_object_get(
			json_array_get(meshes, (size_t)mesh), "primitives")),
		.lists = lists,
	};

	add_levels(&leveler, false, SHADED_MAX);
	add_levels(&leveler, true, SHADOW_MAX);
}

static double extent_of(const json_t *accessor)
{
	const json_t *low = json_object_get(accessor, "min");
	const json_t *high = json_object_get(accessor, "max");
	double extent = 0.0;

	for (size_t axis = 0; axis < 3; axis++) {
		double side = json_number_value(json_array_get(high, axis)) -
			json_number_value(json_array_get(low, axis));

		extent = fmax(extent, side);
	}
	return extent;
}

/* The longest side of any primitive's bounds, in units of the file. */
static double mesh_extent(const struct glb *glb, const json_t *meshes, int mesh)
{
	double extent = 0.0;
	size_t i;
	json_t *primitive;

	json_array_foreach(json_object_get(json_array_get(meshes, (size_t)mesh),
				   "primitives"),
		i, primitive)
	{
		const json_t *number = json_object_get(
			json_object_get(primitive, "attributes"), "POSITION");
		double side = extent_of(json_array_get(
			glb->accessors, (size_t)json_integer_value(number)));

		extent = fmax(extent, side);
	}
	return extent;
}

/*
 * The share of the screen that the mesh covers when a level's error is one
 * pixel, which is MSFT_screencoverage. It is all of it for an error of 0.
 */
static double coverage_of(double extent, const json_t *extras)
{
	double error = json_number_value(json_object_get(extras, "error_m"));
	double side = extent / error / coverage_px;

	return side < 1.0 ? side * side : 1.0;
}

static json_t *level_node(const json_t *node, const json_t *level, int number)
{
	static const char *const own[] = {
		"children", "extensions", "extras", "name"};
	const json_t *extras = json_object_get(level, "extras");
	const char *name = json_string_value(json_object_get(node, "name"));
	json_t *copy = json_deep_copy(node);

	for (size_t i = 0; i < ARRAY_COUNT(own); i++) {
		json_object_del(copy, own[i]);
	}
	json_object_set(copy, "mesh", json_object_get(level, "mesh"));
	json_object_set(copy, "extras", (json_t *)extras);
	json_object_set_new(copy, "name",
		json_object_get(extras, "shape")
			? json_sprintf("%s.shape%d", name ? name : "", number)
			: json_sprintf("%s.lod%d", name ? name : "", number));
	return copy;
}

/* Appends nodes for the levels of a node's mesh; returns whether it has any. */
static bool add_level_nodes(const struct glb *glb, json_t *nodes, json_t *node,
	const json_t *meshes, const json_t *levels)
{
	json_t *ids = json_array(), *coverage = json_array(), *level;
	json_int_t mesh = json_integer_value(json_object_get(node, "mesh"));
	double extent = mesh_extent(glb, meshes, (int)mesh);
	size_t i;

	json_array_foreach(levels, i, level)
	{
		if (json_integer_value(json_object_get(level, "of")) != mesh) {
			continue;
		}
		json_array_append_new(
			ids, json_integer((json_int_t)json_array_size(nodes)));
		json_array_append_new(coverage,
			json_real(coverage_of(
				extent, json_object_get(level, "extras"))));
		json_array_append_new(nodes,
			level_node(node, level, (int)json_array_size(ids)));
	}
	if (json_array_size(ids) == 0) {
		json_decref(ids);
		json_decref(coverage);
		return false;
	}
	json_array_append_new(coverage, json_real(0.0));
	json_object_set_new(node, "extensions",
		json_pack("{s:{s:o}}", "MSFT_lod", "ids", ids));
	json_object_set_new(node, "extras",
		json_pack("{s:o}", "MSFT_screencoverage", coverage));
	return true;
}

void export_level_nodes(struct glb *glb, json_t *nodes, const json_t *meshes,
	const json_t *levels)
{
	size_t count = json_array_size(nodes);
	bool used = false;

	for (size_t i = 0; i < count; i++) {
		json_t *node = json_array_get(nodes, i);

		if (json_object_get(node, "mesh") &&
			add_level_nodes(glb, nodes, node, meshes, levels)) {
			used = true;
		}
	}
	if (used) {
		glb_use_extension(glb, "MSFT_lod");
	}
}

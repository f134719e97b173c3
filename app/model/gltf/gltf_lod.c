#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <float.h>
#include <math.h>

enum {
	LEVELS_MAX = 16 /* of a mesh */
};

/*
 * A share of the screen says how many pixels a metre of the mesh has where the
 * next level takes over. By custom its error is then a pixel of so many.
 */
static const double coverage_px = 640.0;

/* Who names the nodes and meshes of a file. */
struct mentions {
	struct gltf *gltf;
	const json_t *nodes, *meshes; /* arrays, or NULL */
	int *node;     /* [node_count]: besides levels of detail */
	int *mesh;     /* [mesh_count]: by nodes */
	int *level;    /* [mesh_count]: by nodes that are levels */
	bool *refused; /* [mesh_count]: no level of anything */
};

/* As gltf_index() reads it; -1 for what it would refuse. */
static int index_in(const json_t *number, int count)
{
	double value = json_is_number(number) ? json_number_value(number) : -1.0;

	return value >= 0.0 && value < (double)count && floor(value) == value
		? (int)value
		: -1;
}

static void mention(const struct mentions *mentions, const json_t *number)
{
	int node = index_in(number, mentions->gltf->node_count);

	if (node >= 0) {
		mentions->node[node]++;
	}
}

static void mention_all(const struct mentions *mentions, const json_t *numbers)
{
	size_t i;
	json_t *number;

	json_array_foreach(numbers, i, number)
	{
		mention(mentions, number);
	}
}

/* The member of each element of an array of the file's top. */
static void mention_members(
	const struct mentions *mentions, const char *array, const char *member)
{
	size_t i;
	json_t *element;

	json_array_foreach(
		json_object_get(mentions->gltf->json, array), i, element)
	{
		json_t *value = json_object_get(element, member);

		mention(mentions, value);
		mention_all(mentions, value);
	}
}

static void mention_channels(const struct mentions *mentions)
{
	size_t i, k;
	json_t *clip, *channel;

	json_array_foreach(
		json_object_get(mentions->gltf->json, "animations"), i, clip)
	{
		json_array_foreach(json_object_get(clip, "channels"), k, channel)
		{
			mention(mentions,
				json_object_get(
					json_object_get(channel, "target"),
					"node"));
		}
	}
}

static int mesh_of(const struct mentions *mentions, const json_t *node)
{
	return index_in(
		json_object_get(node, "mesh"), mentions->gltf->mesh_count);
}

static void collect(const struct mentions *mentions)
{
	size_t i;
	json_t *node;

	mention_members(mentions, "nodes", "children");
	mention_members(mentions, "scenes", "nodes");
	mention_members(mentions, "skins", "joints");
	mention_members(mentions, "skins", "skeleton");
	mention_channels(mentions);
	json_array_foreach(mentions->nodes, i, node)
	{
		int mesh = mesh_of(mentions, node);

		if (mesh >= 0) {
			mentions->mesh[mesh]++;
		}
	}
}

static const json_t *levels_of(const json_t *node)
{
	return json_object_get(
		json_object_get(json_object_get(node, "extensions"), "MSFT_lod"),
		"ids");
}

static bool same(const json_t *a, const json_t *b, const char *const *keys)
{
	for (; *keys; keys++) {
		json_t *p = json_object_get(a, *keys);
		json_t *q = json_object_get(b, *keys);

		if (p != q && (!p || !q || !json_equal(p, q))) {
			return false;
		}
	}
	return true;
}

/* The vertices of both are the same ones. */
static bool share_vertices(const json_t *mesh, const json_t *other)
{
	static const char *const keys[] = {
		"attributes", "targets", "material", "mode", NULL};
	const json_t *p = json_object_get(mesh, "primitives");
	const json_t *q = json_object_get(other, "primitives");
	size_t count = json_array_size(p), i;

	if (count == 0 || json_array_size(q) != count) {
		return false;
	}
	for (i = 0; i < count; i++) {
		const json_t *from = json_array_get(p, i);
		const json_t *to = json_array_get(q, i);

		if (!same(from, to, keys) || !json_object_get(to, "indices")) {
			return false;
		}
	}
	return true;
}

static float positive(const json_t *number)
{
	double value = json_is_number(number) ? json_number_value(number) : 0.0;

	return value > 0.0 && value <= (double)FLT_MAX ? (float)value : 0.0f;
}

/* How coarse it is; false where nothing says so. */
static bool read_error(const json_t *node, size_t level, const json_t *other,
	struct gltf_level *out)
{
	const json_t *extras = json_object_get(other, "extras");
	const json_t *coverage = json_object_get(
		json_object_get(node, "extras"), "MSFT_screencoverage");

	out->error_m = positive(json_object_get(extras, "error_m"));
	out->coverage = positive(json_array_get(coverage, level));
	out->shape = json_is_true(json_object_get(extras, "shape"));
	return out->error_m > 0.0f || out->coverage > 0.0f;
}

/* Node number other is drawn as node is, by another list of triangles. */
static bool stands_for(const struct mentions *mentions, const json_t *node,
	int number, int mesh)
{
	static const char *const keys[] = {
		"translation", "rotation", "scale", "matrix", "skin", NULL};
	const json_t *other = json_array_get(mentions->nodes, (size_t)number);
	int level = mesh_of(mentions, other);

	return mentions->node[number] == 0 && level >= 0 && level != mesh &&
		!json_object_get(other, "children") &&
		!json_object_get(other, "camera") && !levels_of(other) &&
		same(node, other, keys);
}

/* Each mesh is looked at once, however many nodes have it. */
static bool is_level(const struct mentions *mentions, const json_t *node,
	size_t place, int number, int mesh)
{
	struct gltf *gltf = mentions->gltf;
	const json_t *other = json_array_get(mentions->nodes, (size_t)number);
	int level = mesh_of(mentions, other);

	if (!stands_for(mentions, node, number, mesh) ||
		mentions->refused[level]) {
		return false;
	}
	if (gltf->level[level].of < 0 &&
		read_error(node, place, other, &gltf->level[level]) &&
		share_vertices(json_array_get(mentions->meshes, (size_t)mesh),
			json_array_get(mentions->meshes, (size_t)level))) {
		gltf->level[level].of = mesh;
	}
	mentions->refused[level] = gltf->level[level].of != mesh;
	return !mentions->refused[level];
}

static void look_at_node(const struct mentions *mentions, const json_t *node)
{
	struct gltf *gltf = mentions->gltf;
	int mesh = mesh_of(mentions, node);
	size_t i;
	json_t *id;

	json_array_foreach(mesh >= 0 ? levels_of(node) : NULL, i, id)
	{
		int number = index_in(id, gltf->node_count);

		if (number < 0 || gltf->node_is_level[number]) {
			continue;
		}
		if (is_level(mentions, node, i, number, mesh)) {
			const json_t *level =
				json_array_get(mentions->nodes, (size_t)number);

			gltf->node_is_level[number] = true;
			mentions->level[mesh_of(mentions, level)]++;
		}
	}
}

static void add_level(struct gltf_level *levels, int level)
{
	struct gltf_level *of = &levels[levels[level].of];

	levels[level].next = of->first;
	of->first = level;
	of->count++;
}

/* A mesh that is also drawn for itself stays; so do the nodes that have it. */
static void settle(const struct mentions *mentions)
{
	struct gltf *gltf = mentions->gltf;
	int next = 0;
	int i;

	for (i = 0; i < gltf->mesh_count; i++) {
		int of = gltf->level[i].of;
		bool is_level = of >= 0 && !mentions->refused[i] &&
			mentions->level[i] == mentions->mesh[i] &&
			gltf->level[of].count < LEVELS_MAX;

		if (is_level) {
			add_level(gltf->level, i);
			gltf->mesh_place[i] = -1;
		} else {
			gltf->level[i].of = -1;
			gltf->mesh_number[next] = i;
			gltf->mesh_place[i] = next++;
		}
	}
	for (i = 0; i < gltf->node_count; i++) {
		int mesh = mesh_of(
			mentions, json_array_get(mentions->nodes, (size_t)i));

		gltf->node_is_level[i] =
			gltf->node_is_level[i] && gltf->level[mesh].of >= 0;
	}
}

static int take_room(struct mentions *mentions, const struct gltf_at *at)
{
	struct gltf *gltf = mentions->gltf;
	int i;

	mentions->node = GLTF_SCRATCH(at, int, gltf->node_count);
	mentions->mesh = GLTF_SCRATCH(at, int, gltf->mesh_count);
	mentions->level = GLTF_SCRATCH(at, int, gltf->mesh_count);
	mentions->refused = GLTF_SCRATCH(at, bool, gltf->mesh_count);
	gltf->level = GLTF_SCRATCH(at, struct gltf_level, gltf->mesh_count);
	gltf->mesh_place = GLTF_SCRATCH(at, int, gltf->mesh_count);
	gltf->mesh_number = GLTF_SCRATCH(at, int, gltf->mesh_count);
	gltf->node_is_level = GLTF_SCRATCH(at, bool, gltf->node_count);
	if (!mentions->node || !mentions->mesh || !mentions->level ||
		!mentions->refused || !gltf->level || !gltf->mesh_place ||
		!gltf->mesh_number || !gltf->node_is_level) {
		return -ENOMEM;
	}
	for (i = 0; i < gltf->mesh_count; i++) {
		struct gltf_level *level = &gltf->level[i];

		level->of = level->first = level->next = -1;
	}
	return 0;
}

int gltf_find_levels(struct gltf *gltf)
{
	struct mentions mentions = {.gltf = gltf};
	struct gltf_at nodes, meshes;
	size_t i;
	json_t *node;
	int error =
		gltf_array(&gltf->root, "meshes", &meshes, &gltf->mesh_count);

	if (!error) {
		error = gltf_array(
			&gltf->root, "nodes", &nodes, &gltf->node_count);
	}
	if (!error) {
		error = take_room(&mentions, &nodes);
	}
	if (error) {
		return error;
	}
	mentions.nodes = nodes.json;
	mentions.meshes = meshes.json;
	collect(&mentions);
	json_array_foreach(nodes.json, i, node)
	{
		look_at_node(&mentions, node);
	}
	settle(&mentions);
	return 0;
}

static float largest_side(const struct model_mesh *mesh)
{
	float low[3] = {FLT_MAX, FLT_MAX, FLT_MAX};
	float high[3] = {-FLT_MAX, -FLT_MAX, -FLT_MAX};
	float largest = 0;
	int p, v, k;

	for (p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		for (v = 0; v < primitive->vertex_count; v++) {
			for (k = 0; k < 3; k++) {
				float at = primitive->position[v][k];

				low[k] = at < low[k] ? at : low[k];
				high[k] = at > high[k] ? at : high[k];
			}
		}
	}
	for (k = 0; k < 3; k++) {
		largest =
			high[k] - low[k] > largest ? high[k] - low[k] : largest;
	}
	return largest;
}

static float error_of(
	const struct gltf_level *level, const struct model_mesh *mesh)
{
	double side = (double)largest_side(mesh);

	return level->error_m > 0.0f
		? level->error_m
		: (float)(side / coverage_px / sqrt((double)level->coverage));
}

/* Where it belongs: the finest first, those for shapes last. */
static int place_of(const struct model_primitive *primitive,
	const struct model_lod *new_one)
{
	int place = primitive->lod_count;

	while (place > 0) {
		const struct model_lod *before = &primitive->lod[place - 1];

		if (before->shape == new_one->shape
				? before->error_m <= new_one->error_m
				: new_one->shape) {
			break;
		}
		place--;
	}
	return place;
}

static int read_level(const struct gltf_at *mesh, int count,
	struct model_primitive *primitive, struct model_lod *level)
{
	struct gltf_at array = gltf_member(mesh, "primitives");
	struct gltf_at at = gltf_element(&array, primitive->file_index);
	int place;
	int error = gltf_read_triangles(&at, primitive->vertex_count,
		&level->index, &level->index_count);

	if (!error && !primitive->lod) {
		primitive->lod = GLTF_KEEP(&at, struct model_lod, count);
		error = primitive->lod ? 0 : -ENOMEM;
	}
	if (error) {
		return error;
	}
	place = place_of(primitive, level);
	for (int i = primitive->lod_count++; i > place; i--) {
		primitive->lod[i] = primitive->lod[i - 1];
	}
	primitive->lod[place] = *level;
	return 0;
}

/* Of all primitives that are drawn. */
static int read_mesh_level(const struct gltf_at *at, int count,
	const struct gltf_level *level, struct model_mesh *mesh)
{
	struct model_lod lod = {
		.error_m = error_of(level, mesh),
		.shape = level->shape,
	};
	int error = 0;
	int i;

	for (i = 0; i < mesh->primitive_count && !error; i++) {
		error = read_level(at, count, &mesh->primitive[i], &lod);
	}
	return error;
}

int gltf_read_levels(struct gltf *gltf, int mesh)
{
	struct gltf_at array = gltf_member(&gltf->root, "meshes");
	struct model_mesh *out = &gltf->model->mesh[gltf->mesh_place[mesh]];
	int error = 0;
	int i;

	for (i = gltf->level[mesh].first; i >= 0 && !error;
		i = gltf->level[i].next) {
		struct gltf_at at = gltf_element(&array, i);

		error = read_mesh_level(
			&at, gltf->level[mesh].count, &gltf->level[i], out);
	}
	return error;
}

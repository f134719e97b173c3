#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <float.h>
#include <math.h>

enum {
	LEVELS_MAX = 16 /* per mesh */
};

/* What in the file refers to its nodes and meshes. */
struct references {
	struct gltf *gltf;
	const json_t *nodes, *meshes; /* arrays, or NULL */
	bool *node;    /* [node_count]: something other than MSFT_lod refers
			to it */
	int *mesh;     /* [mesh_count]: number of nodes that have the mesh */
	int *level;    /* [mesh_count]: how many of these nodes are levels */
	bool *refused; /* [mesh_count]: the mesh cannot be a level */
};

/* Returns the index that gltf_index() would read, or -1 if that would fail. */
static int valid_index(const json_t *number, int count)
{
	double value = json_is_number(number) ? json_number_value(number) : -1.0;

	return value >= 0.0 && value < (double)count && floor(value) == value
		? (int)value
		: -1;
}

static void note_reference(
	const struct references *references, const json_t *number)
{
	int node = valid_index(number, references->gltf->node_count);

	if (node >= 0) {
		references->node[node] = true;
	}
}

static void note_references(
	const struct references *references, const json_t *numbers)
{
	size_t i;
	json_t *number;

	json_array_foreach(numbers, i, number)
	{
		note_reference(references, number);
	}
}

/* Counts the node or nodes in a member of each element of a root array. */
static void note_member_references(const struct references *references,
	const char *array, const char *member)
{
	size_t i;
	json_t *element;

	json_array_foreach(
		json_object_get(references->gltf->json, array), i, element)
	{
		json_t *value = json_object_get(element, member);

		note_reference(references, value);
		note_references(references, value);
	}
}

static void note_channel_references(const struct references *references)
{
	size_t i, k;
	json_t *clip, *channel;

	json_array_foreach(
		json_object_get(references->gltf->json, "animations"), i, clip)
	{
		json_array_foreach(json_object_get(clip, "channels"), k, channel)
		{
			note_reference(references,
				json_object_get(
					json_object_get(channel, "target"),
					"node"));
		}
	}
}

static int mesh_of(const struct references *references, const json_t *node)
{
	return valid_index(
		json_object_get(node, "mesh"), references->gltf->mesh_count);
}

static void count_all(const struct references *references)
{
	size_t i;
	json_t *node;

	note_member_references(references, "nodes", "children");
	note_member_references(references, "scenes", "nodes");
	note_member_references(references, "skins", "joints");
	note_member_references(references, "skins", "skeleton");
	note_channel_references(references);
	json_array_foreach(references->nodes, i, node)
	{
		int mesh = mesh_of(references, node);

		if (mesh >= 0) {
			references->mesh[mesh]++;
		}
	}
}

static const json_t *levels_of(const json_t *node)
{
	return json_object_get(
		json_object_get(json_object_get(node, "extensions"), "MSFT_lod"),
		"ids");
}

static bool members_equal(
	const json_t *a, const json_t *b, const char *const *keys)
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

/* Whether both meshes differ only in their lists of indices. */
static bool have_same_vertices(const json_t *mesh, const json_t *other)
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

		if (!members_equal(from, to, keys) ||
			!json_object_get(to, "indices")) {
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

/* Reads how coarse a level is. Returns false if the file does not state it. */
static bool read_coarseness(const json_t *node, size_t level,
	const json_t *other, struct gltf_level *out)
{
	const json_t *extras = json_object_get(other, "extras");
	const json_t *coverage = json_object_get(
		json_object_get(node, "extras"), "MSFT_screencoverage");

	out->error_m = positive(json_object_get(extras, "error_m"));
	out->coverage = positive(json_array_get(coverage, level));
	out->shadow_only = json_is_true(json_object_get(extras, "shape"));
	return out->error_m > 0.0f || out->coverage > 0.0f;
}

/*
 * Whether the node with this number in the file can be a level of node, whose
 * mesh is given too.
 */
static bool can_replace(const struct references *references, const json_t *node,
	int number, int mesh)
{
	static const char *const keys[] = {
		"translation", "rotation", "scale", "matrix", "skin", NULL};
	const json_t *other = json_array_get(references->nodes, (size_t)number);
	int level = mesh_of(references, other);

	return !references->node[number] && level >= 0 && level != mesh &&
		!json_object_get(other, "children") &&
		!json_object_get(other, "camera") && !levels_of(other) &&
		members_equal(node, other, keys);
}

/*
 * Whether the node with this number is a level of node. Each mesh is compared
 * only once, even if several nodes have it.
 */
static bool is_level(const struct references *references, const json_t *node,
	size_t position, int number, int mesh)
{
	struct gltf *gltf = references->gltf;
	const json_t *other = json_array_get(references->nodes, (size_t)number);
	int level = mesh_of(references, other);

	if (!can_replace(references, node, number, mesh) ||
		references->refused[level]) {
		return false;
	}
	if (gltf->level[level].of < 0 &&
		read_coarseness(node, position, other, &gltf->level[level]) &&
		have_same_vertices(
			json_array_get(references->meshes, (size_t)mesh),
			json_array_get(references->meshes, (size_t)level))) {
		gltf->level[level].of = mesh;
	}
	references->refused[level] = gltf->level[level].of != mesh;
	return !references->refused[level];
}

static void find_node_levels(
	const struct references *references, const json_t *node)
{
	struct gltf *gltf = references->gltf;
	int mesh = mesh_of(references, node);
	size_t i;
	json_t *id;

	json_array_foreach(mesh >= 0 ? levels_of(node) : NULL, i, id)
	{
		int number = valid_index(id, gltf->node_count);

		/* Limits the time for a very long list. */
		if (i >= LEVELS_MAX) {
			break;
		}
		if (number < 0 || gltf->node_is_level[number]) {
			continue;
		}
		if (is_level(references, node, i, number, mesh)) {
			const json_t *level = json_array_get(
				references->nodes, (size_t)number);

			gltf->node_is_level[number] = true;
			references->level[mesh_of(references, level)]++;
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

/*
 * Accepts a mesh as a level only if all nodes with it are levels, and a node
 * only if its mesh is accepted. Numbers the other meshes.
 */
static void accept_levels(const struct references *references)
{
	struct gltf *gltf = references->gltf;
	int next = 0;
	int i;

	for (i = 0; i < gltf->mesh_count; i++) {
		int of = gltf->level[i].of;
		bool is_level = of >= 0 && !references->refused[i] &&
			references->level[i] == references->mesh[i] &&
			gltf->level[of].count < LEVELS_MAX;

		if (is_level) {
			add_level(gltf->level, i);
			gltf->mesh_index[i] = -1;
		} else {
			gltf->level[i].of = -1;
			gltf->mesh_file_index[next] = i;
			gltf->mesh_index[i] = next++;
		}
	}
	for (i = 0; i < gltf->node_count; i++) {
		int mesh = mesh_of(references,
			json_array_get(references->nodes, (size_t)i));

		gltf->node_is_level[i] =
			gltf->node_is_level[i] && gltf->level[mesh].of >= 0;
	}
}

static int allocate(struct references *references, const struct gltf_at *at)
{
	struct gltf *gltf = references->gltf;
	int i;

	references->node = GLTF_SCRATCH(at, bool, gltf->node_count);
	references->mesh = GLTF_SCRATCH(at, int, gltf->mesh_count);
	references->level = GLTF_SCRATCH(at, int, gltf->mesh_count);
	references->refused = GLTF_SCRATCH(at, bool, gltf->mesh_count);
	gltf->level = GLTF_SCRATCH(at, struct gltf_level, gltf->mesh_count);
	gltf->mesh_index = GLTF_SCRATCH(at, int, gltf->mesh_count);
	gltf->mesh_file_index = GLTF_SCRATCH(at, int, gltf->mesh_count);
	gltf->node_is_level = GLTF_SCRATCH(at, bool, gltf->node_count);
	if (!references->node || !references->mesh || !references->level ||
		!references->refused || !gltf->level || !gltf->mesh_index ||
		!gltf->mesh_file_index || !gltf->node_is_level) {
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
	struct references references = {.gltf = gltf};
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
		error = allocate(&references, &nodes);
	}
	if (error) {
		return error;
	}
	references.nodes = nodes.json;
	references.meshes = meshes.json;
	count_all(&references);
	json_array_foreach(nodes.json, i, node)
	{
		find_node_levels(&references, node);
	}
	accept_levels(&references);
	return 0;
}

#include "app/compare/optimize/optimize_prune.h"

#include "app/compare/optimize/optimize_refs.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* The elements in use, and those still to be searched for references. */
struct marks {
	json_t *root;
	int count[OPTIMIZE_PARTS];
	bool *used[OPTIMIZE_PARTS];
	int *number[OPTIMIZE_PARTS]; /* the new index */
	int *parent;                 /* of each node: its index + 1, or 0 */
	int pending;
	struct pending {
		enum optimize_part part;
		int index;
	} * stack; /* room for each element once */
};

static json_t *elements(const struct marks *marks, int part)
{
	return json_object_get(marks->root, optimize_part_name[part]);
}

static int mark(void *context, enum optimize_part part, int index)
{
	struct marks *marks = context;

	if (index >= 0 && index < marks->count[part] &&
		!marks->used[part][index]) {
		marks->used[part][index] = true;
		marks->stack[marks->pending++] = (struct pending){part, index};
	}
	return index;
}

static void search(struct marks *marks)
{
	while (marks->pending > 0) {
		struct pending next = marks->stack[--marks->pending];
		json_t *element = json_array_get(
			elements(marks, (int)next.part), (size_t)next.index);

		if (next.part == OPTIMIZE_NODES) {
			mark(marks, OPTIMIZE_NODES,
				marks->parent[next.index] - 1);
		}
		optimize_refs_of(next.part, element, mark, marks);
	}
}

static int allocate(struct marks *marks)
{
	int total = 0;

	for (int part = 0; part < OPTIMIZE_PARTS; part++) {
		int count = (int)json_array_size(elements(marks, part));

		marks->count[part] = count;
		marks->used[part] = calloc((size_t)count + 1, sizeof(bool));
		marks->number[part] = calloc((size_t)count + 1, sizeof(int));
		if (!marks->used[part] || !marks->number[part]) {
			return -ENOMEM;
		}
		total += count;
	}
	marks->parent =
		calloc((size_t)marks->count[OPTIMIZE_NODES] + 1, sizeof(int));
	marks->stack = malloc(((size_t)total + 1) * sizeof(*marks->stack));
	return marks->parent && marks->stack ? 0 : -ENOMEM;
}

static void find_parents(struct marks *marks)
{
	json_t *node, *child;
	size_t i, k;

	json_array_foreach(elements(marks, OPTIMIZE_NODES), i, node)
	{
		json_array_foreach(json_object_get(node, "children"), k, child)
		{
			json_int_t index = json_integer_value(child);

			if (index >= 0 && index < marks->count[OPTIMIZE_NODES]) {
				marks->parent[index] = (int)i + 1;
			}
		}
	}
}

static int node_of(const struct marks *marks, const json_t *channel)
{
	json_t *node =
		json_object_get(json_object_get(channel, "target"), "node");
	json_int_t index = json_is_integer(node) ? json_integer_value(node) : -1;

	return index >= 0 && index < marks->count[OPTIMIZE_NODES] ? (int)index
								  : -1;
}

/* Returns the time of a channel's last key, or 0 if the file does not say it. */
static double end_of(const struct marks *marks, const json_t *animation,
	const json_t *channel)
{
	json_t *sampler = json_array_get(json_object_get(animation, "samplers"),
		(size_t)json_integer_value(json_object_get(channel, "sampler")));
	json_t *accessor = json_array_get(
		json_object_get(marks->root, "accessors"),
		(size_t)json_integer_value(json_object_get(sampler, "input")));

	return json_number_value(
		json_array_get(json_object_get(accessor, "max"), 0));
}

/*
 * Marks the node of a clip's last channel if the clip, without the channels of
 * unused nodes, would end earlier or vanish: then other clips would get its
 * number, by which people name clips too.
 */
static void mark_last_channel(struct marks *marks, const json_t *animation)
{
	double used_end_s = -1.0, end_s = -1.0;
	int last = -1;
	json_t *channel;
	size_t i;

	json_array_foreach(json_object_get(animation, "channels"), i, channel)
	{
		double at_s = end_of(marks, animation, channel);
		int node = node_of(marks, channel);

		if (node < 0) {
			continue;
		}
		if (marks->used[OPTIMIZE_NODES][node] && at_s > used_end_s) {
			used_end_s = at_s;
		}
		if (at_s > end_s) {
			end_s = at_s;
			last = node;
		}
	}
	if (end_s > used_end_s) {
		mark(marks, OPTIMIZE_NODES, last);
		search(marks);
	}
}

static void mark_all(struct marks *marks)
{
	json_t *scenes = elements(marks, OPTIMIZE_SCENES);
	json_t *scene, *node, *animation;
	size_t i;

	json_array_foreach(scenes, i, scene)
	{
		optimize_refs_of(OPTIMIZE_SCENES, scene, mark, marks);
	}
	json_array_foreach(elements(marks, OPTIMIZE_NODES), i, node)
	{
		if (!json_array_size(scenes) || json_object_get(node, "camera")) {
			mark(marks, OPTIMIZE_NODES, (int)i);
		}
	}
	search(marks);
	json_array_foreach(
		json_object_get(marks->root, "animations"), i, animation)
	{
		mark_last_channel(marks, animation);
	}
}

static int new_number(void *context, enum optimize_part part, int index)
{
	const struct marks *marks = context;

	return index >= 0 && index < marks->count[part]
		? marks->number[part][index]
		: index;
}

static void remove_unused(struct marks *marks, int part)
{
	json_t *array = elements(marks, part);
	int kept = 0;

	for (int i = 0; i < marks->count[part]; i++) {
		marks->number[part][i] = kept;
		kept += marks->used[part][i];
	}
	for (int i = marks->count[part]; i-- > 0;) {
		if (!marks->used[part][i]) {
			json_array_remove(array, (size_t)i);
		}
	}
	if (array && kept == 0) {
		json_object_del(marks->root, optimize_part_name[part]);
	}
}

/* Removes channels without a node or of a removed one; renumbers the others. */
static void prune_channels(const struct marks *marks, json_t *animation)
{
	json_t *channels = json_object_get(animation, "channels");

	for (size_t i = json_array_size(channels); i-- > 0;) {
		json_t *channel = json_array_get(channels, i);
		int index = node_of(marks, channel);

		if (index < 0 || !marks->used[OPTIMIZE_NODES][index]) {
			json_array_remove(channels, i);
		} else {
			json_object_set_new(json_object_get(channel, "target"),
				"node",
				json_integer(
					marks->number[OPTIMIZE_NODES][index]));
		}
	}
}

/* A sampler's accessor of numbers; *index is its number. NULL: it has none. */
static const json_t *numbers_of(const struct marks *marks,
	const json_t *sampler, const char *key, json_int_t *index)
{
	const json_t *number = json_object_get(sampler, key);
	const json_t *accessors = json_object_get(marks->root, "accessors");
	const json_t *accessor;
	const char *type;

	*index = json_integer_value(number);
	accessor = json_is_integer(number) && *index >= 0
		? json_array_get(accessors, (size_t)*index)
		: NULL;
	type = json_string_value(json_object_get(accessor, "type"));
	return type && strcmp(type, "SCALAR") == 0 ? accessor : NULL;
}

/*
 * Gives a clip that moves no node a channel without a node, which players
 * ignore, so that the clips after it keep their numbers: glTF has no clip
 * without channels. Its values are numbers of its first sampler, or times.
 * Returns false if there is no such sampler.
 */
static bool keep_still_clip(const struct marks *marks, json_t *animation)
{
	const json_t *sampler =
		json_array_get(json_object_get(animation, "samplers"), 0);
	json_int_t input, output;
	const json_t *times = numbers_of(marks, sampler, "input", &input);
	const json_t *values = numbers_of(marks, sampler, "output", &output);

	if (!times) {
		return false;
	}
	if (!values ||
		!json_equal(json_object_get(values, "count"),
			json_object_get(times, "count"))) {
		output = input;
	}
	json_object_set_new(animation, "samplers",
		json_pack("[{s:i, s:i}]", "input", (int)input, "output",
			(int)output));
	json_object_set_new(animation, "channels",
		json_pack("[{s:i, s:{s:s}}]", "sampler", 0, "target", "path",
			"weights"));
	return true;
}

static void prune_animations(const struct marks *marks)
{
	json_t *animations = json_object_get(marks->root, "animations");

	for (size_t i = json_array_size(animations); i-- > 0;) {
		json_t *animation = json_array_get(animations, i);

		prune_channels(marks, animation);
		if (json_array_size(json_object_get(animation, "channels")) == 0 &&
			!keep_still_clip(marks, animation)) {
			json_array_remove(animations, i);
		}
	}
	if (json_array_size(animations) == 0) {
		json_object_del(marks->root, "animations");
	}
}

static void renumber(struct marks *marks)
{
	json_t *element;
	size_t i;

	for (int part = 0; part < OPTIMIZE_PARTS; part++) {
		remove_unused(marks, part);
	}
	for (int part = 0; part <= OPTIMIZE_PARTS; part++) {
		json_array_foreach(elements(marks, part), i, element)
		{
			optimize_refs_of((enum optimize_part)part, element,
				new_number, marks);
		}
	}
	prune_animations(marks);
}

/*
 * Sets bit n for each TEXCOORD_n that textures in the object use, and *normals
 * if there is a normal texture. The recursion is bounded: jansson reads at most
 * 2048 levels of objects.
 */
static void find_sets(const json_t *object, unsigned int *sets, bool *normals)
{
	const char *key;
	json_t *value;

	json_object_foreach((json_t *)object, key, value)
	{
		json_t *transform, *set;

		if (!json_is_object(value)) {
			continue;
		}
		if (!optimize_ends_with(key, "Texture")) {
			find_sets(value, sets, normals);
			continue;
		}
		transform = json_object_get(json_object_get(value, "extensions"),
			"KHR_texture_transform");
		set = json_object_get(value, "texCoord");
		*sets |= 1u << (json_integer_value(set) & 31);
		set = json_object_get(transform, "texCoord");
		*sets |= 1u << (json_integer_value(set) & 31);
		*normals = *normals || optimize_ends_with(key, "ormalTexture");
	}
}

struct coordinates {
	json_t *materials;
	unsigned int sets;
	bool normals;
};

static int add_material(void *context, enum optimize_part part, int index)
{
	struct coordinates *found = context;

	(void)part;
	find_sets(json_array_get(found->materials, (size_t)index), &found->sets,
		&found->normals);
	return index;
}

/* Whether name is a TEXCOORD_n whose bit is not in sets. */
static bool is_unread_set(const char *name, unsigned int sets)
{
	static const char prefix[] = "TEXCOORD_";
	unsigned long set;

	if (strncmp(name, prefix, sizeof(prefix) - 1) != 0) {
		return false;
	}
	set = strtoul(name + sizeof(prefix) - 1, NULL, 10);
	return set > 31 || !(sets & 1u << set);
}

/* TEXCOORD_0 stays: live pictures need it even without any texture. */
static void prune_attributes(json_t *attributes, unsigned int sets, bool normals)
{
	const char *key;
	json_t *value;
	void *next;

	json_object_foreach_safe(attributes, next, key, value)
	{
		if ((!normals && strcmp(key, "TANGENT") == 0) ||
			is_unread_set(key, sets)) {
			json_object_del(attributes, key);
		}
	}
}

/*
 * Removes unused vertex attributes. All primitives keep what any material
 * needs, because levels of detail must have the attributes of the full mesh.
 */
static void prune_vertices(json_t *root)
{
	struct coordinates found = {
		json_object_get(root, "materials"), 1, false};
	json_t *meshes = json_object_get(root, "meshes");
	json_t *mesh, *primitive, *target;
	size_t i, p, t;

	json_array_foreach(meshes, i, mesh)
	{
		optimize_refs_of(OPTIMIZE_MESHES, mesh, add_material, &found);
	}
	json_array_foreach(meshes, i, mesh)
	{
		json_array_foreach(
			json_object_get(mesh, "primitives"), p, primitive)
		{
			json_t *targets = json_object_get(primitive, "targets");

			prune_attributes(
				json_object_get(primitive, "attributes"),
				found.sets, found.normals);
			json_array_foreach(targets, t, target)
			{
				prune_attributes(
					target, found.sets, found.normals);
			}
		}
	}
}

int optimize_prune(json_t *root)
{
	struct marks marks = {.root = root};
	int error = allocate(&marks);

	if (!error) {
		find_parents(&marks);
		mark_all(&marks);
		renumber(&marks);
		prune_vertices(root);
	}
	for (int part = 0; part < OPTIMIZE_PARTS; part++) {
		free(marks.used[part]);
		free(marks.number[part]);
	}
	free(marks.parent);
	free(marks.stack);
	return error;
}

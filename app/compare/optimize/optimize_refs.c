#include "app/compare/optimize/optimize_refs.h"

#include "platform/base/compiler.h"

#include <stdlib.h>
#include <string.h>

const char *const optimize_part_name[OPTIMIZE_PARTS + 1] = {
	[OPTIMIZE_NODES] = "nodes",
	[OPTIMIZE_MESHES] = "meshes",
	[OPTIMIZE_SKINS] = "skins",
	[OPTIMIZE_CAMERAS] = "cameras",
	[OPTIMIZE_MATERIALS] = "materials",
	[OPTIMIZE_TEXTURES] = "textures",
	[OPTIMIZE_IMAGES] = "images",
	[OPTIMIZE_SAMPLERS] = "samplers",
	[OPTIMIZE_SCENES] = "scenes",
};

struct walk {
	optimize_ref ref;
	void *context;
};

bool optimize_ends_with(const char *string, const char *end)
{
	size_t length = strlen(string), tail = strlen(end);

	return length >= tail && strcmp(string + length - tail, end) == 0;
}

static void member(const struct walk *walk, json_t *object, const char *key,
	enum optimize_part part)
{
	json_t *value = json_object_get(object, key);

	if (json_is_integer(value)) {
		int index = (int)json_integer_value(value);

		json_object_set_new(object, key,
			json_integer(walk->ref(walk->context, part, index)));
	}
}

static void list(const struct walk *walk, json_t *array, enum optimize_part part)
{
	for (size_t i = 0; i < json_array_size(array); i++) {
		int index = (int)json_integer_value(json_array_get(array, i));

		json_array_set_new(array, i,
			json_integer(walk->ref(walk->context, part, index)));
	}
}

static json_t *extension(const json_t *object, const char *name)
{
	return json_object_get(json_object_get(object, "extensions"), name);
}

static void node_refs(const struct walk *walk, json_t *node)
{
	member(walk, node, "mesh", OPTIMIZE_MESHES);
	member(walk, node, "skin", OPTIMIZE_SKINS);
	member(walk, node, "camera", OPTIMIZE_CAMERAS);
	list(walk, json_object_get(node, "children"), OPTIMIZE_NODES);
	list(walk, json_object_get(extension(node, "MSFT_lod"), "ids"),
		OPTIMIZE_NODES);
}

static void mesh_refs(const struct walk *walk, json_t *mesh)
{
	json_t *primitive, *mapping;
	size_t i, k;

	json_array_foreach(json_object_get(mesh, "primitives"), i, primitive)
	{
		json_t *mappings = json_object_get(
			extension(primitive, "KHR_materials_variants"),
			"mappings");

		member(walk, primitive, "material", OPTIMIZE_MATERIALS);
		json_array_foreach(mappings, k, mapping)
		{
			member(walk, mapping, "material", OPTIMIZE_MATERIALS);
		}
	}
}

/*
 * Objects named "...Texture" refer to textures, also in extensions. The
 * recursion is bounded: jansson reads at most 2048 levels of objects.
 */
static void texture_refs(const struct walk *walk, json_t *object)
{
	const char *key;
	json_t *value;

	json_object_foreach(object, key, value)
	{
		if (!json_is_object(value) || strcmp(key, "extras") == 0) {
			continue;
		}
		if (optimize_ends_with(key, "Texture")) {
			member(walk, value, "index", OPTIMIZE_TEXTURES);
		} else {
			texture_refs(walk, value);
		}
	}
}

static void image_refs(const struct walk *walk, json_t *texture)
{
	const char *key;
	json_t *value;

	member(walk, texture, "source", OPTIMIZE_IMAGES);
	member(walk, texture, "sampler", OPTIMIZE_SAMPLERS);
	json_object_foreach(json_object_get(texture, "extensions"), key, value)
	{
		member(walk, value, "source", OPTIMIZE_IMAGES);
	}
}

void optimize_refs_of(enum optimize_part part, json_t *element,
	optimize_ref ref, void *context)
{
	const struct walk walk = {ref, context};

	switch (part) {
	case OPTIMIZE_NODES:
		node_refs(&walk, element);
		break;
	case OPTIMIZE_MESHES:
		mesh_refs(&walk, element);
		break;
	case OPTIMIZE_SKINS:
		list(&walk, json_object_get(element, "joints"), OPTIMIZE_NODES);
		member(&walk, element, "skeleton", OPTIMIZE_NODES);
		break;
	case OPTIMIZE_MATERIALS:
		texture_refs(&walk, element);
		list(&walk,
			json_object_get(extension(element, "MSFT_lod"), "ids"),
			OPTIMIZE_MATERIALS);
		break;
	case OPTIMIZE_TEXTURES:
		image_refs(&walk, element);
		break;
	case OPTIMIZE_SCENES:
		list(&walk, json_object_get(element, "nodes"), OPTIMIZE_NODES);
		break;
	default:
		break;
	}
}

/* Whether an extension has no references, or only those handled above. */
static bool is_known(const char *name)
{
	static const char *const known[] = {
		"EXT_mesh_gpu_instancing",
		"EXT_texture_avif",
		"EXT_texture_webp",
		"KHR_lights_punctual",
		"KHR_mesh_quantization",
		"KHR_node_visibility",
		"KHR_texture_basisu",
		"KHR_texture_transform",
		"KHR_xmp_json_ld",
		"MSFT_lod",
	};
	static const char materials[] = "KHR_materials_";

	for (size_t i = 0; i < ARRAY_COUNT(known); i++) {
		if (strcmp(known[i], name) == 0) {
			return true;
		}
	}
	return strncmp(name, materials, sizeof(materials) - 1) == 0;
}

static void strip_object(json_t *extensions)
{
	const char *key;
	json_t *value;
	void *next;

	json_object_foreach_safe(extensions, next, key, value)
	{
		if (!is_known(key)) {
			json_object_del(extensions, key);
		}
	}
}

/* Recursive: the JSON reader limits how deep values are nested. */
static void strip_value(json_t *value)
{
	json_t *extensions = json_object_get(value, "extensions");
	const char *key;
	json_t *inner;
	size_t i;

	if (extensions) {
		strip_object(extensions);
		if (json_object_size(extensions) == 0) {
			json_object_del(value, "extensions");
		}
	}
	json_object_foreach(value, key, inner)
	{
		if (strcmp(key, "extras") != 0) {
			strip_value(inner);
		}
	}
	json_array_foreach(value, i, inner)
	{
		strip_value(inner);
	}
}

void optimize_strip_extensions(json_t *root,
	void (*removed)(void *context, const char *name), void *context)
{
	json_t *used = json_object_get(root, "extensionsUsed");

	strip_value(root);
	for (size_t i = json_array_size(used); i-- > 0;) {
		const char *name = json_string_value(json_array_get(used, i));

		if (!name || !is_known(name)) {
			if (name) {
				removed(context, name);
			}
			json_array_remove(used, i);
		}
	}
	if (used && json_array_size(used) == 0) {
		json_object_del(root, "extensionsUsed");
	}
}

static bool is_needed(const json_t *node, const char *named)
{
	static const char *const members[] = {
		"mesh", "camera", "extensions", "extras"};
	const char *name = json_string_value(json_object_get(node, "name"));

	for (size_t i = 0; i < ARRAY_COUNT(members); i++) {
		if (json_object_get(node, members[i])) {
			return true;
		}
	}
	return name && *name && named && strstr(named, name);
}

bool *optimize_find_needed(const json_t *root, const char *named)
{
	const json_t *nodes = json_object_get(root, "nodes");
	bool *needed = calloc(json_array_size(nodes) + 1, sizeof(*needed));

	for (size_t i = 0; needed && i < json_array_size(nodes); i++) {
		needed[i] = is_needed(json_array_get(nodes, i), named);
	}
	return needed;
}

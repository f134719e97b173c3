#include "app/compare/optimize/optimize_sizes.h"

#include <errno.h>
#include <stdlib.h>

struct counter {
	const struct gltf_document *document;
	bool *counted; /* [accessors] */
	struct optimize_sizes *sizes;
};

/* Adds an accessor's bytes once, to the first use that is found. */
static void count(struct counter *counter, const json_t *value, size_t *bytes)
{
	json_int_t index =
		json_is_integer(value) ? json_integer_value(value) : -1;

	if (index >= 0 && index < gltf_document_array_count(counter->document) &&
		!counter->counted[index]) {
		counter->counted[index] = true;
		*bytes +=
			gltf_document_array(counter->document, (int)index).bytes;
	}
}

static void count_all(struct counter *counter, json_t *object, size_t *bytes)
{
	const char *key;
	json_t *value;

	json_object_foreach(object, key, value)
	{
		count(counter, value, bytes);
	}
}

static void count_mesh(struct counter *counter, const json_t *mesh)
{
	struct optimize_sizes *sizes = counter->sizes;
	json_t *primitive, *target;
	size_t p, t;

	json_array_foreach(json_object_get(mesh, "primitives"), p, primitive)
	{
		count_all(counter, json_object_get(primitive, "attributes"),
			&sizes->vertices);
		json_array_foreach(
			json_object_get(primitive, "targets"), t, target)
		{
			count_all(counter, target, &sizes->vertices);
		}
		count(counter, json_object_get(primitive, "indices"),
			&sizes->indices);
	}
}

static void count_animation(struct counter *counter, const json_t *animation)
{
	struct optimize_sizes *sizes = counter->sizes;
	json_t *samplers = json_object_get(animation, "samplers");
	json_t *channel;
	size_t i;

	json_array_foreach(json_object_get(animation, "channels"), i, channel)
	{
		const json_t *sampler = json_array_get(samplers,
			(size_t)json_integer_value(
				json_object_get(channel, "sampler")));
		const json_t *input = json_object_get(sampler, "input");
		json_int_t times =
			json_is_integer(input) ? json_integer_value(input) : -1;

		count(counter, input, &sizes->keys);
		count(counter, json_object_get(sampler, "output"), &sizes->keys);
		if (times >= 0 &&
			times < gltf_document_array_count(counter->document)) {
			sizes->key_count += gltf_document_array(
				counter->document, (int)times)
						    .count;
		}
	}
}

int optimize_sizes_of(
	const struct gltf_document *document, struct optimize_sizes *out)
{
	json_t *root = gltf_document_json(document);
	struct counter counter = {.document = document,
		.counted =
			calloc((size_t)gltf_document_array_count(document) + 1,
				sizeof(bool)),
		.sizes = out};
	json_t *item;
	size_t i, known;

	*out = (struct optimize_sizes){.file = gltf_document_bytes(document)};
	if (!counter.counted) {
		return -ENOMEM;
	}
	json_array_foreach(json_object_get(root, "animations"), i, item)
	{
		count_animation(&counter, item);
	}
	json_array_foreach(json_object_get(root, "meshes"), i, item)
	{
		count_mesh(&counter, item);
	}
	known = out->keys + out->vertices + out->indices;
	out->rest = out->file > known ? out->file - known : 0;
	free(counter.counted);
	return 0;
}

#include "app/compare/optimize/build/optimize_keys.h"

#include "app/model/clip/key_times.h"
#include "platform/base/compiler.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const char *const optimize_path_name[4] = {
	[MODEL_TRANSLATION] = "translation",
	[MODEL_ROTATION] = "rotation",
	[MODEL_SCALE] = "scale",
	[MODEL_WEIGHTS] = "weights",
};

const char *const optimize_interpolation_name[3] = {
	[MODEL_STEP] = "STEP",
	[MODEL_LINEAR] = "LINEAR",
	[MODEL_CUBICSPLINE] = "CUBICSPLINE",
};

static int find_name(
	const json_t *value, const char *const *names, int count, int otherwise)
{
	const char *name = json_string_value(value);

	for (int i = 0; name && i < count; i++) {
		if (strcmp(names[i], name) == 0) {
			return i;
		}
	}
	return otherwise;
}

static float unit_of(const struct gltf_document_array *array)
{
	switch (array->normalized ? array->component : GLB_FLOAT) {
	case GLB_BYTE:
		return 127.0f;
	case GLB_UBYTE:
		return 255.0f;
	case GLB_SHORT:
		return 32767.0f;
	case GLB_USHORT:
		return 65535.0f;
	default:
		return 1.0f;
	}
}

static int read_values(struct optimize_keys *keys,
	struct optimize_channel *channel, int input, int output, int key_count)
{
	const struct gltf_document *document = keys->build->document;
	size_t count;
	int error;

	channel->output = gltf_document_array(document, output);
	channel->unit = unit_of(&channel->output);
	count = (size_t)channel->output.count * (size_t)channel->output.width;
	channel->time_s = malloc((size_t)key_count * sizeof(*channel->time_s));
	channel->value = malloc(count * sizeof(*channel->value));
	if (!channel->time_s || !channel->value) {
		return -ENOMEM;
	}
	error = gltf_document_floats(document, input, channel->time_s);
	if (!error) {
		error = gltf_document_floats(document, output, channel->value);
	}
	for (size_t i = 0; !error && i < count; i++) {
		float value = channel->value[i] / channel->unit;

		channel->value[i] =
			value < -1.0f && channel->unit > 1.0f ? -1.0f : value;
	}
	return error;
}

/* Leaves out the keys that no moment shows, as the loader does. */
static void take_keys(struct optimize_channel *channel, int count)
{
	struct optimize_track *track = &channel->track;
	int first = key_times_separate(channel->time_s, count).first;
	int key_width = channel->output.count * channel->output.width / count;

	track->key_count = count - first;
	track->width = track->interpolation == MODEL_CUBICSPLINE ? key_width / 3
								 : key_width;
	memmove(channel->time_s, channel->time_s + first,
		(size_t)track->key_count * sizeof(*channel->time_s));
	memmove(channel->value,
		channel->value + (size_t)first * (size_t)key_width,
		(size_t)track->key_count * (size_t)key_width *
			sizeof(*channel->value));
	track->time_s = channel->time_s;
	track->value = channel->value;
}

static int read_channel(struct optimize_keys *keys, const json_t *json,
	struct optimize_channel *out)
{
	const struct optimize_build *build = keys->build;
	const json_t *sampler = json_array_get(
		json_object_get(keys->json, "samplers"),
		(size_t)json_integer_value(json_object_get(json, "sampler")));
	int input = optimize_build_member(build, sampler, "input");
	int output = optimize_build_member(build, sampler, "output");
	struct optimize_track *track = &out->track;
	json_int_t node;
	int key_count, error;

	out->target = json_object_get(json, "target");
	if (input < 0 || output < 0) {
		return -EINVAL;
	}
	track->path = (enum model_path)find_name(
		json_object_get(out->target, "path"), optimize_path_name,
		ARRAY_COUNT(optimize_path_name), MODEL_WEIGHTS);
	track->interpolation = (enum model_interpolation)find_name(
		json_object_get(sampler, "interpolation"),
		optimize_interpolation_name,
		ARRAY_COUNT(optimize_interpolation_name), MODEL_LINEAR);
	key_count = gltf_document_array(build->document, input).count;
	error = read_values(keys, out, input, output, key_count);
	if (error) {
		return error;
	}
	take_keys(out, key_count);
	/* A clip that moves nothing has weights without a node: as of node 0. */
	node = json_integer_value(json_object_get(out->target, "node"));
	if (build->reach && node >= 0 && node < build->reach->node_count) {
		track->reach = &build->reach->node[node];
	}
	track->bound_px = keys->bound_px;
	return 0;
}

void optimize_keys_release(struct optimize_keys *keys)
{
	for (int i = 0; i < keys->count; i++) {
		free(keys->channel[i].time_s);
		free(keys->channel[i].value);
		free(keys->channel[i].kept);
	}
	free(keys->channel);
	free(keys->bucket);
}

static int read_channels(struct optimize_keys *keys)
{
	json_t *channels = json_object_get(keys->json, "channels");
	size_t count = json_array_size(channels);
	int error = 0;

	keys->channel = calloc(count + 1, sizeof(*keys->channel));
	keys->bucket = calloc(count + 1, sizeof(*keys->bucket));
	if (!keys->channel || !keys->bucket) {
		return -ENOMEM;
	}
	for (size_t i = 0; i < count && !error; i++) {
		struct optimize_channel *channel = &keys->channel[keys->count++];
		float end_s;

		channel->number = (int)i;
		error = read_channel(keys, json_array_get(channels, i), channel);
		if (!error) {
			end_s = channel->time_s[channel->track.key_count - 1];
			keys->end_s = end_s > keys->end_s ? end_s : keys->end_s;
		}
	}
	return error;
}

int optimize_keys_read(struct optimize_build *build, json_t *animation,
	size_t index, struct optimize_keys *keys)
{
	const float *key_px = build->plan->key_px;

	*keys = (struct optimize_keys){
		.build = build,
		.json = animation,
		.bound_px = key_px ? key_px[index] : 0.0f,
	};
	return read_channels(keys);
}

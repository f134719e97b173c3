#include "app/model/clip/key_times.h"
#include "app/model/gltf/gltf_internal.h"
#include "app/model/origin/model_origin.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	KEY_BLOCK_BYTES = 256 /* most channels have a few keys */
};

struct sampler {
	const struct gltf_accessor *input, *output;
	enum model_interpolation interpolation;
};

/* The state of reading one animation. */
struct animation_reader {
	struct gltf_at samplers;
	int sampler_count;
	int number;        /* number of this animation, from 1 */
	int pointer_count; /* channels of KHR_animation_pointer in this
			      animation */
	int (*seen)[4];    /* [node_count][path]: number of the last animation
			      that has such a channel */
};

static int read_path(const struct gltf_at *target, enum model_path *out)
{
	static const char *const names[] = {
		[MODEL_TRANSLATION] = "translation",
		[MODEL_ROTATION] = "rotation",
		[MODEL_SCALE] = "scale",
		[MODEL_WEIGHTS] = "weights",
	};
	int choice = 0;
	int error = gltf_require(target, "path");

	if (!error) {
		error = gltf_maybe_choice(
			target, "path", names, ARRAY_COUNT(names), &choice);
	}
	*out = (enum model_path)choice;
	return error;
}

static int read_interpolation(
	const struct gltf_at *at, enum model_interpolation *out)
{
	static const char *const names[] = {
		[MODEL_STEP] = "STEP",
		[MODEL_LINEAR] = "LINEAR",
		[MODEL_CUBICSPLINE] = "CUBICSPLINE",
	};
	int choice = MODEL_LINEAR;
	int error = gltf_maybe_choice(
		at, "interpolation", names, ARRAY_COUNT(names), &choice);

	*out = (enum model_interpolation)choice;
	return error;
}

/* Separates keys of equal time. glTF has no keys before 0; Blender writes them. */
static int check_times(const struct gltf_at *at, float *time_s, int count)
{
	struct key_times keys = key_times_separate(time_s, count);

	if (keys.wrong) {
		return gltf_fail(at, -EINVAL,
			"key %d at %g s is earlier than key %d at %g s",
			keys.wrong, (double)time_s[keys.wrong], keys.wrong - 1,
			(double)time_s[keys.wrong - 1]);
	}
	if (keys.equal) {
		gltf_warn(at,
			"%d of %d keys have the same time as the key before them; limber jumps to the last one at that time",
			keys.equal, count);
	}
	if (time_s[0] < 0.0f) {
		gltf_warn(at,
			"no player shows keys before 0 s, and the first is at %g s: let the animation begin at frame 0, and export it again",
			(double)time_s[0]);
	}
	return 0;
}

/*
 * Unpacks the key times. Many channels share an accessor of times, so it is
 * unpacked only once.
 */
static int read_times(const struct gltf_at *sampler,
	const struct gltf_accessor *input, float **out)
{
	struct gltf *gltf = sampler->gltf;
	struct gltf_at at = gltf_member(sampler, "input");
	float **known = &gltf->times[input->index];
	float *time_s;
	int error;

	if (!*known) {
		time_s = GLTF_KEEP(&at, float, input->count);
		if (!time_s) {
			return -ENOMEM;
		}
		error = gltf_unpack_floats(&at, input, time_s);
		if (!error) {
			error = check_times(&at, time_s, input->count);
		}
		if (error) {
			return error;
		}
		*known = time_s;
	}
	*out = *known;
	return 0;
}

/* Leaves out the keys that no moment shows. */
static void skip_keys(struct model_channel *channel, int first)
{
	size_t width = (size_t)channel->width *
		(channel->interpolation == MODEL_CUBICSPLINE ? 3 : 1);

	channel->key_count -= first;
	channel->time_s += first;
	channel->value += (size_t)first * width;
	channel->packed = channel->packed ? channel->packed + first : NULL;
}

/*
 * Makes rotation keys unit length: all integer keys, which are rounded, and
 * float keys whose squared length is outside 0.98..1.02. Other float keys stay
 * as they are, as in other players. Splines are normalised after evaluation.
 */
static int normalize_keys(const struct gltf_at *at, bool are_floats,
	float *value, const struct model_channel *out)
{
	int error = 0;

	if (out->path != MODEL_ROTATION ||
		out->interpolation == MODEL_CUBICSPLINE) {
		return 0;
	}
	for (int i = 0; i < out->key_count && !error; i++) {
		float *key = value + (size_t)i * 4;
		float length2 = key[0] * key[0] + key[1] * key[1] +
			key[2] * key[2] + key[3] * key[3];

		if (!are_floats || !(length2 > 0.98f && length2 < 1.02f)) {
			error = gltf_normalize_rotation(at, key);
		}
	}
	return error;
}

/* Returns the arena for the keys of the channel that is being read. */
static struct arena *keys_arena(struct gltf *gltf)
{
	return gltf->all_keys ? &gltf->scratch
			      : &gltf->key_arena[gltf->key_arena_count - 1];
}

/* Whether the file stores the keys in the format of model_channel.packed. */
static bool is_packed(
	const struct gltf_accessor *output, const struct model_channel *channel)
{
	return channel->path == MODEL_ROTATION &&
		channel->interpolation == MODEL_LINEAR &&
		output->base.component == GLTF_I16 && output->normalized;
}

static int keep_packed(
	const struct gltf_at *at, const float *value, struct model_channel *out)
{
	size_t count = (size_t)out->key_count;
	int16_t(*packed)[4] =
		gltf_alloc(at, keys_arena(at->gltf), count, sizeof(*packed));

	for (size_t i = 0; packed && i < 4 * count; i++) {
		packed[i / 4][i % 4] =
			(int16_t)lrintf(value[i] * MODEL_PACKED_UNIT);
	}
	out->packed = (const int16_t(*)[4])packed;
	return packed ? 0 : -ENOMEM;
}

static int read_values(const struct gltf_at *sampler,
	const struct gltf_accessor *output, struct model_channel *out)
{
	struct gltf_at at = gltf_member(sampler, "output");
	int64_t floats = (int64_t)output->count * output->width;
	int64_t expected = (int64_t)out->key_count * out->width;
	float *value;
	int error;

	if (out->interpolation == MODEL_CUBICSPLINE) {
		expected *= 3;
	}
	if (floats != expected) {
		return gltf_fail(&at, -EINVAL,
			"has %lld numbers, but %d keys need %lld",
			(long long)floats, out->key_count, (long long)expected);
	}
	value = gltf_alloc(
		&at, keys_arena(at.gltf), (size_t)floats, sizeof(*value));
	if (!value) {
		return -ENOMEM;
	}
	error = gltf_unpack_floats(&at, output, value);
	if (!error && is_packed(output, out)) {
		error = keep_packed(&at, value, out);
	}
	if (!error) {
		error = normalize_keys(
			&at, output->base.component == GLTF_F32, value, out);
	}
	if (!error && at.gltf->shift && out->path == MODEL_TRANSLATION) {
		model_origin_shift_keys(at.gltf->shift[out->node], out, value);
	}
	out->value = value;
	return error;
}

static int require_accessor(const struct gltf_at *at, const char *key,
	const char *type, const struct gltf_accessor **out)
{
	int error = gltf_require(at, key);

	return error ? error : gltf_maybe_accessor(at, key, type, out);
}

static int read_sampler(const struct gltf_at *at, struct model_channel *out)
{
	static const char *const types[] = {
		[MODEL_TRANSLATION] = "VEC3",
		[MODEL_ROTATION] = "VEC4",
		[MODEL_SCALE] = "VEC3",
		[MODEL_WEIGHTS] = "SCALAR",
	};
	struct gltf_at input_at = gltf_member(at, "input");
	const struct gltf_accessor *input, *output;
	float *time_s = NULL;
	int error = require_accessor(at, "input", "SCALAR", &input);

	if (!error && input->base.component != GLTF_F32) {
		error = gltf_fail(&input_at, -EINVAL, "does not hold floats");
	}
	if (!error) {
		error = require_accessor(
			at, "output", types[out->path], &output);
	}
	if (!error) {
		error = read_interpolation(at, &out->interpolation);
	}
	if (!error) {
		out->key_count = input->count;
		error = read_times(at, input, &time_s);
	}
	if (!error) {
		out->time_s = time_s;
		error = read_values(at, output, out);
	}
	if (!error) {
		skip_keys(out, key_times_separate(time_s, input->count).first);
	}
	return error;
}

static int read_width(const struct gltf_at *target, const struct model *model,
	struct model_channel *out)
{
	const struct model_node *node = &model->node[out->node];

	out->width = out->path == MODEL_ROTATION ? 4 : 3;
	if (out->path != MODEL_WEIGHTS) {
		return 0;
	}
	out->width = node->mesh < 0 ? 0 : model->mesh[node->mesh].target_count;
	if (out->width == 0) {
		return gltf_fail(target, -EINVAL,
			"node %d has no morph targets", node->file_index);
	}
	return 0;
}

/*
 * A node that a channel moves is posed by translation, rotation and scale,
 * which cannot express the shear of a matrix.
 */
static void drop_matrix(
	const struct gltf_at *target, const struct model_channel *channel)
{
	struct model_node *node = &target->gltf->model->node[channel->node];

	if (node->matrix && channel->path != MODEL_WEIGHTS) {
		gltf_warn(target,
			"limber drops the shear of node %d, because this channel moves the node",
			node->file_index);
		node->matrix = NULL;
	}
}

static int check_unique(const struct gltf_at *target,
	struct animation_reader *reader, const struct model_channel *channel)
{
	int *seen = &reader->seen[channel->node][channel->path];

	if (*seen == reader->number) {
		return gltf_fail(target, -EINVAL,
			"another channel of this animation has the same node and path");
	}
	*seen = reader->number;
	return 0;
}

static int read_target(const struct gltf_at *target,
	struct animation_reader *reader, struct model_channel *out)
{
	struct gltf *gltf = target->gltf;
	struct gltf_at node = gltf_member(target, "node");
	int error = gltf_node(&node, &out->node);

	if (!error) {
		error = read_path(target, &out->path);
	}
	if (error) {
		return error;
	}
	error = read_width(target, gltf->model, out);
	if (!error) {
		error = check_unique(target, reader, out);
	}
	if (!error) {
		drop_matrix(target, out);
	}
	return error;
}

/*
 * Whether a channel belongs to KHR_animation_pointer. Such a channel may change
 * any value but has no node. A warning says that nodes do not appear.
 */
static bool has_pointer(const struct gltf_at *target)
{
	const char *path =
		json_string_value(json_object_get(target->json, "path"));
	const json_t *extension =
		json_object_get(json_object_get(target->json, "extensions"),
			"KHR_animation_pointer");
	const char *pointer =
		json_string_value(json_object_get(extension, "pointer"));

	if (!path || strcmp(path, "pointer") != 0) {
		return false;
	}
	if (pointer && strstr(pointer, "/KHR_node_visibility/")) {
		gltf_warn(target,
			"the clip shows or hides a node, which limber does not play: nodes stay visible or hidden as they are without a clip");
	}
	return true;
}

/*
 * Reads a channel and sets *has_node. A channel without a node belongs to an
 * extension and is skipped.
 */
static int read_channel(const struct gltf_at *at,
	struct animation_reader *reader, struct model_channel *out,
	bool *has_node)
{
	struct gltf_at target, sampler;
	int index = 0;
	int error = gltf_require(at, "target");

	if (!error) {
		error = gltf_object(at, "target", &target);
	}
	if (!error) {
		error = gltf_require(at, "sampler");
	}
	if (!error) {
		error = gltf_maybe_index(at, "sampler", reader->sampler_count,
			"sampler", &index);
	}
	if (!error && has_pointer(&target)) {
		reader->pointer_count++;
		return 0;
	}
	*has_node = !error && json_object_get(target.json, "node");
	if (!*has_node) {
		return error;
	}
	error = read_target(&target, reader, out);
	if (!error) {
		error = gltf_item(&reader->samplers, index, &sampler);
	}
	return error ? error : read_sampler(&sampler, out);
}

static void begin_keys(struct gltf *gltf, int channel)
{
	struct arena *keys = &gltf->key_arena[channel];

	*keys = arena_within(gltf->model->budget);
	keys->block_bytes = KEY_BLOCK_BYTES;
	gltf->key_arena_count = channel + 1;
}

static int read_animation(const struct gltf_at *at,
	struct animation_reader *reader, struct model_clip *out)
{
	struct gltf *gltf = at->gltf;
	struct gltf_at array, item;
	int count, i;
	int error = gltf_name(at, &out->name);

	if (!error) {
		error = gltf_array(at, "samplers", &reader->samplers,
			&reader->sampler_count);
	}
	if (!error) {
		error = gltf_array(at, "channels", &array, &count);
	}
	if (error) {
		return error;
	}
	out->channel = GLTF_KEEP(&array, struct model_channel, count);
	gltf->key_arena_count = 0;
	gltf->key_arena = GLTF_SCRATCH(&array, struct arena, count);
	if (!out->channel || !gltf->key_arena) {
		return -ENOMEM;
	}
	for (i = 0; i < count && !error; i++) {
		struct model_channel *channel =
			&out->channel[out->channel_count];
		bool has_node = false;

		begin_keys(gltf, out->channel_count);
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_channel(&item, reader, channel, &has_node);
		}
		if (!error && has_node) {
			float end_s = channel->time_s[channel->key_count - 1];

			out->duration_s = scalar_max(end_s, out->duration_s);
			out->channel_count++;
		}
	}
	if (!error && reader->pointer_count > 0) {
		gltf_warn(at,
			"limber ignores %d of %d channels, which KHR_animation_pointer defines",
			reader->pointer_count, count);
	}
	return error;
}

static int keep_clip(const struct gltf_at *at, struct model_clip *clip)
{
	struct gltf *gltf = at->gltf;
	int error = model_keep_clip(clip, gltf->key_arena, &gltf->model->arena);

	return error ? gltf_no_memory(at) : 0;
}

int gltf_read_animations(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct animation_reader reader = {0};
	struct gltf_at array, item;
	int count, i;
	int error = gltf_array(&gltf->root, "animations", &array, &count);

	if (error) {
		return error;
	}
	model->clip = GLTF_KEEP(&array, struct model_clip, count);
	reader.seen = gltf_alloc(&array, &gltf->scratch,
		(size_t)model->node_count, sizeof(*reader.seen));
	if (!model->clip || !reader.seen) {
		return -ENOMEM;
	}
	model->clip_count = count;
	for (i = 0; i < count && !error; i++) {
		reader.number = i + 1;
		reader.pointer_count = 0;
		error = gltf_item(&array, i, &item);
		if (!error) {
			error = read_animation(&item, &reader, &model->clip[i]);
		}
		if (!error && !gltf->all_keys) {
			error = keep_clip(&item, &model->clip[i]);
		}
		gltf_drop_element(gltf, "animations", i);
	}
	return error;
}

#include "app/model/gltf/gltf.h"
#include "app/model/gltf/gltf_internal.h"
#include "app/model/origin/model_origin.h"
#include "app/model/split/split.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <string.h>

bool gltf_recognise(const uint8_t *data, size_t size)
{
	size_t i = 0;

	if (size >= 4 && memcmp(data, "glTF", 4) == 0) {
		return true;
	}
	if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0) {
		i = 3;
	}
	while (i < size && data[i] && strchr(" \t\r\n", data[i])) {
		i++;
	}
	return i < size && data[i] == '{';
}

/* "2" or "2.x" */
static bool is_version_2(const char *version)
{
	return version[0] == '2' && (version[1] == '.' || version[1] == '\0');
}

/* Files of glTF 1.0 may have a number as version. */
static int read_version(const struct gltf_at *asset, const char **out)
{
	const json_t *number = json_object_get(asset->json, "version");

	if (json_is_number(number) && json_number_value(number) < 2.0) {
		*out = "1.0";
		return 0;
	}
	return gltf_maybe_string(asset, "version", out);
}

static int check_version(struct gltf *gltf)
{
	struct gltf_at asset;
	const char *version = NULL;
	const char *minimum = "2.0";
	int error = gltf_object(&gltf->root, "asset", &asset);

	if (!error) {
		error = read_version(&asset, &version);
	}
	if (!error) {
		error = gltf_maybe_string(&asset, "minVersion", &minimum);
	}
	if (error) {
		return error;
	}
	if (!version) {
		return gltf_fail(&asset, -EINVAL, "has no \"version\"");
	}
	if (!is_version_2(version) || strcmp(minimum, "2.0") != 0) {
		return gltf_fail(&asset, -ENOTSUP,
			"is glTF %.20s; limber reads glTF 2.0",
			is_version_2(version) ? minimum : version);
	}
	return 0;
}

bool gltf_knows_extension(const char *name)
{
	static const char *const known[] = {
		"KHR_materials_emissive_strength",
		"KHR_materials_pbrSpecularGlossiness",
		"KHR_materials_transmission",
		"KHR_materials_unlit",
		"KHR_mesh_quantization",
		"KHR_node_visibility",
		"KHR_texture_transform",
	};

	for (size_t i = 0; i < ARRAY_COUNT(known); i++) {
		if (strcmp(known[i], name) == 0) {
			return true;
		}
	}
	return false;
}

/* Whether the extension changes only how a model looks, by its name. */
static bool adds_looks_only(const char *name)
{
	static const char *const begins[] = {
		"KHR_materials_", "KHR_lights_", "EXT_lights_", "KHR_xmp"};

	for (size_t i = 0; i < ARRAY_COUNT(begins); i++) {
		if (strncmp(name, begins[i], strlen(begins[i])) == 0) {
			return true;
		}
	}
	return false;
}

/*
 * An extension that changes only the looks is allowed even if the file requires
 * it, as Blender's files require lights.
 */
static int check_extension(const struct gltf_at *at)
{
	const char *name = json_string_value(at->json);

	if (!name) {
		return gltf_fail(at, -EINVAL, "is not a string");
	}
	if (gltf_knows_extension(name)) {
		return 0;
	}
	if (adds_looks_only(name)) {
		gltf_warn_alone(at,
			"the model requires %.80s, which limber ignores, so that it looks different: export it without",
			name);
		return 0;
	}
	return gltf_fail(at, -ENOTSUP,
		"the model requires %.80s, which limber does not support: export it without",
		name);
}

static int check_extensions(struct gltf *gltf)
{
	struct gltf_at array;
	int count, i;
	int error =
		gltf_array(&gltf->root, "extensionsRequired", &array, &count);

	for (i = 0; i < count && !error; i++) {
		struct gltf_at element = gltf_element(&array, i);

		error = check_extension(&element);
	}
	return error;
}

enum {
	/*
	 * Scratch memory is either little or allocated in large pieces, so
	 * small blocks are enough.
	 */
	SCRATCH_BLOCK_BYTES = 8 * 1024
};

typedef int (*gltf_step)(struct gltf *gltf);

static const gltf_step document_steps[] = {
	gltf_open,
	check_version,
	check_extensions,
	gltf_read_buffers,
	gltf_read_accessors,
};

/*
 * Frees the JSON that gltf->view and gltf->accessor have replaced: two thirds
 * of the JSON in most files, and JSON takes ten times as much memory as its
 * text.
 */
static int drop_read_json(struct gltf *gltf)
{
	json_object_del(gltf->json, "bufferViews");
	json_object_del(gltf->json, "accessors");
	return 0;
}

static int split_meshes(struct gltf *gltf)
{
	struct gltf_at meshes = gltf_member(&gltf->root, "meshes");

	return split_primitives(gltf->model, &gltf->scratch) == 0
		? 0
		: gltf_no_memory(&meshes);
}

/* Returns a member as an index below count, or -1. */
static int index_of(const json_t *object, const char *key, int count)
{
	const json_t *number = json_object_get(object, key);
	double value = json_is_number(number) ? json_number_value(number) : -1;

	return value >= 0 && value < count ? (int)value : -1;
}

/* Reads where the first key of a channel has a node; else leaves it. */
static int read_first_key(
	const struct gltf_at *animation, const json_t *channel, float start[3])
{
	const struct gltf *gltf = animation->gltf;
	struct gltf_at samplers = gltf_member(animation, "samplers");
	int index = index_of(
		channel, "sampler", (int)json_array_size(samplers.json));
	struct gltf_at sampler = gltf_element(&samplers, index);
	struct gltf_at output = gltf_member(&sampler, "output");
	const char *mode = json_string_value(
		json_object_get(sampler.json, "interpolation"));
	int accessor = index_of(sampler.json, "output", gltf->accessor_count);
	int value = mode && strcmp(mode, "CUBICSPLINE") == 0 ? 1 : 0;
	struct gltf_accessor first;
	float key[2][3];
	int error;

	if (index < 0 || accessor < 0) {
		return 0;
	}
	first = gltf->accessor[accessor];
	if (first.width != 3 || first.count <= value || first.sparse_count > 0) {
		return 0;
	}
	first.count = value + 1;
	error = gltf_unpack_floats(&output, &first, key[0]);
	if (!error) {
		memcpy(start, key[value], sizeof(key[value]));
	}
	return error;
}

/* What clips do to the nodes, before they are read. */
struct clip_scan {
	bool *turned;      /* [node_count] */
	bool *started;     /* [node_count] */
	float (*start)[3]; /* [node_count] */
};

static int scan_channel(const struct gltf_at *animation, const json_t *channel,
	struct clip_scan *scan)
{
	const struct gltf *gltf = animation->gltf;
	const json_t *target = json_object_get(channel, "target");
	const char *path = json_string_value(json_object_get(target, "path"));
	int node = index_of(target, "node", gltf->node_count);

	node = node >= 0 ? gltf->node_index[node] : -1;
	if (node < 0 || !path) {
		return 0;
	}
	if (strcmp(path, "translation") != 0) {
		scan->turned[node] = true;
		return 0;
	}
	if (gltf->model->node[node].parent >= 0 || scan->started[node]) {
		return 0;
	}
	scan->started[node] = true;
	return read_first_key(animation, channel, scan->start[node]);
}

static int scan_clips(struct gltf *gltf, struct clip_scan *scan)
{
	struct gltf_at clips = gltf_member(&gltf->root, "animations");
	size_t count = json_array_size(clips.json);
	int error = 0;

	for (size_t c = 0; c < count; c++) {
		struct gltf_at animation = gltf_element(&clips, (int)c);
		const json_t *channels =
			json_object_get(animation.json, "channels");
		size_t channel_count = json_array_size(channels);

		for (size_t i = 0; i < channel_count && !error; i++) {
			error = scan_channel(
				&animation, json_array_get(channels, i), scan);
		}
	}
	return error;
}

/* Moves a model that is far from the origin, before its clips are read. */
static int move_to_origin(struct gltf *gltf)
{
	struct gltf_at nodes = gltf_member(&gltf->root, "nodes");
	struct model *model = gltf->model;
	size_t count = (size_t)model->node_count;
	struct clip_scan scan = {
		.turned = GLTF_SCRATCH(&nodes, bool, count),
		.started = GLTF_SCRATCH(&nodes, bool, count),
		.start = gltf_alloc(
			&nodes, &gltf->scratch, count, sizeof(float[3])),
	};
	int error;

	if (!scan.turned || !scan.started || !scan.start) {
		return -ENOMEM;
	}
	for (size_t n = 0; n < count; n++) {
		memcpy(scan.start[n], model->node[n].rest.translation,
			sizeof(scan.start[n]));
	}
	error = scan_clips(gltf, &scan);
	if (error) {
		return error;
	}
	return model_origin_find(model, scan.turned,
		       (const float(*)[3])scan.start, &gltf->scratch,
		       &gltf->shift) == 0
		? 0
		: gltf_no_memory(&nodes);
}

static const gltf_step model_steps[] = {
	drop_read_json,
	gltf_read_materials,
	gltf_find_levels,
	gltf_read_meshes,
	gltf_read_cameras,
	gltf_read_nodes,
	gltf_read_skins,
	move_to_origin,
	gltf_read_animations,
	split_meshes,
	gltf_keep_targets,
};

static int run_steps(struct gltf *gltf, const gltf_step *step, size_t count)
{
	int error = 0;

	for (size_t i = 0; i < count && !error; i++) {
		error = interrupt_pending() ? -EINTR : step[i](gltf);
	}
	return error;
}

void gltf_release(struct gltf *gltf)
{
	int i;

	gltf_write_warnings(gltf);
	for (i = 0; i < gltf->buffer_count; i++) {
		model_file_release(&gltf->buffer[i].file);
	}
	gltf->buffer_count = 0;
	json_decref(gltf->json);
	json_decref(gltf->nothing);
	gltf->json = gltf->nothing = NULL;
	for (i = 0; i < gltf->key_arena_count; i++) {
		arena_release(&gltf->key_arena[i]);
	}
	gltf->key_arena_count = 0;
	arena_release(&gltf->scratch);
	arena_release(&gltf->brief);
	if (gltf->model) {
		gltf_give_back(gltf, gltf->taken_bytes);
	}
}

/*
 * Frees everything after an error. The scratch arena comes first: it refers to
 * the budget, which the model owns.
 */
static void discard(struct gltf *gltf)
{
	gltf_release(gltf);
	model_destroy(gltf->model);
	gltf->model = NULL;
}

int gltf_read_document(struct gltf *gltf, const struct model_source *source,
	const struct log *log)
{
	int error;

	*gltf = (struct gltf){
		.source = source,
		.log = log,
		.default_material = -1,
	};
	gltf->root.gltf = gltf;
	gltf->model = model_create(source, "glTF 2.0", log);
	if (!gltf->model) {
		return -ENOMEM;
	}
	gltf->scratch = arena_within(gltf->model->budget);
	gltf->brief = arena_within(gltf->model->budget);
	gltf->scratch.block_bytes = SCRATCH_BLOCK_BYTES;
	gltf->brief.block_bytes = SCRATCH_BLOCK_BYTES;
	error = run_steps(gltf, document_steps, ARRAY_COUNT(document_steps));
	if (error) {
		discard(gltf);
	} else {
		gltf_write_warnings(gltf);
	}
	return error;
}

int gltf_read(struct gltf *gltf, const struct model_source *source,
	bool all_keys, const struct log *log)
{
	int error = gltf_read_document(gltf, source, log);

	if (!error) {
		gltf->all_keys = all_keys;
		error = run_steps(gltf, model_steps, ARRAY_COUNT(model_steps));
		if (error) {
			discard(gltf);
		}
	}
	return error;
}

int gltf_load(const struct model_source *source, const struct log *log,
	struct model **out)
{
	struct gltf gltf;
	int error = gltf_read(&gltf, source, false, log);

	*out = gltf.model;
	gltf_release(&gltf);
	return error;
}

#include "app/compare/optimize/optimize.h"

#include "app/compare/optimize/build/optimize_build.h"
#include "app/compare/optimize/optimize_known.h"
#include "app/compare/optimize/optimize_measure.h"
#include "app/compare/optimize/optimize_prune.h"
#include "app/compare/optimize/optimize_refs.h"
#include "app/compare/optimize/optimize_search.h"
#include "app/compare/optimize/optimize_sizes.h"
#include "app/model/gltf/gltf.h"
#include "platform/base/json_memory.h"

#include <errno.h>
#include <stdlib.h>

enum {
	LEVELS = 4,     /* of precision, see set_precision() */
	ROUNDS_MAX = 7, /* of choose_keys() */
	LAST_MAX = 3    /* of settle_keys() */
};

/* Rounding may cause this share of the bound; keys left out cause the rest. */
static const float numbers_share = 0.5f;

/* What is known of a clip. */
struct clip_search {
	struct bounds box; /* of the clip, once it has been measured */
	struct optimize_known known; /* with these vertices and moments */
	struct optimize_search keys;
};

struct optimizer {
	const struct model *model;
	const struct optimize_request *request;
	const struct log *log;
	struct model_file file;
	struct model_source source;
	struct gltf_document *document;
	struct optimize_order order;
	struct optimize_scale scale;
	struct optimize_reach reach;
	struct model *base;  /* unrounded, in the new order */
	struct model *found; /* built by the plan */
	struct optimize_plan plan;
	struct clip_search *clip;
	float *key_px, *peak_px; /* [clip_count] */
	int clip_count;          /* at least 1; without clips, the rest pose */
	float left_px;
	struct optimize_measure_view view; /* of the search */
	uint8_t *data;
	size_t size;
	int steps;
};

static void step(struct optimizer *optimizer)
{
	const struct optimize_request *request = optimizer->request;

	optimizer->steps++;
	if (request->progress) {
		request->progress(request->progress_context, optimizer->steps,
			optimizer->steps + 1);
	}
}

static int fail_memory(const struct optimizer *optimizer)
{
	log_error(optimizer->log,
		"%s: there is not enough memory to optimize it",
		optimizer->model->path);
	return -ENOMEM;
}

static void warn_removed(void *context, const char *name)
{
	const struct optimizer *optimizer = context;

	log_warning(optimizer->log,
		"%s: limber does not know the extension %.80s and leaves it out",
		optimizer->model->path, name);
}

static int open_document(struct optimizer *optimizer)
{
	const char *path = optimizer->model->path;
	int error =
		model_file_read(path, NULL, optimizer->log, &optimizer->file);

	if (error) {
		return error;
	}
	optimizer->source = (struct model_source){
		.name = path,
		.has_folder = true,
		.data = optimizer->file.data,
		.size = optimizer->file.size,
		.memory_bytes = optimizer->request->memory_bytes,
	};
	if (!gltf_recognise(optimizer->file.data, optimizer->file.size)) {
		log_error(optimizer->log,
			"%s: limber optimizes glTF files only; this one is %s",
			path, optimizer->model->format);
		return -ENOTSUP;
	}
	return gltf_document_open(
		&optimizer->source, optimizer->log, &optimizer->document);
}

/* Removes unused parts, and finds the order of vertices and the units. */
static int prepare(struct optimizer *optimizer)
{
	json_t *root = gltf_document_json(optimizer->document);
	int error;

	json_memory_begin();
	optimize_strip_extensions(root, warn_removed, optimizer);
	error = optimize_prune(root);
	if (!error) {
		error = optimize_order_find(
			&optimizer->order, optimizer->document);
	}
	if (!error) {
		error = optimize_scale_find(
			&optimizer->scale, optimizer->document);
	}
	if (!json_memory_ok()) {
		error = -ENOMEM;
	}
	return error == -ENOMEM ? fail_memory(optimizer) : error;
}

/* Builds a file by the plan and loads it; reduces: leaves keys out. */
static int build(struct optimizer *optimizer, bool reduces, struct model **model)
{
	struct optimize_build request = {
		.document = optimizer->document,
		.order = &optimizer->order,
		.scale = &optimizer->scale,
		.reach = reduces ? &optimizer->reach : NULL,
		.plan = &optimizer->plan,
	};
	const char *path = optimizer->model->path;
	struct log errors = *optimizer->log;
	int error;

	/* The first load has warned about the file already. */
	errors.threshold = LOG_ERROR;
	free(optimizer->data);
	optimizer->data = NULL;
	model_destroy(*model);
	*model = NULL;
	error = optimize_build(&request, path, optimizer->log, &optimizer->data,
		&optimizer->size);
	step(optimizer);
	return error ? error
		     : model_load_memory(optimizer->data, optimizer->size, path,
			       &errors, model);
}

/* Measures a clip, unless the same keys have been measured before. */
static int measure(struct optimizer *optimizer, int clip)
{
	struct clip_search *search = &optimizer->clip[clip];
	float *peak_px = &optimizer->peak_px[clip];
	int played = clip < optimizer->found->clip_count ? clip : -1;
	int error = 0;
	uint64_t stamp = optimize_known_stamp(optimizer->found, played);

	if (!optimize_known_find(&search->known, stamp, peak_px)) {
		error = optimize_measure(optimizer->base, optimizer->found,
			played, optimizer->view, &search->box, optimizer->log,
			peak_px);
		optimize_known_add(&search->known, stamp, *peak_px);
		step(optimizer);
	}
	return error;
}

static int measure_all(struct optimizer *optimizer, float *most_px)
{
	int error = 0;

	*most_px = 0.0f;
	for (int c = 0; c < optimizer->clip_count && !error; c++) {
		error = measure(optimizer, c);
		*most_px = optimizer->peak_px[c] > *most_px
			? optimizer->peak_px[c]
			: *most_px;
	}
	return error;
}

static void set_precision(struct optimize_plan *plan, int level)
{
	plan->directions = true;
	plan->byte_weights = level == 0;
	plan->weights = level < 3;
	plan->positions = level < 2;
	plan->rotations = level < 3;
}

/* What is known of clips was measured with other vertices, or more coarsely. */
static void forget(struct optimizer *optimizer)
{
	for (int c = 0; c < optimizer->clip_count; c++) {
		optimizer->clip[c].known.count = 0;
	}
}

/* Chooses the fewest bits whose error is at most numbers_share of the bound. */
static int choose_precision(struct optimizer *optimizer)
{
	for (int level = 0; level < LEVELS; level++) {
		float most_px;
		int error;

		set_precision(&optimizer->plan, level);
		forget(optimizer);
		error = build(optimizer, true, &optimizer->found);
		error = error ? error : measure_all(optimizer, &most_px);
		if (error || most_px <= numbers_share * optimizer->left_px) {
			return error;
		}
	}
	return 0;
}

static bool is_done(const struct optimizer *optimizer)
{
	for (int c = 0; c < optimizer->clip_count; c++) {
		if (!optimizer->clip[c].keys.done) {
			return false;
		}
	}
	return true;
}

/*
 * Builds the file that was found and measures all of it. It may exceed the
 * bound at moments that the search has not looked at, or as a channel that one
 * clip needs may have to stay in another one: then these clips keep more keys.
 */
static int settle_keys(struct optimizer *optimizer, float *peak_px)
{
	if (optimizer->view.share < 1.0) {
		optimizer->view.share = 1.0;
		forget(optimizer);
	}
	for (int round = 1;; round++) {
		int error;

		for (int c = 0; c < optimizer->clip_count; c++) {
			optimizer->key_px[c] = optimizer->clip[c].keys.good_px;
		}
		error = build(optimizer, true, &optimizer->found);
		error = error ? error : measure_all(optimizer, peak_px);
		if (error || *peak_px <= optimizer->left_px ||
			round == LAST_MAX) {
			return error;
		}
		for (int c = 0; c < optimizer->clip_count; c++) {
			optimize_search_keep_more(&optimizer->clip[c].keys,
				optimizer->peak_px[c], optimizer->left_px);
		}
	}
}

/* Measures a clip as it was built, and decides what to build next. */
static int try_keys(struct optimizer *optimizer, int clip)
{
	float *key_px = &optimizer->key_px[clip];
	int error = measure(optimizer, clip);

	if (!error) {
		*key_px = optimize_search_next(&optimizer->clip[clip].keys,
			*key_px, optimizer->peak_px[clip], optimizer->left_px);
	}
	return error;
}

/* Finds key_px of all clips. */
static int choose_keys(struct optimizer *optimizer, float *peak_px)
{
	int error = 0;

	for (int c = 0; c < optimizer->clip_count; c++) {
		optimizer->key_px[c] = optimizer->left_px;
	}
	for (int round = 1; round <= ROUNDS_MAX && !is_done(optimizer); round++) {
		error = error ? error
			      : build(optimizer, true, &optimizer->found);
		for (int c = 0; c < optimizer->clip_count && !error; c++) {
			if (!optimizer->clip[c].keys.done) {
				error = try_keys(optimizer, c);
			}
		}
	}
	return error ? error : settle_keys(optimizer, peak_px);
}

/* The last resort if the bound is missed: only the order changes. */
static int keep_numbers(struct optimizer *optimizer, float *peak_px)
{
	int error;

	optimizer->plan = (struct optimize_plan){
		.key_px = optimizer->key_px,
		.stated_px = optimizer->plan.stated_px,
	};
	for (int c = 0; c < optimizer->clip_count; c++) {
		optimizer->key_px[c] = 0.0f;
	}
	forget(optimizer);
	error = build(optimizer, true, &optimizer->found);
	return error ? error : measure_all(optimizer, peak_px);
}

static float stated_error(const struct optimizer *optimizer)
{
	json_t *asset = json_object_get(
		gltf_document_json(optimizer->document), "asset");
	double stated = json_number_value(json_object_get(
		json_object_get(asset, "extras"), "limber_error_px"));

	return stated > 0.0 && stated < 1e6 ? (float)stated : 0.0f;
}

static int allocate(struct optimizer *optimizer)
{
	int clips = optimizer->base->clip_count;
	size_t count = clips > 0 ? (size_t)clips : 1;

	optimizer->clip_count = (int)count;
	optimizer->clip = calloc(count, sizeof(*optimizer->clip));
	optimizer->key_px = calloc(count, sizeof(float));
	optimizer->peak_px = calloc(count, sizeof(float));
	optimizer->plan.key_px = optimizer->key_px;
	optimizer->view = (struct optimize_measure_view){
		.width = optimizer->request->width,
		.height = optimizer->request->height,
		.share = optimize_measure_share(optimizer->base),
	};
	for (size_t c = 0; optimizer->clip && c < count; c++) {
		optimizer->clip[c].box = bounds_empty();
	}
	return optimizer->clip && optimizer->key_px && optimizer->peak_px
		? 0
		: fail_memory(optimizer);
}

/* Builds the file in its new order without loss, and measures its reach. */
static int build_base(struct optimizer *optimizer)
{
	float px_per_unit;
	bool *needed;
	int error = build(optimizer, false, &optimizer->base);

	error = error ? error : allocate(optimizer);
	if (!error) {
		error = optimize_measure_unit(optimizer->base, &optimizer->view,
			optimizer->log, &optimizer->clip[0].box, &px_per_unit);
	}
	if (!error) {
		needed = optimize_find_needed(
			gltf_document_json(optimizer->document),
			optimizer->request->named);
		error = optimize_reach_find(&optimizer->reach, optimizer->base,
			px_per_unit, needed);
		error = error || !needed ? fail_memory(optimizer) : 0;
		free(needed);
	}
	return error;
}

static int search(struct optimizer *optimizer, struct optimize_result *out)
{
	int error;

	out->earlier_px = stated_error(optimizer);
	optimizer->left_px = optimizer->request->bound_px - out->earlier_px;
	if (!(optimizer->left_px > 0.0f)) {
		optimizer->plan.stated_px = out->earlier_px;
		return keep_numbers(optimizer, &out->peak_px);
	}
	optimizer->plan.stated_px = optimizer->request->bound_px;
	error = choose_precision(optimizer);
	if (!error) {
		error = choose_keys(optimizer, &out->peak_px);
	}
	if (!error && out->peak_px > optimizer->left_px) {
		error = keep_numbers(optimizer, &out->peak_px);
	}
	return error;
}

static int measure_result(
	const struct optimizer *optimizer, struct optimize_result *out)
{
	const struct model_source source = {
		.name = optimizer->model->path,
		.data = optimizer->data,
		.size = optimizer->size,
		.memory_bytes = optimizer->request->memory_bytes,
	};
	struct gltf_document *document;
	int error = gltf_document_open(&source, optimizer->log, &document);

	if (!error) {
		error = optimize_sizes_of(document, &out->after);
		error = error ? fail_memory(optimizer) : 0;
		gltf_document_close(document);
	}
	return error;
}

static int run(struct optimizer *optimizer, struct optimize_result *out)
{
	int error = open_document(optimizer);

	if (!error && optimize_sizes_of(optimizer->document, &out->before)) {
		error = fail_memory(optimizer);
	}
	error = error ? error : prepare(optimizer);
	error = error ? error : build_base(optimizer);
	error = error ? error : search(optimizer, out);
	return error ? error : measure_result(optimizer, out);
}

int optimize_model(const struct model *model,
	const struct optimize_request *request, const struct log *log,
	struct optimize_result *out)
{
	struct optimizer optimizer = {
		.model = model,
		.request = request,
		.log = log,
		.plan = {.stated_px = -1.0f},
	};
	int error;

	*out = (struct optimize_result){.data = NULL};
	error = run(&optimizer, out);
	if (!error) {
		out->idle = optimize_reach_idle(&optimizer.reach, model);
		out->data = optimizer.data;
		optimizer.data = NULL;
	}
	free(optimizer.data);
	free(optimizer.clip);
	free(optimizer.key_px);
	free(optimizer.peak_px);
	model_destroy(optimizer.base);
	model_destroy(optimizer.found);
	optimize_reach_release(&optimizer.reach);
	optimize_scale_release(&optimizer.scale);
	optimize_order_release(&optimizer.order);
	gltf_document_close(optimizer.document);
	model_file_release(&optimizer.file);
	return error;
}

#include "app/cmd/doctor/doctor_clips.h"

#include "app/character/sketch/sketch_once.h"

static void report(const struct model *model, const struct sketch_once *once,
	const struct examiner *examiner)
{
	int count = 0, first = -1;

	for (int i = 0; i < CHARACTER_SKETCH_CLIPS; i++) {
		if (once->clip[i]) {
			first = count == 0 ? i : first;
			count++;
		}
	}
	if (count == 0) {
		return;
	}
	examine_report_clips(examiner, model, count, first,
		"clips that end in another shape than they begin with",
		"limber plays them once and shows their end, unless a character file or --repeat says otherwise; players that repeat them jump");
}

int doctor_clips_check(const char *model_path, size_t memory_bytes,
	const struct examiner *examiner, const struct log *log)
{
	const struct character_sketch_play plain = {
		.rate = 1, .repeat = CLIP_LOOP};
	/* The caller has loaded the model before, with its warnings. */
	struct log errors = *log;
	struct sketch_once once;
	struct model *model;
	int error;

	errors.threshold = LOG_ERROR;
	error = model_load_within(model_path,
		memory_bytes ? memory_bytes : MODEL_MEMORY_BYTES, &errors,
		&model);
	if (error) {
		return error;
	}
	error = sketch_find_once(model, &plain, &once);
	if (error) {
		log_error(log, "%s: there is not enough memory", model_path);
	} else {
		report(model, &once, examiner);
	}
	model_destroy(model);
	return error;
}

/*
 * Loads any bytes as a DirectX .x file in memory. Expects a model, or exactly
 * one error and no leak.
 */
#include "app/model/model.h"
#include "app/model/model_stats.h"
#include "app/model/xfile/xfile.h"

#include <stdint.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void count_errors(void *user, enum log_level level, const char *sentence)
{
	(void)sentence;
	*(int *)user += level == LOG_ERROR;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct model_source source = {
		.name = "fuzz.x", .data = data, .size = size};
	struct model_stats stats;
	struct model *model = NULL;
	int errors = 0;
	const struct log log = {
		.write = count_errors, .user = &errors, .threshold = LOG_ERROR};

	if (!xfile_recognise(data, size)) {
		return 0;
	}
	if (xfile_load(&source, &log, &model) == 0) {
		model_measure(model, &stats);
		model_destroy(model);
	} else if (errors != 1) {
		abort();
	}
	return 0;
}

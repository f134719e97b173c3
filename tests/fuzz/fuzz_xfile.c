/*
 * Loads any bytes as a DirectX .x file in memory. Expects a model, or exactly
 * one error and no leak.
 */
#include "app/model/model.h"
#include "app/model/model_stats.h"
#include "app/model/xfile/xfile.h"
#include "tests/fuzz/fuzz_expect.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	const struct model_source source = {
		.name = "fuzz.x", .data = data, .size = size};
	struct model_stats stats;
	struct model *model = NULL;
	int errors = 0;
	const struct log log = fuzz_log(&errors);

	if (!xfile_recognise(data, size)) {
		return 0;
	}
	if (xfile_load(&source, &log, &model) == 0) {
		model_measure(model, &stats);
		model_destroy(model);
	} else {
		fuzz_expect(errors == 1);
	}
	return 0;
}

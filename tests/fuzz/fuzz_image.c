/* Decodes any bytes as an image. Expects pixels, or one error and no leak. */
#include "app/model/image/image.h"
#include "tests/fuzz/fuzz_expect.h"

enum {
	PIXELS_MAX = 512 * 512, /* larger images would slow the run down */
};

/* Reads every pixel, so that the sanitizers check its address. */
static void check(const struct model_image *image)
{
	size_t total = (size_t)image->width * (size_t)image->height;
	bool opaque = true;
	size_t i;

	for (i = 0; i < total; i++) {
		opaque = opaque && image->rgba[i * 4 + 3] == 255;
	}
	fuzz_expect(opaque == image->opaque);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	/* The image, and as much for the decoder. */
	struct memory_budget budget = {.limit_bytes = PIXELS_MAX * 4 * 2};
	struct arena arena = arena_within(&budget);
	struct model_image image = {0};
	int errors = 0;
	struct log log = fuzz_log(&errors);

	if (image_decode(data, size, "fuzz", &log, &arena, &image) == 0) {
		fuzz_expect(errors == 0);
		check(&image);
	} else {
		fuzz_expect(errors == 1);
	}
	arena_release(&arena);
	return 0;
}

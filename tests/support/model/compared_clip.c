#include "tests/support/model/compared_clip.h"

#include "tests/support/test.h"

void compared_clip_begin(
	struct compared_clip *compared, const char *path, const char *clip)
{
	int index;

	*compared = (struct compared_clip){.log = log_to_stderr(LOG_WARNING)};
	assert_int_equal(model_load(path, &compared->log, &compared->model), 0);
	index = model_find_clip(compared->model, clip);
	assert_true(index >= 0);
	assert_int_equal(reference_create(compared->model, index,
				 &compared->log, &compared->reference),
		0);
	assert_int_equal(
		time_grid_make(compared->reference->clip, &compared->grid), 0);
	compared->screen = screen_view_create(
		compared->reference, &compared->grid, 480, 640);
}

void compared_clip_end(struct compared_clip *compared)
{
	time_grid_release(&compared->grid);
	reference_destroy(compared->reference);
	model_destroy(compared->model);
}

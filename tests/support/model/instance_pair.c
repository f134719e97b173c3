#include "tests/support/model/instance_pair.h"

#include "tests/support/test.h"

static struct instance *make_instance(
	const struct model *model, const char *kernel)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance = NULL;

	assert_int_equal(
		instance_create(model, kernel_find(kernel), &nowhere, &instance),
		0);
	return instance;
}

void instance_pair_begin(struct instance_pair *pair, struct model *model)
{
	*pair = (struct instance_pair){.model = model};
	pair->exact = make_instance(model, "float");
	pair->fixed = make_instance(model, "fixed");
	assert_int_equal(
		clip_cursor_init(&pair->cursor, model, &pair->exact->arena), 0);
}

void instance_pair_load(struct instance_pair *pair, const char *path)
{
	struct log nowhere = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load(path, &nowhere, &model), 0);
	instance_pair_begin(pair, model);
}

void instance_pair_end(struct instance_pair *pair)
{
	instance_destroy(pair->exact);
	instance_destroy(pair->fixed);
	model_destroy(pair->model);
}

void instance_pair_pose(struct instance_pair *pair, int clip, float time_s)
{
	if (clip >= 0) {
		clip_pose(&pair->model->clip[clip], time_s, CLIP_AUTO,
			&pair->cursor, &pair->exact->pose);
	}
	pose_copy(&pair->fixed->pose, &pair->exact->pose);
	instance_update(pair->exact);
	instance_update(pair->fixed);
	assert_false(instance_overflowed(pair->fixed));
}

#include "app/demo/crowd/crowd_dress.h"

#include "app/scene/instance/batch.h"
#include "platform/base/compiler.h"

int crowd_dress(struct instance *instance, int number)
{
	/* sRGB-encoded factors; the first leaves the texture's own colours. */
	static const float color[][3] = {{1.0f, 1.0f, 1.0f},
		{1.0f, 0.62f, 0.45f}, {0.55f, 0.75f, 1.0f}, {1.0f, 0.9f, 0.45f},
		{0.95f, 0.55f, 0.75f}, {0.6f, 1.0f, 0.55f}, {0.7f, 0.6f, 1.0f},
		{0.55f, 0.55f, 0.6f}, {1.0f, 0.75f, 0.75f}, {0.75f, 0.9f, 0.3f},
		{0.4f, 0.9f, 0.95f}, {0.8f, 0.65f, 0.5f}};
	int error = 0;

	for (int i = 0; !error && i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];
		int material = drawable->primitive->material;

		if (instance->model->material[material].texture >= 0) {
			error = batch_tint(drawable,
				color[number % (int)ARRAY_COUNT(color)],
				&instance->arena);
		}
	}
	return error;
}

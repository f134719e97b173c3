#include "app/character/sketch/sketch_layers.h"

#include "app/character/sketch/sketch_names.h"

#include <errno.h>
#include <stdlib.h>

enum {
	LAYERS_MAX = 12
};

static void write_layers(
	const struct model *model, const int *clip, int count, FILE *out)
{
	if (count > 0) {
		fputs("; Clips that move other nodes than the first one can play with it.\n",
			out);
	}
	for (int i = 0; i < count && i < LAYERS_MAX; i++) {
		fputs(";[layer ", out);
		sketch_write_heading(out, model, clip[i]);
		fputs("]\n;clip = ", out);
		sketch_write_clip(out, model, clip[i]);
		fputs("\n;nodes = moved\n\n", out);
	}
}

int sketch_write_layers(const struct model *model, int first, FILE *out)
{
	bool *moved = calloc((size_t)model->node_count + 1, sizeof(*moved));
	int *clip = calloc((size_t)model->clip_count + 1, sizeof(*clip));
	int error = moved && clip ? 0 : -ENOMEM;

	if (!error && model->clip_count > 0) {
		write_layers(model, clip + 1,
			model_clips_apart(model, first, moved, clip) - 1, out);
	}
	free(moved);
	free(clip);
	return error;
}

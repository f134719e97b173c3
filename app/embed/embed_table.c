#include "app/embed/embed_internal.h"

void embed_each_part(struct embed *embed, embed_part_fn *function)
{
	const struct model *model = embed->model;

	for (int i = 0; i < model->node_count && !embed->too_large; i++) {
		const struct model_node *node = &model->node[i];
		const struct model_mesh *mesh;

		if (!model_node_shows_mesh(node)) {
			continue;
		}
		mesh = &model->mesh[node->mesh];
		for (int p = 0; p < mesh->primitive_count; p++) {
			const struct embed_part part = {
				node, i, mesh, &mesh->primitive[p]};

			function(embed, &part);
		}
	}
}

bool embed_is_skinned(const struct embed_part *part)
{
	return part->node->skin >= 0 && part->primitive->influences > 0;
}

int embed_channel_values(const struct model_channel *channel)
{
	return channel->key_count * channel->width *
		(channel->interpolation == MODEL_CUBICSPLINE ? 3 : 1);
}

void embed_begin_table(struct embed *embed, const char *type, const char *name,
	const char *wide, int count, size_t size)
{
	count = count > 0 ? count : 1;
	fprintf(embed->out, "\nstatic const %s %s_%s[%d]%s = {", type,
		embed->prefix, name, count, wide);
	embed->rom_bytes += (size_t)count * size;
}

void embed_end_table(struct embed *embed, int count)
{
	fprintf(embed->out, "%s\n};\n", count > 0 ? "" : "\n\t0,");
}

void embed_put_floats(struct embed *embed, const float *value, int count)
{
	for (int i = 0; i < count; i++) {
		/* Nine digits suffice to read a float back exactly. */
		fprintf(embed->out, "%s%.9g,", i % EMBED_ROW ? " " : "\n\t",
			(double)value[i]);
	}
}

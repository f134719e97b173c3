#include "app/embed/embed_internal.h"
#include "app/model/origin/model_origin.h"

#include <string.h>

/*
 * Puts translations of a node. At the top of the tree they are places, which
 * the source states as the file does, however far from the origin.
 */
static void put_translations(
	struct embed *embed, int node, const float *value, int count)
{
	for (int i = 0; i < count; i++) {
		float place[3];

		memcpy(place, value + 3 * i, sizeof(place));
		if (embed->model->node[node].parent < 0) {
			double at[3];

			model_origin_to_file(embed->model, place, at);
			for (int axis = 0; axis < 3; axis++) {
				place[axis] = (float)at[axis];
			}
		}
		embed_put_floats(embed, place, 3);
	}
}

void embed_print_nodes(struct embed *embed)
{
	const struct model *model = embed->model;

	embed_begin_table(embed, "int16_t", "parent", "", model->node_count, 2);
	for (int i = 0; i < model->node_count; i++) {
		fprintf(embed->out, "%s%d,", i % EMBED_ROW ? " " : "\n\t",
			model->node[i].parent);
	}
	embed_end_table(embed, 1);
	fprintf(embed->out,
		"\n/* Translation, rotation, scale. */\n"
		"static const float %s_rest[%d][10] = {",
		embed->prefix, model->node_count);
	embed->rom_bytes += (size_t)model->node_count * 40;
	for (int i = 0; i < model->node_count; i++) {
		const struct transform *rest = &model->node[i].rest;

		fprintf(embed->out, "\n\t{");
		put_translations(embed, i, rest->translation, 1);
		embed_put_floats(embed, rest->rotation, 4);
		embed_put_floats(embed, rest->scale, 3);
		fprintf(embed->out, "},");
	}
	embed_end_table(embed, 1);
	embed_begin_table(embed, "float", "rest_weight", "", embed->weights, 4);
	embed_put_floats(embed, model->rest_weights, embed->weights);
	embed_end_table(embed, embed->weights);
}

static void put_matrix(struct embed *embed, const vec4 *matrix)
{
	fprintf(embed->out, "\n\t{");
	for (int column = 0; column < 4; column++) {
		embed_put_floats(embed, matrix[column], 3);
	}
	fprintf(embed->out, "},");
}

void embed_print_skins(struct embed *embed)
{
	const struct model *model = embed->model;

	if (embed->joints == 0) {
		return; /* the player does not use these tables then */
	}
	embed_begin_table(embed, "int16_t", "joint_node", "", embed->joints, 2);
	for (int s = 0; s < model->skin_count; s++) {
		for (int j = 0; j < model->skin[s].joint_count; j++) {
			fprintf(embed->out, "%s%d,",
				j % EMBED_ROW ? " " : "\n\t",
				model->skin[s].joint[j]);
		}
	}
	embed_end_table(embed, embed->joints);
	fprintf(embed->out, "\nstatic const float %s_bind[%d][12] = {",
		embed->prefix, embed->joints);
	embed->rom_bytes += (size_t)embed->joints * 48;
	for (int s = 0; s < model->skin_count; s++) {
		for (int j = 0; j < model->skin[s].joint_count; j++) {
			put_matrix(embed,
				(const vec4 *)model->skin[s].inverse_bind[j]);
		}
	}
	fprintf(embed->out, "\n};\n");
}

static void print_channels(struct embed *embed)
{
	int time = 0, value = 0;

	fprintf(embed->out,
		"\n/* path: 0 translation, 1 rotation, 2 scale, 3 weights; kind: 0 step, 1 linear, 2 cubic. */\n"
		"static const struct %s_channel {\n"
		"\tint32_t time, value;\n\tint16_t node, keys, width;\n"
		"\tuint8_t path, kind;\n} %s_clip[%d] = {",
		embed->prefix, embed->prefix,
		embed->channels ? embed->channels : 1);
	embed->rom_bytes += (size_t)(embed->channels ? embed->channels : 1) * 16;
	for (int c = 0; c < embed->channels; c++) {
		const struct model_channel *channel = &embed->clip->channel[c];
		const struct model_node *node =
			&embed->model->node[channel->node];

		fprintf(embed->out, "\n\t{%d, %d, %d, %d, %d, %d, %d},", time,
			value,
			channel->path == MODEL_WEIGHTS ? node->weight_offset
						       : channel->node,
			channel->key_count, channel->width, (int)channel->path,
			(int)channel->interpolation);
		time += channel->key_count;
		value += embed_channel_values(channel);
	}
	fprintf(embed->out, "%s\n};\n", embed->channels ? "" : "\n\t{0},");
}

static void print_values(
	struct embed *embed, const struct model_channel *channel)
{
	if (channel->path == MODEL_TRANSLATION &&
		channel->interpolation != MODEL_CUBICSPLINE) {
		put_translations(embed, channel->node, channel->value,
			channel->key_count);
		return;
	}
	if (channel->path == MODEL_TRANSLATION) {
		for (int k = 0; k < channel->key_count; k++) {
			const float *key = channel->value + 9 * k;

			embed_put_floats(embed, key, 3);
			put_translations(embed, channel->node, key + 3, 1);
			embed_put_floats(embed, key + 6, 3);
		}
		return;
	}
	if (!channel->packed) {
		embed_put_floats(
			embed, channel->value, embed_channel_values(channel));
		return;
	}
	for (int k = 0; k < channel->key_count; k++) {
		float rotation[4];

		model_channel_key(channel, k, rotation);
		embed_put_floats(embed, rotation, 4);
	}
}

void embed_print_clip(struct embed *embed)
{
	embed_begin_table(embed, "float", "time", "", embed->times, 4);
	for (int c = 0; c < embed->channels; c++) {
		embed_put_floats(embed, embed->clip->channel[c].time_s,
			embed->clip->channel[c].key_count);
	}
	embed_end_table(embed, embed->times);
	embed_begin_table(embed, "float", "value", "", embed->values, 4);
	for (int c = 0; c < embed->channels; c++) {
		print_values(embed, &embed->clip->channel[c]);
	}
	embed_end_table(embed, embed->values);
	print_channels(embed);
}

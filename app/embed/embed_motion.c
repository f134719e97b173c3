#include "app/embed/embed_internal.h"
#include "app/model/origin/model_origin.h"

/*
 * Whether a node's translations are places: at the top of the tree of a model
 * that was moved to near the origin. The source states them as the file does.
 */
static bool has_places(const struct embed *embed, int node)
{
	const double *origin = embed->model->origin;

	return embed->model->node[node].parent < 0 &&
		(origin[0] != 0 || origin[1] != 0 || origin[2] != 0);
}

static void put_place(struct embed *embed, const float *value)
{
	double at[3];
	float place[3];

	model_origin_to_file(embed->model, value, at);
	for (int axis = 0; axis < 3; axis++) {
		place[axis] = (float)at[axis];
	}
	embed_put_floats(embed, place, 3);
}

/* Puts the keys of a translation; of a cubic key, the second value is a place. */
static void put_places(struct embed *embed, const struct model_channel *channel)
{
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;
	int count = embed_channel_values(channel) / 3;

	for (int i = 0; i < count; i++) {
		const float *value = channel->value + 3 * i;

		if (cubic && i % 3 != 1) {
			embed_put_floats(embed, value, 3);
		} else {
			put_place(embed, value);
		}
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
		if (has_places(embed, i)) {
			put_place(embed, rest->translation);
		} else {
			embed_put_floats(embed, rest->translation, 3);
		}
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
		has_places(embed, channel->node)) {
		put_places(embed, channel);
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

#include "app/embed/embed_internal.h"

#include "platform/base/count.h"
#include "platform/base/printable.h"

#include <ctype.h>
#include <errno.h>
#include <string.h>

enum {
	TABLE_BYTES_MAX = 256 * 1024 * 1024
};

/* The text of app/embed/player.inc; the build makes this array from it. */
extern const char embed_player_text[];

static void add(struct embed *embed, int *sum, int count)
{
	embed->too_large = !count_add(*sum, count, sum) || embed->too_large;
}

/* Adds a * b. */
static void add_product(struct embed *embed, int *sum, int a, int b)
{
	int product = 0;

	embed->too_large = !count_multiply(a, b, &product) || embed->too_large;
	add(embed, sum, product);
}

/* An upper bound of the tables' size, before any of them is printed. */
static double table_bytes(const struct embed *embed)
{
	return 28.0 * embed->vertices + 4.0 * embed->indices +
		6.0 * embed->influences + 4.0 * embed->targets +
		50.0 * embed->joints + 4.0 * embed->weights +
		42.0 * embed->model->node_count + 60.0 * embed->parts +
		16.0 * embed->channels + 4.0 * embed->times +
		4.0 * embed->values;
}

static void count_part(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;
	int values = 0;

	add(embed, &embed->parts, 1);
	embed->dark_parts += !primitive->normal &&
		!embed->model->material[primitive->material].unlit;
	add(embed, &embed->vertices, primitive->vertex_count);
	add(embed, &embed->indices, primitive->index_count);
	add_product(embed, &values, part->mesh->target_count, 6);
	add_product(embed, &embed->targets, primitive->vertex_count, values);
	embed->wide_index = embed->wide_index || primitive->vertex_count > 65536;
	if (embed_is_skinned(part)) {
		add_product(embed, &embed->influences, primitive->vertex_count,
			primitive->influences);
	}
	/* Stops early: nodes times primitives may be very many. */
	embed->too_large =
		embed->too_large || table_bytes(embed) > TABLE_BYTES_MAX;
}

/* Counts a channel; some of its numbers have 16 bits in the player. */
static void count_channel(
	struct embed *embed, const struct model_channel *channel)
{
	const struct model_node *node = &embed->model->node[channel->node];

	embed->too_large = embed->too_large || channel->key_count > INT16_MAX ||
		channel->width > INT16_MAX ||
		(channel->path == MODEL_WEIGHTS &&
			node->weight_offset > INT16_MAX);
	add(embed, &embed->channels, 1);
	add(embed, &embed->times, channel->key_count);
	if (!embed->too_large) {
		add(embed, &embed->values, embed_channel_values(channel));
	}
}

static void count_all(struct embed *embed)
{
	const struct model *model = embed->model;

	embed_each_part(embed, count_part);
	for (int i = 0; i < model->skin_count; i++) {
		embed->skin_first[i] = embed->joints;
		add(embed, &embed->joints, model->skin[i].joint_count);
		embed->wide_joint =
			embed->wide_joint || model->skin[i].joint_count > 256;
	}
	embed->weights = model->weight_count;
	for (int c = 0; embed->clip && c < embed->clip->channel_count; c++) {
		count_channel(embed, &embed->clip->channel[c]);
	}
	embed->too_large = embed->too_large || model->node_count > INT16_MAX;
}

static int check_size(const struct embed *embed, const struct log *log)
{
	if (embed->too_large || table_bytes(embed) > TABLE_BYTES_MAX) {
		log_error(log,
			"%s: the model is too large to be C source: its tables may have up to %d MiB, with up to %d nodes, morph weights and keys of a channel",
			embed->model->path, TABLE_BYTES_MAX >> 20, INT16_MAX);
		return -EFBIG;
	}
	if (embed->parts == 0) {
		log_error(log,
			"%s: the model has nothing to draw: export it with its meshes",
			embed->model->path);
		return -EINVAL;
	}
	return 0;
}

static void put_part(struct embed *embed, const struct embed_part *part)
{
	struct embed_offsets *at = &embed->next;
	const struct model_primitive *primitive = part->primitive;
	const struct model_material *material =
		&embed->model->material[primitive->material];
	int skin = -1;

	if (embed_is_skinned(part)) {
		skin = embed->skin_first[part->node->skin];
	}
	fprintf(embed->out,
		"\n\t{{%.9g, %.9g, %.9g, %.9g}, %d, %d, %d, %d, %d, %d, "
		"%d, %d, %d, %d, %d},",
		(double)material->base_color[0], (double)material->base_color[1],
		(double)material->base_color[2], (double)material->base_color[3],
		at->vertex, primitive->vertex_count, at->index,
		primitive->index_count, at->influence,
		embed_is_skinned(part) ? primitive->influences : 0, skin,
		part->node_index, at->target, part->mesh->target_count,
		part->mesh->target_count ? part->node->weight_offset : 0);
	at->vertex += primitive->vertex_count;
	at->index += primitive->index_count;
	at->target += primitive->vertex_count * part->mesh->target_count * 6;
	if (embed_is_skinned(part)) {
		at->influence += primitive->vertex_count * primitive->influences;
	}
}

static void print_parts(struct embed *embed)
{
	fprintf(embed->out,
		"\n/* Offsets and counts of elements in the tables above. */\n"
		"static const struct %s_part {\n\tfloat color[4];\n"
		"\tint32_t vertex, vertices, index, indices;\n"
		"\tint32_t influence, influences, skin, node;\n"
		"\tint32_t target, targets, weight;\n} %s_part[%d] = {",
		embed->prefix, embed->prefix, embed->parts);
	embed->rom_bytes += (size_t)embed->parts * 60;
	embed_each_part(embed, put_part);
	fprintf(embed->out, "\n};\n");
}

static size_t ram_bytes(const struct embed *embed)
{
	size_t joints = (size_t)(embed->joints ? embed->joints : 1);
	size_t weights = (size_t)(embed->weights ? embed->weights : 1);
	size_t nodes = (size_t)embed->model->node_count;

	return nodes * (10 + 12) * 4 + weights * 4 + joints * 24 * 4 +
		(size_t)embed->vertices * 6 * 4;
}

static void print_state(struct embed *embed)
{
	const char *p = embed->prefix, *u = embed->upper;

	fprintf(embed->out,
		"\n#define %s_NODES %d\n#define %s_JOINTS %d\n"
		"#define %s_PARTS %d\n#define %s_CHANNELS %d\n"
		"#define %s_VERTICES %d\n",
		u, embed->model->node_count, u, embed->joints, u, embed->parts,
		u, embed->channels, u, embed->vertices);
	fprintf(embed->out,
		"\n/* The state: %zu bytes. */\nstruct %s_state {\n"
		"\tfloat local[%d][10], world[%d][12];\n\tfloat weight[%d];\n"
		"\tfloat palette[%d][12], normals[%d][12];\n"
		"\tfloat position[%d][3], normal[%d][3];\n};\n",
		ram_bytes(embed), p, embed->model->node_count,
		embed->model->node_count, embed->weights ? embed->weights : 1,
		embed->joints ? embed->joints : 1,
		embed->joints ? embed->joints : 1, embed->vertices,
		embed->vertices);
}

/* Writes the player with "embedded" replaced by the prefix. */
static void print_player(const struct embed *embed)
{
	static const char lower[] = "embedded", upper[] = "EMBEDDED";
	const char *at = embed_player_text;

	while (*at) {
		if (strncmp(at, lower, sizeof(lower) - 1) == 0) {
			fputs(embed->prefix, embed->out);
			at += sizeof(lower) - 1;
		} else if (strncmp(at, upper, sizeof(upper) - 1) == 0) {
			fputs(embed->upper, embed->out);
			at += sizeof(upper) - 1;
		} else {
			fputc(*at++, embed->out);
		}
	}
}

static void print_head(const struct embed *embed)
{
	fprintf(embed->out, "/*\n * ");
	printable_put_comment(embed->model->path, embed->out);
	if (embed->clip) {
		fprintf(embed->out, ", clip ");
		printable_put_comment(embed->clip->name, embed->out);
	}
	fprintf(embed->out,
		" as C: %d vertices in %d parts, %d nodes, %d joints, %d channels.\n"
		" * limber export has written this file. To use it:\n"
		" *\n"
		" *\tstatic struct %s_state state;\n"
		" *\t%s_pose(&state, time_s);          0 to %.4f seconds\n"
		" *\t%s_draw(&state, draw, NULL);       draw is your function\n"
		" *\n"
		" * With -ffast-math the results are less exact; without a floating-point\n"
		" * unit they are the same but take longer.\n"
		" */\n"
		"#include <math.h>\n#include <stdint.h>\n#include <string.h>\n",
		embed->vertices, embed->parts, embed->model->node_count,
		embed->joints, embed->channels, embed->prefix, embed->prefix,
		embed->clip ? (double)embed->clip->duration_s : 0.0,
		embed->prefix);
}

static int set_prefix(
	struct embed *embed, const char *prefix, const struct log *log)
{
	size_t length = strlen(prefix);
	bool good = length > 0 && length < EMBED_NAME_SIZE &&
		!isdigit((unsigned char)prefix[0]);

	for (size_t i = 0; good && i <= length; i++) {
		unsigned char c = (unsigned char)prefix[i];

		good = c < 128 && (isalnum(c) || c == '_' || c == '\0');
		embed->prefix[i] = prefix[i];
		embed->upper[i] = (char)toupper(c);
	}
	if (!good) {
		log_error(log,
			"%s: this name is not a C identifier of at most %d characters: give the file another name",
			prefix, EMBED_NAME_SIZE - 1);
		return -EINVAL;
	}
	return 0;
}

static int check_nodes(const struct model *model, const struct log *log)
{
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].matrix) {
			log_error(log,
				"%s: node %d has a sheared matrix, which the C player does not support: apply the scale of the nodes above its parts where the model was made",
				model->path, model->node[i].file_index);
			return -EINVAL;
		}
	}
	return 0;
}

static void print_all(struct embed *embed)
{
	print_head(embed);
	embed_print_vertices(embed);
	embed_print_nodes(embed);
	embed_print_skins(embed);
	embed_print_clip(embed);
	print_parts(embed);
	print_state(embed);
	print_player(embed);
	/* The player's own table, an identity matrix. */
	embed->rom_bytes += 48;
}

int embed_print(const struct model *model, int clip, const char *prefix,
	const struct log *log, FILE *out, struct embed_size *size)
{
	struct arena arena = arena_within(model->budget);
	struct embed embed = {
		.model = model,
		.clip = clip >= 0 ? &model->clip[clip] : NULL,
		.out = out,
		.skin_first =
			ARENA_ARRAY(&arena, int, (size_t)model->skin_count),
	};
	int error = set_prefix(&embed, prefix, log);

	if (!error && !embed.skin_first) {
		error = memory_budget_fail(model->budget, model->path, log);
	}
	if (!error) {
		error = check_nodes(model, log);
	}
	if (!error) {
		count_all(&embed);
		error = check_size(&embed, log);
	}
	if (!error) {
		print_all(&embed);
		*size = (struct embed_size){
			embed.rom_bytes, ram_bytes(&embed), embed.dark_parts};
	}
	arena_release(&arena);
	return error;
}

#include "app/embed/embed_internal.h"

#include "app/model/model_deltas.h"

enum {
	TARGET_VALUES = 6 /* of a vertex: the ways of position and normal */
};

static void put_vectors(struct embed *embed, const float (*vector)[3], int count)
{
	for (int i = 0; i < count; i++) {
		fprintf(embed->out, "\n\t{%.9g, %.9g, %.9g},",
			(double)vector[i][0], (double)vector[i][1],
			(double)vector[i][2]);
	}
}

static void put_positions(struct embed *embed, const struct embed_part *part)
{
	put_vectors(embed, (const float(*)[3])part->primitive->position,
		part->primitive->vertex_count);
}

static void put_normals(struct embed *embed, const struct embed_part *part)
{
	static const float none[1][3];
	const struct model_primitive *primitive = part->primitive;

	for (int v = 0; v < primitive->vertex_count; v++) {
		put_vectors(embed,
			primitive->normal
				? (const float(*)[3])primitive->normal + v
				: none,
			1);
	}
}

static void put_colors(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;

	for (int v = 0; v < primitive->vertex_count; v++) {
		static const uint8_t white[4] = {255, 255, 255, 255};
		const uint8_t *c =
			primitive->color ? primitive->color[v] : white;

		fprintf(embed->out, "%s{%d, %d, %d, %d},", v % 4 ? " " : "\n\t",
			c[0], c[1], c[2], c[3]);
	}
}

static void put_joints(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;
	int count = primitive->vertex_count * primitive->influences;

	for (int i = 0; embed_is_skinned(part) && i < count; i++) {
		fprintf(embed->out, "%s%d,", i % EMBED_ROW ? " " : "\n\t",
			primitive->joint[i]);
	}
}

static void put_weights(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;

	if (embed_is_skinned(part)) {
		embed_put_floats(embed, primitive->weight,
			primitive->vertex_count * primitive->influences);
	}
}

static void put_indices(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;

	for (int i = 0; i < primitive->index_count; i++) {
		fprintf(embed->out, "%s%u,", i % EMBED_ROW ? " " : "\n\t",
			(unsigned)primitive->index[i]);
	}
}

static void put_targets(struct embed *embed, const struct embed_part *part)
{
	const struct model_primitive *primitive = part->primitive;

	for (int t = 0; t < part->mesh->target_count; t++) {
		const struct model_target *target = &primitive->target[t];

		for (int v = 0; v < primitive->vertex_count; v++) {
			float delta[TARGET_VALUES];

			model_deltas_get(&target->position, v, delta);
			model_deltas_get(&target->normal, v, delta + 3);
			embed_put_floats(embed, delta, TARGET_VALUES);
		}
	}
}

void embed_print_vertices(struct embed *embed)
{
	const char *joint = embed->wide_joint ? "uint16_t" : "uint8_t";

	embed_begin_table(
		embed, "float", "position", "[3]", embed->vertices, 12);
	embed_each_part(embed, put_positions);
	embed_end_table(embed, 1);
	embed_begin_table(embed, "float", "normal", "[3]", embed->vertices, 12);
	embed_each_part(embed, put_normals);
	embed_end_table(embed, 1);
	embed_begin_table(embed, "uint8_t", "color", "[4]", embed->vertices, 4);
	embed_each_part(embed, put_colors);
	embed_end_table(embed, 1);
	embed_begin_table(embed, joint, "joint", "", embed->influences,
		embed->wide_joint ? 2 : 1);
	embed_each_part(embed, put_joints);
	embed_end_table(embed, embed->influences);
	embed_begin_table(embed, "float", "weight", "", embed->influences, 4);
	embed_each_part(embed, put_weights);
	embed_end_table(embed, embed->influences);
	/* Compilers warn about a loop, run or not, that would leave the table. */
	embed_begin_table(embed, "float", "target", "",
		embed->targets ? embed->targets : TARGET_VALUES, 4);
	embed_each_part(embed, put_targets);
	embed_end_table(embed, embed->targets);
	fprintf(embed->out, "\ntypedef %s %s_index_t;\n",
		embed->wide_index ? "uint32_t" : "uint16_t", embed->prefix);
	fprintf(embed->out, "\nstatic const %s_index_t %s_index[%d] = {",
		embed->prefix, embed->prefix,
		embed->indices ? embed->indices : 1);
	embed->rom_bytes += (size_t)(embed->indices ? embed->indices : 1) *
		(embed->wide_index ? 4 : 2);
	embed_each_part(embed, put_indices);
	embed_end_table(embed, embed->indices);
}

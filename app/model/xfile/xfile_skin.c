#include "app/model/xfile/xfile_scene.h"

static int read_vertices(struct xfile_reader *reader,
	const struct xfile_mesh *mesh, struct xfile_bone *bone)
{
	bone->vertex = ARENA_ARRAY(reader->scratch, uint32_t, bone->count);
	if (!bone->vertex) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; i < bone->count; i++) {
		size_t location = reader->token.location;
		uint32_t vertex;
		int error = xfile_read_integer(
			reader, "a vertex of SkinWeights", &vertex);

		if (error) {
			return error;
		}
		if (vertex >= mesh->vertex_count) {
			return xfile_fail_at(&reader->context, location,
				"SkinWeights of bone \"%.200s\" refers to vertex %u, but the mesh has %u vertices",
				bone->name, (unsigned)vertex,
				(unsigned)mesh->vertex_count);
		}
		bone->vertex[i] = vertex;
	}
	return 0;
}

/* Reads weights. Rounding errors, like -0.000001, count as 0. */
static int read_weights(struct xfile_reader *reader, struct xfile_bone *bone)
{
	int error;

	bone->weight = ARENA_ARRAY(reader->scratch, float, bone->count);
	if (!bone->weight) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; i < bone->count; i++) {
		size_t location = reader->token.location;

		error = xfile_read_floats(
			reader, "a skin weight", 1, &bone->weight[i]);
		if (error) {
			return error;
		}
		if (bone->weight[i] < -1e-3f) {
			return xfile_fail_at(&reader->context, location,
				"vertex %u has a negative skin weight",
				(unsigned)bone->vertex[i]);
		}
		if (bone->weight[i] < 0) {
			bone->weight[i] = 0;
		}
	}
	return 0;
}

int xfile_parse_skin_weights(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_mesh *mesh = scope->mesh;
	struct xfile_bone *bone = ARENA_NEW(reader->scratch, struct xfile_bone);
	int error;

	(void)name;
	if (!bone) {
		return xfile_no_memory(&reader->context);
	}
	bone->location = reader->token.location;
	mesh->bone_count++;
	XFILE_APPEND(mesh->bones, mesh->last_bone, bone);
	error = xfile_read_name(reader, "the name of a bone", &bone->name);
	if (!error) {
		error = xfile_read_count(
			reader, "the count of weights", 2, &bone->count);
	}
	if (!error) {
		error = read_vertices(reader, mesh, bone);
	}
	if (!error) {
		error = read_weights(reader, bone);
	}
	if (!error) {
		error = xfile_read_floats(reader,
			"an element of a bone's offset matrix", 16,
			bone->offset);
	}
	return error ? error : xfile_skip_rest(reader);
}

#include "app/model/model.h"
#include "app/model/xfile/xfile_scene.h"

#include <math.h>
#include <string.h>

/*
 * DeclData holds vertex data with the layout of a Direct3D vertex declaration
 * (D3DVERTEXELEMENT9). Newer exporters write normals, texture coordinates and
 * colours there.
 */
enum {
	TYPE_FLOAT2 = 1,
	TYPE_FLOAT3 = 2,
	TYPE_COLOR = 4, /* 0xAARRGGBB */
	USAGE_NORMAL = 3,
	USAGE_TEXCOORD = 5,
	USAGE_COLOR = 10,
	ABSENT = -1,
};

/* The size of each D3DDECLTYPE in 32-bit words. */
static const uint8_t type_words[] = {
	1, 2, 3, 4, 1, 1, 1, 2, 1, 1, 2, 1, 2, 1, 1, 1, 2};

/* Offsets in words from the start of a vertex, or ABSENT. */
struct layout {
	uint64_t stride;
	int64_t normal;
	int64_t texcoord;
	int64_t color;
};

static int read_element(struct xfile_reader *reader, struct layout *layout)
{
	size_t location = reader->token.location;
	uint32_t field[4]; /* type, method, usage, usage index */
	int error = 0;

	for (int i = 0; !error && i < 4; i++) {
		error = xfile_read_integer(
			reader, "a vertex element's description", &field[i]);
	}
	if (error) {
		return error;
	}
	if (field[0] >= sizeof(type_words)) {
		return xfile_fail_at(&reader->context, location,
			"DeclData has an element of the undefined type %u",
			(unsigned)field[0]);
	}
	if (field[3] == 0) {
		int64_t offset = (int64_t)layout->stride;

		if (field[0] == TYPE_FLOAT3 && field[2] == USAGE_NORMAL) {
			layout->normal = offset;
		} else if (field[0] == TYPE_FLOAT2 &&
			field[2] == USAGE_TEXCOORD) {
			layout->texcoord = offset;
		} else if (field[0] == TYPE_COLOR && field[2] == USAGE_COLOR) {
			layout->color = offset;
		}
	}
	layout->stride += type_words[field[0]];
	return 0;
}

static int read_words(
	struct xfile_reader *reader, uint32_t *count, uint32_t **out)
{
	int error =
		xfile_read_count(reader, "DeclData's count of words", 1, count);

	if (error) {
		return error;
	}
	*out = ARENA_ARRAY(reader->scratch, uint32_t, *count);
	if (!*out) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; !error && i < *count; i++) {
		error = xfile_read_integer(
			reader, "a word of DeclData", &(*out)[i]);
	}
	return error;
}

/*
 * Copies width floats of each vertex. words points to those of the first
 * vertex, stride is the words of a vertex.
 */
static int take_floats(struct xfile_reader *reader,
	const struct xfile_mesh *mesh, const uint32_t *words, uint64_t stride,
	int width, float **out)
{
	size_t location = reader->token.location;

	*out = ARENA_ARRAY(reader->scratch, float,
		(size_t)mesh->vertex_count *(size_t)width);
	if (!*out) {
		return xfile_no_memory(&reader->context);
	}
	for (size_t v = 0; v < mesh->vertex_count; v++) {
		float *to = *out + v * (size_t)width;

		memcpy(to, words + v * stride, (size_t)width * sizeof(*to));
		for (int i = 0; i < width; i++) {
			if (!(fabsf(to[i]) <= MODEL_NUMBER_MAX)) {
				return xfile_fail_at(&reader->context, location,
					"DeclData has a number for vertex %zu that is %s",
					v,
					isfinite(to[i]) ? "larger than 1e9"
							: "not finite");
			}
		}
	}
	return 0;
}

static int take_colors(struct xfile_reader *reader, struct xfile_mesh *mesh,
	const uint32_t *words, uint64_t stride)
{
	float *color = ARENA_ARRAY(
		reader->scratch, float, 4 * (size_t)mesh->vertex_count);

	if (!color) {
		return xfile_no_memory(&reader->context);
	}
	mesh->color = (float(*)[4])color;
	for (size_t v = 0; v < mesh->vertex_count; v++) {
		uint32_t argb = words[v * stride];

		for (int i = 0; i < 4; i++) {
			static const int shift[] = {16, 8, 0, 24};

			mesh->color[v][i] =
				(float)(argb >> shift[i] & 255) / 255.0f;
		}
	}
	return 0;
}

/*
 * Copies the attributes that the layout has, unless MeshNormals,
 * MeshTextureCoords and MeshVertexColors have them: these take precedence.
 */
static int take_layout(struct xfile_reader *reader, struct xfile_mesh *mesh,
	const struct layout *layout, const uint32_t *words)
{
	float *floats;
	int error = 0;

	if (layout->normal != ABSENT) {
		error = take_floats(reader, mesh, words + layout->normal,
			layout->stride, 3, &floats);
		mesh->declared_normal = (float(*)[3])floats;
	}
	if (!error && layout->texcoord != ABSENT && !mesh->texcoord) {
		error = take_floats(reader, mesh, words + layout->texcoord,
			layout->stride, 2, &floats);
		mesh->texcoord = (float(*)[2])floats;
	}
	if (!error && layout->color != ABSENT && !mesh->color) {
		error = take_colors(
			reader, mesh, words + layout->color, layout->stride);
	}
	return error;
}

int xfile_parse_decl_data(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct layout layout = {0, ABSENT, ABSENT, ABSENT};
	struct xfile_mesh *mesh = scope->mesh;
	size_t location = reader->token.location;
	uint32_t elements;
	uint32_t words;
	uint32_t *word;
	int error = xfile_read_count(
		reader, "DeclData's count of elements", 4, &elements);

	(void)name;
	for (uint32_t i = 0; !error && i < elements; i++) {
		error = read_element(reader, &layout);
	}
	if (!error) {
		error = read_words(reader, &words, &word);
	}
	if (!error && words != layout.stride * mesh->vertex_count) {
		error = xfile_fail_at(&reader->context, location,
			"DeclData has %u words, but %u vertices need %llu",
			(unsigned)words, (unsigned)mesh->vertex_count,
			(unsigned long long)layout.stride * mesh->vertex_count);
	}
	if (!error) {
		error = take_layout(reader, mesh, &layout, word);
	}
	return error ? error : xfile_skip_rest(reader);
}

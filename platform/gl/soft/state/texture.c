/* Texture objects and their images. */
#include <stdlib.h>
#include <string.h>

#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/state/state.h"

struct texture soft_new_texture(GLuint name)
{
	return (struct texture){
		.name = name,
		.min_filter = GL_NEAREST_MIPMAP_LINEAR,
		.mag_filter = GL_LINEAR,
		.wrap_s = GL_REPEAT,
		.wrap_t = GL_REPEAT,
	};
}

static void free_levels(struct texture *texture)
{
	for (int i = 0; i < SOFT_LEVELS; i++) {
		free(texture->level[i].texels);
		free(texture->level[i].tiles);
	}
}

/* Where the list points to the texture of that name, or its end: NULL. */
static struct texture **find_link(struct soft *soft, GLuint name)
{
	struct texture **link = &soft->textures.first[name % SOFT_TEXTURE_LISTS];

	while (*link && (*link)->name != name) {
		link = &(*link)->next;
	}
	return link;
}

static struct texture *add_texture(struct soft *soft, GLuint name)
{
	struct textures *textures = &soft->textures;
	struct texture *texture = malloc(sizeof(*texture));
	struct texture **first = &textures->first[name % SOFT_TEXTURE_LISTS];

	if (!soft_check(texture != NULL, GL_OUT_OF_MEMORY)) {
		return NULL;
	}
	*texture = soft_new_texture(name);
	texture->next = *first;
	*first = texture;
	if (name > textures->last_name) {
		textures->last_name = name;
	}
	return texture;
}

void soft_gl_GenTextures(GLsizei count, GLuint *names)
{
	struct soft *soft = soft_current();

	if (!soft_check(count >= 0, GL_INVALID_VALUE)) {
		return;
	}
	for (int i = 0; i < count; i++) {
		const struct texture *added =
			add_texture(soft, soft->textures.last_name + 1);

		names[i] = added ? added->name : 0;
	}
}

static void delete_texture(struct soft *soft, GLuint name)
{
	struct texture **link = find_link(soft, name), *texture = *link;

	if (!texture) {
		return;
	}
	for (int i = 0; i < SOFT_UNITS; i++) {
		if (soft->textures.unit[i].bound == texture) {
			soft->textures.unit[i].bound = &soft->textures.none;
			soft->changed |= GROUP_TEXTURES;
		}
	}
	*link = texture->next;
	free_levels(texture);
	free(texture);
}

void soft_gl_DeleteTextures(GLsizei count, const GLuint *names)
{
	struct soft *soft = soft_current();

	if (!soft_check(count >= 0, GL_INVALID_VALUE)) {
		return;
	}
	for (int i = 0; i < count; i++) {
		delete_texture(soft, names[i]);
	}
}

static struct texture *bound_texture(const struct soft *soft)
{
	return soft->textures.unit[soft->textures.active].bound;
}

void soft_gl_BindTexture(GLenum target, GLuint name)
{
	struct soft *soft = soft_current();
	struct texture *texture = &soft->textures.none;

	if (!soft_check(target == GL_TEXTURE_2D, GL_INVALID_ENUM)) {
		return;
	}
	if (name != 0) {
		texture = *find_link(soft, name);
		texture = texture ? texture : add_texture(soft, name);
	}
	if (texture && texture != bound_texture(soft)) {
		soft->changed |= GROUP_TEXTURES;
		soft->textures.unit[soft->textures.active].bound = texture;
	}
}

/* A format and type of glTexImage2D, and how the driver stores its texels. */
struct transfer {
	GLenum format, type;
	int source_bytes; /* of a pixel in the program's image */
	enum texel_format kept;
};

static const struct transfer transfers[] = {
	{GL_RGB, GL_UNSIGNED_BYTE, 3, TEXEL_565},
	{GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2, TEXEL_565},
	{GL_RGBA, GL_UNSIGNED_BYTE, 4, TEXEL_8888},
	{GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2, TEXEL_4444},
	{GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2, TEXEL_5551},
	{GL_ALPHA, GL_UNSIGNED_BYTE, 1, TEXEL_A8},
	{GL_LUMINANCE, GL_UNSIGNED_BYTE, 1, TEXEL_L8},
	{GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2, TEXEL_LA88},
};

/* Finds the entry; false, with GL's error set, where there is none. */
static bool choose_transfer(const struct soft *soft, GLenum format, GLenum type,
	struct transfer *out)
{
	bool format_known = false, type_known = false, pair_known = false;

	for (size_t i = 0; i < ARRAY_COUNT(transfers); i++) {
		const struct transfer *known = &transfers[i];

		format_known |= known->format == format;
		type_known |= known->type == type;
		if (known->format == format && known->type == type) {
			pair_known = true;
			*out = *known;
		}
	}
	/* In pictures of RGBA8888, RGB bytes are not cut to RGB565. */
	if (pair_known && out->source_bytes == 3 &&
		soft->format == PIXELS_RGBA8888) {
		out->kept = TEXEL_8888;
	}
	return soft_check(format_known && type_known, GL_INVALID_ENUM) &&
		soft_check(pair_known, GL_INVALID_OPERATION);
}

static int kept_bytes(enum texel_format format)
{
	return 1 << soft_texel_bytes_log2(format);
}

/* Converts a row of the program's pixels to the stored format. */
static void convert_row(const struct transfer *transfer, const uint8_t *from,
	uint8_t *to, int width)
{
	if (transfer->source_bytes != 3) {
		memcpy(to, from, (size_t)width * (size_t)transfer->source_bytes);
		return;
	}
	for (int x = 0; x < width && transfer->kept == TEXEL_565; x++) {
		store_16(to + 2 * x,
			(uint16_t)(from[3 * x] >> 3 << 11 |
				from[3 * x + 1] >> 2 << 5 |
				from[3 * x + 2] >> 3));
	}
	for (int x = 0; x < width && transfer->kept == TEXEL_8888; x++) {
		memcpy(to + 4 * x, from + 3 * x, 3);
		to[4 * x + 3] = 255;
	}
}

static void copy_rows(const struct soft *soft, const struct transfer *transfer,
	const struct level *level, const struct rectangle *part,
	const uint8_t *from)
{
	int align = soft->textures.unpack_alignment;
	int row_bytes = (part->width * transfer->source_bytes + align - 1) /
		align * align;
	int bytes = kept_bytes(level->format);

	for (int y = 0; y < part->height; y++) {
		int at = ((part->y + y) << level->width_log2) + part->x;

		convert_row(transfer, from + (size_t)y * (size_t)row_bytes,
			level->texels + (size_t)at * (size_t)bytes, part->width);
	}
}

static void define_level(struct soft *soft, struct level *level,
	const struct transfer *transfer, GLsizei width, GLsizei height,
	const void *pixels)
{
	/* Filters read a row and a texel more, with weights of 0. */
	size_t size = ((size_t)width * (size_t)height + (size_t)width + 1) *
		(size_t)kept_bytes(transfer->kept);
	const struct rectangle all = {0, 0, width, height};

	soft->changed |= GROUP_TEXTURES;
	free(level->texels);
	free(level->tiles);
	*level = (struct level){0};
	if (width == 0 || height == 0) {
		return;
	}
	level->texels = calloc(1, size);
	if (!soft_check(level->texels != NULL, GL_OUT_OF_MEMORY)) {
		return;
	}
	level->format = transfer->kept;
	level->base_format = transfer->format;
	level->width_log2 = 31 - LEADING_ZEROS_32((unsigned)width);
	level->height_log2 = 31 - LEADING_ZEROS_32((unsigned)height);
	if (pixels) {
		copy_rows(soft, transfer, level, &all, pixels);
	}
	soft_tiles_make(level);
}

/* Whether a size is 0 or a power of two, and not too large. */
static bool is_size(GLsizei size)
{
	return size >= 0 && size <= SOFT_TEXTURE_SIZE_MAX &&
		(size & (size - 1)) == 0;
}

static bool is_internal_format(GLint format)
{
	return IS_ONE_OF((GLenum)format, GL_RGB, GL_RGBA, GL_ALPHA,
		GL_LUMINANCE, GL_LUMINANCE_ALPHA);
}

void soft_gl_TexImage2D(GLenum target, GLint level, GLint internal_format,
	GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
	const void *pixels)
{
	struct soft *soft = soft_current();
	struct transfer transfer;

	if (soft_check(target == GL_TEXTURE_2D, GL_INVALID_ENUM) &&
		choose_transfer(soft, format, type, &transfer) &&
		soft_check(level >= 0 && level < SOFT_LEVELS && border == 0 &&
				is_internal_format(internal_format) &&
				is_size(width) && is_size(height),
			GL_INVALID_VALUE) &&
		soft_check((GLenum)internal_format == format,
			GL_INVALID_OPERATION)) {
		define_level(soft, &bound_texture(soft)->level[level],
			&transfer, width, height, pixels);
	}
}

static bool is_part(const struct level *level, const struct rectangle *part)
{
	const int width = 1 << level->width_log2;
	const int height = 1 << level->height_log2;

	return part->x >= 0 && part->y >= 0 && part->width >= 0 &&
		part->height >= 0 && part->width <= width &&
		part->height <= height && part->x <= width - part->width &&
		part->y <= height - part->height;
}

void soft_gl_TexSubImage2D(GLenum target, GLint number, GLint x, GLint y,
	GLsizei width, GLsizei height, GLenum format, GLenum type,
	const void *pixels)
{
	struct soft *soft = soft_current();
	const struct rectangle part = {x, y, width, height};
	struct transfer transfer;
	struct level *level;

	if (!soft_check(target == GL_TEXTURE_2D, GL_INVALID_ENUM) ||
		!choose_transfer(soft, format, type, &transfer) ||
		!soft_check(number >= 0 && number < SOFT_LEVELS,
			GL_INVALID_VALUE)) {
		return;
	}
	level = &bound_texture(soft)->level[number];
	if (soft_check(level->format == transfer.kept &&
			    level->base_format == format,
		    GL_INVALID_OPERATION) &&
		soft_check(is_part(level, &part), GL_INVALID_VALUE) && pixels) {
		copy_rows(soft, &transfer, level, &part, pixels);
		level->changed = true;
		soft->changed |= GROUP_TEXTURES;
	}
}

void soft_release_textures(struct soft *soft)
{
	for (int i = 0; i < SOFT_TEXTURE_LISTS; i++) {
		while (soft->textures.first[i]) {
			delete_texture(soft, soft->textures.first[i]->name);
		}
	}
	free_levels(&soft->textures.none);
}

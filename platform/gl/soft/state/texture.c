/* Texture objects and their pictures. */
#include <stdlib.h>
#include <string.h>

#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/soft.h"

static struct texture new_texture(GLuint name)
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

static struct texture *find_texture(struct soft *soft, GLuint name)
{
	struct texture *texture = soft->textures.first;

	while (texture && texture->name != name) {
		texture = texture->next;
	}
	return texture;
}

static struct texture *add_texture(struct soft *soft, GLuint name)
{
	struct textures *textures = &soft->textures;
	struct texture *texture = malloc(sizeof(*texture));

	if (!texture) {
		soft_set_error(soft, GL_OUT_OF_MEMORY);
		return NULL;
	}
	*texture = new_texture(name);
	texture->next = textures->first;
	textures->first = texture;
	if (name > textures->last_name) {
		textures->last_name = name;
	}
	return texture;
}

static void gen_textures(GLsizei count, GLuint *names)
{
	struct soft *soft = soft_current();

	if (count < 0) {
		soft_set_error(soft, GL_INVALID_VALUE);
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
	struct texture **link = &soft->textures.first;
	struct texture *texture;

	while (*link && (*link)->name != name) {
		link = &(*link)->next;
	}
	texture = *link;
	if (!texture) {
		return;
	}
	for (int i = 0; i < SOFT_UNITS; i++) {
		if (soft->textures.unit[i].bound == texture) {
			soft->textures.unit[i].bound = &soft->textures.none;
		}
	}
	*link = texture->next;
	free_levels(texture);
	free(texture);
}

static void delete_textures(GLsizei count, const GLuint *names)
{
	struct soft *soft = soft_current();

	if (count < 0) {
		soft_set_error(soft, GL_INVALID_VALUE);
		return;
	}
	for (int i = 0; i < count; i++) {
		delete_texture(soft, names[i]);
	}
}

static void bind_texture(GLenum target, GLuint name)
{
	struct soft *soft = soft_current();
	struct texture *texture = &soft->textures.none;

	if (target != GL_TEXTURE_2D) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	if (name != 0) {
		texture = find_texture(soft, name);
		texture = texture ? texture : add_texture(soft, name);
	}
	if (texture) {
		soft->textures.unit[soft->textures.active].bound = texture;
	}
}

static void active_texture(GLenum unit)
{
	struct soft *soft = soft_current();

	if (unit - GL_TEXTURE0 >= SOFT_UNITS) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	soft->textures.active = (int)(unit - GL_TEXTURE0);
}

static struct texture *bound_texture(struct soft *soft)
{
	return soft->textures.unit[soft->textures.active].bound;
}

static void tex_parameter(GLenum target, GLenum name, GLfixed value)
{
	struct soft *soft = soft_current();
	struct texture *texture = bound_texture(soft);
	GLenum v = (GLenum)value;
	bool plain = v == GL_NEAREST || v == GL_LINEAR;
	bool mipmap =
		v >= GL_NEAREST_MIPMAP_NEAREST && v <= GL_LINEAR_MIPMAP_LINEAR;
	bool wrap = v == GL_REPEAT || v == GL_CLAMP_TO_EDGE;

	if (target != GL_TEXTURE_2D) {
		soft_set_error(soft, GL_INVALID_ENUM);
	} else if (name == GL_TEXTURE_MIN_FILTER && (plain || mipmap)) {
		texture->min_filter = v;
	} else if (name == GL_TEXTURE_MAG_FILTER && plain) {
		texture->mag_filter = v;
	} else if (name == GL_TEXTURE_WRAP_S && wrap) {
		texture->wrap_s = v;
	} else if (name == GL_TEXTURE_WRAP_T && wrap) {
		texture->wrap_t = v;
	} else {
		soft_set_error(soft, GL_INVALID_ENUM);
	}
}

static void pixel_store(GLenum name, GLint value)
{
	struct soft *soft = soft_current();

	if (name != GL_UNPACK_ALIGNMENT && name != GL_PACK_ALIGNMENT) {
		soft_set_error(soft, GL_INVALID_ENUM);
	} else if (value != 1 && value != 2 && value != 4 && value != 8) {
		soft_set_error(soft, GL_INVALID_VALUE);
	} else if (name == GL_UNPACK_ALIGNMENT) {
		soft->textures.unpack_alignment = value;
	} else {
		soft->textures.pack_alignment = value;
	}
}

/* How a program's picture is read and kept. */
struct transfer {
	int source_bytes; /* a pixel */
	enum texel_format kept;
	GLenum format, type;
};

static bool is_format(GLenum format)
{
	return format == GL_RGB || format == GL_RGBA || format == GL_ALPHA ||
		format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;
}

/* 0, or the error GL has for this pair. */
static GLenum choose_transfer(const struct soft *soft, GLenum format,
	GLenum type, struct transfer *out)
{
	bool wide = soft->format == PIXELS_RGBA8888;

	*out = (struct transfer){2, TEXEL_NONE, format, type};
	if (!is_format(format)) {
		return GL_INVALID_ENUM;
	}
	switch (type) {
	case GL_UNSIGNED_SHORT_5_6_5:
		out->kept = TEXEL_565;
		return format == GL_RGB ? 0 : GL_INVALID_OPERATION;
	case GL_UNSIGNED_SHORT_4_4_4_4:
		out->kept = TEXEL_4444;
		return format == GL_RGBA ? 0 : GL_INVALID_OPERATION;
	case GL_UNSIGNED_SHORT_5_5_5_1:
		out->kept = TEXEL_5551;
		return format == GL_RGBA ? 0 : GL_INVALID_OPERATION;
	case GL_UNSIGNED_BYTE:
		break;
	default:
		return GL_INVALID_ENUM;
	}
	switch (format) {
	case GL_RGB:
		out->source_bytes = 3;
		out->kept = wide ? TEXEL_8888 : TEXEL_565;
		break;
	case GL_RGBA:
		out->source_bytes = 4;
		out->kept = TEXEL_8888;
		break;
	case GL_ALPHA:
		out->source_bytes = 1;
		out->kept = TEXEL_A8;
		break;
	case GL_LUMINANCE:
		out->source_bytes = 1;
		out->kept = TEXEL_L8;
		break;
	default:
		out->kept = TEXEL_LA88;
		break;
	}
	return 0;
}

static int kept_bytes(enum texel_format format)
{
	switch (format) {
	case TEXEL_8888:
		return 4;
	case TEXEL_L8:
	case TEXEL_A8:
		return 1;
	default:
		return 2;
	}
}

/* One row of texels into the kept format. */
static void convert_row(const struct transfer *transfer, const uint8_t *from,
	uint8_t *to, int width)
{
	if (transfer->format != GL_RGB || transfer->type != GL_UNSIGNED_BYTE) {
		memcpy(to, from, (size_t)width * (size_t)transfer->source_bytes);
		return;
	}
	for (int x = 0; x < width; x++, from += 3) {
		uint16_t packed = (uint16_t)(from[0] >> 3 << 11 |
			from[1] >> 2 << 5 | from[2] >> 3);

		if (transfer->kept == TEXEL_565) {
			memcpy(to + 2 * x, &packed, 2);
		} else {
			memcpy(to + 4 * x, from, 3);
			to[4 * x + 3] = 255;
		}
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

/* The logarithm of a power of two up to the largest size, or -1. */
static int size_log2(GLsizei size)
{
	for (int i = 0; i < SOFT_LEVELS; i++) {
		if (size == 1 << i) {
			return i;
		}
	}
	return -1;
}

static void define_level(struct soft *soft, struct level *level,
	const struct transfer *transfer, GLsizei width, GLsizei height,
	const void *pixels)
{
	/* A row and a texel more: they are read, with weights of 0. */
	size_t size = ((size_t)width * (size_t)height + (size_t)width + 1) *
		(size_t)kept_bytes(transfer->kept);
	const struct rectangle all = {0, 0, width, height};

	free(level->texels);
	free(level->tiles);
	*level = (struct level){0};
	if (width == 0 || height == 0) {
		return;
	}
	level->texels = calloc(1, size);
	if (!level->texels) {
		soft_set_error(soft, GL_OUT_OF_MEMORY);
		return;
	}
	level->format = transfer->kept;
	level->base_format = transfer->format;
	level->width_log2 = size_log2(width);
	level->height_log2 = size_log2(height);
	if (pixels) {
		copy_rows(soft, transfer, level, &all, pixels);
	}
	soft_tiles_make(level);
}

static void tex_image(GLenum target, GLint level, GLint internal_format,
	GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,
	const void *pixels)
{
	struct soft *soft = soft_current();
	struct transfer transfer;
	GLenum error;

	if (target != GL_TEXTURE_2D) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	error = choose_transfer(soft, format, type, &transfer);
	if (error) {
		soft_set_error(soft, error);
		return;
	}
	if (level < 0 || level >= SOFT_LEVELS || border != 0 ||
		!is_format((GLenum)internal_format) ||
		(width != 0 && size_log2(width) < 0) ||
		(height != 0 && size_log2(height) < 0)) {
		soft_set_error(soft, GL_INVALID_VALUE);
		return;
	}
	if ((GLenum)internal_format != format) {
		soft_set_error(soft, GL_INVALID_OPERATION);
		return;
	}
	define_level(soft, &bound_texture(soft)->level[level], &transfer, width,
		height, pixels);
}

static void tex_sub_image(GLenum target, GLint number, GLint x, GLint y,
	GLsizei width, GLsizei height, GLenum format, GLenum type,
	const void *pixels)
{
	struct soft *soft = soft_current();
	const struct rectangle part = {x, y, width, height};
	struct transfer transfer;
	struct level *level;
	GLenum error;

	if (target != GL_TEXTURE_2D) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	error = choose_transfer(soft, format, type, &transfer);
	if (error || number < 0 || number >= SOFT_LEVELS) {
		soft_set_error(soft, error ? error : GL_INVALID_VALUE);
		return;
	}
	level = &bound_texture(soft)->level[number];
	if (level->format != transfer.kept || level->base_format != format) {
		soft_set_error(soft, GL_INVALID_OPERATION);
		return;
	}
	if (x < 0 || y < 0 || width < 0 || height < 0 ||
		width > 1 << level->width_log2 ||
		height > 1 << level->height_log2 ||
		x > (1 << level->width_log2) - width ||
		y > (1 << level->height_log2) - height) {
		soft_set_error(soft, GL_INVALID_VALUE);
		return;
	}
	if (pixels) {
		copy_rows(soft, &transfer, level, &part, pixels);
		soft_tiles_update(level);
	}
}

void soft_init_textures(struct soft *soft)
{
	struct textures *textures = &soft->textures;
	struct gl *gl = &soft->base.gl;

	textures->none = new_texture(0);
	for (int i = 0; i < SOFT_UNITS; i++) {
		textures->unit[i].bound = &textures->none;
	}
	textures->unpack_alignment = 4;
	textures->pack_alignment = 4;
	gl->GenTextures = gen_textures;
	gl->DeleteTextures = delete_textures;
	gl->BindTexture = bind_texture;
	gl->ActiveTexture = active_texture;
	gl->TexParameterx = tex_parameter;
	gl->PixelStorei = pixel_store;
	gl->TexImage2D = tex_image;
	gl->TexSubImage2D = tex_sub_image;
}

void soft_release_textures(struct soft *soft)
{
	struct texture *texture = soft->textures.first;

	while (texture) {
		struct texture *next = texture->next;

		free_levels(texture);
		free(texture);
		texture = next;
	}
	free_levels(&soft->textures.none);
}

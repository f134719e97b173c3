/*
 * A draw call: what it derives from the state, its vertices and the triangle
 * under way. All of this is scratch memory of fixed size.
 *
 * Number formats, where no suffix of a name, such as _q16, says them:
 *	position    one exponent a call: its largest coordinate is just below
 *	            2^30; position_q is the number of fraction bits
 *	clip        one exponent a call, |coordinate| < 2^29
 *	window x, y 4 bits of fraction, y downwards; 0 to 2^17. Where both stay
 *	            below 2^15 a word holds both, see struct cache_tag
 *	window z    18 bits, 2 of them fraction
 *	attributes  colours and fog 8.8, 0x80 to 0xFF80; texture coordinates
 *	            16.16 in vertices, in triangles texels of the base level
 *	            with 8 bits of fraction
 *	planes      8 bits of fraction more than the attributes; they wrap, and
 *	            are right modulo 2^32 inside of their triangle
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_DRAW_H
#define PLATFORM_GL_SOFT_VERTEX_DRAW_H

#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/soft.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/shading.h"

enum {
	VERTEX_CACHE = 512, /* a power of two */
	/*
	 * Triangles up to this width and height, in 1/16 of pixels, are set up
	 * in 32 bits where attributes differ by less than SMALL_DELTA.
	 */
	SMALL_EXTENT = 2047,
	SMALL_DELTA = 1 << 18,
	/* In viewports that end here, a word holds a vertex's x and y. */
	PACKED_PIXELS = 2047,
	CLIP_VERTICES = 9,     /* a triangle cut by six planes */
	PERSPECTIVE_STEP = 16, /* pixels between exact divisions */
	LUMINANCE_RUN = 512,   /* longest run of luminance.c, in pixels */
	RECENT_CALLS = 32,     /* that counts.c remembers; a power of two */
};

enum attribute {
	RED,
	GREEN,
	BLUE,
	ALPHA,
	FOG,
	TEX_S, /* s and t of unit 0, then those of unit 1 */
	ATTRIBUTES = TEX_S + 2 * SOFT_UNITS,
	/* planes of values that are no attributes */
	DEPTH = ATTRIBUTES,
	INVERSE_W,
	PLANES,
};

/* Outcodes: the planes of the clip volume that a vertex lies outside of. */
enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
};

/*
 * Three cache lines: all triangles read the first one, those with textures or
 * fog the second one; clipping and two-sided lighting use the third one.
 * arm/vertex.S knows the offsets.
 */
struct vertex {
	_Alignas(32) uint8_t w_zeros; /* leading zeros of clip[3] */
	uint8_t outcode;
	bool shaded;     /* attribute and back are computed */
	int32_t x, y, z; /* window coordinates, if outcode is 0 */
	int32_t attribute[ATTRIBUTES];
	int32_t inverse_w_q30; /* 2^62 / (clip[3] << w_zeros) */
	uint32_t index;
	_Alignas(32) int32_t clip[4];
	int32_t back[4]; /* colour of the back, if lighting is two-sided */
};

/*
 * Which vertex a slot of the cache holds and, while draw->packed, its window x
 * and y in one word, y in the upper half. TAG_OUTSIDE marks a vertex outside of
 * the clip volume: xy is undefined then, and struct vertex has the index.
 */
#define PLACE_EMPTY UINT32_MAX
#define TAG_OUTSIDE (UINT32_MAX - 1)
struct cache_tag {
	_Alignas(8) uint32_t tag; /* index, PLACE_EMPTY or TAG_OUTSIDE */
	uint32_t xy;
};

struct texture_input {
	bool used, identity;
	bool plain_floats; /* coordinates are GL_FLOAT, the matrix identity */
	const struct array *array;
	int32_t matrix[2][3]; /* s', t' from s, t, 1 */
	int matrix_q;
	int width_log2, height_log2;
	struct texture *texture;
	const struct level *base;
	int levels; /* number of mipmap levels; 1 without mipmaps */
	const struct texenv *env;
	GLenum mode; /* of the environment, simplified: see combine_rows.h */
};

struct plane {
	uint32_t start; /* at the centre of column 0 in the first row */
	int32_t dx, dy; /* change by pixel to the right, and down */
};

/*
 * The terms of degree two that a polynomial has besides its plane: xx x^2 +
 * xy x y + yy y^2 at column x, row y from the plane's start. Wraps as planes do.
 */
struct bend {
	int32_t xx, xy, yy;
};

/* What a triangle's gradients have in common; frame.h finds and uses it. */
struct frame {
	int32_t x1, less_y1, less_x2, y2; /* from v[0]: x1, -y1, -x2, y2 */
	/* 2^62 / (area << zeros), negative if middle_left; 0 of tiny areas */
	int32_t inverse_area;
	int32_t inverse; /* inverse << shift is 2^44 / area, below 2^32 */
	int zeros, shift;
	int32_t off_x, off_y; /* from v[0] to column's centre, first row */
	int column;           /* that v[0] lies in */
	bool middle_left;     /* the middle vertex lies left of the long edge */
};

enum {
	RASTER_LISTED =
		INT32_MIN + 1 /* raster.top of a small triangle that is drawn */
};

/* The triangle under way. */
struct raster {
	struct frame frame;
	struct plane plane[PLANES];
	bool perspective;    /* planes of s / w and t / w, divided by 1 / w */
	bool colors_divided; /* colours too; see rows_is_divided() */
	bool bent;           /* s and t are polynomials instead; see bend.c */
	int bent_pixels;     /* if bent: the longest run drawn linearly */
	struct bend bend[ATTRIBUTES];  /* if bent: of s and t */
	int middle_column, middle_row; /* if bent: the triangle's centre */
	/* least and largest s and t, in 1/256 of the base's texels */
	int32_t texel_range[2 * SOFT_UNITS][2];
	int tex_shift[2 * SOFT_UNITS]; /* scale of s / w and t / w */
	int moving[ATTRIBUTES];        /* the attributes that have planes */
	int moving_count;
	int top;              /* the planes' first row, or RASTER_LISTED */
	uint32_t moving_bits; /* bits of attributes that are not constant */
	uint32_t constant[FOG + 1]; /* colours and fog that have no planes */
	int lod[SOFT_UNITS];        /* levels of detail, 8 bits of fraction */
};

/* The position array's type; arm/vertex.S fetches all kinds but the last. */
enum position_kind {
	POSITION_SHORTS, /* three */
	POSITION_FLOATS, /* three, in range and aligned */
	POSITION_OTHER,
};

/*
 * Transforms positions to window coordinates; arm/vertex.S knows the offsets. A
 * clip coordinate is moved + row . position, with the products shifted right by
 * 16 for shorts, else by 32.
 */
struct view {
	_Alignas(32) int32_t moved_x;
	int32_t moved_y, row_x[3], row_y[3];
	int32_t row_z[3], row_w[3], moved_z, moved_w;
	const uint8_t *positions;
	int stride_bytes;
	enum position_kind kind;
	float scale; /* 2^position_q, which floats are multiplied by */
	int32_t center_x_q8, center_y_q8, width_q10, height_q10;
	int32_t center_z, depth; /* window z of 0, its scale of z / w in Q29 */
	const uint16_t *reciprocals; /* soft_reciprocal_table */
};

/* The triangle under way, drawn from a luminance texture. */
struct tiled {
	bool by_share;             /* luminance times a gray that varies */
	int level;                 /* of detail; -1: none is chosen yet */
	const struct tiles *tiles; /* of the level */
	int from_fine; /* pixels drawn for each place of run.fine; 0: not read */
	uint32_t mixed; /* what draw->mixed was made of, see make_mixed() */
	/* The run under way; share is the gray as a factor, 8.8 of 256. */
	struct tile_run run;
	uint16_t *pixel;
	uint32_t alpha, share; /* at the first pixel; alpha is 8.16 */
	int32_t alpha_right, share_right; /* steps a pixel */
};

struct setup; /* raster.h */

typedef void (*fill_function)(struct draw *draw, struct setup *setup);

/* All that rejecting and setting up small triangles needs, for arm/list.S. */
struct fast_setup {
	fill_function fill;
	struct cache_tag *place;
	struct vertex *cache;
	/* positive areas are clockwise in the picture */
	_Alignas(8) uint32_t cull_side; /* culls areas > 0: all ones; < 0: 0 */
	uint32_t cull_mask;             /* 1 << 31; 0: nothing is culled */
	/* draw->box in cache_tag.xy's format, a column narrower at both sides */
	uint32_t box_low, box_high;
	uintptr_t depth;        /* address of column 0, row 0 */
	uintptr_t stride_bytes; /* of depths */
	/* from a depth's address, twice that in RGBA8888, + 2 to its pixel's */
	uintptr_t pixels;
	uint32_t attributes; /* draw->attributes; 0: no corner is shaded */
	uint32_t back_flip;  /* 1: positive areas are back faces; else 0 */
};

/* What counts.c remembers of a draw call. */
struct counted_call {
	const uint8_t *positions;
	double vertices;
};

struct draw {
	struct view view; /* first: arm/vertex.S */
	struct fast_setup fast_setup;
	struct soft *soft;
	GLenum primitive; /* GL_POINTS, GL_LINES or GL_TRIANGLES */
	int exponent;     /* of positions: see soft_array_position_exponent() */
	/* soft_fill_textured()'s, soft_fill_narrow()'s */
	void (*fill_band)(void *band);
	/* eye coordinates of positions, eye_q fraction bits, below 2^28 */
	int32_t eye[3][4];
	int eye_q, position_q;
	bool passes;         /* there are fragments that pass the alpha test */
	bool draws;          /* these lie in the picture */
	bool same_texcoords; /* both units have the same array */
	bool checked; /* positions may be out of range: each is checked */
	struct clip_box box;
	/*
	 * Window x and y of vertices inside of the clip volume are below 2^15,
	 * so cache_tag.xy is valid, and the state is one that soft_list() draws
	 */
	bool packed;
	bool perspective, eye_needed, fogged;
	bool shade_more;   /* vertices have fog or texture coordinates */
	int32_t fog_scale; /* 1 / (end - start), fog_scale_q fraction bits */
	int fog_scale_q;
	struct shading shading;
	struct spec_table spec_table; /* of the last shininess */
	struct texture_input texture[SOFT_UNITS];
	const GLfixed *added; /* colour added to all fragments, or NULL */
	uint32_t attributes;  /* bits of those that are interpolated */
	/* fragments */
	bool offset; /* polygon offset applies */
	bool hides;  /* what lies behind the depth buffer changes nothing */
	bool smooth; /* smooth (antialiased) points or lines */
	bool front_is_ccw, cull_front, cull_back, blended;
	fill_function fill;     /* the chosen path; called by fast_setup.fill */
	bool lists;             /* raster/thin_line.c draws points or lines */
	struct flat_color flat; /* for soft_fill_flat() */
	struct tiled tiled;     /* luminance.c's */
	bool divides;    /* s and t are divided, not bent: see soft_bend() */
	bool rectangles; /* soft_fill_rectangle() may draw two triangles as one */
	struct soft_spans spans;
	struct vertex *provoking; /* whose colour GL_FLAT uses */
	struct vertex copies[3];  /* of corners: see triangle.c */
	/*
	 * NULL, or the lowest corner of a parallelogram, which lies opposite to
	 * the highest one and not to the left of all others: the triangle of
	 * these is drawn, except that two of its edges end here.
	 */
	const struct vertex *fourth;
	struct raster raster;
	/*
	 * luminance.c's tables [luminance in halves of 127ths]: its RGB565 in
	 * shade_color; the same blended with a pixel; its value of 0 to 255
	 */
	uint32_t shade_color[3], shade[255], mixed[255], luminance[255];
	uint32_t gray[256];                    /* RGB565 of each gray */
	uint16_t shaded[LUMINANCE_RUN + 1];    /* a run before gray or alpha */
	int32_t inverse_q31[SMALL_EXTENT + 1]; /* 2^31 / n; of 0 and 1 the most */
	struct cache_tag place[VERTEX_CACHE]; /* [slot of cache] */
	struct vertex cache[VERTEX_CACHE];    /* [index % VERTEX_CACHE] */
	struct vertex apart[3]; /* corners whose slot another corner takes */
	struct vertex clipped[2 * CLIP_VERTICES + 6];
	/* counts.c's, while a program counts */
	fill_function counted_fill;
	/* the triangle's runs by span functions, and those by draw_anywhere */
	uint32_t counted_runs, counted_across, counted_across_pixels;
	struct counted_call recent[RECENT_CALLS]; /* ring buffer */
	uint32_t recent_next;
	uint32_t counted[VERTEX_CACHE]; /* tags of vertices counted already */
};

/* cache_tag.xy of a vertex inside of the clip volume, while draw->packed. */
static inline uint32_t vertex_xy(const struct vertex *vertex)
{
	return (uint32_t)vertex->y << 16 | (uint32_t)vertex->x;
}

/* prepare.c: sets what no draw call changes: tables and constants. */
void soft_init_scratch(struct draw *draw);

/*
 * prepare.c: derives struct draw from the state for a call of count vertices
 * from first on, in a mode of DrawArrays(), as far as the state has changed
 * since the last call. False when there is nothing to draw.
 */
bool soft_prepare(struct soft *soft, struct draw *draw, GLenum mode,
	uint32_t first, uint32_t count);

/* Parts of that, as prepare.c lists them. prepare_light.c: fill draw->shading. */
void soft_prepare_sides(struct soft *soft, struct draw *draw);
void soft_prepare_normals(struct soft *soft, struct draw *draw);
void soft_prepare_sources(struct soft *soft, struct draw *draw);
void soft_prepare_directions(struct soft *soft, struct draw *draw);
void soft_prepare_lit_arrays(struct soft *soft, struct draw *draw);
/* triangle.c: sets draw->packed and draw->fast_setup, after all else. */
void soft_prepare_fast_setup(struct soft *soft, struct draw *draw);
/* fill_flat.c: sets draw->flat. */
void soft_prepare_flat(struct soft *soft, struct draw *draw);

/* arm/vertex.S or portable/vertices.c: fetches, transforms, does not shade. */
void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out);
/* vertex.c: the same in C, for all kinds of positions. */
void soft_transform_c(
	const struct draw *draw, uint32_t index, struct vertex *out);
/* Finds window coordinates of a vertex inside of the clip volume. */
void soft_project(const struct draw *draw, struct vertex *vertex);
/* light.c: computes the vertex's attributes, and back if two-sided. */
void soft_shade_vertex(const struct draw *draw, struct vertex *vertex);
/* light.c: 1 / (k[0] + k[1] d + k[2] d^2) at a distance d, 16.16, limited. */
int32_t soft_light_fade(const int32_t k_q16[3], int32_t distance_q16);
/* light.c: a share of light times a spot's factor towards a direction. */
int32_t soft_light_spot(const struct light_source *source,
	const int32_t towards_q30[3], int32_t share_q16);
/* The same, unless the vertex is shaded or no attribute is interpolated. */
static inline void soft_shade(const struct draw *draw, struct vertex *vertex)
{
	if (!vertex->shaded && draw->attributes != 0) {
		soft_shade_vertex(draw, vertex);
	}
}

/* array.c: an array's element, or the current value, in fixed point. */
void soft_array_position(
	const struct draw *draw, uint32_t index, int32_t out[3]);
/* of any length if normalize is on: normals of one direction are alike then */
void soft_array_normal_q28(
	const struct draw *draw, uint32_t index, int32_t out[3]);
void soft_array_color_q16(
	const struct draw *draw, uint32_t index, int32_t out[4]);
void soft_array_texcoord_q16(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2]);
/* e, where the positions' coordinates are below 2^(e + 1) in magnitude. */
int soft_array_position_exponent(
	const struct array *array, uint32_t first, uint32_t count);

/* shade.c: the colour without lighting; then fog and texture coordinates. */
void soft_shade_color(const struct draw *draw, struct vertex *vertex);
void soft_shade_rest(const struct draw *draw, struct vertex *vertex);
/* shade.c: a vertex's position in eye space, draw->eye_q, from coordinate first on. */
void soft_shade_find_eye(
	const struct draw *draw, uint32_t index, int first, int32_t out[3]);
/* shade.c: a distance of q fraction bits as 16.16, limited. */
int32_t soft_shade_to_q16(int32_t distance, int q);

/* clip.c: shades and cuts a triangle; fills what is inside. */
void soft_clip_triangle(struct draw *draw, struct vertex *const v[3]);
/* The same of a line whose ends are shaded. */
void soft_clip_line(struct draw *draw, struct vertex *a, struct vertex *b);

/*
 * counts.c: counts a prepared call's vertices in soft->counts, and replaces
 * draw->fill by a function that also counts triangles.
 */
struct source;
void soft_count_call(
	struct draw *draw, const struct source *source, GLenum mode);

/*
 * fast/paths.c: sets draw->fill to the fastest path that draws this state, with
 * whatever else the path needs.
 */
void soft_choose_path(struct draw *draw);

/*
 * triangle.c: draws the triangle of three projected vertices. Shades them if it
 * is not culled and may cover a pixel's centre.
 */
void soft_fill_triangle(struct draw *draw, struct vertex *const v[3]);

/*
 * thin_line.c: whether it draws a prepared call's points or lines: sharp ones
 * without a texture, and lines one pixel wide. These have a pixel for each
 * column, or for each row of steep lines, as GL ES 1.1 section 3.4.1 has it;
 * line.c makes two triangles of others.
 */
bool soft_lists_primitives(const struct draw *draw);
/* thin_line.c: draws a line between shaded vertices at different places. */
void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);
/* thin_line.c: draws a shaded point that covers the pixels of a box. */
void soft_draw_sharp_point(
	struct draw *draw, const struct vertex *v, struct clip_box place);

/* line.c: draw a point; a line between shaded vertices inside the volume. */
void soft_draw_point(struct draw *draw, struct vertex *v);
void soft_draw_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);

#endif

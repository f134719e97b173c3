/*
 * A draw call: what is derived from the state for it, its vertices and the
 * triangle under way. All of it is scratch of fixed size.
 *
 * Numbers, by their names' endings or here:
 *	position    block floating: the array's largest coordinate is just below
 *	            2^30; position_q says where the point is
 *	clip        block floating for all of the draw, |coordinate| < 2^29
 *	window x, y 4 bits of fraction, y downwards; 0 to 2^17. Below 2^15 they
 *	            also go as one number, see struct cache_tag
 *	window z    2 bits of fraction: 18 bits
 *	attributes  colours and fog 8.8 with 0x80 to spare at either end,
 *	            texture coordinates 16.16, then texels with 8 bits of
 *	            fraction
 *	planes      8 bits of fraction more than the attributes; they wrap, and
 *	            are right modulo 2^32 inside of their triangle
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_DRAW_H
#define PLATFORM_GL_SOFT_VERTEX_DRAW_H

#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/soft.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/key.h"
#include "platform/gl/soft/vertex/shading.h"

enum {
	VERTEX_CACHE = 512, /* a power of two */
	/*
	 * Up to so many sixteenths of a pixel, and with attributes that differ
	 * by less than SMALL_DELTA, products of a triangle's set-up fit 32 bits.
	 */
	SMALL_EXTENT = 2047,
	SMALL_DELTA = 1 << 18,
	/* Viewports that end there have their x and y as one number. */
	PACKED_PIXELS = 2047,
	CLIP_VERTICES = 9,     /* a triangle cut by six planes */
	PERSPECTIVE_STEP = 16, /* pixels between exact divisions */
	LUMINANCE_RUN = 512,   /* pixels of luminance.c's at a time */
	RECENT_CALLS = 32,     /* that counts.c remembers; a power of two */
};

enum attribute {
	RED,
	GREEN,
	BLUE,
	ALPHA,
	FOG,
	TEX_S, /* and T; then the next unit's */
	ATTRIBUTES = TEX_S + 2 * SOFT_UNITS,
	/* planes have two more */
	DEPTH = ATTRIBUTES,
	INVERSE_W,
	PLANES,
};

/* Outside of which planes of the clip volume. */
enum {
	OUT_LEFT = 1,
	OUT_RIGHT = 2,
	OUT_BOTTOM = 4,
	OUT_TOP = 8,
	OUT_NEAR = 16,
	OUT_FAR = 32,
};

/*
 * Three cache lines: what every triangle wants, what textured ones want
 * besides, and what clipping and two sides want. arm/vertex.S knows the
 * offsets.
 */
struct vertex {
	_Alignas(32) uint8_t w_zeros;
	uint8_t outcode;
	bool shaded;     /* attributes and back are there */
	int32_t x, y, z; /* window, where outcode is 0 */
	int32_t attribute[ATTRIBUTES];
	int32_t inverse_w_q30; /* 2^62 / (w << w_zeros) */
	uint32_t index;
	_Alignas(32) int32_t clip[4];
	int32_t back[4]; /* colour of the other side, if there are two */
};

/*
 * Which vertex is in a slot of the cache, and its window x and y as one number,
 * y in the upper half, while draw->packed. A tag of TAG_OUTSIDE says that the
 * vertex lies outside of the clip volume: then xy is nothing, and the vertex
 * itself has the index.
 */
#define PLACE_EMPTY UINT32_MAX
#define TAG_OUTSIDE (UINT32_MAX - 1)
struct cache_tag {
	_Alignas(8) uint32_t tag; /* else the index */
	uint32_t xy;
};

struct texture_input {
	bool used, identity;
	bool plain_floats; /* coordinates that no matrix changes */
	const struct array *array;
	int32_t matrix[2][3]; /* s', t' from s, t, 1 */
	int matrix_q;
	int width_log2, height_log2;
	const struct texture *texture;
	const struct level *base;
	int levels; /* how many there are to choose from */
	const struct texenv *env;
	GLenum mode; /* the environment's: see combine_rows.h */
};

struct plane {
	uint32_t start; /* at the centre of column 0, of the row under way */
	int32_t dx, dy;
};

/*
 * What a plane is less than a value that bends: xx x^2 + xy x y + yy y^2, of
 * columns x and rows y from where the plane starts. It wraps as the plane does.
 */
struct bend {
	int32_t xx, xy, yy;
};

/* Fragments of a row, and how their values run. */
struct span {
	int x, y, count;
	uint32_t value[PLANES];
	int32_t step[PLANES];
	int lod[SOFT_UNITS]; /* level, 8 bits of fraction */
};

/* What all gradients of a triangle share; frame.h finds and uses it. */
struct frame {
	int32_t x1, less_y1, less_x2, y2; /* from the first vertex */
	/* 2^62 over the area << zeros, with its sign; 0 of too small an area */
	int32_t inverse_area;
	int32_t inverse; /* the same << shift, of areas of 32 bits */
	int zeros, shift;
	int32_t off_x, off_y; /* to the centre of column, of the first row */
	int column;
	bool middle_left; /* the middle vertex lies left of the long edge */
};

enum {
	RASTER_LISTED =
		INT32_MIN + 1 /* raster.top: it was small, and is drawn */
};

/* The triangle under way. */
struct raster {
	struct frame frame;
	struct plane plane[PLANES];
	bool perspective;    /* texture coordinates are divided by 1 / w */
	bool colors_divided; /* and colours too; see rows_is_divided() */
	bool bent;           /* texture coordinates bend instead; see bend.c */
	int bent_pixels;     /* that run linearly then, at most */
	struct bend bend[ATTRIBUTES];  /* of texture coordinates */
	int middle_column, middle_row; /* of the triangle then */
	/* the least and the largest, in 1/256 of texels */
	int32_t texel_range[2 * SOFT_UNITS][2];
	int tex_shift[2 * SOFT_UNITS]; /* of perspective coordinates */
	int moving[ATTRIBUTES];        /* the attributes that have planes */
	int moving_count;
	int top; /* the row that planes begin in, or RASTER_LISTED */
	uint32_t moving_bits;
	struct span span; /* of the row under way, and what is the same in all */
};

/* How positions are given; all but the last are fast to fetch. */
enum position_kind {
	POSITION_SHORTS, /* three */
	POSITION_FLOATS, /* three, in range and aligned */
	POSITION_OTHER,
};

/*
 * From positions to the window; arm/vertex.S knows the offsets. A row of the
 * matrix gives a clip coordinate: moved + row . position, the products shifted
 * by 16 for shorts, else by 32.
 */
struct view {
	_Alignas(32) int32_t moved_x;
	int32_t moved_y, row_x[3], row_y[3];
	int32_t row_z[3], row_w[3], moved_z, moved_w;
	const uint8_t *positions;
	int stride_bytes;
	enum position_kind kind;
	float scale; /* of floats */
	int32_t center_x_q8, center_y_q8, width_q10, height_q10;
	int32_t center_z, depth;     /* 2 bits of fraction; for z / w in Q29 */
	const uint16_t *reciprocals; /* soft_reciprocal_table */
};

/* The triangle under way, drawn from a luminance texture. */
struct tiled {
	bool by_share;             /* in shades of gray */
	int level;                 /* of the texture; -1: none yet */
	const struct tiles *tiles; /* of the level */
	int from_fine; /* pixels that are drawn as one from there, or 0 */
	void (*draw)(const struct tile_run *run, int by_fine);
	uint32_t mixed; /* what draw->mixed was made of, see make_mixed() */
	/* Pixels of a row; share, how much of 256 a texel counts, is 8.8. */
	struct tile_run run;
	uint16_t *pixel;
	uint32_t alpha, share; /* of the first one; alpha is 8.16 */
	int32_t alpha_right, share_right;
};

struct setup; /* raster.h */

typedef void (*fill_function)(struct draw *draw, struct setup *setup);

/* What rejects triangles, and sets small ones up, in one place; for arm/list.S. */
struct fast_setup {
	fill_function fill;
	struct cache_tag *place;
	struct vertex *cache;
	/* positive areas are clockwise as they are seen */
	_Alignas(8) uint32_t cull_side; /* all ones: of negative areas */
	uint32_t cull_mask;             /* the sign's bit, or 0 for none */
	/* draw->box, as struct cache_tag has xy, a column narrower at both sides */
	uint32_t box_low, box_high;
	uintptr_t depth; /* of column and row 0 */
	uintptr_t stride_bytes;
	uintptr_t pixels;    /* from behind a depth to its pixel */
	uint32_t attributes; /* 0 where no vertex is shaded */
	uint32_t back_flip;  /* 1 where positive areas are back, else 0 */
};

/* What counts.c remembers of a call. */
struct counted_call {
	const uint8_t *positions;
	double vertices;
};

struct draw {
	struct view view; /* first: arm/vertex.S */
	struct fast_setup fast_setup;
	struct soft *soft;
	int32_t eye_q16[3][4];
	int position_q;
	bool checked; /* positions may be out of range */
	struct clip_box box;
	bool same_stride; /* the rows of depth and picture are as far apart */
	/*
	 * x and y of all that is inside are below 2^15, and no state is in the
	 * way of soft_list(): places have tags
	 */
	bool packed;
	bool perspective, eye_needed, fogged;
	bool shade_more; /* vertices have fog or texture coordinates */
	int32_t fog_end_q16;
	int32_t fog_scale; /* of linear fog, of fog_scale_q bits */
	int fog_scale_q;
	struct shading shading;
	struct spec_table spec_table[SPEC_TABLES];
	unsigned spec_table_next; /* to be made over */
	struct texture_input texture[SOFT_UNITS];
	const GLfixed *added; /* to all fragments' colours, unless NULL */
	uint32_t attributes;  /* bits of those that are interpolated */
	/* fragments */
	bool offset; /* depths of triangles are moved */
	bool hides;  /* nothing behind what is there changes anything */
	bool smooth; /* points or lines with soft edges */
	bool front_is_ccw, cull_front, cull_back, color_written, early_tests,
		blended;
	fill_function fill;       /* lists call that of fast_setup */
	bool thin_lines;          /* raster/thin_line.c draws lines */
	struct flat_color flat;   /* for soft_fill_flat() */
	struct textured textured; /* for soft_fill_textured() */
	struct tiled tiled;       /* luminance.c's */
	uint32_t key;             /* see key.h */
	bool divides;    /* never bends: levels of detail change by row */
	bool rectangles; /* soft_fill_rectangle() may draw two triangles as one */
	struct soft_spans spans;
	struct vertex *provoking;      /* whose colour is flat */
	struct vertex flat_corners[3]; /* of the triangle that is drawn */
	/*
	 * NULL, or a rectangle is drawn as a triangle of its left, its right
	 * and its lower left corner whose right edge ends here.
	 */
	const struct vertex *fourth;
	struct raster raster;
	/*
	 * luminance.c's: halves of 127ths as colours of shade_color, those
	 * mixed into a colour, and 0 to 255
	 */
	uint32_t shade_color[3], shade[255], mixed[255], luminance[255];
	uint32_t gray[256];                 /* pixels of each shade of gray */
	uint16_t shaded[LUMINANCE_RUN + 1]; /* to be varied or blended */
	int32_t inverse_q31[SMALL_EXTENT + 1]; /* 2^31 / n, of 2 and more */
	struct cache_tag place[VERTEX_CACHE];  /* of cache, slot by slot */
	struct vertex cache[VERTEX_CACHE];
	struct vertex apart[3]; /* vertices that shared a place in it */
	struct vertex clipped[2 * CLIP_VERTICES + 6];
	/* counts.c's, while a program counts */
	fill_function counted_fill;
	struct counted_call recent[RECENT_CALLS]; /* a ring */
	uint32_t recent_next;
	uint32_t counted[VERTEX_CACHE]; /* tags */
};

/* Of a vertex inside of the clip volume, while draw->packed. */
static inline uint32_t vertex_xy(const struct vertex *vertex)
{
	return (uint32_t)vertex->y << 16 | (uint32_t)vertex->x;
}

/* prepare.c: what stays the same for good. */
void soft_init_scratch(struct draw *draw);

/*
 * prepare.c: derives all of this for a mode of DrawArrays(). False when there
 * is nothing to draw.
 */
bool soft_prepare(struct soft *soft, struct draw *draw, GLenum mode,
	uint32_t first, uint32_t count);

/* prepare_light.c */
void soft_prepare_shading(const struct soft *soft, struct draw *draw);

/* vertex.c: fetches and transforms; attributes follow when they are wanted. */
void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out);
/* The same in C; arm/vertex.S has another for the fast kinds. */
void soft_transform_c(
	const struct draw *draw, uint32_t index, struct vertex *out);
/* From clip coordinates inside of the volume to the window. */
void soft_project(const struct draw *draw, struct vertex *vertex);
/* light.c: fills the attributes of a vertex. */
void soft_shade_vertex(const struct draw *draw, struct vertex *vertex);
/* Unless they are there, or nobody wants them. */
static inline void soft_shade(const struct draw *draw, struct vertex *vertex)
{
	if (!vertex->shaded && draw->attributes != 0) {
		soft_shade_vertex(draw, vertex);
	}
}

/* array.c: elements of arrays as fixed point. */
void soft_array_position(
	const struct draw *draw, uint32_t index, int32_t out[3]);
void soft_array_normal_q30(
	const struct draw *draw, uint32_t index, int32_t out[3]);
void soft_array_color_q16(
	const struct draw *draw, uint32_t index, int32_t out[4]);
void soft_array_texcoord_q16(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2]);
/*
 * The largest of count times so many floats, as bits without their sign,
 * shifted to the left by one.
 */
uint32_t soft_largest_float(
	const uint8_t *at, int stride_bytes, uint32_t count, int size);
/* arm/largest_float.S or portable/loops.c: of three aligned ones each. */
uint32_t soft_largest_aligned_float(
	const uint8_t *at, int stride_bytes, uint32_t count);
/* The exponent of the largest coordinate of these positions, within 1. */
int soft_array_position_exponent(
	const struct array *array, uint32_t first, uint32_t count);

/* shade.c: the colour of a vertex that is not lit, and all else of any vertex. */
void soft_shade_color(const struct draw *draw, struct vertex *vertex);
void soft_shade_rest(const struct draw *draw, struct vertex *vertex);
/* shade.c: a vertex's position in eye space, 16.16. */
void soft_shade_find_eye(
	const struct draw *draw, uint32_t index, int32_t out[3]);

/* clip.c: cuts a triangle and hands on what is left. */
void soft_clip_triangle(struct draw *draw, struct vertex *const v[3]);
/* Ends are shaded. */
void soft_clip_line(struct draw *draw, struct vertex *a, struct vertex *b);

/*
 * counts.c: counts a prepared call and lets draw->fill count its triangles;
 * soft->counts is set.
 */
struct source;
void soft_count_call(
	struct draw *draw, const struct source *source, GLenum mode);
/* Counts pixels that finer tiles drew; soft->counts is set. */
void soft_count_fine(const struct draw *draw, int pixels);

/*
 * fast/paths.c: draw->key and the first path that takes it, of which draw->fill
 * and what else it needs are.
 */
void soft_choose_path(struct draw *draw);

/* triangle.c: draw->fast_setup, once a call, after all else. */
void soft_prepare_fast_setup(struct draw *draw);

/*
 * triangle.c: from three projected vertices to rows of pixels. Shades them once
 * it is known that they are seen.
 */
void soft_fill_triangle(struct draw *draw, struct vertex *const v[3]);

/*
 * thin_line.c: whether lines of a prepared call are one pixel wide and without a
 * texture. Such lines have a pixel for each column, or for each row of steep
 * lines, as GL ES 1.1 section 3.4.1 has it; line.c makes two triangles of others.
 */
bool soft_lines_are_thin(const struct draw *draw, GLenum mode);
/* thin_line.c: one between two shaded vertices at different places. */
void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);

/* line.c */
void soft_draw_point(struct draw *draw, struct vertex *v);
void soft_draw_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);

#endif

/*
 * Opaque triangles without a texture in a few columns: most of a character's.
 * Set up in 32 bits, with rows and colours that run as one number.
 *
 * arm/narrow.S does the same, and leaves the same bytes.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"

enum {
	/*
	 * The packed colour's steps are off by a 64th of a step of RGB565 at
	 * most, and it is taken afresh after so many rows: it stays within
	 * half a step for up to so many columns (one more by rounding).
	 */
	CHUNK_ROWS = 8,
	NARROW_COLUMNS = 23,
};

/* A colour's channel, times 31/32 or 63/64: in 8.15 and 8.16 bits. */
struct channel {
	int32_t start, down;
};

struct narrow {
	uintptr_t depth, pixel; /* addresses of column 0 */
	uintptr_t stride_bytes; /* of both */
	struct band_edges edges;
	uint32_t z, z_right, z_down;
	uint32_t packed, packed_right,
		packed_down;       /* 6.5 green, 5.6 red, 5.5 blue */
	struct channel channel[3]; /* where packed was taken from last */
	int column;
	int chunk; /* rows until it is taken afresh */
};

bool soft_fill_is_linear(const struct draw *draw, const struct setup *setup)
{
	const struct perspective perspective = raster_find_perspective(setup);
	const struct vertex *const *v = setup->v;
	uint32_t most = 0;

	for (int i = RED; i <= BLUE; i++) {
		int32_t first = v[0]->attribute[i];
		uint32_t own = frame_find_spread(
			v[1]->attribute[i] - first, v[2]->attribute[i] - first);

		most = own > most ? own : most;
	}
	return !raster_bends(&perspective, most, rows_color_tolerance(draw));
}

/* Mostly w differs so little that all colours run linearly. */
static bool runs_linearly(const struct draw *draw, const struct setup *setup)
{
	int32_t w = setup->v[0]->clip[3];
	int32_t d1 = setup->v[1]->clip[3] - w, d2 = setup->v[2]->clip[3] - w;

	d1 = d1 < 0 ? -d1 : d1;
	d2 = d2 < 0 ? -d2 : d2;
	return !draw->perspective || d1 + d2 <= w >> 6 ||
		soft_fill_is_linear(draw, setup);
}

static void set_depth(struct narrow *narrow, const struct setup *setup,
	const struct frame *frame)
{
	const struct plane z = frame_find_depth(frame, setup);

	narrow->z = z.start;
	narrow->z_right = (uint32_t)z.dx;
	narrow->z_down = (uint32_t)z.dy;
}

/* value * offset / 2 of sixteenths. */
static uint32_t move_half(int32_t value, int32_t offset)
{
	return (uint32_t)(int32_t)((int64_t)value * (offset * 2048) >> 16);
}

/* Six or five bits of RGB565, and so many less of fraction than 8.16 have. */
static int32_t round_off(int32_t value, int bits)
{
	return (int32_t)((uint32_t)value + (1u << (bits - 1))) >> bits;
}

/*
 * Deltas lose their lowest bit to fit 16; bits are those of five or six of
 * the colour, cut those that packing cuts.
 */
static ALWAYS_INLINE void add_channel(struct narrow *narrow,
	const struct setup *setup, const struct frame *frame, int name,
	int bits, int cut, int place)
{
	int32_t first = setup->v[0]->attribute[name];
	int32_t d1 = (setup->v[1]->attribute[name] - first) >> 1;
	int32_t d2 = (setup->v[2]->attribute[name] - first) >> 1;
	int32_t inverse = frame->inverse - (frame->inverse >> bits);
	int32_t right =
		shift_by(mul_high(frame_find_right(frame, d1, d2), inverse),
			frame->shift + 1);
	int32_t down =
		shift_by(mul_high(frame_find_down(frame, d1, d2), inverse),
			frame->shift + 1);
	/* half a step of RGB565, and half of what is cut */
	uint32_t round = (1u << (22 - bits)) + (1u << (cut - 2));

	narrow->channel[name].start = (int32_t)(round +
		(uint32_t)((first << 7) - (first << (7 - bits))) +
		move_half(right, frame->off_x) + move_half(down, frame->off_y));
	narrow->channel[name].down = down;
	narrow->packed_right += (uint32_t)round_off(right, cut) << place;
	narrow->packed_down += (uint32_t)round_off(down, cut) << place;
}

static void pack(struct narrow *narrow)
{
	const struct channel *channel = narrow->channel;

	narrow->packed = ((uint32_t)(channel[GREEN].start >> 12) << 21) +
		((uint32_t)(channel[RED].start >> 12) << 10) +
		(uint32_t)(channel[BLUE].start >> 13) -
		narrow->packed_right * (uint32_t)narrow->column;
	narrow->chunk = CHUNK_ROWS;
}

/* From the colour of the row that packed was taken from to that of this one. */
static void pack_again(struct narrow *narrow)
{
	for (int i = 0; i < 3; i++) {
		narrow->channel[i].start =
			(int32_t)((uint32_t)narrow->channel[i].start +
				(uint32_t)narrow->channel[i].down *
					(CHUNK_ROWS / 2));
	}
	pack(narrow);
}

/* Green is in 31..21, red in 20..10, blue in 9..0. */
static ALWAYS_INLINE uint16_t unpack(uint32_t packed)
{
	uint32_t wide = (packed >> 5 | packed << 27) & WIDE_MASK;

	return narrow(wide);
}

static void draw_row(const struct narrow *narrow, int left, int right)
{
	uint16_t *depth = (uint16_t *)narrow->depth;
	uint16_t *pixel = (uint16_t *)narrow->pixel;
	uint32_t z = narrow->z + narrow->z_right * (uint32_t)left;
	uint32_t packed = narrow->packed + narrow->packed_right * (uint32_t)left;

	for (int i = left; i < right; i++) {
		if (z < (uint32_t)depth[i] << 16) {
			depth[i] = (uint16_t)(z >> 16);
			pixel[i] = unpack(packed);
		}
		z += narrow->z_right;
		packed += narrow->packed_right;
	}
}

static void draw_rows(void *band)
{
	struct narrow *narrow = band;

	for (; narrow->edges.rows > 0; band_next_row(&narrow->edges)) {
		if (narrow->chunk == 0) {
			pack_again(narrow);
		}
		draw_row(narrow, band_column(&narrow->edges, BAND_LEFT),
			band_column(&narrow->edges, BAND_RIGHT));
		narrow->depth += narrow->stride_bytes;
		narrow->pixel += narrow->stride_bytes;
		narrow->z += narrow->z_down;
		narrow->packed += narrow->packed_down;
		narrow->chunk--;
	}
}

static void set_up(const struct draw *draw, const struct setup *setup,
	const struct frame *frame, struct narrow *narrow)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;

	*narrow = (struct narrow){
		.depth = fast_setup->depth +
			(uintptr_t)setup->top * fast_setup->stride_bytes,
		.stride_bytes = fast_setup->stride_bytes,
		.column = frame->column,
	};
	narrow->pixel = narrow->depth + 2 + fast_setup->pixels;
	set_depth(narrow, setup, frame);
	add_channel(narrow, setup, frame, RED, 5, 13, 10);
	add_channel(narrow, setup, frame, GREEN, 6, 13, 21);
	add_channel(narrow, setup, frame, BLUE, 5, 14, 0);
	pack(narrow);
}

void soft_fill_narrow_c(struct draw *draw, struct setup *setup)
{
	struct narrow narrow;
	struct frame frame;

	if (!setup->fast_setup || setup->columns > NARROW_COLUMNS ||
		!runs_linearly(draw, setup)) {
		soft_rows_fill(draw, setup);
		return;
	}
	frame_find(setup, &frame);
	set_up(draw, setup, &frame, &narrow);
	raster_draw_bands(draw, setup, frame.middle_left, &narrow.edges,
		draw_rows, &narrow);
}

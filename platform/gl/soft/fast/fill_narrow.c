/*
 * Opaque triangles without a texture, up to 23 columns wide, as most of a
 * character's are: set up in 32 bits, with the colour packed into one word.
 */
#include "platform/gl/soft/fast/narrow.h"

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/halves.h"

/* Drops a step's lowest bits, rounded to the nearest. */
static ALWAYS_INLINE uint32_t round_off(uint32_t value, int bits)
{
	return (uint32_t)((int32_t)(value + (1u << (bits - 1))) >> bits);
}

/* struct frame's values for channels, differences in halves of words. */
struct corners {
	/* from v[0] to v[1] in the lower half, to v[2] in the upper one */
	uint32_t x, y;
	int32_t off_x, off_y; /* struct frame's, times 2^11 */
	int32_t inverse;
	int shift;
};

/*
 * Sets a channel's plane and packed steps, from differences of 16 bits: halved.
 * bits is RGB565's 5 or 6; packing drops cut bits; place is the field's first bit.
 */
static ALWAYS_INLINE void add_channel(struct narrow *narrow,
	const struct setup *setup, const struct corners *corners, int name,
	int bits, int cut, int place)
{
	const int32_t first = setup->v[0]->attribute[name];
	const int32_t d1 = setup->v[1]->attribute[name] - first;
	const int32_t d2 = setup->v[2]->attribute[name] - first;
	const uint32_t d = LOWER_HALVES(d1 >> 1, d2 >> 1);
	const int32_t inverse = corners->inverse - (corners->inverse >> bits);
	const uint32_t right =
		(uint32_t)mul_high(cross_halves(d, corners->y), inverse)
		<< (corners->shift + 1);
	const uint32_t down =
		(uint32_t)mul_high(cross_halves(corners->x, d), inverse)
		<< (corners->shift + 1);
	/* half a step of RGB565, and half of what packing drops */
	const int32_t round = (1 << (22 - bits)) + (1 << (cut - 2));
	int32_t start = round + ((first << 7) - (first << (7 - bits)));

	start = MULTIPLY_ADD_HALF(start, (int32_t)right, corners->off_x);
	start = MULTIPLY_ADD_HALF(start, (int32_t)down, corners->off_y);
	narrow->channel[name] = (struct narrow_channel){start, (int32_t)down};
	narrow->packed_right += round_off(right, cut) << place;
	narrow->down.packed += round_off(down, cut) << place;
}

static ALWAYS_INLINE bool begin(const struct draw *draw,
	const struct setup *setup, bool offset, struct narrow *narrow)
{
	struct frame frame;
	struct corners corners;

	if (!setup->inside || setup->columns > NARROW_COLUMNS ||
		!rows_are_linear(draw, setup, 4)) {
		return false;
	}
	frame_find(setup, &frame);
	narrow_set_edges(draw, setup, frame.middle_left, false, narrow);
	narrow_set_depth(draw, setup, &frame, NARROW_LEFT, offset, narrow);
	corners = (struct corners){
		.x = LOWER_HALVES(frame.x1, -frame.less_x2),
		.y = LOWER_HALVES(-frame.less_y1, frame.y2),
		.off_x = frame.off_x * 2048,
		.off_y = frame.off_y * 2048,
		.inverse = frame.inverse,
		.shift = frame.shift,
	};
	narrow->packed_right = narrow->down.packed = 0;
	add_channel(narrow, setup, &corners, BLUE, 5, 14, 0);
	add_channel(narrow, setup, &corners, RED, 5, 13, 10);
	add_channel(narrow, setup, &corners, GREEN, 6, 13, 21);
	narrow->row.packed = narrow_pack(narrow);
	return true;
}

static ALWAYS_INLINE void fill(
	struct draw *draw, struct setup *setup, bool offset)
{
	struct narrow narrow;

	if (begin(draw, setup, offset, &narrow)) {
		draw->fill_band(&narrow);
	} else {
		soft_rows_fill(draw, setup);
	}
}

void soft_fill_narrow(struct draw *draw, struct setup *setup)
{
	fill(draw, setup, false);
}

void soft_fill_narrow_offset(struct draw *draw, struct setup *setup)
{
	fill(draw, setup, true);
}

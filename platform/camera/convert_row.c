/*
 * One row of a picture into RGB565.
 *
 * A channel is (luma * C + chroma + half) >> 16, clamped: with luma up to 255
 * and the constants below, sums stay within -2^22 and 2^23. The constants are
 * BT.601's, scaled to 31 or 63 for a full channel instead of 255, in Q16.
 */
#include "platform/camera/convert.h"

#include "platform/base/compiler.h"

#include <string.h>

#define LUMA_5     9277  /* 255 / 219 * 31 / 255 */
#define LUMA_6     18853 /* 255 / 219 * 63 / 255 */
#define CR_RED     12716 /* 1.402 * 255 / 224 * 31 / 255 */
#define CB_BLUE    16072 /* 1.772 * 255 / 224 * 31 / 255 */
#define CR_GREEN   13163 /* 0.714136 * 255 / 224 * 63 / 255 */
#define CB_GREEN   6343  /* 0.344136 * 255 / 224 * 63 / 255 */
#define HALF       32768
#define RED_BIAS   (HALF - 16 * LUMA_5 - 128 * CR_RED)
#define BLUE_BIAS  (HALF - 16 * LUMA_5 - 128 * CB_BLUE)
#define GREEN_BIAS (HALF - 16 * LUMA_6 + 128 * (CR_GREEN + CB_GREEN))

/* What a pair's chroma adds to each channel. */
struct tint {
	int red, green, blue;
};

static ALWAYS_INLINE struct tint tint_of(int cb, int cr)
{
	return (struct tint){
		.red = cr * CR_RED + RED_BIAS,
		.green = GREEN_BIAS - cr * CR_GREEN - cb * CB_GREEN,
		.blue = cb * CB_BLUE + BLUE_BIAS,
	};
}

/* ARMv6 has one instruction for the shift and both limits. */
static ALWAYS_INLINE uint32_t limit(int sum, int most)
{
	int value = sum >> 16;

	value = value < 0 ? 0 : value;
	return (uint32_t)(value > most ? most : value);
}

static ALWAYS_INLINE uint32_t color_of(int luma, struct tint tint)
{
	int luma_5 = luma * LUMA_5;

	return limit(luma_5 + tint.red, 31) << 11 |
		limit(luma * LUMA_6 + tint.green, 63) << 5 |
		limit(luma_5 + tint.blue, 31);
}

static ALWAYS_INLINE void put_pair(
	uint16_t *out, int luma, int next_luma, struct tint tint)
{
	out[0] = (uint16_t)color_of(luma, tint);
	out[1] = (uint16_t)color_of(next_luma, tint);
}

/* Four bytes a pair: where in them the two lumas and Cb stand, Cr after it. */
static ALWAYS_INLINE void convert_packed(const uint8_t *in, int luma_at,
	int cb_at, int cr_at, int count, uint16_t *out)
{
	for (; count >= 2; count -= 2, in += 4, out += 2) {
		put_pair(out, in[luma_at], in[luma_at + 2],
			tint_of(in[cb_at], in[cr_at]));
	}
	if (count) {
		*out = (uint16_t)color_of(
			in[luma_at], tint_of(in[cb_at], in[cr_at]));
	}
}

static ALWAYS_INLINE void convert_planar(const uint8_t *luma, const uint8_t *cb,
	const uint8_t *cr, int chroma_step, int count, uint16_t *out)
{
	for (; count >= 2; count -= 2, luma += 2, out += 2) {
		put_pair(out, luma[0], luma[1], tint_of(*cb, *cr));
		cb += chroma_step;
		cr += chroma_step;
	}
	if (count) {
		*out = (uint16_t)color_of(*luma, tint_of(*cb, *cr));
	}
}

static void convert_uyvy(const uint8_t *in, int count, uint16_t *out)
{
	convert_packed(in, 1, 0, 2, count, out);
}

static void convert_yuyv(const uint8_t *in, int count, uint16_t *out)
{
	convert_packed(in, 0, 1, 3, count, out);
}

static void convert_nv12(
	const uint8_t *luma, const uint8_t *chroma, int count, uint16_t *out)
{
	convert_planar(luma, chroma, chroma + 1, 2, count, out);
}

static void convert_yuv420(const uint8_t *luma, const uint8_t *cb,
	const uint8_t *cr, int count, uint16_t *out)
{
	convert_planar(luma, cb, cr, 1, count, out);
}

static void convert_565(const uint8_t *in, int count, uint16_t *out)
{
	for (int i = 0; i < count; i++) {
		out[i] = (uint16_t)(in[2 * i] | in[2 * i + 1] << 8);
	}
}

/* value * most / 255, to the nearest. */
static uint32_t scale_down(int value, int most)
{
	return (uint32_t)((value * most * 257 + 257 * 128) >> 16);
}

static ALWAYS_INLINE void convert_bytes(
	const uint8_t *in, int red_at, int count, uint16_t *out)
{
	for (int i = 0; i < count; i++, in += 3) {
		out[i] = (uint16_t)(scale_down(in[red_at], 31) << 11 |
			scale_down(in[1], 63) << 5 |
			scale_down(in[2 - red_at], 31));
	}
}

void camera_convert_row(const struct camera_image *image, int x, int y,
	int count, uint16_t *out)
{
	const uint8_t *row[CAMERA_PLANES];

	for (int i = 0; i < CAMERA_PLANES; i++) {
		row[i] = image->plane[i] +
			(i ? y / 2 : y) * image->stride_bytes[i];
	}
	switch (image->format) {
	case CAMERA_RGB565:
		convert_565(row[0] + x * 2, count, out);
		break;
	case CAMERA_UYVY:
		convert_uyvy(row[0] + x * 2, count, out);
		break;
	case CAMERA_YUYV:
		convert_yuyv(row[0] + x * 2, count, out);
		break;
	case CAMERA_NV12:
		convert_nv12(row[0] + x, row[1] + x, count, out);
		break;
	case CAMERA_YUV420:
		convert_yuv420(
			row[0] + x, row[1] + x / 2, row[2] + x / 2, count, out);
		break;
	case CAMERA_RGB24:
		convert_bytes(row[0] + x * 3, 0, count, out);
		break;
	case CAMERA_BGR24:
		convert_bytes(row[0] + x * 3, 2, count, out);
		break;
	default:
		break;
	}
}

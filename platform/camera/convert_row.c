/*
 * Converts one row of a picture to RGB565.
 *
 * A channel is (luma * C + chroma + half) >> 16, clamped. With luma up to 255
 * and the constants below, sums stay within -2^22..2^23. The constants are
 * those of BT.601 in Q16, scaled so that a full channel is 31 or 63.
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

/*
 * The constants as pairs of halves, for ARMv6's 16-bit multiplications. They
 * are hidden from the compiler, which would otherwise replace the products by
 * shifts and additions.
 */
struct matrix {
	uint32_t luma; /* to 5 bits, to 6 bits */
	uint32_t cr;   /* to red, to green */
	uint32_t cb;   /* to blue, to green */
	int32_t red_bias, green_bias, blue_bias;
};

static ALWAYS_INLINE uint32_t two_halves(int bottom, int top)
{
	return (uint16_t)bottom | (uint32_t)(uint16_t)top << 16;
}

static ALWAYS_INLINE struct matrix load_matrix(void)
{
	struct matrix m = {
		.luma = two_halves(LUMA_5, LUMA_6),
		.cr = two_halves(CR_RED, -CR_GREEN),
		.cb = two_halves(CB_BLUE, -CB_GREEN),
		.red_bias = RED_BIAS,
		.green_bias = GREEN_BIAS,
		.blue_bias = BLUE_BIAS,
	};

	OPAQUE(m.luma);
	OPAQUE(m.cr);
	OPAQUE(m.cb);
	OPAQUE(m.red_bias);
	OPAQUE(m.green_bias);
	OPAQUE(m.blue_bias);
	return m;
}

/* What the chroma of two pixels adds to each channel, in Q16, with the bias. */
struct tint {
	int32_t red, green, blue;
};

/* chroma has Cb in the bottom half and Cr in the top half. */
static ALWAYS_INLINE struct tint tint_of(const struct matrix *m, uint32_t chroma)
{
	int32_t green = HALVES_BT(chroma, m->cb, m->green_bias);

	return (struct tint){
		.red = HALVES_TB(chroma, m->cr, m->red_bias),
		.green = HALVES_TT(chroma, m->cr, green),
		.blue = HALVES_BB(chroma, m->cb, m->blue_bias),
	};
}

/* ARMv6 shifts and clamps in one instruction (usat). */
static ALWAYS_INLINE uint32_t limit(int32_t sum, int most)
{
	int32_t value = sum >> 16;

	value = value < 0 ? 0 : value;
	return (uint32_t)(value > most ? most : value);
}

static ALWAYS_INLINE uint32_t pack(int32_t red, int32_t green, int32_t blue)
{
	return limit(blue, 31) | limit(red, 31) << 11 | limit(green, 63) << 5;
}

/* Writes two pixels; the first one's luma is in the bottom half of lumas. */
static ALWAYS_INLINE void put_pair(
	const struct matrix *m, uint32_t lumas, uint32_t chroma, uint16_t *out)
{
	struct tint tint = tint_of(m, chroma);

	out[0] = (uint16_t)pack(HALVES_BB(lumas, m->luma, tint.red),
		HALVES_BT(lumas, m->luma, tint.green),
		HALVES_BB(lumas, m->luma, tint.blue));
	out[1] = (uint16_t)pack(HALVES_TB(lumas, m->luma, tint.red),
		HALVES_TT(lumas, m->luma, tint.green),
		HALVES_TB(lumas, m->luma, tint.blue));
}

static ALWAYS_INLINE void put_last(
	const struct matrix *m, int luma, int cb, int cr, uint16_t *out)
{
	struct tint tint = tint_of(m, two_halves(cb, cr));

	*out = (uint16_t)pack(HALVES_BB((uint32_t)luma, m->luma, tint.red),
		HALVES_BT((uint32_t)luma, m->luma, tint.green),
		HALVES_BB((uint32_t)luma, m->luma, tint.blue));
}

/*
 * Loads four bytes, which compilers turn into one load. Fewer loads matter
 * because drivers' buffers are often not cached.
 */
static ALWAYS_INLINE uint32_t load_word(const uint8_t *in)
{
	return in[0] | (uint32_t)in[1] << 8 | (uint32_t)in[2] << 16 |
		(uint32_t)in[3] << 24;
}

/* Spreads bytes 0 and 1 to the two halves. */
static ALWAYS_INLINE uint32_t first_bytes(uint32_t word)
{
	return (word & 0xff) | (word & 0xff00) << 8;
}

static ALWAYS_INLINE void convert_packed(
	const uint8_t *in, int luma_at, int count, uint16_t *out)
{
	const struct matrix m = load_matrix();
	for (; count >= 2; count -= 2, in += 4, out += 2) {
		uint32_t word = load_word(in);
		uint32_t even = BYTES_AS_HALVES(word);
		uint32_t odd = BYTES_AS_HALVES(word >> 8);

		put_pair(&m, luma_at ? odd : even, luma_at ? even : odd, out);
	}
	if (count) {
		put_last(&m, in[luma_at], in[1 - luma_at], in[3 - luma_at], out);
	}
}

static void convert_uyvy(const uint8_t *in, int count, uint16_t *out)
{
	convert_packed(in, 1, count, out);
}

static void convert_yuyv(const uint8_t *in, int count, uint16_t *out)
{
	convert_packed(in, 0, count, out);
}

/* Converts the last pixels of a row, fewer than four. */
static void convert_end(const struct matrix *m, const uint8_t *luma,
	const uint8_t *cb, const uint8_t *cr, int chroma_step, int count,
	uint16_t *out)
{
	for (int i = 0; i < count; i++) {
		int at = i / 2 * chroma_step;

		put_last(m, luma[i], cb[at], cr[at], &out[i]);
	}
}

static void convert_nv12(
	const uint8_t *luma, const uint8_t *chroma, int count, uint16_t *out)
{
	const struct matrix m = load_matrix();

	for (; count >= 4; count -= 4, luma += 4, chroma += 4, out += 4) {
		uint32_t lumas = load_word(luma), pairs = load_word(chroma);
		uint32_t left = first_bytes(lumas);
		uint32_t right = first_bytes(lumas >> 16);

		put_pair(&m, left, first_bytes(pairs), out);
		put_pair(&m, right, first_bytes(pairs >> 16), out + 2);
	}
	convert_end(&m, luma, chroma, chroma + 1, 2, count, out);
}

static void convert_yuv420(const uint8_t *luma, const uint8_t *cb,
	const uint8_t *cr, int count, uint16_t *out)
{
	const struct matrix m = load_matrix();

	for (; count >= 4; count -= 4, luma += 4, out += 4) {
		uint32_t lumas = load_word(luma);
		uint32_t left = first_bytes(lumas);
		uint32_t right = first_bytes(lumas >> 16);

		put_pair(&m, left, two_halves(cb[0], cr[0]), out);
		put_pair(&m, right, two_halves(cb[1], cr[1]), out + 2);
		cb += 2;
		cr += 2;
	}
	convert_end(&m, luma, cb, cr, 1, count, out);
}

static void convert_565(const uint8_t *in, int count, uint16_t *out)
{
	const uint16_t one = 1;
	uint8_t first;

	memcpy(&first, &one, 1);
	if (first == 1) {
		memcpy(out, in, (size_t)count * sizeof(*out));
		return;
	}
	for (int i = 0; i < count; i++) {
		out[i] = (uint16_t)(in[2 * i] | in[2 * i + 1] << 8);
	}
}

/* value * most / 255, rounded to nearest. */
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

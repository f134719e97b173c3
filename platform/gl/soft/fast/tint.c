#include "platform/gl/soft/fast/tint.h"

#include "platform/gl/soft/raster/pixel.h"

/* A channel's value times 2^18: 6 bits, and 5 and 13 of fraction. */
struct channels {
	uint32_t red, green, blue;
};

static uint32_t load_texel(const struct tint_band *band, uint32_t texel)
{
	uint32_t at = texel & band->texel_mask;
	uint32_t index = (at >> 8 & 255) + (at >> band->texel_shift);

	return load_16(band->texels + 2 * index);
}

/* Two texels by their weights; channel is moved to where it belongs. */
static uint32_t mix_pair(uint32_t left, uint32_t right, uint32_t mask,
	uint32_t weight_left, uint32_t weight_right)
{
	return (left & mask & 0xFFFF) * weight_left +
		(right & mask & 0xFFFF) * weight_right;
}

static struct channels load_linear(const struct tint_band *band, uint32_t at)
{
	uint32_t right = (at & 0xFFFF0000) | ((at + 0x100) & 0xFFFF);
	uint32_t below = 1u << 24;
	uint32_t a = load_texel(band, at), b = load_texel(band, right);
	uint32_t c = load_texel(band, at + below);
	uint32_t d = load_texel(band, right + below);
	uint32_t across = at >> 3 & 31, down = at >> 16 & 255;
	uint32_t c_weight = (32 - across) * down, d_weight = across * down;
	uint32_t a_weight = (32 - across) * 256 - c_weight;
	uint32_t b_weight = across * 256 - d_weight;

	return (struct channels){
		.red = mix_pair(a >> 6, b >> 6, TINT_RED_BLUE, a_weight,
			       b_weight) +
			mix_pair(c >> 6, d >> 6, TINT_RED_BLUE, c_weight,
				d_weight),
		.green = mix_pair(a, b, TINT_GREEN, a_weight, b_weight) +
			mix_pair(c, d, TINT_GREEN, c_weight, d_weight),
		.blue = mix_pair(a << 5, b << 5, TINT_RED_BLUE, a_weight,
				b_weight) +
			mix_pair(c << 5, d << 5, TINT_RED_BLUE, c_weight,
				d_weight),
	};
}

static struct channels load_nearest(const struct tint_band *band, uint32_t at)
{
	uint32_t texel = load_texel(band, at);

	return (struct channels){
		.red = texel >> 11 << 18,
		.green = (texel >> 5 & 63) << 18,
		.blue = (texel & 31) << 18,
	};
}

/* The channel by a colour: 17 bits of fraction. */
static int32_t tint(uint32_t channel, uint32_t color)
{
	return (int32_t)((uint64_t)channel * color >> 16);
}

static uint32_t to_channel(int32_t value, int fraction, int32_t most)
{
	int32_t whole = (value + (1 << (fraction - 1))) >> fraction;

	return (uint32_t)(whole < 0 ? 0 : whole > most ? most : whole);
}

static uint16_t pack(uint32_t red, uint32_t green, uint32_t blue)
{
	return (uint16_t)(red << 11 | green << 5 | blue);
}

/* What a pixel becomes: the texel's channels, their colours, what it was. */
typedef uint16_t (*finish_function)(const struct channels *c, uint32_t red_blue,
	uint32_t green, uint16_t old);

static uint16_t replace(const struct channels *c, uint32_t red_blue,
	uint32_t green, uint16_t old)
{
	(void)old;
	return pack(to_channel(tint(c->red, red_blue >> 16), 17, 31),
		to_channel(tint(c->green, green), 17, 63),
		to_channel(tint(c->blue, red_blue & 0xFFFF), 17, 31));
}

static uint16_t add(const struct channels *c, uint32_t red_blue, uint32_t green,
	uint16_t old)
{
	int32_t red = old >> 11, own = old >> 5 & 63, blue = old & 31;

	return pack(
		to_channel(tint(c->red, red_blue >> 16) + (red << 17), 17, 31),
		to_channel(tint(c->green, green) + (own << 17), 17, 63),
		to_channel(tint(c->blue, red_blue & 0xFFFF) + (blue << 17), 17,
			31));
}

/* By 31 or 63 parts, which go on in 1023 and 4095. */
static uint32_t multiply_channel(int32_t value, uint32_t part, int bits)
{
	uint32_t share = part << bits | part;

	return to_channel(tint((uint32_t)value, share), 2 * bits + 1, 63);
}

static uint16_t multiply(const struct channels *c, uint32_t red_blue,
	uint32_t green, uint16_t old)
{
	return pack(multiply_channel(tint(c->red, red_blue >> 16), old >> 11, 5),
		multiply_channel(tint(c->green, green), old >> 5 & 63, 6),
		multiply_channel(tint(c->blue, red_blue & 0xFFFF), old & 31, 5));
}

/* (2 texel - 1) (color - 1/2) of a channel of 63 parts that lies at half. */
static int32_t project(int32_t channel, int32_t half, uint32_t color)
{
	int32_t own = channel - half;

	return (int32_t)((int64_t)own * (int32_t)color >> 16) - (own >> 2);
}

/* Red and blue to 63 parts, half as large as green's: 31 by 65 / 64. */
static uint16_t dot(const struct channels *c, uint32_t red_blue, uint32_t green,
	uint16_t old)
{
	int32_t red = (int32_t)(c->red + (c->red >> 6));
	int32_t blue = (int32_t)(c->blue + (c->blue >> 6));
	int32_t own = (int32_t)c->green;
	int32_t sum;
	uint32_t five;

	(void)old;
	sum = 2 *
			(project(red, 63 << 16, red_blue >> 16) +
				project(blue, 63 << 16, red_blue & 0xFFFF)) +
		project(own, 63 << 17, green);
	five = to_channel(sum - (sum >> 6), 16, 31);
	return pack(five, to_channel(sum, 15, 63), five);
}

/* How a band looks at its pixels. */
struct look {
	struct channels (*load)(const struct tint_band *band, uint32_t at);
	finish_function finish;
	bool equal; /* the depth has to be, and stays, what it is */
};

static ALWAYS_INLINE void run_tint(const struct tint_band *band, int column,
	int count, const struct look *look)
{
	uintptr_t address = band->row.depth + 2 * (uintptr_t)column;
	uint16_t *depth = (uint16_t *)address;
	uint16_t *pixel = (uint16_t *)(address + 2 + band->pixels);
	uint32_t at = (uint32_t)column;
	uint32_t z = band->row.z_q16 + band->z_right * at;
	uint32_t texel = band->row.texel + band->texel_right * at;
	uint32_t red_blue = band->row.red_blue + band->red_blue_right * at;
	uint32_t green = band->row.green + band->green_right * at;

	for (int i = 0; i < count; i++) {
		if (look->equal ? z >> 16 == depth[i]
				: z < (uint32_t)depth[i] << 16) {
			struct channels c = look->load(band, texel);

			depth[i] = (uint16_t)(z >> 16);
			pixel[i] = look->finish(
				&c, red_blue, green & 0xFFFF, pixel[i]);
		}
		z += band->z_right;
		texel += band->texel_right;
		red_blue += band->red_blue_right;
		green += band->green_right;
	}
}

static ALWAYS_INLINE void walk(struct tint_band *band, const struct look *look)
{
	for (; band->rows > 0; band->rows--) {
		int left = (int32_t)band->edge[BAND_LEFT] >> 16;
		int right = (int32_t)band->edge[BAND_RIGHT] >> 16;

		run_tint(band, left, right - left, look);
		band->row.depth += band->down.depth;
		band->row.z_q16 += band->down.z_q16;
		band->row.texel += band->down.texel;
		band->row.red_blue += band->down.red_blue;
		band->row.green += band->down.green;
		band->edge[BAND_LEFT] += band->edge_step[BAND_LEFT];
		band->edge[BAND_RIGHT] += band->edge_step[BAND_RIGHT];
	}
}

void soft_tint_linear_c(struct tint_band *band)
{
	walk(band, &(const struct look){load_linear, replace, false});
}

void soft_tint_nearest_c(struct tint_band *band)
{
	walk(band, &(const struct look){load_nearest, replace, false});
}

void soft_tint_dot_c(struct tint_band *band)
{
	walk(band, &(const struct look){load_linear, dot, false});
}

void soft_tint_multiply_c(struct tint_band *band)
{
	walk(band, &(const struct look){load_linear, multiply, true});
}

void soft_tint_add_c(struct tint_band *band)
{
	walk(band, &(const struct look){load_linear, add, true});
}

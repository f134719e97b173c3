#include "platform/display/pixel_layout.h"

struct pixel_layout pixel_layout_of(enum pixel_format format)
{
	static const uint16_t probe = 1;
	bool little = *(const uint8_t *)&probe == 1;

	if (format == PIXELS_RGB565) {
		return (struct pixel_layout){
			.bits = 16,
			.red = {11, 5},
			.green = {5, 6},
			.blue = {0, 5},
		};
	}
	return (struct pixel_layout){
		.bits = 32,
		.red = {little ? 0 : 24, 8},
		.green = {little ? 8 : 16, 8},
		.blue = {little ? 16 : 8, 8},
		.alpha = {little ? 24 : 0, 8},
	};
}

uint32_t pixel_layout_mask(struct pixel_field field)
{
	return field.length ? (UINT32_MAX >> (32 - field.length)) << field.offset
			    : 0;
}

static bool is_within(struct pixel_field field, int bits)
{
	return field.length >= 0 && field.offset >= 0 && field.length <= bits &&
		field.offset <= bits - field.length;
}

bool pixel_layout_is_valid(const struct pixel_layout *layout)
{
	const struct pixel_field fields[] = {
		layout->red, layout->green, layout->blue, layout->alpha};
	uint32_t used = 0;

	if (layout->bits < 1 || layout->bits > 32) {
		return false;
	}
	for (int i = 0; i < 4; i++) {
		/* In gray layouts the three colour fields are one and the same. */
		bool counts = !layout->gray || i == 0 || i == 3;

		if (!is_within(fields[i], layout->bits) ||
			(i < 3 && fields[i].length == 0)) {
			return false;
		}
		if (counts && (used & pixel_layout_mask(fields[i]))) {
			return false;
		}
		used |= counts ? pixel_layout_mask(fields[i]) : 0;
	}
	return true;
}

int pixel_layout_bytes(const struct pixel_layout *layout)
{
	return (layout->bits + 7) / 8;
}

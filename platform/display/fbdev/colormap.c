#include "platform/display/fbdev/colormap.h"

static struct fb_cmap describe(
	uint32_t count, uint16_t (*tables)[COLORMAP_ENTRIES])
{
	return (struct fb_cmap){
		.len = count,
		.red = tables[0],
		.green = tables[1],
		.blue = tables[2],
	};
}

/* Scales a value of 0..max to 0..65535. */
static uint16_t spread(uint32_t value, uint32_t max)
{
	return (uint16_t)(value * 65535 / max);
}

/* The entries of the longest channel's table; 0 if a channel exceeds 8 bits. */
static uint32_t longest(const struct pixel_layout *layout)
{
	int length = layout->red.length;

	length = length > layout->green.length ? length : layout->green.length;
	length = length > layout->blue.length ? length : layout->blue.length;
	return length <= 8 ? 1u << length : 0;
}

static void fill_channel(
	uint16_t *table, uint32_t count, struct pixel_field field)
{
	uint32_t max = (1u << field.length) - 1;

	for (uint32_t i = 0; i < count; i++) {
		table[i] = spread(i < max ? i : max, max);
	}
}

static void fill_palette(uint16_t (*tables)[COLORMAP_ENTRIES])
{
	for (uint32_t i = 0; i < COLORMAP_ENTRIES; i++) {
		tables[0][i] = spread(i >> 5, 7);
		tables[1][i] = spread(i >> 2 & 7, 7);
		tables[2][i] = spread(i & 3, 3);
	}
}

struct pixel_layout colormap_palette_layout(void)
{
	return (struct pixel_layout){
		.bits = 8,
		.red = {5, 3},
		.green = {2, 3},
		.blue = {0, 2},
	};
}

bool colormap_set(struct colormap *map, const struct device_calls *calls,
	int fd, uint32_t visual, const struct pixel_layout *layout)
{
	uint16_t tables[3][COLORMAP_ENTRIES];
	struct fb_cmap before, now;

	if (visual == FB_VISUAL_PSEUDOCOLOR) {
		map->count = COLORMAP_ENTRIES;
		fill_palette(tables);
	} else if (visual == FB_VISUAL_DIRECTCOLOR) {
		map->count = longest(layout);
		fill_channel(tables[0], map->count, layout->red);
		fill_channel(tables[1], map->count, layout->green);
		fill_channel(tables[2], map->count, layout->blue);
	}
	if (map->count == 0) {
		return visual == FB_VISUAL_TRUECOLOR;
	}
	before = describe(map->count, map->before);
	now = describe(map->count, tables);
	map->changed = device_control(calls, fd, FBIOGETCMAP, &before) == 0;
	return device_control(calls, fd, FBIOPUTCMAP, &now) == 0;
}

void colormap_restore(
	const struct colormap *map, const struct device_calls *calls, int fd)
{
	uint16_t tables[3][COLORMAP_ENTRIES];
	struct fb_cmap before = describe(map->count, tables);

	for (int channel = 0; channel < 3; channel++) {
		for (int i = 0; i < COLORMAP_ENTRIES; i++) {
			tables[channel][i] = map->before[channel][i];
		}
	}
	if (map->changed) {
		(void)device_control(calls, fd, FBIOPUTCMAP, &before);
	}
}

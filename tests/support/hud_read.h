/*
 * Reads a head-up display before hud_end(), for tests of labels.
 */
#ifndef TESTS_SUPPORT_HUD_READ_H
#define TESTS_SUPPORT_HUD_READ_H

#include "app/scene/hud/hud.h"

#include <stddef.h>

/* Begins an empty display of this size, which needs no GL. */
void hud_read_begin(struct hud *hud, int width, int height);

/*
 * Writes the letters of the display in the order in which they were added: of a
 * row with a value, the value, '|' and the label. Rows end in '\n' but for the
 * last one.
 */
void hud_read_text(const struct hud *hud, char *out, size_t size);

/* The width in pixels of all that has this colour. */
int hud_read_width(const struct hud *hud, struct hud_color color);

#endif

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/spans.h"

/* The template's way, which is that of every state that has no other. */
void soft_rows_fill(struct draw *draw, struct setup *setup)
{
	if (soft_is_hidden(draw, setup)) {
		return;
	}
	soft_raster_set_up(draw, setup);
	soft_walk_rows(draw, setup);
}

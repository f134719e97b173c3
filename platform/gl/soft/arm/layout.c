/* What the assembly knows besides the offsets of offsets.inc. */
#include <assert.h>

#include "platform/gl/soft/raster/raster.h"

/* narrow.S and masked.S */
static_assert(offsetof(struct setup, back) == offsetof(struct setup, inside) + 3,
	"the flags are the bytes of one word");
static_assert(offsetof(struct setup, fast_setup) ==
		offsetof(struct setup, inside) + 2,
	"the flags are the bytes of one word");

/*
 * Easing curves.
 */
#ifndef APP_ANIM_EASE_H
#define APP_ANIM_EASE_H

#include "platform/base/scalar.h"

enum ease {
	EASE_LINEAR,
	EASE_CUBIC, /* 3 u^2 - 2 u^3, whose slope is 0 at both ends */
};

/* The curve at u, clamped to 0..1: 0 at 0 and 1 at 1. A NaN gives 0. */
static inline float ease_at(enum ease ease, float u)
{
	u = scalar_clamp(u, 0, 1);
	return ease == EASE_CUBIC ? u * u * (3 - 2 * u) : u;
}

#endif

#include "app/scene/color.h"

#include "platform/base/scalar.h"

#include <math.h>

float color_encode_srgb(float linear)
{
	linear = scalar_clamp(linear, 0.0f, 1.0f);
	return linear <= 0.0031308f
		? 12.92f * linear
		: 1.055f * powf(linear, 1.0f / 2.4f) - 0.055f;
}

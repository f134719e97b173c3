#include "platform/gl/soft/span/any.h"

#include <string.h>

#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

bool soft_finish_any(const struct soft_fragment_stages *stages,
	const uint8_t texel[4], uint32_t alpha_q7, uint32_t fog,
	const uint8_t picture[4], uint8_t color[4])
{
	if (stages->textured && stages->dot) {
		soft_apply_dot(texel, color, color);
	} else if (stages->textured) {
		soft_apply_environment(stages->env, stages->base_format,
			stages->env_color, texel, color);
	}
	if (stages->alpha_scaled) {
		color[3] = (uint8_t)soft_scale_alpha(alpha_q7, texel[3]);
	}
	if (((color[3] - stages->alpha_low) & 255) > stages->alpha_range) {
		return false;
	}
	for (int i = 0; i < 3 && stages->fogged; i++) {
		int to = stages->fog_color[i];

		color[i] = (uint8_t)(to +
			(((color[i] - to) * (int)fog + (1 << 14)) >> 15));
	}
	if (stages->blended) {
		soft_blend(stages->blend_source, stages->blend_destination,
			picture, color);
	}
	return true;
}

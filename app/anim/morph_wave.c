#include "app/anim/morph_wave.h"

#include "platform/base/scalar.h"

float morph_wave_omega(const struct morph_wave *wave, float omega, float place)
{
	return scalar_clamp(
		omega * (1.0f + wave->delay) - wave->delay * place, 0.0f, 1.0f);
}

float morph_wave_at(const struct morph_wave *wave, float omega, float place)
{
	float own = morph_wave_omega(wave, omega, place);

	return own <= 0.0f || own >= 1.0f
		? 0.0f
		: wave->amplitude * scalar_sin(SCALAR_PI * own);
}

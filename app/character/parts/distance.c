#include "app/character/parts/distance.h"

#include "app/anim/math/vec.h"

/* C. Ericson, Real-Time Collision Detection, 5.1.9. */
float character_line_distance(
	const float a[3], const float b[3], const float c[3], const float d[3])
{
	float u[3], v[3], w[3], apart[3];
	float uu, uv, vv, uw, vw, denominator, s = 0, t = 0;

	vec_subtract(b, a, u);
	vec_subtract(d, c, v);
	vec_subtract(a, c, w);
	uu = vec_dot(u, u);
	uv = vec_dot(u, v);
	vv = vec_dot(v, v);
	uw = vec_dot(u, w);
	vw = vec_dot(v, w);
	denominator = uu * vv - uv * uv;
	if (denominator > 1e-12f * uu * vv) {
		s = scalar_clamp((uv * vw - vv * uw) / denominator, 0, 1);
	}
	if (vv > 0) {
		t = scalar_clamp((uv * s + vw) / vv, 0, 1);
	}
	if (uu > 0) {
		s = scalar_clamp((uv * t - uw) / uu, 0, 1);
	}
	vec_add_scaled(w, u, s, apart);
	vec_add_scaled(apart, v, -t, apart);
	return vec_length(apart);
}

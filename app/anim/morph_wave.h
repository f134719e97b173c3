/*
 * The sinusoidal part of a morph as a wave (AN4044, section 1.2.5).
 *
 * The document adds sin(pi Omega) to every vertex alike, which lets the whole
 * object glide forth and back. A wave gives each vertex a phase by its place
 * along an axis: the vertex's own Omega starts later and ends earlier than the
 * morph's. The signal is 0 where Omega is 0 or 1 for every vertex, so that the
 * morph begins and ends exactly as without it.
 */
#ifndef APP_ANIM_MORPH_WAVE_H
#define APP_ANIM_MORPH_WAVE_H

struct morph_wave {
	float direction[3]; /* of the displacement, a unit vector */
	float axis[3];      /* along which the wave runs, a unit vector */
	float amplitude;    /* greatest displacement, in the vertices' unit */
	/*
	 * How much later the last vertex begins than the first one, in
	 * durations of one vertex's own motion. 0 moves all vertices alike.
	 */
	float delay;
};

/*
 * Omega of a vertex at this place, 0 for the first one along the axis to 1 for
 * the last one: clamp(omega (1 + delay) - delay place, 0, 1).
 */
float morph_wave_omega(const struct morph_wave *wave, float omega, float place);

/* The displacement along the direction: amplitude sin(pi Omega of the place). */
float morph_wave_at(const struct morph_wave *wave, float omega, float place);

#endif

/*
 * The sinusoidal part of a morph as a wave (AN4044, section 1.2.5).
 *
 * The document adds sin(pi Omega) to every vertex alike, so the whole object
 * glides forth and back. A wave gives each vertex an Omega of its own, by the
 * vertex's place along an axis: it starts later and ends earlier than that of
 * the morph. When the morph's Omega is 0 or 1, the wave is 0 at every vertex,
 * so that the morph begins and ends exactly as without it.
 */
#ifndef APP_ANIM_MORPH_WAVE_H
#define APP_ANIM_MORPH_WAVE_H

struct morph_wave {
	float direction[3]; /* of the displacement; unit length */
	float axis[3];      /* along which the wave runs; unit length */
	float amplitude;    /* greatest displacement, in the vertices' unit */
	/*
	 * How much later the last vertex begins than the first one, in
	 * durations of one vertex's own motion. 0 moves all vertices alike.
	 */
	float delay;
};

/*
 * Omega of a vertex: clamp(omega * (1 + delay) - delay * place, 0, 1). omega is
 * that of the morph. place is 0 for the first vertex along the axis and 1 for
 * the last.
 */
float morph_wave_omega(const struct morph_wave *wave, float omega, float place);

/* A vertex's displacement: amplitude * sin(pi * its Omega) along direction. */
float morph_wave_at(const struct morph_wave *wave, float omega, float place);

#endif

/*
 * Morphing between key frames (AN4044, section 1).
 *
 * Source and Destiny are key frames; Temporal is the shape to draw. A trigger
 * makes another key frame the Destiny and copies Temporal to Source, so it may
 * come at any moment, also during a morph. In every mode Temporal begins equal
 * to Source and ends exactly equal to Destiny.
 *
 * The document prints Omega = currentTime / (currentTime + endTime), which does
 * not reach 1. This module follows the document's text instead:
 * Omega = 1 - (endTime - currentTime) / animationTime.
 */
#ifndef APP_ANIM_MORPH_H
#define APP_ANIM_MORPH_H

#include "platform/base/arena.h"

#include <stdbool.h>

struct kernel;

/* One key frame: vertex_count positions and normals; not owned. */
struct morph_key {
	const float (*position)[3];
	const float (*normal)[3]; /* or NULL */
};

enum morph_timing {
	MORPH_OVER_TIME, /* 1.2.1: ends after duration_ms */
	MORPH_BY_FRAMES, /* 1.2.2: ends after frame_count updates, each of which
			    adds (Destiny - Source) / frame_count. Linear morphs
			    without normals use the document's own arithmetic */
};

enum morph_curve {
	MORPH_LINEAR,     /* 1.2.3 */
	MORPH_SINUSOIDAL, /* 1.2.5: linear plus direction * amplitude *
			     sin(pi Omega), which is 0 at both ends */
	MORPH_SHAPED,     /* 1.2.4: along any other function of Omega */
};

struct morph_motion {
	enum morph_timing timing;
	enum morph_curve curve;
	float duration_ms;
	int frame_count;
	float direction[3];
	float amplitude; /* in the vertices' unit */
	/*
	 * For MORPH_SHAPED: maps Omega, 0..1, to the part of the way from
	 * Source to Destiny. It is not called at the end, where the shape is
	 * exactly Destiny.
	 */
	float (*shape)(const void *user, float omega);
	const void *user; /* for shape(); stays valid until the morph ends */
};

struct morph {
	const struct kernel *kernel; /* whose float loops are used; the caller
					may replace it */
	int vertex_count;
	float (*temporal)[3];        /* the shape to draw */
	float (*temporal_normal)[3]; /* unit length, or NULL */

	/* Private. */
	float (*source)[3];
	float (*source_normal)[3];
	struct morph_key destiny;
	struct morph_motion motion;
	double end_ms;
	int count;
	bool running;
};

/*
 * Returns a linear motion over half a second. Direction (+Y) and amplitude
 * (0.1) are set for callers that change the curve to MORPH_SINUSOIDAL.
 */
struct morph_motion morph_motion_default(void);

/*
 * Makes a morph that shows the key frame rest and does not move. It has normals
 * if rest has. The key frame must stay valid, the arena owns the arrays.
 * Returns 0 or -ENOMEM.
 */
int morph_init(struct morph *morph, int vertex_count, struct morph_key rest,
	struct arena *arena);

/*
 * Starts a morph from the present shape to destiny, which must have normals if
 * the rest key had. The key frame must stay valid until the morph ends. If the
 * duration or frame count is 0 or less, the next update ends the morph.
 */
void morph_trigger(struct morph *morph, struct morph_key destiny,
	const struct morph_motion *motion, double now_ms);

/*
 * Computes temporal for a frame. Returns true if it changed, also in the frame
 * that reaches Destiny; from then on the call costs nothing. now_ms must not
 * decrease.
 */
bool morph_update(struct morph *morph, double now_ms);

/* Returns Omega, 0..1; 1 once Destiny is reached. */
float morph_omega(const struct morph *morph, double now_ms);

#endif

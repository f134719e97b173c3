/*
 * Morphing between key frames (AN4044, section 1).
 *
 * Source and Destiny are key frames; Temporal is what is drawn. A trigger
 * points Destiny at another key frame and may come at any moment: mid-flight,
 * the current shape becomes the source. In every mode Temporal starts equal to
 * the source and ends exactly equal to Destiny.
 *
 * The document prints Omega = currentTime / (currentTime + endTime), which
 * does not reach 1. Its text rules here:
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
	MORPH_OVER_TIME, /* 1.2.1: done after duration_ms */
	MORPH_BY_FRAMES, /* 1.2.2: done after frame_count updates, each of
			    which goes on by (Destiny - Source) / frame_count */
};

enum morph_curve {
	MORPH_LINEAR,     /* 1.2.3 */
	MORPH_SINUSOIDAL, /* 1.2.5: plus direction * amplitude * sin(pi Omega),
			     zero at both ends with either timing */
};

struct morph_motion {
	enum morph_timing timing;
	enum morph_curve curve;
	float duration_ms;
	int frame_count;
	float direction[3];
	float amplitude; /* in the vertices' unit */
};

struct morph {
	const struct kernel *kernel; /* the float one; may be replaced */
	int vertex_count;
	float (*temporal)[3];        /* the shape to draw */
	float (*temporal_normal)[3]; /* unit length, or NULL */

	/* Below: for the functions of this header. */
	float (*source)[3];
	float (*source_normal)[3];
	struct morph_key destiny;
	struct morph_motion motion;
	double end_ms;
	int count;
	bool running;
};

/* Half a second over time, linear; sinusoidal would bulge along +Y. */
struct morph_motion morph_motion_default(void);

/*
 * Room in the arena for a morph that rests on the key frame. Normals are kept
 * when it has them. 0 or -ENOMEM.
 */
int morph_init(struct morph *morph, int vertex_count, struct morph_key rest,
	struct arena *arena);

/*
 * Starts towards destiny, which must have normals if the rest key had. A
 * duration or frame count of zero or less arrives at the next update.
 */
void morph_trigger(struct morph *morph, struct morph_key destiny,
	const struct morph_motion *motion, double now_ms);

/*
 * One frame. Returns true when temporal changed, the arrival at Destiny
 * included; at rest it costs nothing. now_ms may not run backwards.
 */
bool morph_update(struct morph *morph, double now_ms);

/*
 * Shows what lies omega, 0..1, of the way from one key frame to another, which
 * have normals if the rest key had, and comes to rest there.
 */
void morph_hold(struct morph *morph, struct morph_key from, struct morph_key to,
	float omega);

/* How far it is, 0..1; 1 at rest. */
float morph_omega(const struct morph *morph, double now_ms);

#endif

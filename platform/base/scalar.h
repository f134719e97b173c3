/*
 * Elementary functions of floats without the C library's maths.
 *
 * Debian's armel C library computes these in software floating point, at
 * hundreds of instructions a call. The polynomials here cost a few dozen,
 * give the same result on every machine, and state their error.
 */
#ifndef PLATFORM_BASE_SCALAR_H
#define PLATFORM_BASE_SCALAR_H

#define SCALAR_PI 3.14159265358979f

/* Within 2e-6 for |angle_rad| up to 8192, beyond it precision fades. */
float scalar_sin(float angle_rad);
float scalar_cos(float angle_rad);

/* Within 2e-6; the argument is clamped to -1..1. */
float scalar_acos(float cosine);

/* The angle of (x, y) in -pi..pi, within 2e-6; 0 for the origin. */
float scalar_atan2(float y, float x);

/* The processor's own square root; negative arguments give 0. */
float scalar_sqrt(float value);

/* value limited to low..high. */
float scalar_clamp(float value, float low, float high);

#endif

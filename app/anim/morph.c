#include "app/anim/morph.h"

#include "app/anim/kernel/an4044.h"
#include "app/anim/kernel/kernel.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

struct morph_motion morph_motion_default(void)
{
	return (struct morph_motion){
		.timing = MORPH_OVER_TIME,
		.curve = MORPH_LINEAR,
		.duration_ms = 500,
		.frame_count = 15,
		.direction = {0, 1, 0},
		.amplitude = 0.1f,
	};
}

static void copy(int count, const float (*from)[3], float (*to)[3])
{
	memcpy(to, from, (size_t)count * sizeof(*to));
}

static void copy_key(struct morph *morph, struct morph_key key)
{
	copy(morph->vertex_count, key.position, morph->temporal);
	if (morph->temporal_normal) {
		copy(morph->vertex_count, key.normal, morph->temporal_normal);
	}
}

static float (*vectors(struct arena *arena, int count))[3]
{
	return arena_alloc(arena, (size_t)count, sizeof(float[3]));
}

int morph_init(struct morph *morph, int vertex_count, struct morph_key rest,
	struct arena *arena)
{
	*morph = (struct morph){
		.kernel = &kernel_float,
		.vertex_count = vertex_count,
		.destiny = rest,
		.motion = morph_motion_default(),
	};
	morph->temporal = vectors(arena, vertex_count);
	morph->source = vectors(arena, vertex_count);
	if (!morph->temporal || !morph->source) {
		return -ENOMEM;
	}
	if (rest.normal) {
		morph->temporal_normal = vectors(arena, vertex_count);
		morph->source_normal = vectors(arena, vertex_count);
		if (!morph->temporal_normal || !morph->source_normal) {
			return -ENOMEM;
		}
	}
	copy_key(morph, rest);
	return 0;
}

void morph_trigger(struct morph *morph, struct morph_key destiny,
	const struct morph_motion *motion, double now_ms)
{
	copy(morph->vertex_count, (const float(*)[3])morph->temporal,
		morph->source);
	if (morph->temporal_normal) {
		copy(morph->vertex_count,
			(const float(*)[3])morph->temporal_normal,
			morph->source_normal);
	}
	morph->destiny = destiny;
	morph->motion = *motion;
	morph->end_ms = now_ms + (double)motion->duration_ms;
	morph->count = 0;
	morph->running = true;
}

float morph_omega(const struct morph *morph, double now_ms)
{
	const struct morph_motion *motion = &morph->motion;
	double left;

	if (!morph->running) {
		return 1;
	}
	if (motion->timing == MORPH_BY_FRAMES) {
		return morph->count < motion->frame_count
			? (float)morph->count / (float)motion->frame_count
			: 1;
	}
	left = morph->end_ms - now_ms;
	if (!(left > 0)) {
		return 1;
	}
	return scalar_clamp(1 - (float)(left / motion->duration_ms), 0, 1);
}

static void interpolate(struct morph *morph, struct morph_key from,
	struct morph_key to, float omega, const float offset[3])
{
	static const float none[3] = {0, 0, 0};
	const struct kernel *kernel = morph->kernel;
	int count = morph->vertex_count;

	kernel->morph_lerp(count, from.position, to.position, omega, offset,
		morph->temporal);
	if (morph->temporal_normal) {
		kernel->morph_lerp(count, from.normal, to.normal, omega, none,
			morph->temporal_normal);
		kernel->normalize(count, morph->temporal_normal);
	}
}

/* One frame of 1.2.2. The last frame copies Destiny instead. */
static void add_step(struct morph *morph)
{
	const float(*source)[3] = (const float(*)[3])morph->source;

	an4044_by_frames(morph->vertex_count, source, morph->destiny.position,
		morph->motion.frame_count, morph->temporal);
}

static bool adds_steps(const struct morph *morph)
{
	return morph->motion.timing == MORPH_BY_FRAMES &&
		morph->motion.curve == MORPH_LINEAR && !morph->temporal_normal;
}

static void interpolate_to_destiny(struct morph *morph, float omega)
{
	const struct morph_motion *motion = &morph->motion;
	const struct morph_key source = {(const float(*)[3])morph->source,
		(const float(*)[3])morph->source_normal};
	float offset[3] = {0, 0, 0};

	if (motion->curve == MORPH_SINUSOIDAL) {
		float wave = motion->amplitude * scalar_sin(SCALAR_PI * omega);

		for (int i = 0; i < 3; i++) {
			offset[i] = motion->direction[i] * wave;
		}
	} else if (motion->curve == MORPH_SHAPED) {
		omega = motion->shape(motion->user, omega);
	}
	interpolate(morph, source, morph->destiny, omega, offset);
}

bool morph_update(struct morph *morph, double now_ms)
{
	float omega;

	if (!morph->running) {
		return false;
	}
	morph->count++;
	omega = morph_omega(morph, now_ms);
	if (omega < 1 && adds_steps(morph)) {
		add_step(morph);
	} else if (omega < 1) {
		interpolate_to_destiny(morph, omega);
	} else {
		copy_key(morph, morph->destiny);
		morph->running = false;
	}
	return true;
}

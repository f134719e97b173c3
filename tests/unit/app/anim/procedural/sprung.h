/*
 * Bones of which the last are a spring, and what tests do with them.
 */
#ifndef TESTS_UNIT_APP_ANIM_PROCEDURAL_SPRUNG_H
#define TESTS_UNIT_APP_ANIM_PROCEDURAL_SPRUNG_H

#include "app/anim/procedural/spring.h"
#include "tests/support/model/bones.h"

struct fixture {
	struct bones bones;
	struct spring spring;
};

/* Too short for a spring to move. */
static const float INSTANT_S = 1e-4f;

static inline void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

/* A frame in which nothing else has turned the spring's bones. */
static inline void frame_beside(struct fixture *f, float step_s,
	const struct capsule_world *capsule, int count)
{
	for (int i = 0; i < f->spring.count; i++) {
		int node = f->spring.node[i];

		f->bones.pose.local[node] = f->bones.node[node].rest;
	}
	bones_update(&f->bones);
	spring_update(&f->spring, step_s, capsule, count,
		(const mat4 *)f->bones.world, &f->bones.pose);
	bones_update(&f->bones);
}

static inline void frame(struct fixture *f, float step_s)
{
	frame_beside(f, step_s, NULL, 0);
}

#endif

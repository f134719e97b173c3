/* What the walk over a triangle's rows calls. */
#ifndef PLATFORM_GL_SOFT_SPAN_WALK_H
#define PLATFORM_GL_SOFT_SPAN_WALK_H

struct draw;
struct setup;

/* By fragment.c, for states that no span function takes. */
void soft_walk_general(struct draw *draw, const struct setup *setup);

/* level.c: the level and filter for a level of detail. */
void soft_set_level(struct draw *draw, int lod);

/* level.c: a window of few texels, if the triangle has few; else the level's. */
void soft_set_window(struct draw *draw);

#endif

/*
 * What drawing consists of: counts that are the same on every machine.
 *
 * A driver that counts (struct gl_driver, count) adds to them while it draws.
 * With the cost of each, what a picture costs on another machine is known.
 */
#ifndef PLATFORM_GL_GL_COUNTS_H
#define PLATFORM_GL_GL_COUNTS_H

/* Triangles by how they are drawn, which depends on state and size. */
enum gl_work_kind {
	GL_WORK_FLAT,     /* one colour, such as shadows */
	GL_WORK_PLAIN,    /* small, opaque, depth tested, no texture */
	GL_WORK_TEXTURED, /* the same with one RGB565 texture */
	GL_WORK_GROUND,   /* what lies behind: floors and backgrounds */
	GL_WORK_SPANS,    /* all else without a texture */
	GL_WORK_SPANS_TEXTURED,
	GL_WORK_SPANS_DIVIDED, /* with a texture in strong perspective */
	GL_WORK_MIXED,         /* blended or alpha-tested, without a texture */
	GL_WORK_MIXED_TEXTURED,
	GL_WORK_KINDS
};

struct gl_work {
	double triangles; /* that are set up */
	double rows;
	double pixels; /* that are seen when they are drawn */
};

struct gl_counts {
	double calls;    /* of DrawArrays and DrawElements */
	double listed;   /* triangles in these calls */
	double vertices; /* transformed */
	double shaded;   /* of these, lit or coloured */
	double hidden;   /* pixels of triangles that lie behind others */
	struct gl_work work[GL_WORK_KINDS];
};

/* Multiplies all counts. */
static inline void gl_counts_scale(struct gl_counts *counts, double factor)
{
	counts->calls *= factor;
	counts->listed *= factor;
	counts->vertices *= factor;
	counts->shaded *= factor;
	counts->hidden *= factor;
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		counts->work[i].triangles *= factor;
		counts->work[i].rows *= factor;
		counts->work[i].pixels *= factor;
	}
}

#endif

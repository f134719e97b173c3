/*
 * How much work a picture took, as counts that are the same on every machine.
 *
 * A driver that counts (gl_driver.count) adds to them while it draws.
 * Multiplied by the cost of each kind of work on another machine, they predict
 * what the picture costs there.
 */
#ifndef PLATFORM_GL_GL_COUNTS_H
#define PLATFORM_GL_GL_COUNTS_H

/*
 * The kinds of triangles by how gl/soft draws them, which depends on GL's state
 * and on the triangle's size.
 */
enum gl_work_kind {
	GL_WORK_FLAT,      /* one colour through a stencil */
	GL_WORK_PLAIN,     /* small, opaque, depth tested, no texture */
	GL_WORK_TEXTURED,  /* the same with one RGB565 texture */
	GL_WORK_BACKDROP,  /* untested: one colour a row, or whole pictures */
	GL_WORK_LUMINANCE, /* a small luminance texture that repeats */
	GL_WORK_SPANS,     /* any other opaque triangle without a texture */
	GL_WORK_SPANS_TEXTURED, /* any other opaque one with a texture */
	GL_WORK_SPANS_DIVIDED,  /* with a texture in strong perspective */
	GL_WORK_SPANS_NEAREST,  /* with a texture by its nearest texels */
	GL_WORK_MIXED,          /* blended or alpha-tested, without a texture */
	GL_WORK_TESTED,         /* alpha-tested, small, with a texture */
	GL_WORK_TESTED_SPANS,   /* alpha-tested, larger, with a texture */
	GL_WORK_MIXED_TEXTURED, /* blended, small, with a texture */
	GL_WORK_MIXED_SPANS,    /* blended, larger, with a texture */
	GL_WORK_MIXED_DIVIDED,  /* the same in strong perspective */
	/* Triangles counted above that take additional work because: */
	GL_WORK_COLORED, /* their corners have different colours */
	GL_WORK_BENT,    /* texture coordinates curve in weak perspective */
	GL_WORK_DEEP,    /* they have a luminance texture and write depths */
	GL_WORK_SECOND,  /* they have a second texture */
	/* their texels lie at both edges of the texture, or in several parts of
	   a large one: rows and pixels are those of their runs that do */
	GL_WORK_CROSSED,
	GL_WORK_PARTED, /* a stencil or an odd depth function cuts their rows */
	GL_WORK_ADDED,  /* they are blended, but not by their alpha alone */
	GL_WORK_KINDS
};

struct gl_work {
	double triangles; /* that were drawn, not skipped as hidden */
	/* with pixels of the triangles; others count less, and those that are
	   cut into runs (span/run.h) as so many */
	double rows;
	double pixels; /* not hidden by what was drawn before */
};

struct gl_counts {
	double calls;    /* of DrawArrays and DrawElements */
	double listed;   /* their triangles, or the vertices of other lists */
	double vertices; /* transformed for GL_TRIANGLES with 16-bit indices */
	double again;    /* the same, of an array that recent calls have read */
	double single;   /* transformed one by one, for all other calls */
	double shaded;   /* vertices of all kinds that were lit or coloured */
	double hidden;   /* pixels of triangles that lie behind others */
	double skipped;  /* triangles found behind others before their set-up */
	double fine;     /* pixels of luminance textures drawn two at a time */
	struct gl_work work[GL_WORK_KINDS];
};

/* Multiplies all counts. */
static inline void gl_counts_scale(struct gl_counts *counts, double factor)
{
	counts->calls *= factor;
	counts->listed *= factor;
	counts->vertices *= factor;
	counts->again *= factor;
	counts->single *= factor;
	counts->shaded *= factor;
	counts->hidden *= factor;
	counts->skipped *= factor;
	counts->fine *= factor;
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		counts->work[i].triangles *= factor;
		counts->work[i].rows *= factor;
		counts->work[i].pixels *= factor;
	}
}

#endif

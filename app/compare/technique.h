/*
 * The animation techniques, as AN4044 rates them.
 */
#ifndef APP_COMPARE_TECHNIQUE_H
#define APP_COMPARE_TECHNIQUE_H

/* AN4044's three techniques, and the combination of two that it recommends. */
enum technique {
	TECHNIQUE_MORPHING,
	TECHNIQUE_HIERARCHICAL,
	TECHNIQUE_SKELETAL,
	TECHNIQUE_COMBINED,
	TECHNIQUE_COUNT
};

/* A row of the table in AN4044, section 4. */
struct technique_rating {
	const char *name;
	const char *control;
	const char *looks;
	const char *coding;
};

extern const struct technique_rating technique_ratings[TECHNIQUE_COUNT];

#endif

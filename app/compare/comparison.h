/*
 * Bakes and measures all candidates for a clip, and recommends one.
 */
#ifndef APP_COMPARE_COMPARISON_H
#define APP_COMPARE_COMPARISON_H

#include "app/compare/candidate.h"

enum {
	COMPARISON_CANDIDATES_MAX = 20
};

/* Which figure counts as the cost of a frame. */
enum comparison_cost {
	COMPARISON_COST_PREDICTED,    /* the board's time, on other machines */
	COMPARISON_COST_INSTRUCTIONS, /* counted, on the board */
	COMPARISON_COST_TIME, /* measured, on a board that cannot count */
	COMPARISON_COSTS
};

struct comparison_request {
	int clip;
	double rate_hz;      /* of the reference's frames */
	float bound_px;      /* the largest error to accept */
	size_t memory_bytes; /* the most memory to accept; 0: any */
	int width, height;   /* of the screen, in pixels */
	const struct kernel *kernel;
};

struct comparison {
	struct comparison_request request;
	struct reference *reference;
	struct screen_view screen;
	int candidate_count;
	struct candidate candidate[COMPARISON_CANDIDATES_MAX];

	enum comparison_cost cost; /* used by the advice and the plot */
	int advised;               /* index of the recommended candidate */
	char reason[200];          /* why it is recommended */
};

/*
 * Bakes and measures. The model must outlive the comparison, which
 * comparison_destroy() releases. Returns 0, or -errno after logging an error.
 */
int comparison_create(const struct model *model,
	const struct comparison_request *request, const struct log *log,
	struct comparison **out);

/* The figure that comparison->cost selects; its unit depends on that. */
double comparison_cost_of(
	const struct comparison *comparison, const struct candidate *candidate);

/* Whether a listed candidate uses the technique. */
bool comparison_has(
	const struct comparison *comparison, enum technique technique);

/* NULL is fine. */
void comparison_destroy(struct comparison *comparison);

#endif

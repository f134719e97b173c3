/*
 * All candidates of one clip, measured, and which of them to take.
 */
#ifndef APP_COMPARE_COMPARISON_H
#define APP_COMPARE_COMPARISON_H

#include "app/compare/candidate.h"

enum {
	CANDIDATES_MAX = 20
};

/* What a frame costs. */
enum cost_kind {
	COST_PREDICTED,    /* the board's time, on any other machine */
	COST_INSTRUCTIONS, /* counted here, on the board: they repeat */
	COST_TIME,         /* measured there, where it cannot count */
	COST_KINDS
};

/* What is asked. */
struct comparison_request {
	int clip;
	double rate_hz;      /* of the reference's frames */
	float bound_px;      /* the error that may be */
	size_t memory_bytes; /* that may be used; 0: any */
	int width, height;   /* of the screen */
	const struct kernel *kernel;
};

struct comparison {
	struct comparison_request request;
	struct reference *reference;
	struct screen screen;
	int candidate_count;
	struct candidate candidate[CANDIDATES_MAX];

	enum cost_kind cost; /* what advice and plots go by */
	int advised;         /* the candidate to take */
	char reason[200];    /* why, in a sentence */
};

/*
 * Bakes and measures. 0, or -errno after a sentence. The model must outlive
 * it; release it with comparison_destroy().
 */
int comparison_create(const struct model *model,
	const struct comparison_request *request, const struct log *log,
	struct comparison **out);

/* By that kind; only to be compared. */
double comparison_cost(
	const struct comparison *comparison, const struct candidate *candidate);

/* NULL is fine. */
void comparison_destroy(struct comparison *comparison);

#endif

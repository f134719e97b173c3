/*
 * Compares all techniques on the clips of a model, and recommends one.
 *
 * A row is a technique, and a cell is a technique that plays one clip. Memory
 * that all clips of a row share counts once: for a skin its mesh and its
 * influences, for a morph its posed vertices. Keys belong to one clip.
 */
#ifndef APP_COMPARE_COMPARISON_H
#define APP_COMPARE_COMPARISON_H

#include "app/compare/board_profile.h"
#include "app/compare/candidate/candidate_error.h"
#include "app/compare/candidate/candidate_time.h"
#include "app/compare/candidate/fit.h"
#include "app/compare/measure/sampling.h"
#include "app/compare/technique.h"

enum {
	COMPARISON_ROWS_MAX = 20,
	COMPARISON_REASON_BYTES = 512
};

enum comparison_kind {
	COMPARISON_ORIGINAL,   /* the model, maybe with fewer influences */
	COMPARISON_MORPH,      /* key frames fitted to bound_px */
	COMPARISON_MORPH_EVEN, /* AN4044's number of keys, evenly spaced */
	COMPARISON_RIGID       /* rigid parts on pivots */
};

struct comparison_request {
	int clip;       /* -1: all clips */
	double rate_hz; /* playback rate of the clips */
	float bound_px; /* the largest error to accept */
	const struct board_profile *board;
	size_t memory_bytes; /* the most memory to accept; 0: the board's */
	double frame_ms;     /* the longest frame to accept; 0: the board's */
	int width, height;   /* of the screen, in pixels */
	int jobs;            /* threads */
	const struct kernel *kernel;
	/* NULL, or called now and then with the jobs done and all jobs. */
	void (*progress)(void *context, int done, int total);
	void *progress_context;
};

struct comparison_cell {
	struct candidate_error error;
	struct candidate_time time;
	struct board_frame board;
	struct candidate_bytes bytes;
	int vertex_count;
	struct fit_keys keys; /* the key frames of a morph */
};

/* The clips of a row together. */
struct comparison_total {
	float peak_px, mean_px, outline_px, normal_deg, shade_steps;
	int peak_clip;       /* index in clip[] of the clip with peak_px */
	double frame_us;     /* on this machine, a mean over the clips */
	double instructions; /* a mean, too; negative: no counter */
	struct board_cost board, draw; /* means: the whole frame; its drawing */
	size_t memory_bytes, file_bytes;
	int key_count;
};

struct comparison_row {
	char name[48]; /* "morph, 9 keys" */
	enum technique technique;
	enum comparison_kind kind;
	bool listed;        /* in the table; other rows are only plotted */
	bool front;         /* on the Pareto front */
	int max_influences; /* a vertex, of an original; 0: all */
	bool targets;       /* of an original: with its morph targets */
	float bound_px;     /* of a fitted morph */
	struct comparison_cell *cell; /* [clip_count] */
	struct comparison_total total;
};

struct comparison_clip {
	int clip;           /* of the model */
	struct bounds rest; /* of the model's rest pose */
	struct time_grid grid;
	struct screen_view screen;
	bool turns; /* inside out for a part of the time: see measure/winding.h */
	int row;    /* the row that plays it in the mixed plan */
};

struct comparison {
	struct comparison_request request;
	const struct model *model;
	/* Bounds of all clips and of a rest pose near them, in model units. */
	struct bounds box;
	float unit_scale; /* of the model's instances; 0 until one was created */
	int vertex_count;
	int clip_count;
	struct comparison_clip *clip;
	struct sampling sampling;
	int row_count;
	struct comparison_row row[COMPARISON_ROWS_MAX];

	/* Set by advice_give(). */
	size_t memory_limit_bytes;
	double time_limit_us;
	int advised; /* the row that suits all clips best */
	bool mixed;  /* a plan of several rows, in clip[].row, is better */
	size_t mixed_bytes;
	double mixed_us;
	char reason[COMPARISON_REASON_BYTES]; /* a sentence with both numbers */
};

/*
 * Converts the clips to all techniques and measures them. The caller has made
 * the model's levels of detail (app/model/levels), which exports contain, too.
 * The model must outlive the comparison; comparison_destroy() releases *out.
 * Returns 0, or -errno after logging an error.
 */
int comparison_create(const struct model *model,
	const struct comparison_request *request, const struct log *log,
	struct comparison **out);

/* Whether a listed row uses the technique. */
bool comparison_has(
	const struct comparison *comparison, enum technique technique);

/* NULL is fine. */
void comparison_destroy(struct comparison *comparison);

#endif

/*
 * The model's parameters, KEY=VALUE on the plugin's command line. Cycles are
 * the core's.
 */
#ifndef TESTS_ARM1136_CORE_PARAMS_H
#define TESTS_ARM1136_CORE_PARAMS_H

#include <stdbool.h>

struct params {
	int l1i_kib, l1d_kib, l2_kib;
	int l2;         /* extra cycles of a load that hits L2 */
	int l2_busy;    /* cycles that a line occupies L2 */
	int ddr;        /* extra cycles of a load from memory */
	int ddr_busy;   /* cycles that a line read occupies memory */
	int ddr_write;  /* cycles that a line written occupies memory */
	int misses;     /* lines that can be requested at once */
	int writes;     /* entries of the write buffer */
	int byte_extra; /* extra cycles of a byte or halfword over a word */
	int predictor;  /* entries of the dynamic predictor */
	int tlb;        /* cycles for a page that is in no MicroTLB */
	bool pages;     /* addresses are translated */
	bool fold;      /* predicted branches can take no cycle */
	bool ideal;     /* every access hits L1 */
	bool whole;     /* count from the first instruction to the last */
	const char *begin, *end; /* symbols to count between, or NULL */
	const char *profile;     /* symbol to list instruction by instruction */
	const char *json, *report, *map; /* files, or NULL */
	unsigned int top;                /* symbols in the report */
};

void params_default(struct params *params);

/*
 * Sets one parameter from KEY=VALUE, which must outlive params. Returns false
 * when key or value is wrong.
 */
bool params_set(struct params *params, char *argument);

/* Computes the parameters that depend on others, once all are set. */
void params_complete(struct params *params);

#endif

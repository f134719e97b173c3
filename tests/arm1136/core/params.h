/*
 * The model's parameters, KEY=VALUE on the plugin's command line. Cycles are
 * the core's.
 */
#ifndef TESTS_ARM1136_CORE_PARAMS_H
#define TESTS_ARM1136_CORE_PARAMS_H

#include <stdbool.h>

struct params {
	int l1i_kib, l1d_kib, l2_kib;
	int l2;         /* a load that hits L2 waits so much longer */
	int l2_busy;    /* L2 is busy with a line */
	int ddr;        /* a load that hits nothing waits so much longer */
	int ddr_busy;   /* memory is busy with a line that is read */
	int ddr_write;  /* and with one that is written */
	int misses;     /* loads of lines under way at once */
	int writes;     /* entries of the write buffer */
	int byte_extra; /* a byte or halfword comes so much later than a word */
	int predictor;  /* entries of the dynamic predictor */
	int tlb;        /* cycles for a page that is in no MicroTLB */
	bool pages;     /* addresses are translated */
	bool fold;      /* predicted branches can vanish */
	bool ideal;     /* every access hits L1 */
	bool whole;     /* count from the first instruction to the last */
	const char *begin, *end; /* symbols to count between, or NULL */
	const char *profile;     /* symbol to list instruction by instruction */
	const char *json, *report, *map; /* files, or NULL */
	unsigned int top;                /* symbols in the report */
};

void params_default(struct params *params);

/* One KEY=VALUE; false when it is none. The strings must stay. */
bool params_set(struct params *params, char *argument);

/* Works out what was left open, once all are set. */
void params_complete(struct params *params);

#endif

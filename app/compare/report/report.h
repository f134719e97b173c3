/*
 * A comparison as people and programs read it.
 */
#ifndef APP_COMPARE_REPORT_REPORT_H
#define APP_COMPARE_REPORT_REPORT_H

#include "app/compare/comparison.h"

#include <stdio.h>

struct report_format {
	const char *name;
	/* 0, or -ENOMEM; what cannot be written shows in ferror(). */
	int (*print)(const struct comparison *comparison, FILE *out);
};

/* text, json, csv and md, NULL at the end. */
extern const struct report_format report_formats[];

/* The format of that name, or NULL. */
const struct report_format *report_find(const char *name);

int report_print_text(const struct comparison *comparison, FILE *out);
int report_print_json(const struct comparison *comparison, FILE *out);
int report_print_csv(const struct comparison *comparison, FILE *out);
int report_print_markdown(const struct comparison *comparison, FILE *out);

/*
 * Error against memory and against the cost of a frame, as an SVG picture
 * with a curve a technique. 0, or -errno after a sentence.
 */
int report_plot(const struct comparison *comparison, const char *path,
	const struct log *log);

#endif

/*
 * Prints and plots a comparison.
 */
#ifndef APP_COMPARE_REPORT_REPORT_H
#define APP_COMPARE_REPORT_REPORT_H

#include "app/compare/comparison.h"

#include <stdio.h>

struct report_format {
	const char *name;
	/*
	 * Returns 0, -ENOMEM, or -EINVAL if the format cannot state the model's
	 * name. Errors of writing are in ferror(out).
	 */
	int (*print)(const struct comparison *comparison, FILE *out);
};

/* The formats text, json, csv and md; ends with an entry whose name is NULL. */
extern const struct report_format report_formats[];

/* Returns the format of that name, or NULL. */
const struct report_format *report_find(const char *name);

int report_print_text(const struct comparison *comparison, FILE *out);
int report_print_json(const struct comparison *comparison, FILE *out);
int report_print_csv(const struct comparison *comparison, FILE *out);
int report_print_markdown(const struct comparison *comparison, FILE *out);

/*
 * Writes an SVG picture of two charts: error against memory, and error against
 * the predicted time of posing, with a curve for each technique. Returns 0, or
 * -errno after logging an error.
 */
int report_plot(const struct comparison *comparison, const char *path,
	const struct log *log);

#endif

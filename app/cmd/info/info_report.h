/*
 * What `limber info` tells, measured once and printed in two ways.
 */
#ifndef APP_CMD_INFO_INFO_REPORT_H
#define APP_CMD_INFO_INFO_REPORT_H

#include "app/model/model_stats.h"

#include <stdio.h>

struct info_report {
	const struct model *model;
	struct model_stats stats;
	int joint_count; /* of all skins */

	/* Memory that the techniques take beside the geometry itself. */
	size_t hierarchical_bytes; /* a transform and a matrix a node */
	size_t morphing_bytes;     /* targets, and the shape they give */
	size_t skeletal_bytes;     /* influences, palettes, the skinned shape */
};

/* 0, or -ENOMEM after a sentence. */
int info_measure(const struct model *model, const struct log *log,
	struct info_report *out);

void info_print_text(const struct info_report *report, FILE *out);

/* 0, or -errno after a sentence when it cannot be told in JSON. */
int info_print_json(
	const struct info_report *report, const struct log *log, FILE *out);

#endif

/*
 * Measures what `limber info` prints about a model, and prints it.
 */
#ifndef APP_CMD_INFO_INFO_REPORT_H
#define APP_CMD_INFO_INFO_REPORT_H

#include "app/model/model_stats.h"

#include <stdbool.h>
#include <stdio.h>

struct info_report {
	const struct model *model; /* not owned */
	struct model_stats stats;
	int joint_count; /* of all skins */
	/*
	 * [mesh_count]: the length in metres of a unit of the mesh's positions
	 * at the first node that shows it; 1 if none does.
	 */
	float *unit_m;

	/* Memory that each technique needs in addition to the geometry. */
	size_t hierarchical_bytes; /* a transform and a matrix for each node */
	size_t morphing_bytes;     /* targets and morphed vertices */
	size_t skeletal_bytes;     /* influences, palettes, skinned vertices */
};

/*
 * Measures the model. Returns 0, or -errno after logging an error. The caller
 * calls info_release() after success; the model must outlive the report.
 */
int info_measure(const struct model *model, const struct log *log,
	struct info_report *out);

void info_release(struct info_report *report);

void info_print_text(const struct info_report *report, FILE *out);

/*
 * Prints the name of each node below that of its parent, whether it is a joint,
 * and the number of its mesh. Returns 0, or -ENOMEM after logging an error.
 */
int info_print_nodes(
	const struct model *model, const struct log *log, FILE *out);

/*
 * Prints the report, with all nodes if that is asked for.
 * Returns 0, or after logging an error -EINVAL if a name in the model is not
 * UTF-8, or -ENOMEM.
 */
int info_print_json(const struct info_report *report, bool nodes,
	const struct log *log, FILE *out);

#endif

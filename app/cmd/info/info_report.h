/*
 * What `limber info` prints about a model, as text or JSON.
 */
#ifndef APP_CMD_INFO_INFO_REPORT_H
#define APP_CMD_INFO_INFO_REPORT_H

#include "app/model/model_stats.h"

#include <stdio.h>

struct info_report {
	const struct model *model; /* not owned */
	struct model_stats stats;
	int joint_count; /* of all skins */
	/*
	 * [mesh_count]: metres in the scene that a unit of the mesh's positions
	 * is, where a node shows it first; 1 if none does.
	 */
	float *unit_m;

	/* Memory that each technique needs in addition to the geometry. */
	size_t hierarchical_bytes; /* a transform and a matrix for each node */
	size_t morphing_bytes;     /* targets and morphed vertices */
	size_t skeletal_bytes;     /* influences, palettes, skinned vertices */
};

/*
 * Returns 0, or -errno after logging an error. info_release() frees what the
 * report holds.
 */
int info_measure(const struct model *model, const struct log *log,
	struct info_report *out);

void info_release(struct info_report *report);

void info_print_text(const struct info_report *report, FILE *out);

/*
 * Returns 0, or -errno after logging an error: a name in the model is not
 * UTF-8.
 */
int info_print_json(
	const struct info_report *report, const struct log *log, FILE *out);

#endif

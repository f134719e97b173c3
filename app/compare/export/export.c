#include "app/compare/export/export.h"

#include "app/compare/candidate_morph.h"
#include "app/compare/export/export_bake.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static int export_candidate(const struct comparison *comparison,
	const struct candidate *candidate, const char *folder,
	const struct log *log)
{
	char path[4096];
	int length;
	struct glb glb;

	if (candidate->key_count > 0) {
		length = snprintf(path, sizeof(path), "%s/morph-%d.glb", folder,
			candidate->key_count);
	} else {
		length = snprintf(path, sizeof(path), "%s/rigid.glb", folder);
	}
	if (length < 0 || (size_t)length >= sizeof(path)) {
		log_error(log,
			"--export %s: the name is too long: choose a shorter one",
			folder);
		return -ENAMETOOLONG;
	}
	glb_begin(&glb);
	if (candidate->key_count > 0) {
		export_morph(&glb, comparison->reference,
			candidate_morph_keys(candidate), candidate->key_count);
	} else {
		export_rigid(&glb, candidate_rigid_bake(candidate));
	}
	return glb_write(&glb, path, log);
}

int export_comparison(const struct comparison *comparison, const char *folder,
	const struct log *log)
{
	int error = 0;

	if (mkdir(folder, 0777) != 0 && errno != EEXIST) {
		error = -errno;
		log_error(log, "--export %s: the folder cannot be made: %s",
			folder, strerror(-error));
		return error;
	}
	for (int i = 0; !error && i < comparison->candidate_count; i++) {
		const struct candidate *candidate = &comparison->candidate[i];

		if (candidate->listed &&
			(candidate->key_count > 0 || candidate->source)) {
			error = export_candidate(
				comparison, candidate, folder, log);
		}
	}
	return error;
}

/*
 * Says which clips of a model limber plays once.
 */
#ifndef APP_CMD_DOCTOR_DOCTOR_CLIPS_H
#define APP_CMD_DOCTOR_DOCTOR_CLIPS_H

#include "app/model/examine/examine.h"

/*
 * Reports the clips that end in another shape than they begin with, as one that
 * opens a door: without a character file, limber does not repeat them. Logs
 * errors of the model to log. Returns 0, or -errno if the model cannot be
 * loaded.
 */
int doctor_clips_check(const char *model_path, size_t memory_bytes,
	const struct examiner *examiner, const struct log *log);

#endif

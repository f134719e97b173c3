/*
 * limber doctor without a model: what of this machine works for limber.
 */
#ifndef APP_CMD_DOCTOR_DOCTOR_MACHINE_H
#define APP_CMD_DOCTOR_DOCTOR_MACHINE_H

#include "app/cmd/options/options.h"

/*
 * Prints what every driver finds, and the rest that play needs. One of enum
 * exit_code: EXIT_OK when some display and some GL driver work.
 */
int doctor_examine_machine(const struct options *options, const struct log *log);

#endif

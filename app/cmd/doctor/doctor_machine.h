/*
 * `limber doctor` without a model: checks displays, drivers, devices and files.
 */
#ifndef APP_CMD_DOCTOR_DOCTOR_MACHINE_H
#define APP_CMD_DOCTOR_DOCTOR_MACHINE_H

#include "app/cmd/options/options.h"

/*
 * Prints what every driver finds, then whether limber can play. Returns one of
 * enum exit_code: EXIT_OK when a display and a GL driver work.
 */
int doctor_examine_machine(const struct options *options, const struct log *log);

#endif

/* Prints what the model counted, as text and as JSON. */
#ifndef TESTS_ARM1136_REPORT_H
#define TESTS_ARM1136_REPORT_H

#include "tests/arm1136/program.h"

#include <stdio.h>

void report_text(FILE *out, const struct program *program);
void report_json(FILE *out, const struct program *program);

#endif

/*
 * What the gpiod driver does, whichever libgpiod it was built for.
 */
#ifndef TESTS_GPIOD_CASES_H
#define TESTS_GPIOD_CASES_H

/* Runs all cases; the result is main's. */
int gpiod_cases_run(void);

#endif

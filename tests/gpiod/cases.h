/*
 * The tests of the gpiod driver, for both versions of libgpiod.
 */
#ifndef TESTS_GPIOD_CASES_H
#define TESTS_GPIOD_CASES_H

/* Runs all tests. Returns main()'s result. */
int gpiod_cases_run(void);

#endif

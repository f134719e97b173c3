/*
 * The tests of the gpiod driver, for both versions of libgpiod.
 */
#ifndef TESTS_GPIOD_CASES_H
#define TESTS_GPIOD_CASES_H

/* Run all tests of a file. Return main()'s result. */
int gpiod_cases_run(void);
int gpiod_lost_cases_run(void);
int gpiod_output_cases_run(void);

#endif

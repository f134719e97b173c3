/* Driven lines over libgpiod 2.x; toolchain/gpiod.mk links the fake. */
#include "tests/gpiod/cases.h"

int main(void)
{
	return gpiod_output_cases_run();
}

/* The gpiod driver over libgpiod 1.x; toolchain/gpiod.mk links the fake. */
#include "tests/gpiod/cases.h"

int main(void)
{
	return gpiod_cases_run();
}

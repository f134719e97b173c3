#include "platform/base/interrupt.h"

#include <signal.h>

static volatile sig_atomic_t number;

bool interrupt_pending(void)
{
	return number != 0;
}

int interrupt_signal(void)
{
	return number;
}

void interrupt_set(int signal)
{
	number = signal;
}

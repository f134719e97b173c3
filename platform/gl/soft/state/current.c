/* The context that calls of GL work on. */
#include "platform/gl/soft/soft.h"

/* What GL's calls on this thread mean: they have no parameter to say it. */
static _Thread_local struct soft *current;

struct soft *soft_current(void)
{
	return current;
}

void soft_make_current(struct soft *soft)
{
	current = soft;
}

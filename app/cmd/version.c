#include "app/cmd/version.h"

#if defined(__ARM_ARCH)
#define PROCESSOR "ARM"
#elif defined(__x86_64__)
#define PROCESSOR "x86-64"
#else
#define PROCESSOR "other processor"
#endif

const char *version_text(void)
{
	return "limber 0.1.0 (" PROCESSOR ")";
}

#include "app/cmd/version.h"

#include "app/anim/kernel/kernel.h"
#include "platform/buttons/buttons.h"
#include "platform/camera/camera.h"
#include "platform/display/display.h"
#include "platform/gl/gl_context.h"

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

/* Prints the names in a registry on one line. */
#define PRINT_NAMES(out, title, registry)                           \
	do {                                                        \
		fprintf((out), "%-9s", (title));                    \
		for (int i = 0; (registry)[i]; i++) {               \
			fprintf((out), " %s", (registry)[i]->name); \
		}                                                   \
		fputc('\n', (out));                                 \
	} while (0)

void version_print(FILE *out)
{
	fprintf(out, "%s\n", version_text());
	fprintf(out, "%-9s %s, C %ld\n", "built by", "cc " __VERSION__,
		__STDC_VERSION__);
	PRINT_NAMES(out, "kernels", kernel_registry);
	PRINT_NAMES(out, "gl", gl_registry);
	PRINT_NAMES(out, "displays", display_registry);
	PRINT_NAMES(out, "buttons", button_registry);
	PRINT_NAMES(out, "cameras", camera_registry);
}

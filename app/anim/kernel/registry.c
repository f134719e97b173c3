#include "app/anim/kernel/kernel.h"

#include <string.h>

const struct kernel *const kernel_registry[] = {
	&kernel_float,
	NULL,
};

const struct kernel *kernel_find(const char *name)
{
	for (int i = 0; kernel_registry[i]; i++) {
		if (!name || strcmp(kernel_registry[i]->name, name) == 0) {
			return kernel_registry[i];
		}
	}
	return NULL;
}

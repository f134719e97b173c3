#include "app/anim/kernel/kernel.h"

#include <string.h>

#define KERNEL_DRIVER(name) extern const struct kernel kernel_##name;
#include "kernel_drivers.h"
#undef KERNEL_DRIVER

#define KERNEL_DRIVER(name) &kernel_##name,
const struct kernel *const kernel_registry[] = {
#include "kernel_drivers.h"
	NULL,
};
#undef KERNEL_DRIVER

const struct kernel *kernel_find(const char *name)
{
	for (int i = 0; kernel_registry[i]; i++) {
		if (!name || strcmp(kernel_registry[i]->name, name) == 0) {
			return kernel_registry[i];
		}
	}
	return NULL;
}

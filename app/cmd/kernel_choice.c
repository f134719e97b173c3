#include "app/cmd/kernel_choice.h"

#include "platform/base/name_list.h"

const struct kernel *kernel_choose(const char *name, const struct log *log)
{
	const struct kernel *kernel = kernel_find(name);
	struct name_list names = {""};

	if (kernel) {
		return kernel;
	}
	for (int i = 0; kernel_registry[i]; i++) {
		name_list_add(&names, kernel_registry[i]->name);
	}
	log_error(log, "--kernel %s: no such kernel: choose one of %s", name,
		names.text);
	return NULL;
}

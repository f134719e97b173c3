#include "app/cmd/show/kernel_choice.h"

#include "platform/base/compiler.h"
#include "platform/base/name_list.h"

#include <string.h>

/* What other builds have. */
static const struct {
	const char *name, *where;
} elsewhere[] = {
	{"armv6", "ARMv6 assembly, for the build for ARM boards"},
};

static void say_unknown(const char *name, const struct log *log)
{
	struct name_list names = {""};

	for (int i = 0; kernel_registry[i]; i++) {
		name_list_add(&names, kernel_registry[i]->name);
	}
	for (size_t i = 0; i < ARRAY_COUNT(elsewhere); i++) {
		if (strcmp(elsewhere[i].name, name) == 0) {
			log_error(log,
				"--kernel %s: is %s: choose one of %s here",
				name, elsewhere[i].where, names.text);
			return;
		}
	}
	log_error(log, "--kernel %s: no such kernel: choose one of %s", name,
		names.text);
}

static bool is_of(const struct kernel *kernel, enum math math)
{
	return math == MATH_ANY || !kernel->fixed == (math == MATH_FLOAT);
}

static const struct kernel *choose_named(
	const char *name, enum math math, const struct log *log)
{
	const struct kernel *kernel = kernel_find(name);

	if (!kernel) {
		say_unknown(name, log);
		return NULL;
	}
	if (!is_of(kernel, math)) {
		log_error(log,
			"--kernel %s: computes in %s: leave out --math %s, or "
			"choose another kernel",
			name, kernel->fixed ? "fixed point" : "float",
			math == MATH_FLOAT ? "float" : "fixed");
		return NULL;
	}
	return kernel;
}

const struct kernel *kernel_choose(
	const struct options *options, const struct log *log)
{
	if (options->kernel) {
		return choose_named(options->kernel, options->math, log);
	}
	for (int i = 0; kernel_registry[i]; i++) {
		if (is_of(kernel_registry[i], options->math)) {
			return kernel_registry[i];
		}
	}
	log_error(log, "--math %s: no kernel of this program computes so",
		options->math == MATH_FLOAT ? "float" : "fixed");
	return NULL;
}

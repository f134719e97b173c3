#include "app/cmd/options/options_kernel.h"

#include "platform/base/compiler.h"
#include "platform/base/name_list.h"

#include <string.h>

/* Kernels that this build may lack, and which build has them. */
static const struct {
	const char *name, *where;
} elsewhere[] = {
	{"armv6", "is ARMv6 assembly, which only the build for ARM has"},
};

static void log_unknown(const char *name, const struct log *log)
{
	struct name_list names = {""};
	const char *problem = "there is no such kernel";

	for (int i = 0; kernel_registry[i]; i++) {
		name_list_add(&names, kernel_registry[i]->name);
	}
	for (size_t i = 0; i < ARRAY_COUNT(elsewhere); i++) {
		if (strcmp(elsewhere[i].name, name) == 0) {
			problem = elsewhere[i].where;
		}
	}
	log_error(log, "--kernel %s: %s: choose one of %s", name, problem,
		names.text);
}

static bool uses_math(const struct kernel *kernel, enum options_math math)
{
	return math == MATH_ANY || !kernel->fixed == (math == MATH_FLOAT);
}

static const struct kernel *choose_named(
	const char *name, enum options_math math, const struct log *log)
{
	const struct kernel *kernel = kernel_find(name);

	if (!kernel) {
		log_unknown(name, log);
		return NULL;
	}
	if (!uses_math(kernel, math)) {
		log_error(log,
			"--kernel %s: this kernel computes in %s: leave out --math %s or choose another kernel",
			name, kernel->fixed ? "fixed point" : "float",
			math == MATH_FLOAT ? "float" : "fixed");
		return NULL;
	}
	return kernel;
}

const struct kernel *options_kernel(
	const struct options_vertices *options, const struct log *log)
{
	if (options->kernel) {
		return choose_named(options->kernel, options->math, log);
	}
	for (int i = 0; kernel_registry[i]; i++) {
		if (uses_math(kernel_registry[i], options->math)) {
			return kernel_registry[i];
		}
	}
	log_error(log,
		"--math %s: this build has no kernel that computes in it: leave out --math",
		options->math == MATH_FLOAT ? "float" : "fixed");
	return NULL;
}

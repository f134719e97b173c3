/* The functions of the program that runs, by address. */
#ifndef TESTS_ARM1136_SYMBOLS_H
#define TESTS_ARM1136_SYMBOLS_H

#include <stddef.h>
#include <stdint.h>

struct symbol {
	uint32_t address;
	char *name;
};

struct symbols {
	struct symbol *symbol; /* sorted by address */
	size_t count;
	uint32_t code_end; /* where the code ends; 0: not known */
};

/*
 * Adds the functions of a 32-bit ELF file. start_code is the address at which
 * its code was loaded, or 0 for the address it was linked for. Returns 0 or
 * -errno; with -ENOMEM some of the functions have been added.
 */
int symbols_read_elf(
	struct symbols *symbols, const char *path, uint32_t start_code);

/* The same with lines of nm: address, type, name. */
int symbols_read_map(struct symbols *symbols, const char *path);

void symbols_finish(struct symbols *symbols);

/* The function that contains the address, or NULL. */
const struct symbol *symbols_find(
	const struct symbols *symbols, uint32_t address);

/* The function of that name, or NULL. */
const struct symbol *symbols_named(
	const struct symbols *symbols, const char *name);

#endif

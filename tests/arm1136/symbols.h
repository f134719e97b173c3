/* The functions of the program, by address. */
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
	uint32_t code_end; /* nothing from there on; 0 if not known */
};

/*
 * Adds what the symbol table of a 32-bit ELF file has; code begins at
 * start_code there, or 0. 0, or -errno with nothing added.
 */
int symbols_read_elf(
	struct symbols *symbols, const char *path, uint32_t start_code);

/* Adds lines as nm prints them: address, type, name. 0 or -errno. */
int symbols_read_map(struct symbols *symbols, const char *path);

void symbols_finish(struct symbols *symbols);

/* The function that an address is in, or NULL. */
const struct symbol *symbols_find(
	const struct symbols *symbols, uint32_t address);

/* The function of that name, or NULL. */
const struct symbol *symbols_named(
	const struct symbols *symbols, const char *name);

#endif

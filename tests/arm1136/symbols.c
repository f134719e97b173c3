#include "tests/arm1136/symbols.h"

#include <elf.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int add(struct symbols *symbols, uint32_t address, const char *name)
{
	struct symbol *more = symbols->symbol;

	/* The capacity is a power of two: it doubles when it is reached. */
	if ((symbols->count & (symbols->count - 1)) == 0) {
		size_t capacity = symbols->count ? symbols->count * 2 : 1;

		more = realloc(more, capacity * sizeof(*more));
		if (!more) {
			return -ENOMEM;
		}
		symbols->symbol = more;
	}
	more[symbols->count].address = address & ~1u;
	more[symbols->count].name = strdup(name);
	if (!more[symbols->count].name) {
		return -ENOMEM;
	}
	symbols->count++;
	return 0;
}

static int compare(const void *a, const void *b)
{
	const struct symbol *left = a;
	const struct symbol *right = b;

	if (left->address != right->address) {
		return left->address < right->address ? -1 : 1;
	}
	return strcmp(left->name, right->name);
}

static void sort(struct symbols *symbols)
{
	if (symbols->count) {
		qsort(symbols->symbol, symbols->count, sizeof(*symbols->symbol),
			compare);
	}
}

static int read_file(const char *path, char **data, size_t *size)
{
	FILE *file = fopen(path, "rb");
	long length;
	int result = 0;

	if (!file) {
		return -errno;
	}
	if (fseek(file, 0, SEEK_END) || (length = ftell(file)) < 0 ||
		fseek(file, 0, SEEK_SET)) {
		result = -EIO;
		goto close;
	}
	*size = (size_t)length;
	*data = malloc(*size + 1);
	if (!*data) {
		result = -ENOMEM;
	} else if (fread(*data, 1, *size, file) != *size) {
		free(*data);
		result = -EIO;
	} else {
		(*data)[*size] = '\0';
	}
close:
	fclose(file);
	return result;
}

/* A file in memory. Every offset into it is checked against its size. */
struct image {
	const char *data;
	size_t size;
};

static bool inside(const struct image *image, size_t offset, size_t bytes)
{
	return offset <= image->size && bytes <= image->size - offset;
}

/*
 * Sets the end of the code. Returns the difference between the address at which
 * the code was loaded and the address for which it was linked.
 */
static uint32_t locate_code(struct symbols *symbols, const struct image *image,
	const Elf32_Ehdr *header, uint32_t start_code)
{
	for (size_t i = 0; i < header->e_phnum; i++) {
		Elf32_Phdr segment;
		size_t offset = header->e_phoff + i * sizeof(segment);
		uint32_t bias = 0;

		if (!inside(image, offset, sizeof(segment))) {
			break;
		}
		memcpy(&segment, image->data + offset, sizeof(segment));
		if (segment.p_type != PT_LOAD || !(segment.p_flags & PF_X)) {
			continue;
		}
		if (start_code) {
			bias = (start_code & ~0xfffu) -
				(segment.p_vaddr & ~0xfffu);
		}
		symbols->code_end = segment.p_vaddr + bias + segment.p_memsz;
		return bias;
	}
	return 0;
}

static bool is_function(const Elf32_Sym *symbol, const char *name)
{
	int type = ELF32_ST_TYPE(symbol->st_info);

	return symbol->st_shndx != SHN_UNDEF && symbol->st_shndx < SHN_ABS &&
		(type == STT_FUNC || type == STT_NOTYPE) && *name &&
		*name != '$' && *name != '.';
}

static int read_table(struct symbols *symbols, const struct image *image,
	const Elf32_Shdr *table, const Elf32_Shdr *strings, uint32_t bias)
{
	size_t count = table->sh_size / sizeof(Elf32_Sym);
	int result = 0;

	if (!inside(image, table->sh_offset, table->sh_size) ||
		!inside(image, strings->sh_offset, strings->sh_size)) {
		return -EINVAL;
	}
	for (size_t i = 0; i < count && !result; i++) {
		Elf32_Sym symbol;
		const char *name;

		memcpy(&symbol,
			image->data + table->sh_offset + i * sizeof(symbol),
			sizeof(symbol));
		if (symbol.st_name >= strings->sh_size) {
			continue;
		}
		name = image->data + strings->sh_offset + symbol.st_name;
		if (is_function(&symbol, name)) {
			result = add(symbols, symbol.st_value + bias, name);
		}
	}
	return result;
}

static bool section(const struct image *image, const Elf32_Ehdr *header,
	size_t index, Elf32_Shdr *out)
{
	size_t offset = header->e_shoff + index * sizeof(*out);

	if (index >= header->e_shnum || !inside(image, offset, sizeof(*out))) {
		return false;
	}
	memcpy(out, image->data + offset, sizeof(*out));
	return true;
}

static int read_image(
	struct symbols *symbols, const struct image *image, uint32_t start_code)
{
	Elf32_Ehdr header;
	Elf32_Shdr table;
	Elf32_Shdr strings;

	if (!inside(image, 0, sizeof(header))) {
		return -EINVAL;
	}
	memcpy(&header, image->data, sizeof(header));
	if (memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
		header.e_ident[EI_CLASS] != ELFCLASS32) {
		return -EINVAL;
	}
	for (size_t i = 0; section(image, &header, i, &table); i++) {
		if (table.sh_type == SHT_SYMTAB &&
			section(image, &header, table.sh_link, &strings)) {
			return read_table(symbols, image, &table, &strings,
				locate_code(symbols, image, &header, start_code));
		}
	}
	return -ENOENT;
}

int symbols_read_elf(
	struct symbols *symbols, const char *path, uint32_t start_code)
{
	char *data = NULL;
	struct image image = {0};
	int result = read_file(path, &data, &image.size);

	if (result) {
		return result;
	}
	image.data = data;
	result = read_image(symbols, &image, start_code);
	sort(symbols);
	free(data);
	return result;
}

int symbols_read_map(struct symbols *symbols, const char *path)
{
	FILE *file = fopen(path, "r");
	char line[512];
	int result = 0;

	if (!file) {
		return -errno;
	}
	while (!result && fgets(line, sizeof(line), file)) {
		unsigned int address;
		char type;
		char name[400];

		if (sscanf(line, "%x %c %399s", &address, &type, name) == 3 &&
			(type == 't' || type == 'T')) {
			result = add(symbols, address, name);
		}
	}
	fclose(file);
	sort(symbols);
	return result;
}

void symbols_finish(struct symbols *symbols)
{
	for (size_t i = 0; i < symbols->count; i++) {
		free(symbols->symbol[i].name);
	}
	free(symbols->symbol);
	symbols->symbol = NULL;
	symbols->count = 0;
}

const struct symbol *symbols_find(
	const struct symbols *symbols, uint32_t address)
{
	size_t low = 0;
	size_t high = symbols->count;

	if (symbols->code_end && address >= symbols->code_end) {
		return NULL;
	}
	while (low < high) {
		size_t middle = (low + high) / 2;

		if (symbols->symbol[middle].address <= address) {
			low = middle + 1;
		} else {
			high = middle;
		}
	}
	return low ? &symbols->symbol[low - 1] : NULL;
}

const struct symbol *symbols_named(
	const struct symbols *symbols, const char *name)
{
	for (size_t i = 0; i < symbols->count; i++) {
		if (strcmp(symbols->symbol[i].name, name) == 0) {
			return &symbols->symbol[i];
		}
	}
	return NULL;
}

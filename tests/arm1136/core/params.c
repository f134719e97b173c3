#include "tests/arm1136/core/params.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

/* In a stream, a line takes half the time of a single one (figures.md). */
#define HALF_OF_DDR (-1)

void params_default(struct params *params)
{
	*params = (struct params){
		.l1i_kib = 16,
		.l1d_kib = 16,
		.l2_kib = 128,
		.l2 = 10,
		.l2_busy = 8,
		.ddr = 80,
		.ddr_busy = HALF_OF_DDR,
		.ddr_write = 16,
		.misses = 2,
		.writes = 4,
		.byte_extra = 1,
		.predictor = 128,
		.tlb = 8,
		.pages = true,
		.fold = true,
		.top = 20,
	};
}

enum kind {
	INTEGER,
	SWITCH,
	TEXT
};

struct key {
	const char *name;
	enum kind kind;
	size_t offset;
	long low, high;
};

#define KEY(name, kind, member, low, high)                             \
	{                                                              \
		name, kind, offsetof(struct params, member), low, high \
	}

static const struct key keys[] = {
	KEY("l1i", INTEGER, l1i_kib, 4, 64),
	KEY("l1d", INTEGER, l1d_kib, 4, 64),
	KEY("l2size", INTEGER, l2_kib, 4, 1024),
	KEY("l2", INTEGER, l2, 0, 1000),
	KEY("l2busy", INTEGER, l2_busy, 0, 1000),
	KEY("ddr", INTEGER, ddr, 0, 10000),
	KEY("ddrbusy", INTEGER, ddr_busy, 0, 10000),
	KEY("ddrwrite", INTEGER, ddr_write, 0, 10000),
	KEY("misses", INTEGER, misses, 1, 8),
	KEY("writes", INTEGER, writes, 1, 16),
	KEY("byte", INTEGER, byte_extra, 0, 3),
	KEY("predictor", INTEGER, predictor, 1, 1024),
	KEY("top", INTEGER, top, 0, 100000),
	KEY("tlb", INTEGER, tlb, 0, 1000),
	KEY("pages", SWITCH, pages, 0, 1),
	KEY("fold", SWITCH, fold, 0, 1),
	KEY("ideal", SWITCH, ideal, 0, 1),
	KEY("whole", SWITCH, whole, 0, 1),
	KEY("begin", TEXT, begin, 0, 0),
	KEY("end", TEXT, end, 0, 0),
	KEY("profile", TEXT, profile, 0, 0),
	KEY("json", TEXT, json, 0, 0),
	KEY("report", TEXT, report, 0, 0),
	KEY("map", TEXT, map, 0, 0),
};

static bool is_power_of_two(long value)
{
	return (value & (value - 1)) == 0;
}

static bool set_integer(
	const struct key *key, struct params *params, const char *value)
{
	char *end;
	long number = strtol(value, &end, 10);
	bool is_size = strncmp(key->name, "l1", 2) == 0 ||
		strcmp(key->name, "l2size") == 0 ||
		strcmp(key->name, "predictor") == 0;

	if (end == value || *end || number < key->low || number > key->high ||
		(is_size && !is_power_of_two(number))) {
		return false;
	}
	*(int *)((char *)params + key->offset) = (int)number;
	return true;
}

static bool set(const struct key *key, struct params *params, const char *value)
{
	void *member = (char *)params + key->offset;

	switch (key->kind) {
	case INTEGER:
		return set_integer(key, params, value);
	case SWITCH:
		*(bool *)member = strcmp(value, "on") == 0;
		return *(bool *)member || strcmp(value, "off") == 0;
	default:
		*(const char **)member = value;
		return *value;
	}
}

bool params_set(struct params *params, char *argument)
{
	char *equals = strchr(argument, '=');

	if (!equals) {
		return false;
	}
	for (size_t i = 0; i < sizeof(keys) / sizeof(*keys); i++) {
		if (strlen(keys[i].name) == (size_t)(equals - argument) &&
			strncmp(keys[i].name, argument, strlen(keys[i].name)) ==
				0) {
			return set(&keys[i], params, equals + 1);
		}
	}
	return false;
}

void params_complete(struct params *params)
{
	if (params->ddr_busy == HALF_OF_DDR) {
		params->ddr_busy = params->ddr / 2;
	}
}

/*
 * The places in the program from which calls come.
 *
 * A site is a chain of return addresses: the nearest ones of the program
 * itself, as many as the depth says, and the two nearest of each run of library
 * frames between them. Offsets within each object are compared, as addresses
 * change with every run. The unwinder of libgcc reads the tables that also
 * libraries without frame pointers have; it allocates nothing.
 */
#include "faults.h"

#include <link.h>
#include <stdatomic.h>
#include <stdint.h>
#include <unwind.h>

enum {
	SITES = 1 << 16,
	LIBRARY_FRAMES = 2
};

static struct site {
	uint64_t hash; /* 0: none */
	long first;    /* the first call from here */
} sites[SITES];

static int depth;
static atomic_flag busy = ATOMIC_FLAG_INIT;
static const struct link_map *library, *program;

static const struct link_map *object_of(const void *address)
{
	struct dl_find_object found;

	return _dl_find_object((void *)address, &found) == 0
		? found.dlfo_link_map
		: NULL;
}

void faults_watch_sites(int frames, const void *in_program)
{
	depth = frames;
	library = object_of(sites);
	program = object_of(in_program);
}

struct walk {
	uint64_t hash;
	int program_frames;
	int library_frames; /* since the last frame of the program */
};

/* FNV-1a, of whole words. */
static void mix(struct walk *walk, uint64_t word)
{
	walk->hash = (walk->hash ^ word) * 1099511628211u;
}

static _Unwind_Reason_Code visit(struct _Unwind_Context *context, void *user)
{
	struct walk *walk = user;
	uintptr_t at = _Unwind_GetIP(context);
	const struct link_map *object = object_of((const void *)at);

	if (!object || object == library) {
		return _URC_NO_REASON;
	}
	if (object == program) {
		mix(walk, at - object->l_addr);
		walk->program_frames++;
		walk->library_frames = 0;
	} else if (walk->library_frames++ < LIBRARY_FRAMES) {
		mix(walk, at - object->l_addr);
	}
	return walk->program_frames < depth ? _URC_NO_REASON : _URC_END_OF_STACK;
}

static void add(uint64_t hash, long number)
{
	size_t i = hash % SITES;

	for (int tries = 0; tries < SITES; tries++, i = (i + 1) % SITES) {
		if (sites[i].hash == hash) {
			return;
		}
		if (sites[i].hash == 0) {
			sites[i] = (struct site){hash, number};
			return;
		}
	}
}

void faults_note_site(enum kind kind, long number)
{
	struct walk walk = {.hash = 14695981039346656037u};

	if (!depth) {
		return;
	}
	_Unwind_Backtrace(visit, &walk);
	/* The last digit tells the kinds apart, and is never 0. */
	walk.hash = (walk.hash & ~(uint64_t)31) | (uint64_t)(kind + 1);
	while (atomic_flag_test_and_set(&busy)) {
	}
	add(walk.hash, number);
	atomic_flag_clear(&busy);
}

void faults_write_sites(FILE *report, enum kind kind)
{
	for (int i = 0; i < SITES; i++) {
		if ((sites[i].hash & 31) == (uint64_t)(kind + 1)) {
			fprintf(report, " %ld:%llx", sites[i].first,
				(unsigned long long)sites[i].hash);
		}
	}
}

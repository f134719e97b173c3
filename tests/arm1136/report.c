#include "tests/arm1136/report.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

static const char *const cause_name[CAUSE_COUNT] = {
	[CAUSE_ALU] = "alu",
	[CAUSE_MULTIPLY] = "multiply",
	[CAUSE_LOAD] = "load",
	[CAUSE_L2] = "l2",
	[CAUSE_DDR] = "ddr",
	[CAUSE_PAGE] = "page",
	[CAUSE_VFP] = "vfp",
	[CAUSE_ISSUE] = "issue",
	[CAUSE_MEMORY_PIPE] = "memory-pipe",
	[CAUSE_VFP_PIPE] = "vfp-pipe",
	[CAUSE_LOCK] = "lock",
	[CAUSE_MISSES] = "misses",
	[CAUSE_WRITE_BUFFER] = "write-buffer",
	[CAUSE_FETCH] = "fetch",
	[CAUSE_TAKEN] = "taken",
	[CAUSE_MISPREDICT] = "mispredict",
	[CAUSE_INDIRECT] = "indirect",
};

struct named_count {
	const char *name;
	uint64_t value;
};

/* The cost of a function. */
struct symbol_cost {
	const struct symbol *symbol; /* NULL: outside the program */
	struct insn_counts counts;
};

static const char *name_at(const struct program *program, uint32_t pc)
{
	const struct symbol *symbol = symbols_find(&program->symbols, pc);

	return symbol ? symbol->name : "?";
}

static void region_name(const struct program *program,
	const struct region *region, char *out, size_t size)
{
	if (program->params->whole) {
		snprintf(out, size, "whole");
	} else if (region->id) {
		snprintf(out, size, "%s#%u", name_at(program, region->pc),
			region->id);
	} else {
		snprintf(out, size, "%s", name_at(program, region->pc));
	}
}

static void text_stalls(FILE *out, const uint64_t stall[CAUSE_COUNT])
{
	for (int i = 0; i < CAUSE_COUNT; i++) {
		if (stall[i]) {
			fprintf(out, " %s %" PRIu64, cause_name[i], stall[i]);
		}
	}
}

static void text_region(
	FILE *out, const struct program *program, const struct region *region)
{
	const struct core_totals *totals = &region->totals;
	const struct memory_counts *memory = &totals->memory;
	char name[256];

	region_name(program, region, name, sizeof(name));
	fprintf(out,
		"region %s entries %" PRIu64 " cycles %" PRIu64
		" instructions %" PRIu64 " first %" PRIu64 " last %" PRIu64
		" least %" PRIu64 " most %" PRIu64 "\n",
		name, region->entries, region->cycles, totals->executed,
		region->first, region->last, region->least, region->most);
	fprintf(out, "  stalls");
	text_stalls(out, totals->stall);
	fprintf(out,
		"\n  branches %" PRIu64 " folded %" PRIu64
		" mispredicted %" PRIu64 "\n",
		totals->branches, totals->folded, totals->mispredicted);
	fprintf(out,
		"  lines: fetch missed %" PRIu64 ", load %" PRIu64
		" missed %" PRIu64 " awaited %" PRIu64 ", store %" PRIu64
		" missed %" PRIu64 ", preload %" PRIu64 " dropped %" PRIu64
		" unknown %" PRIu64 ", L2 missed %" PRIu64 ", written %" PRIu64
		"\n  pages: missed %" PRIu64 " walked %" PRIu64 "\n",
		memory->fetches_missed, memory->loads, memory->loads_missed,
		memory->loads_awaited, memory->stores, memory->stores_missed,
		memory->preloads, memory->preloads_dropped,
		memory->preloads_unknown, memory->l2_missed,
		memory->lines_written, memory->pages_missed,
		memory->pages_walked);
	fprintf(out, "  addresses foretold %" PRIu64 " mistaken %" PRIu64 "\n",
		totals->foretold, totals->mistaken);
	if (totals->unknown) {
		fprintf(out, "  not decoded: %" PRIu64 "\n", totals->unknown);
	}
}

static void add_counts(struct insn_counts *sum, const struct insn_counts *more)
{
	sum->executed += more->executed;
	sum->folded += more->folded;
	sum->cycles += more->cycles;
	sum->data_misses += more->data_misses;
	for (int i = 0; i < CAUSE_COUNT; i++) {
		sum->stall[i] += more->stall[i];
	}
}

static int compare_costs(const void *a, const void *b)
{
	const struct symbol_cost *left = a;
	const struct symbol_cost *right = b;

	if (left->counts.cycles != right->counts.cycles) {
		return left->counts.cycles > right->counts.cycles ? -1 : 1;
	}
	return left->symbol < right->symbol ? -1 : 1;
}

/* The cost of each symbol, and of code outside all symbols; largest first. */
static struct symbol_cost *symbol_costs(
	const struct program *program, size_t *count)
{
	const struct symbols *symbols = &program->symbols;
	struct symbol_cost *cost = calloc(symbols->count + 1, sizeof(*cost));

	*count = 0;
	if (!cost) {
		return NULL;
	}
	for (size_t i = 0; i < program->insn_capacity; i++) {
		const struct insn *insn = program->insn[i];
		const struct symbol *symbol;
		size_t index = symbols->count;

		if (!insn || insn->counts.executed == 0) {
			continue;
		}
		symbol = symbols_find(symbols, insn->pc);
		if (symbol) {
			index = (size_t)(symbol - symbols->symbol);
		}
		cost[index].symbol = symbol;
		add_counts(&cost[index].counts, &insn->counts);
	}
	qsort(cost, symbols->count + 1, sizeof(*cost), compare_costs);
	while (*count <= symbols->count && cost[*count].counts.executed) {
		(*count)++;
	}
	return cost;
}

static void text_shares(FILE *out, const struct program *program)
{
	size_t count;
	struct symbol_cost *cost = symbol_costs(program, &count);

	for (size_t i = 0; cost && i < count && i < program->params->top; i++) {
		const struct insn_counts *counts = &cost[i].counts;

		fprintf(out,
			"symbol %s cycles %" PRIu64 " instructions %" PRIu64
			" data-misses %" PRIu64 " stalls",
			cost[i].symbol ? cost[i].symbol->name : "?",
			counts->cycles, counts->executed, counts->data_misses);
		text_stalls(out, counts->stall);
		fprintf(out, "\n");
	}
	free(cost);
}

static int compare_insns(const void *a, const void *b)
{
	const struct insn *left = *(const struct insn *const *)a;
	const struct insn *right = *(const struct insn *const *)b;

	return left->pc < right->pc ? -1 : left->pc > right->pc;
}

/* The executed instructions that pass() accepts, by address, then NULL. */
static const struct insn **sorted_insns(const struct program *program,
	bool (*pass)(const struct program *, const struct insn *))
{
	const struct insn **list =
		calloc(program->insn_count + 1, sizeof(struct insn *));
	size_t count = 0;

	for (size_t i = 0; list && i < program->insn_capacity; i++) {
		const struct insn *insn = program->insn[i];

		if (insn && insn->counts.executed && pass(program, insn)) {
			list[count++] = insn;
		}
	}
	if (list && count) {
		qsort(list, count, sizeof(*list), compare_insns);
	}
	return list;
}

static bool in_profile(const struct program *program, const struct insn *insn)
{
	return strcmp(name_at(program, insn->pc), program->params->profile) == 0;
}

static bool is_unknown(const struct program *program, const struct insn *insn)
{
	(void)program;
	return insn->unit == UNIT_UNKNOWN;
}

/* A line: address, executions, mean cycles, instruction, stalls. */
static void text_profile(FILE *out, const struct program *program)
{
	const struct insn **list = sorted_insns(program, in_profile);

	fprintf(out, "profile %s\n", program->params->profile);
	for (size_t i = 0; list && list[i]; i++) {
		const struct insn_counts *counts = &list[i]->counts;

		fprintf(out, "  %08x %9" PRIu64 " %7.2f  %-36s", list[i]->pc,
			counts->executed,
			(double)counts->cycles / (double)counts->executed,
			list[i]->text ? list[i]->text : "");
		text_stalls(out, counts->stall);
		fprintf(out, "\n");
	}
	free(list);
}

static void text_unknown(FILE *out, const struct program *program)
{
	const struct insn **list = sorted_insns(program, is_unknown);

	for (size_t i = 0; list && list[i]; i++) {
		fprintf(out, "not decoded %08x: %08x, %" PRIu64 " times %s\n",
			list[i]->pc, list[i]->word, list[i]->counts.executed,
			list[i]->text ? list[i]->text : "");
	}
	free(list);
}

void report_text(FILE *out, const struct program *program)
{
	for (size_t i = 0; i < program->region_count; i++) {
		if (program->region[i].entries) {
			text_region(out, program, &program->region[i]);
		}
	}
	text_shares(out, program);
	text_unknown(out, program);
	if (program->params->profile) {
		text_profile(out, program);
	}
}

static void json_counts(
	FILE *out, const char *name, const struct named_count *count, size_t n)
{
	fprintf(out, "\"%s\": {", name);
	for (size_t i = 0; i < n; i++) {
		fprintf(out, "%s\"%s\": %" PRIu64, i ? ", " : "", count[i].name,
			count[i].value);
	}
	fprintf(out, "}");
}

static void json_stalls(FILE *out, const uint64_t stall[CAUSE_COUNT])
{
	struct named_count count[CAUSE_COUNT];

	for (int i = 0; i < CAUSE_COUNT; i++) {
		count[i] = (struct named_count){cause_name[i], stall[i]};
	}
	json_counts(out, "stalls", count, CAUSE_COUNT);
}

#define COUNT(array) (sizeof(array) / sizeof(*(array)))

static void json_lines(FILE *out, const struct memory_counts *memory)
{
	const struct named_count count[] = {
		{"fetch_missed", memory->fetches_missed},
		{"load", memory->loads},
		{"load_missed", memory->loads_missed},
		{"load_awaited", memory->loads_awaited},
		{"store", memory->stores},
		{"store_missed", memory->stores_missed},
		{"preload", memory->preloads},
		{"preload_dropped", memory->preloads_dropped},
		{"preload_unknown", memory->preloads_unknown},
		{"l2_missed", memory->l2_missed},
		{"written", memory->lines_written},
		{"pages_missed", memory->pages_missed},
		{"pages_walked", memory->pages_walked},
	};

	json_counts(out, "lines", count, COUNT(count));
}

static void json_region(
	FILE *out, const struct program *program, const struct region *region)
{
	const struct core_totals *totals = &region->totals;
	const struct named_count count[] = {
		{"entries", region->entries},
		{"cycles", region->cycles},
		{"first", region->first},
		{"last", region->last},
		{"least", region->least},
		{"most", region->most},
		{"instructions", totals->executed},
		{"folded", totals->folded},
		{"branches", totals->branches},
		{"mispredicted", totals->mispredicted},
		{"not_decoded", totals->unknown},
		{"foretold", totals->foretold},
		{"mistaken", totals->mistaken},
	};
	char name[256];

	region_name(program, region, name, sizeof(name));
	fprintf(out, "{\"name\": \"%s\", ", name);
	json_counts(out, "counts", count, COUNT(count));
	fprintf(out, ", ");
	json_stalls(out, totals->stall);
	fprintf(out, ", ");
	json_lines(out, &totals->memory);
	fprintf(out, "}");
}

static void json_shares(FILE *out, const struct program *program)
{
	size_t count;
	struct symbol_cost *cost = symbol_costs(program, &count);

	for (size_t i = 0; cost && i < count; i++) {
		const struct insn_counts *counts = &cost[i].counts;

		fprintf(out,
			"%s\n\t\t{\"name\": \"%s\", \"cycles\": %" PRIu64
			", \"instructions\": %" PRIu64
			", \"data_misses\": %" PRIu64 ", ",
			i ? "," : "",
			cost[i].symbol ? cost[i].symbol->name : "?",
			counts->cycles, counts->executed, counts->data_misses);
		json_stalls(out, counts->stall);
		fprintf(out, "}");
	}
	free(cost);
}

static void json_params(FILE *out, const struct params *params)
{
	const struct named_count count[] = {
		{"l1i", (uint64_t)params->l1i_kib},
		{"l1d", (uint64_t)params->l1d_kib},
		{"l2size", (uint64_t)params->l2_kib},
		{"l2", (uint64_t)params->l2},
		{"l2busy", (uint64_t)params->l2_busy},
		{"ddr", (uint64_t)params->ddr},
		{"ddrbusy", (uint64_t)params->ddr_busy},
		{"ddrwrite", (uint64_t)params->ddr_write},
		{"misses", (uint64_t)params->misses},
		{"writes", (uint64_t)params->writes},
		{"byte", (uint64_t)params->byte_extra},
		{"predictor", (uint64_t)params->predictor},
		{"tlb", (uint64_t)params->tlb},
		{"pages", params->pages},
		{"fold", params->fold},
		{"ideal", params->ideal},
	};

	json_counts(out, "parameters", count, COUNT(count));
}

void report_json(FILE *out, const struct program *program)
{
	bool more = false;

	fprintf(out, "{\n\t\"model\": \"ARM1136JF-S, not measured\",\n\t");
	json_params(out, program->params);
	fprintf(out, ",\n\t\"regions\": [");
	for (size_t i = 0; i < program->region_count; i++) {
		if (program->region[i].entries) {
			fprintf(out, "%s\n\t\t", more ? "," : "");
			json_region(out, program, &program->region[i]);
			more = true;
		}
	}
	fprintf(out, "\n\t],\n\t\"symbols\": [");
	json_shares(out, program);
	fprintf(out, "\n\t]\n}\n");
}

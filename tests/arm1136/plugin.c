/*
 * Connects the model to QEMU's user mode emulator as a plugin.
 *
 * QEMU announces a block of instructions when the block begins, and each memory
 * access when it happens. The model runs a block when the next one begins: only
 * then is it known where the branch went and which conditional accesses were
 * made. The model follows one processor, the first that enters a region.
 */
#include "tests/arm1136/program.h"
#include "tests/arm1136/qemu_plugin.h"
#include "tests/arm1136/report.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

QEMU_PLUGIN_EXPORT int qemu_plugin_version = QEMU_PLUGIN_VERSION;
QEMU_PLUGIN_EXPORT int qemu_plugin_install(qemu_plugin_id_t id,
	const struct qemu_info_t *info, int argc, char **argv);

#define MAX_BLOCK    1024
#define MAX_ACCESSES (MAX_BLOCK * 34)

struct block {
	size_t count;
	bool is_watched; /* a region can begin in this block */
	struct insn *insn[];
};

struct plugin {
	struct params params;
	struct core core;
	struct program program;
	bool has_symbols;
	uint32_t begin, end; /* addresses of params.begin and end, or 0 */

	bool has_processor;
	unsigned int processor;
	bool runs;              /* the first region has begun */
	struct block *block;    /* the executing block, if it is modelled */
	struct block *latest;   /* the executing block in any case */
	struct block *previous; /* the block before latest */
	struct access access[MAX_ACCESSES];
	size_t access_count;
	uintptr_t guest_base; /* host address of the program's address 0 */
	bool has_guest_base;

	struct region *region; /* the region that counts now, or NULL */
	int64_t region_began;  /* the cycle */
	struct core_totals region_before; /* the totals at that cycle */
	uint32_t region_return; /* address at which a region of begin= ends */
};

/* Static, because QEMU's callback for new blocks takes no pointer. */
static struct plugin *the_plugin;

static void region_begin(struct plugin *plugin, uint32_t pc, uint8_t id)
{
	if (plugin->region) {
		return;
	}
	plugin->region = program_region(&plugin->program, pc, id);
	if (!plugin->region) {
		return;
	}
	if (!plugin->runs) {
		values_forget(&plugin->core.values);
		plugin->runs = true;
	}
	plugin->region_began = plugin->core.now;
	plugin->region_before = core_totals(&plugin->core);
	plugin->core.counts_insns = true;
}

static void region_end(struct plugin *plugin)
{
	struct core_totals after;

	if (!plugin->region) {
		return;
	}
	after = core_totals(&plugin->core);
	region_add(plugin->region,
		(uint64_t)(plugin->core.now - plugin->region_began),
		&plugin->region_before, &after);
	plugin->region = NULL;
	plugin->core.counts_insns = false;
}

/* Obeys a marker. Returns whether it is one: markers cost no cycle. */
static bool obey_marker(struct plugin *plugin, const struct insn *insn)
{
	if (insn->marker == MARKER_FLUSH) {
		core_flush(&plugin->core, (enum memory_level)insn->marker_id);
	} else if (insn->marker == MARKER_BEGIN && !plugin->begin) {
		region_begin(plugin, insn->pc, insn->marker_id);
	} else if (insn->marker == MARKER_END && !plugin->begin) {
		region_end(plugin);
	}
	return insn->marker != MARKER_NONE;
}

/* The return address of the function that begins with the current block. */
static uint32_t return_address(const struct plugin *plugin)
{
	const struct block *caller = plugin->previous;
	const struct insn *call;

	if (!caller) {
		return 0;
	}
	call = caller->insn[caller->count - 1];
	if (call->branch == BRANCH_CALL || call->branch == BRANCH_CALL_INDIRECT ||
		!(plugin->core.values.known >> REG_LR & 1)) {
		return call->pc + 4;
	}
	return plugin->core.values.value[REG_LR];
}

/* Begins and ends the regions of begin=: until the function returns, or end=. */
static void obey_symbols(struct plugin *plugin, const struct insn *insn)
{
	if (plugin->region) {
		if (insn->pc ==
			(plugin->end ? plugin->end : plugin->region_return)) {
			region_end(plugin);
		}
	} else if (insn->pc == plugin->begin) {
		plugin->region_return = return_address(plugin);
		region_begin(plugin, insn->pc, 0);
	}
}

static void finish_block(struct plugin *plugin, const struct insn *next)
{
	const struct block *block = plugin->block;
	const struct access *access = plugin->access;
	size_t left = plugin->access_count;

	for (size_t i = 0; i < block->count; i++) {
		struct insn *insn = block->insn[i];
		size_t count = 0;

		while (count < left && access[count].insn == insn) {
			count++;
		}
		if (plugin->begin) {
			obey_symbols(plugin, insn);
		}
		if (!obey_marker(plugin, insn) && plugin->runs) {
			core_step(&plugin->core, insn, access, (int)count,
				i + 1 < block->count ? block->insn[i + 1]
						     : next);
		}
		access += count;
		left -= count;
	}
	plugin->access_count = 0;
}

static void on_block(unsigned int processor, void *user)
{
	struct plugin *plugin = the_plugin;
	struct block *block = user;

	if (plugin->has_processor && processor != plugin->processor) {
		return;
	}
	if (plugin->block) {
		finish_block(plugin, block->insn[0]);
	}
	plugin->previous = plugin->latest;
	plugin->latest = block;
	plugin->block = plugin->runs || block->is_watched ? block : NULL;
	if (plugin->block) {
		plugin->processor = processor;
		plugin->has_processor = true;
	}
}

static uint32_t read_guest(
	const struct plugin *plugin, uint32_t address, unsigned int bytes)
{
	const void *host = (const void *)(plugin->guest_base + address);
	uint32_t word = 0;

	memcpy(&word, host, bytes);
	return word;
}

static void on_access(unsigned int processor, qemu_plugin_meminfo_t info,
	uint64_t address, void *user)
{
	struct plugin *plugin = the_plugin;
	const struct insn *insn = user;
	struct access *access;

	if (!plugin->block || processor != plugin->processor ||
		plugin->access_count == MAX_ACCESSES) {
		return;
	}
	access = &plugin->access[plugin->access_count++];
	access->insn = insn;
	access->address = (uint32_t)address;
	access->bytes = (uint8_t)(1u << qemu_plugin_mem_size_shift(info));
	access->is_store = qemu_plugin_mem_is_store(info);
	access->has_value = false;
	if (!access->is_store && access->bytes == 4 && insn->list &&
		plugin->has_guest_base) {
		access->value = read_guest(plugin, access->address, 4);
		access->has_value = true;
	}
}

/* Called when the first block begins: only then is the program loaded. */
static void find_symbols(struct plugin *plugin)
{
	const struct params *params = &plugin->params;
	char *path = (char *)qemu_plugin_path_to_binary();
	const struct symbol *symbol;
	int result = -1;

	plugin->has_symbols = true;
	if (params->map) {
		result = symbols_read_map(&plugin->program.symbols, params->map);
	} else if (path) {
		result = symbols_read_elf(&plugin->program.symbols, path,
			(uint32_t)qemu_plugin_start_code());
	}
	if (result) {
		fprintf(stderr, "arm1136: %s has no symbols to read\n",
			params->map    ? params->map
				: path ? path
				       : "program");
	}
	free(path);
	if (params->begin) {
		symbol = symbols_named(&plugin->program.symbols, params->begin);
		if (!symbol) {
			fprintf(stderr, "arm1136: no symbol %s\n",
				params->begin);
		}
		plugin->begin = symbol ? symbol->address : 0;
	}
	if (params->end) {
		symbol = symbols_named(&plugin->program.symbols, params->end);
		plugin->end = symbol ? symbol->address : 0;
	}
}

static struct insn *translate(
	struct plugin *plugin, const struct qemu_plugin_insn *from)
{
	uint32_t pc = (uint32_t)qemu_plugin_insn_vaddr(from);
	uint32_t word = 0;
	bool is_new;
	struct insn *insn;

	/* A Thumb instruction has two bytes; the model does not decode it. */
	if (qemu_plugin_insn_size(from) == 4) {
		memcpy(&word, qemu_plugin_insn_data(from), 4);
	} else {
		word = 0xffffffff;
	}
	insn = program_insn(&plugin->program, pc, word, &is_new);
	/* Only these are listed with their text, which takes long to make. */
	if (insn && is_new &&
		(plugin->params.profile || insn->unit == UNIT_UNKNOWN)) {
		insn->text = qemu_plugin_insn_disas(from);
	}
	return insn;
}

static bool begins_region(const struct plugin *plugin, const struct insn *insn)
{
	return plugin->params.whole || insn->marker == MARKER_BEGIN ||
		(plugin->begin && insn->pc == plugin->begin);
}

static void on_translation(qemu_plugin_id_t id, struct qemu_plugin_tb *tb)
{
	struct plugin *plugin = the_plugin;
	size_t count = qemu_plugin_tb_n_insns(tb);
	struct block *block;

	(void)id;
	if (count == 0 || count > MAX_BLOCK) {
		return;
	}
	if (!plugin->has_symbols) {
		find_symbols(plugin);
	}
	/* QEMU keeps a pointer to the block as long as it keeps the translation. */
	block = calloc(1, sizeof(*block) + count * sizeof(*block->insn));
	if (!block) {
		return;
	}
	block->count = count;
	for (size_t i = 0; i < count; i++) {
		struct qemu_plugin_insn *from = qemu_plugin_tb_get_insn(tb, i);
		struct insn *insn = translate(plugin, from);
		const void *host = qemu_plugin_insn_haddr(from);

		if (!insn) {
			free(block);
			return;
		}
		if (host) {
			plugin->guest_base = (uintptr_t)host - insn->pc;
			plugin->has_guest_base = true;
		}
		block->insn[i] = insn;
		block->is_watched |= begins_region(plugin, insn);
		if (insn_is_memory(insn)) {
			qemu_plugin_register_vcpu_mem_cb(from, on_access,
				QEMU_PLUGIN_CB_NO_REGS, QEMU_PLUGIN_MEM_RW,
				insn);
		}
	}
	qemu_plugin_register_vcpu_tb_exec_cb(
		tb, on_block, QEMU_PLUGIN_CB_NO_REGS, block);
}

static void write_report(const char *path, FILE *otherwise,
	const struct program *program,
	void (*report)(FILE *out, const struct program *program))
{
	FILE *out = path ? fopen(path, "w") : otherwise;

	if (!out) {
		fprintf(stderr, "arm1136: cannot write %s\n", path);
		return;
	}
	report(out, program);
	if (path && fclose(out)) {
		fprintf(stderr, "arm1136: cannot write %s\n", path);
	}
}

static void on_exit_of_program(qemu_plugin_id_t id, void *user)
{
	struct plugin *plugin = user;

	(void)id;
	if (plugin->block) {
		const struct block *block = plugin->block;

		finish_block(plugin, block->insn[block->count - 1]);
	}
	region_end(plugin);
	write_report(
		plugin->params.report, stderr, &plugin->program, report_text);
	if (plugin->params.json) {
		write_report(plugin->params.json, NULL, &plugin->program,
			report_json);
	}
}

static char *copies_of(int argc, char **argv, struct params *params)
{
	for (int i = 0; i < argc; i++) {
		char *copy = strdup(argv[i]);

		if (!copy || !params_set(params, copy)) {
			free(copy);
			return argv[i];
		}
	}
	return NULL;
}

int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info,
	int argc, char **argv)
{
	struct plugin *plugin;
	const char *wrong;

	if (strcmp(info->target_name, "arm") != 0 || info->system_emulation) {
		fprintf(stderr, "arm1136: this is for qemu-arm\n");
		return -1;
	}
	plugin = calloc(1, sizeof(*plugin));
	if (!plugin) {
		return -1;
	}
	params_default(&plugin->params);
	wrong = copies_of(argc, argv, &plugin->params);
	if (wrong) {
		fprintf(stderr, "arm1136: cannot use %s\n", wrong);
		goto release_plugin;
	}
	params_complete(&plugin->params);
	if (core_init(&plugin->core, &plugin->params)) {
		goto release_plugin;
	}
	if (program_init(&plugin->program, &plugin->params)) {
		goto release_core;
	}
	if (plugin->params.whole) {
		region_begin(plugin, 0, 0);
	}
	the_plugin = plugin;
	qemu_plugin_register_vcpu_tb_trans_cb(id, on_translation);
	qemu_plugin_register_atexit_cb(id, on_exit_of_program, plugin);
	return 0;
release_core:
	core_finish(&plugin->core);
release_plugin:
	free(plugin);
	return -1;
}

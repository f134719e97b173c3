/*
 * A plugin of QEMU that counts the instructions a guest executes:
 *
 *	qemu-arm -cpu arm1136 -plugin insn_count.so -d plugin PROGRAM
 *
 * prints "instructions: N" on standard error when the guest ends, and
 * "region: N" after each region 1 of tests/arm1136/marker.h. Instructions whose
 * condition fails count as executed. The guest must have one thread. Debian has
 * no package with the plugin header, so the calls are declared here.
 */
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;
struct qemu_info;

typedef uint64_t qemu_plugin_id_t;
typedef void (*translate_callback)(
	qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void (*execute_callback)(unsigned int cpu, void *user);
typedef void (*exit_callback)(qemu_plugin_id_t id, void *user);

enum {
	INLINE_ADD_U64 = 0,
	PLUGIN_API = 1,
	/* MARKER_BEGIN(1) and MARKER_END(1) of tests/arm1136/marker.h */
	BEGIN_1 = 0xE1811001,
	END_1 = 0xE0011001,
};

void qemu_plugin_register_vcpu_tb_trans_cb(
	qemu_plugin_id_t id, translate_callback callback);
void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb *block,
	int operation, void *counter, uint64_t by);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(
	const struct qemu_plugin_tb *block, size_t index);
const void *qemu_plugin_insn_data(const struct qemu_plugin_insn *insn);
void qemu_plugin_register_vcpu_insn_exec_cb(struct qemu_plugin_insn *insn,
	execute_callback callback, int flags, void *user);
void qemu_plugin_register_atexit_cb(
	qemu_plugin_id_t id, exit_callback callback, void *user);
void qemu_plugin_outs(const char *text);
int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info,
	int argc, char **argv);

extern int qemu_plugin_version;
int qemu_plugin_version = PLUGIN_API;

/* Translated code adds to this counter. */
static uint64_t executed;

static uint64_t began;

/* The block of the mark has been counted as a whole when a mark comes here. */
static void on_begin(unsigned int cpu, void *user)
{
	(void)cpu;
	(void)user;
	began = executed;
}

static void on_end(unsigned int cpu, void *user)
{
	char text[64];

	(void)cpu;
	(void)user;
	snprintf(text, sizeof(text), "region: %" PRIu64 "\n", executed - began);
	qemu_plugin_outs(text);
}

static void watch_marks(struct qemu_plugin_tb *block)
{
	for (size_t i = 0; i < qemu_plugin_tb_n_insns(block); i++) {
		struct qemu_plugin_insn *insn =
			qemu_plugin_tb_get_insn(block, i);
		uint32_t code;

		memcpy(&code, qemu_plugin_insn_data(insn), sizeof(code));
		if (code == BEGIN_1 || code == END_1) {
			qemu_plugin_register_vcpu_insn_exec_cb(insn,
				code == BEGIN_1 ? on_begin : on_end, 0, NULL);
		}
	}
}

static void on_translate(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
	(void)id;
	watch_marks(block);
	qemu_plugin_register_vcpu_tb_exec_inline(block, INLINE_ADD_U64,
		&executed, qemu_plugin_tb_n_insns(block));
}

static void on_exit_of_guest(qemu_plugin_id_t id, void *user)
{
	char text[64];

	(void)id;
	(void)user;
	snprintf(text, sizeof(text), "instructions: %" PRIu64 "\n", executed);
	qemu_plugin_outs(text);
}

int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info,
	int argc, char **argv)
{
	(void)info;
	(void)argc;
	(void)argv;
	qemu_plugin_register_vcpu_tb_trans_cb(id, on_translate);
	qemu_plugin_register_atexit_cb(id, on_exit_of_guest, NULL);
	return 0;
}

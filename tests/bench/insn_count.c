/*
 * A plugin of QEMU that counts the instructions a guest executes:
 *
 *	qemu-arm -cpu arm1136 -plugin insn_count.so -d plugin PROGRAM
 *
 * prints "instructions: N" on standard error when the guest ends. Instructions
 * whose condition fails count as executed. The guest must have one thread.
 * Debian has no package with the plugin header, so the calls are declared here.
 */
#include <inttypes.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct qemu_plugin_tb;
struct qemu_info;

typedef uint64_t qemu_plugin_id_t;
typedef void (*translate_callback)(
	qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void (*exit_callback)(qemu_plugin_id_t id, void *user);

enum {
	INLINE_ADD_U64 = 0,
	PLUGIN_API = 1,
};

void qemu_plugin_register_vcpu_tb_trans_cb(
	qemu_plugin_id_t id, translate_callback callback);
void qemu_plugin_register_vcpu_tb_exec_inline(struct qemu_plugin_tb *block,
	int operation, void *counter, uint64_t by);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
void qemu_plugin_register_atexit_cb(
	qemu_plugin_id_t id, exit_callback callback, void *user);
void qemu_plugin_outs(const char *text);
int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info *info,
	int argc, char **argv);

extern int qemu_plugin_version;
int qemu_plugin_version = PLUGIN_API;

/* Translated code adds to this counter. */
static uint64_t executed;

static void on_translate(qemu_plugin_id_t id, struct qemu_plugin_tb *block)
{
	(void)id;
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

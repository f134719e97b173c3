#include "app/cmd/info/info_report.h"
#include "platform/base/arena.h"
#include "platform/base/printable.h"

#include <errno.h>
#include <stdbool.h>

enum {
	DEPTH_SHOWN = 32 /* deeper nodes stand no farther to the right */
};

static void print_node(
	const struct model_node *node, int depth, bool is_joint, FILE *out)
{
	fprintf(out, "  %*s", 2 * (depth < DEPTH_SHOWN ? depth : DEPTH_SHOWN),
		"");
	printable_put(node->name[0] ? node->name : "(unnamed)", out);
	if (is_joint) {
		fputs("  joint", out);
	}
	if (node->mesh >= 0) {
		fprintf(out, "  mesh %d", node->mesh);
	}
	fputc('\n', out);
}

int info_print_nodes(const struct model *model, const struct log *log, FILE *out)
{
	struct arena arena = arena_empty();
	const bool *is_joint = model_find_joints(model, &arena);
	int *depth = ARENA_ARRAY(&arena, int, (size_t)model->node_count);

	if (!is_joint || !depth) {
		arena_release(&arena);
		log_error(log, "%s: there is not enough memory", model->path);
		return -ENOMEM;
	}
	fprintf(out, "\nnodes\n");
	for (int i = 0; i < model->node_count; i++) {
		int parent = model->node[i].parent;

		depth[i] = parent < 0 ? 0 : depth[parent] + 1;
		print_node(&model->node[i], depth[i], is_joint[i], out);
	}
	arena_release(&arena);
	return 0;
}

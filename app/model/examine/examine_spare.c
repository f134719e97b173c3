/*
 * Meshes that a game engine shows by turns or not at all, as their names say.
 * In a file they are nodes like all others, so that every player draws them.
 */
#include "app/model/examine/examine.h"

#include "platform/base/arena.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static bool is_shown(const struct model_node *node)
{
	return node->mesh >= 0 && node->in_scene;
}

/*
 * Returns the level of a name such as Tree_LOD1 and the length of its stem, or
 * -1 if it names none.
 */
static int find_level(const char *name, size_t *stem)
{
	size_t digits = strlen(name);

	while (digits > 0 && isdigit((unsigned char)name[digits - 1])) {
		digits--;
	}
	if (!name[digits] || digits < 3 ||
		strncasecmp(name + digits - 3, "lod", 3) != 0) {
		return -1;
	}
	*stem = digits - 3;
	if (*stem > 0 && isalpha((unsigned char)name[*stem - 1]) &&
		strncmp(name + *stem, "LOD", 3) != 0) {
		return -1;
	}
	return (int)strtol(name + digits, NULL, 10);
}

/* A shown node whose name tells a level. */
struct level {
	const char *name;
	size_t stem; /* the length of the name before the level */
	int level, node;
};

/* By stem, then by level, then by node. */
static int compare_levels(const void *left, const void *right)
{
	const struct level *a = left, *b = right;
	int order = strncmp(
		a->name, b->name, a->stem < b->stem ? a->stem : b->stem);

	if (order != 0) {
		return order;
	}
	if (a->stem != b->stem) {
		return a->stem < b->stem ? -1 : 1;
	}
	return a->level != b->level ? (a->level < b->level ? -1 : 1)
				    : a->node - b->node;
}

/*
 * Counts the levels beside which a finer one is shown, and finds the first node
 * of them. levels has room for all nodes.
 */
static int count_coarse(
	const struct model *model, struct level *levels, const char **first)
{
	int count = 0, coarse = 0, node = model->node_count;
	int finest = 0; /* of the present stem */

	for (int i = 0; i < model->node_count; i++) {
		struct level *one = &levels[count];

		one->name = model->node[i].name;
		one->node = i;
		one->level = find_level(one->name, &one->stem);
		count += is_shown(&model->node[i]) && one->level >= 0;
	}
	if (count > 0) {
		qsort(levels, (size_t)count, sizeof(*levels), compare_levels);
	}
	for (int i = 0; i < count; i++) {
		const struct level *before = i ? &levels[i - 1] : NULL;
		const struct level *one = &levels[i];

		if (!before || before->stem != one->stem ||
			strncmp(before->name, one->name, one->stem) != 0) {
			finest = one->level;
		}
		if (one->level > finest) {
			coarse++;
			node = one->node < node ? one->node : node;
		}
	}
	*first = coarse ? model->node[node].name : "";
	return coarse;
}

static bool contains(const char *name, const char *word)
{
	for (; *name; name++) {
		if (strncasecmp(name, word, strlen(word)) == 0) {
			return true;
		}
	}
	return false;
}

static bool is_collider(const char *name)
{
	static const char *const begins[] = {"UBX_", "UCP_", "UCX_", "USP_"};

	for (size_t i = 0; i < ARRAY_COUNT(begins); i++) {
		if (strncmp(name, begins[i], strlen(begins[i])) == 0) {
			return true;
		}
	}
	return contains(name, "collider") || contains(name, "collision");
}

static int count_colliders(const struct model *model, const char **first)
{
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (is_shown(node) && is_collider(node->name)) {
			*first = count++ == 0 ? node->name : *first;
		}
	}
	return count;
}

int examine_spare(const struct model *model, const struct examiner *examiner,
	const struct log *log)
{
	struct arena arena = arena_empty();
	struct level *levels =
		ARENA_ARRAY(&arena, struct level, (size_t)model->node_count);
	const char *first = "";
	int count, error = 0;

	count = levels ? count_coarse(model, levels, &first) : 0;
	if (!levels) {
		error = memory_budget_fail(model->budget, model->path, log);
	}
	if (count > 0) {
		examine_report(examiner,
			"levels of detail as nodes of their own (%d), such as %.60s: limber draws them and the finest level at once; export that one alone, as limber makes its own levels",
			count, first);
	}
	count = count_colliders(model, &first);
	if (count > 0) {
		examine_report(examiner,
			"shapes for collisions (%d), such as %.60s: limber draws them over the model; export it without them",
			count, first);
	}
	arena_release(&arena);
	return error;
}

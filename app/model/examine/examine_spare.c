/*
 * Meshes that a game engine shows by turns or not at all, as their names say.
 * In a file they are nodes like all others, so that every player draws them.
 */
#include "app/model/examine/examine.h"

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

/* Whether a finer level of the same stem is shown as well. */
static bool is_coarse(const struct model *model, int node)
{
	const char *name = model->node[node].name;
	size_t stem, other;
	int level = find_level(name, &stem);

	for (int i = 0; level > 0 && i < model->node_count; i++) {
		const struct model_node *of = &model->node[i];
		int finer = is_shown(of) ? find_level(of->name, &other) : -1;

		if (finer >= 0 && finer < level && other == stem &&
			strncmp(of->name, name, stem) == 0) {
			return true;
		}
	}
	return false;
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

static bool is_collider(const struct model *model, int node)
{
	static const char *const begins[] = {"UBX_", "UCP_", "UCX_", "USP_"};
	const char *name = model->node[node].name;

	for (size_t i = 0; i < ARRAY_COUNT(begins); i++) {
		if (strncmp(name, begins[i], strlen(begins[i])) == 0) {
			return true;
		}
	}
	return contains(name, "collider") || contains(name, "collision");
}

static void report(const struct model *model, const struct examiner *examiner,
	bool (*is_spare)(const struct model *model, int node),
	const char *feature, const char *treatment)
{
	const char *first = "";
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		if (is_shown(&model->node[i]) && is_spare(model, i)) {
			first = count++ == 0 ? model->node[i].name : first;
		}
	}
	if (count > 0) {
		examine_report(examiner, "%s (%d), such as %.60s: %s", feature,
			count, first, treatment);
	}
}

void examine_spare(const struct model *model, const struct examiner *examiner)
{
	report(model, examiner, is_coarse,
		"levels of detail as nodes of their own",
		"limber draws them and the finest level at once; export that one alone, as limber makes its own levels");
	report(model, examiner, is_collider, "shapes for collisions",
		"limber draws them over the model; export it without them");
}

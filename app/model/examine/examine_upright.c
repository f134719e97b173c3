#include "app/model/examine/examine.h"

#include <ctype.h>
#include <string.h>

#include <cglm/cglm.h>

/* Cosine of the angle at the hips between head and foot of what can stand. */
static const float opposite = -0.7f;
/* Sine of the slope up to which head and foot count as equally high. */
static const float level = 0.5f;

/* Whether the name contains the word, in letters of any case. */
static bool contains(const char *name, const char *word)
{
	size_t length = strlen(word), i = 0;

	for (; *name && i < length; name++) {
		i = 0;
		while (i < length && tolower((unsigned char)name[i]) == word[i]) {
			i++;
		}
	}
	return i == length;
}

/* Returns the first joint whose name contains one of the words, or -1. */
static int find_joint(const struct model *model, const bool *is_joint,
	const char *const word[2])
{
	for (int i = 0; i < model->node_count; i++) {
		const char *name = model->node[i].name;

		if (is_joint[i] &&
			(contains(name, word[0]) || contains(name, word[1]))) {
			return i;
		}
	}
	return -1;
}

/* Computes where a node is at rest. Returns false below a sheared matrix. */
static bool place(const struct model *model, int node, vec3 out)
{
	glm_vec3_zero(out);
	for (; node >= 0; node = model->node[node].parent) {
		const struct transform *rest = &model->node[node].rest;
		versor turn;

		if (model->node[node].matrix) {
			return false;
		}
		memcpy(turn, rest->rotation, sizeof(turn));
		glm_vec3_mul(out, (float *)rest->scale, out);
		glm_quat_rotatev(turn, out, out);
		glm_vec3_add(out, (float *)rest->translation, out);
	}
	return true;
}

bool examine_find_lying(
	const struct model *model, const bool *is_joint, int *head, int *foot)
{
	static const char *const heads[2] = {"head", "skull"};
	static const char *const feet[2] = {"foot", "ankle"};
	vec3 at[3], up, down, body;
	int hips;

	*head = find_joint(model, is_joint, heads);
	*foot = find_joint(model, is_joint, feet);
	if (*head < 0 || *foot < 0) {
		return false;
	}
	hips = model_find_common(model, *head, *foot);
	if (hips < 0 || hips == *head || hips == *foot ||
		!place(model, *head, at[0]) || !place(model, *foot, at[1]) ||
		!place(model, hips, at[2])) {
		return false;
	}
	glm_vec3_sub(at[0], at[2], up);
	glm_vec3_sub(at[1], at[2], down);
	glm_vec3_sub(at[0], at[1], body);
	return glm_vec3_dot(up, down) <
		opposite * glm_vec3_norm(up) * glm_vec3_norm(down) &&
		fabsf(body[1]) < level * glm_vec3_norm(body);
}

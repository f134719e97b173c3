#include "app/character/sketch/sketch_feet.h"

#include "app/anim/math/vec.h"
#include "app/character/sketch/sketch_names.h"
#include "platform/base/scalar.h"

#include <float.h>
#include <string.h>

enum {
	LEGS_MAX = 64,
	PAIRS_MAX = 4,
	/* three in quotation marks fit into a line of 198 characters */
	NAME_MAX_BYTES = 60
};

/* Parts of a leg's length: its ankle is lower above the lowest joint, */
static const float lowest_part = 0.3f;
/* and a leg differs by less from the mirror image of the other one. */
static const float uneven_part = 0.1f;
/* Each bone of a leg has at least this part of it. */
static const float bone_part = 0.25f;

struct leg {
	int upper, lower, tip;
	float length;
};

struct pair {
	struct leg left, right;
	int hips;
};

struct search {
	const struct model *model;
	const bool *is_joint, *is_named;
	const mat4 *world;
	float low; /* height of the lowest joint */
	int count;
	struct pair pair[PAIRS_MAX];
};

static const float *place_of(const struct search *search, int node)
{
	return search->world[node][3];
}

static float distance(const struct search *search, int a, int b)
{
	float apart[3];

	vec_subtract(place_of(search, a), place_of(search, b), apart);
	return vec_length(apart);
}

static bool is_bone(const struct search *search, int node)
{
	return node >= 0 && search->is_joint[node] && search->is_named[node] &&
		strlen(search->model->node[node].name) <= NAME_MAX_BYTES;
}

/* Takes a node for an ankle. Returns false if it does not end a leg. */
static bool find_leg(const struct search *search, int tip, struct leg *leg)
{
	const struct model_node *node = search->model->node;
	float upper, lower, height[3];

	leg->tip = tip;
	leg->lower = is_bone(search, tip) ? node[tip].parent : -1;
	leg->upper = is_bone(search, leg->lower) ? node[leg->lower].parent : -1;
	if (!is_bone(search, leg->upper) ||
		!is_bone(search, node[leg->upper].parent)) {
		return false;
	}
	upper = distance(search, leg->upper, leg->lower);
	lower = distance(search, leg->lower, tip);
	leg->length = upper + lower;
	height[0] = place_of(search, leg->upper)[1];
	height[1] = place_of(search, leg->lower)[1];
	height[2] = place_of(search, tip)[1];
	return height[0] > height[1] && height[1] > height[2] &&
		height[0] - height[2] > 0.5f * leg->length &&
		upper > bone_part * leg->length &&
		lower > bone_part * leg->length &&
		height[2] - search->low < lowest_part * leg->length;
}

/* Returns true if two nodes are at the two sides of the hips. */
static bool mirrors(const struct search *search, int hips, int left, int right,
	float uneven)
{
	const float *a = place_of(search, left), *b = place_of(search, right);
	float middle = 2 * place_of(search, hips)[0];

	return a[0] > b[0] && scalar_abs(a[0] + b[0] - middle) < uneven &&
		scalar_abs(a[1] - b[1]) < uneven &&
		scalar_abs(a[2] - b[2]) < uneven;
}

/* Returns the nearest node above a, or a itself, that is above b, too; or -1. */
static int find_common(const struct model *model, int a, int b)
{
	while (a != b) {
		if (a > b) {
			a = model->node[a].parent;
		} else {
			b = model->node[b].parent;
		}
	}
	return a;
}

/*
 * Adds a pair; hips that carry others come first, as [feet] needs it. Of two
 * pairs with the same hips, the one with longer legs stays.
 */
static void add(struct search *search, const struct pair *pair)
{
	int at = 0;

	for (int i = 0; i < search->count; i++) {
		struct pair *other = &search->pair[i];

		if (other->hips == pair->hips) {
			if (pair->left.length > other->left.length) {
				*other = *pair;
			}
			return;
		}
		if (!model_is_below(search->model, other->hips, pair->hips)) {
			at = i + 1;
		}
	}
	if (search->count == PAIRS_MAX) {
		return;
	}
	for (int i = search->count++; i > at; i--) {
		search->pair[i] = search->pair[i - 1];
	}
	search->pair[at] = *pair;
}

static void try_pair(
	struct search *search, const struct leg *left, const struct leg *right)
{
	float uneven = uneven_part * left->length;
	int hips = find_common(search->model, left->upper, right->upper);
	struct pair pair = {*left, *right, hips};

	if (is_bone(search, hips) && hips != left->upper &&
		hips != right->upper &&
		scalar_abs(left->length - right->length) < uneven &&
		mirrors(search, hips, left->upper, right->upper, uneven) &&
		mirrors(search, hips, left->lower, right->lower, 2 * uneven) &&
		mirrors(search, hips, left->tip, right->tip, 3 * uneven)) {
		add(search, &pair);
	}
}

static void find_pairs(struct search *search)
{
	int count = search->model->node_count, legs = 0;
	struct leg leg[LEGS_MAX];

	search->low = FLT_MAX;
	for (int i = 0; i < count; i++) {
		float y = place_of(search, i)[1];

		search->low =
			search->is_joint[i] && y < search->low ? y : search->low;
	}
	for (int i = 0; i < count && legs < LEGS_MAX; i++) {
		legs += find_leg(search, i, &leg[legs]);
	}
	for (int i = 0; i < legs; i++) {
		for (int k = 0; k < legs; k++) {
			if (k != i) {
				try_pair(search, &leg[i], &leg[k]);
			}
		}
	}
}

static void write_leg(const struct model *model, const char *side,
	const struct leg *leg, FILE *out)
{
	const int node[3] = {leg->upper, leg->lower, leg->tip};

	fprintf(out, "\n;%s =", side);
	for (int i = 0; i < 3; i++) {
		fputc(' ', out);
		sketch_write_name(out, model->node[node[i]].name);
	}
}

void sketch_write_feet(const struct model *model, const bool *is_joint,
	const bool *is_named, const mat4 *world, FILE *out)
{
	struct search search = {.model = model,
		.is_joint = is_joint,
		.is_named = is_named,
		.world = world};

	find_pairs(&search);
	if (search.count > 0) {
		fputs("; Legs. Feet on the ground neither slide nor sink while clips change, and they\n"
		      "; keep to the uneven ground of waves = METRES in [scene]:\n",
			out);
	}
	for (int i = 0; i < search.count; i++) {
		const struct pair *pair = &search.pair[i];

		fprintf(out, ";[feet feet%d]\n;hips = ", i + 1);
		sketch_write_name(out, model->node[pair->hips].name);
		write_leg(model, "left", &pair->left, out);
		write_leg(model, "right", &pair->right, out);
		fputs("\n\n", out);
	}
}

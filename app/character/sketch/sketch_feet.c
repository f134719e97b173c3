#include "app/character/sketch/sketch_feet.h"

#include "app/anim/math/vec.h"
#include "app/character/sketch/sketch_names.h"
#include "platform/base/scalar.h"

#include <float.h>
#include <string.h>

enum {
	LEGS_MAX = 64,
	PAIRS_MAX = 4,
	CANDIDATES_MAX = 256,
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

/* Legs that may be a pair, as seen from their hips. */
struct candidate {
	const struct leg *left, *right;
	int hips;
};

struct search {
	const struct model *model;
	const bool *is_joint, *is_named;
	const mat4 *world;
	float low;     /* height of the lowest joint */
	float side[2]; /* unit vector along x and z, to the model's left */
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

/* Returns how far a node is to the left, and *ahead how far to the front. */
static float left_of(const struct search *search, int node, float *ahead)
{
	const float *at = place_of(search, node), *side = search->side;

	*ahead = at[2] * side[0] - at[0] * side[1];
	return at[0] * side[0] + at[2] * side[1];
}

/* Returns true if two nodes are at the two sides of the hips. */
static bool mirrors(const struct search *search, int hips, int left, int right,
	float uneven)
{
	float ahead[3];
	float a = left_of(search, left, &ahead[0]);
	float b = left_of(search, right, &ahead[1]);
	float middle = 2 * left_of(search, hips, &ahead[2]);

	return a > b && scalar_abs(a + b - middle) < uneven &&
		scalar_abs(place_of(search, left)[1] -
			place_of(search, right)[1]) < uneven &&
		scalar_abs(ahead[0] - ahead[1]) < uneven;
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

static float uneven_of(const struct leg *left)
{
	return uneven_part * left->length;
}

static int list_candidates(const struct search *search, const struct leg *leg,
	int legs, struct candidate out[CANDIDATES_MAX])
{
	int count = 0;

	for (int i = 0; i < legs * legs && count < CANDIDATES_MAX; i++) {
		const struct leg *left = &leg[i / legs], *right = &leg[i % legs];
		int hips;

		if (left == right ||
			!(scalar_abs(left->length - right->length) <
				uneven_of(left))) {
			continue;
		}
		hips = model_find_common(
			search->model, left->upper, right->upper);
		if (is_bone(search, hips) && hips != left->upper &&
			hips != right->upper) {
			out[count++] = (struct candidate){left, right, hips};
		}
	}
	return count;
}

/* Adds the candidates that mirror each other for the side of the search. */
static void try_side(
	struct search *search, const struct candidate *candidate, int count)
{
	for (int i = 0; i < count; i++) {
		const struct leg *left = candidate[i].left;
		const struct leg *right = candidate[i].right;
		const struct pair pair = {*left, *right, candidate[i].hips};
		float uneven = uneven_of(left);

		if (mirrors(search, pair.hips, left->upper, right->upper,
			    uneven) &&
			mirrors(search, pair.hips, left->lower, right->lower,
				2 * uneven) &&
			mirrors(search, pair.hips, left->tip, right->tip,
				3 * uneven)) {
			add(search, &pair);
		}
	}
}

/*
 * Sets the side to that of a candidate. Returns how far apart its legs are, or
 * 0 if they are at one place or the right one is nearer to +X.
 */
static float take_side(struct search *search, const struct candidate *candidate)
{
	const float *left = place_of(search, candidate->left->upper);
	const float *right = place_of(search, candidate->right->upper);
	float x = left[0] - right[0], z = left[2] - right[2];
	float apart = scalar_sqrt(x * x + z * z);

	if (!(apart > 0.0f) || x < 0.0f) {
		return 0.0f;
	}
	search->side[0] = x / apart;
	search->side[1] = z / apart;
	return apart;
}

/*
 * Finds pairs in a model that may face any way: the side is the one with most
 * pairs, if possible +X as in glTF, or else that whose legs are the nearest.
 */
static void choose_side(
	struct search *search, const struct candidate *candidate, int count)
{
	float nearest = 0.0f;

	search->side[0] = 1.0f;
	try_side(search, candidate, count);
	for (int i = 0; i < count; i++) {
		struct search other = *search;
		float apart = take_side(&other, &candidate[i]);

		other.count = 0;
		if (apart > 0.0f) {
			try_side(&other, candidate, count);
		}
		if (other.count > search->count ||
			(other.count == search->count && apart < nearest)) {
			*search = other;
			nearest = apart;
		}
	}
}

static void find_pairs(struct search *search)
{
	int count = search->model->node_count, legs = 0;
	struct leg leg[LEGS_MAX];
	struct candidate candidate[CANDIDATES_MAX] = {{0}};

	search->low = FLT_MAX;
	for (int i = 0; i < count; i++) {
		float y = place_of(search, i)[1];

		search->low =
			search->is_joint[i] && y < search->low ? y : search->low;
	}
	for (int i = 0; i < count && legs < LEGS_MAX; i++) {
		legs += find_leg(search, i, &leg[legs]);
	}
	count = list_candidates(search, leg, legs, candidate);
	choose_side(search, candidate, count);
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

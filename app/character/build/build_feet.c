/*
 * Sections [feet]: finds the points of a figure's soles in the rest pose.
 */
#include "app/character/build/build.h"

#include "app/anim/math/vec.h"
#include "app/character/run/feet.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

/*
 * A sole is flat in the middle and rises at its edge. The outermost points are
 * kept of the flat part of each bone and of two lines around the foot. A ring
 * takes vertices up to a height above the lowest one, in heights of the figure.
 */
struct ring {
	float height;
	int directions; /* in which the outermost points are kept */
	bool of_bone;
};

static const struct ring rings[] = {
	{0.0015f, 4, true}, {0.0075f, 8, false}, {0.012f, 8, false}};

/* Two of each four neighbours are opposite to the others. */
static const struct {
	float x, z;
} direction[] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1},
	/* along the axes */
	{1, 0}, {-1, 0}, {0, 1}, {0, -1}};

/* Points of a sole below this part of the figure's height are on the ground. */
static const float planted_height = 0.002f;

static int read_leg(struct character_words *words,
	const struct character_key *key, void *member)
{
	return character_read_limb(words, key, member);
}

#define FEET(name) offsetof(struct character_feet, name)

static const struct character_key keys[] = {
	CHARACTER_SWITCH_KEYS(struct character_feet, is),
	{"hips", character_read_node, FEET(hips),
		.right = "the node that carries both legs"},
	{"left", read_leg, FEET(foot[0].leg),
		.right = "three nodes, such as thigh.L shin.L foot.L"},
	{"right", read_leg, FEET(foot[1].leg),
		.right = "three nodes, such as thigh.R shin.R foot.R"},
	{0},
};

/* A vertex that moves with a foot, and its place in the rest pose. */
struct found {
	struct found *next; /* in the order of the vertices, or NULL */
	struct character_sole sole;
	float place[3];
};

struct search {
	const struct character_build *build;
	int tip;             /* the foot's node */
	struct arena *arena; /* of what is found */
	struct found *first, **last;
	float lowest;
};

static int add_found(struct search *search, const struct character_sole *sole)
{
	struct found *found = ARENA_NEW(search->arena, struct found);

	if (!found) {
		return -ENOMEM;
	}
	found->sole = *sole;
	character_sole_place(
		sole, search->build->character->instance, found->place);
	search->lowest = scalar_min(found->place[1], search->lowest);
	*search->last = found;
	search->last = &found->next;
	return 0;
}

static int search_primitive(struct search *search, int node,
	const struct model_primitive *primitive)
{
	const struct model *model = search->build->model;
	int error = 0;

	for (int v = 0; !error && v < primitive->vertex_count; v++) {
		int mover = character_sole_mover(model, node, primitive, v);

		if (model_is_below(model, mover, search->tip)) {
			struct character_sole sole =
				character_sole_of_vertex(model, node, primitive,
					v, primitive->position[v]);

			error = add_found(search, &sole);
		}
	}
	return error;
}

static int search_model(struct search *search)
{
	const struct model *model = search->build->model;
	int error = 0;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_mesh *mesh = model->node[n].mesh >= 0
			? &model->mesh[model->node[n].mesh]
			: NULL;

		for (int i = 0; mesh && !error && i < mesh->primitive_count;
			i++) {
			error = search_primitive(search, n, &mesh->primitive[i]);
		}
	}
	return error;
}

/* Returns how far a place of the sole is in a direction. */
static float towards(const float place[3], int which)
{
	return place[0] * direction[which].x + place[2] * direction[which].z;
}

/*
 * Keeps the vertex in each direction in which it is the outermost one. The
 * ring's points begin at first.
 */
static void take_sole(struct character_foot *foot, const struct ring *ring,
	int first, const struct found *found)
{
	int i = first;

	while (ring->of_bone && i < foot->sole_count &&
		foot->sole[i].node[0] != found->sole.node[0]) {
		i += ring->directions;
	}
	if (i + ring->directions > CHARACTER_SOLE_MAX) {
		return;
	}
	for (int which = 0; which < ring->directions; which++, i++) {
		if (i >= foot->sole_count ||
			towards(found->place, which) >
				towards(foot->place[i], which)) {
			foot->sole[i] = found->sole;
			memcpy(foot->place[i], found->place,
				sizeof(foot->place[i]));
		}
	}
	foot->sole_count = i > foot->sole_count ? i : foot->sole_count;
}

/*
 * Drops equal points: a vertex may be the outermost one in several directions.
 */
static void drop_twins(struct character_foot *foot)
{
	int count = 0;

	for (int i = 0; i < foot->sole_count; i++) {
		int twin = 0;

		while (twin < count &&
			memcmp(foot->place[twin], foot->place[i],
				sizeof(foot->place[i])) != 0) {
			twin++;
		}
		if (twin == count) {
			foot->sole[count] = foot->sole[i];
			memcpy(foot->place[count++], foot->place[i],
				sizeof(foot->place[i]));
		}
	}
	foot->sole_count = count;
}

/*
 * Finds the points that are farthest back and farthest ahead. Both are the
 * first one until others are farther.
 */
static void find_ends(struct character_foot *foot)
{
	for (int i = 1; i < foot->sole_count; i++) {
		float ahead = foot->place[i][2];

		foot->heel = ahead < foot->place[foot->heel][2] ? i : foot->heel;
		foot->toe = ahead > foot->place[foot->toe][2] ? i : foot->toe;
	}
}

/* A foot without vertices stands on its last bone. */
static int find_sole(const struct character_build *build, float height_m,
	struct character_foot *foot)
{
	static const float origin[3] = {0};
	struct arena arena = arena_within(build->arena->budget);
	struct search search = {.build = build,
		.tip = foot->leg.tip,
		.arena = &arena,
		.lowest = 1e9f};
	int error;

	search.last = &search.first;
	error = search_model(&search);
	for (size_t i = 0; !error && i < ARRAY_COUNT(rings); i++) {
		float up_to = search.lowest + rings[i].height * height_m;
		int first = foot->sole_count;

		for (const struct found *found = search.first; found;
			found = found->next) {
			if (!(found->place[1] > up_to)) {
				take_sole(foot, &rings[i], first, found);
			}
		}
	}
	arena_release(&arena);
	drop_twins(foot);
	find_ends(foot);
	if (foot->sole_count == 0) {
		foot->sole_count = 1;
		foot->sole[0] = character_sole_on_node(foot->leg.tip, origin);
	}
	return error;
}

static float distance(const struct character_build *build, int a, int b)
{
	mat4 *world = build->character->instance->world;
	float apart[3];

	vec_subtract(world[a][3], world[b][3], apart);
	return vec_length(apart);
}

/* Returns true if hips that move would move the feet of another pair. */
static bool carries(
	const struct model *model, int hips, const struct character_feet *other)
{
	return model_is_below(model, other->foot[0].leg.upper, hips) ||
		model_is_below(model, other->foot[1].leg.upper, hips);
}

static bool is_below(const struct character_build *build,
	const struct character_feet *feet, const struct character_feet *other)
{
	return model_is_below(build->model, feet->hips, other->hips);
}

/*
 * Adds a pair behind the others, whose feet are placed first: its hips may hang
 * below theirs, but not the other way round.
 */
static int add_pair(struct character_build *build,
	const struct character_section *section, struct character_feet *feet)
{
	struct character_feet **last = &build->character->feet;

	for (; *last; last = &(*last)->next) {
		const struct character_feet *carrier = feet->carrier;

		if (carries(build->model, feet->hips, *last)) {
			return character_fail_section(build, section,
				"its hips carry the feet of [feet %s], too: name a node that carries only these legs, or put this section before that one",
				(*last)->is.name);
		}
		if (is_below(build, feet, *last) &&
			(!carrier || is_below(build, *last, carrier))) {
			feet->carrier = *last;
		}
		feet->pair++;
	}
	*last = feet;
	return 0;
}

int character_build_feet(struct character_build *build,
	const struct character_section *section, void *what)
{
	struct character_feet *feet = what;
	int error;

	feet->hips = feet->foot[0].leg.upper = feet->foot[1].leg.upper = -1;
	error = character_read_section(build, section, keys, feet);
	if (error) {
		return error;
	}
	if (feet->hips < 0 || feet->foot[0].leg.upper < 0 ||
		feet->foot[1].leg.upper < 0) {
		return character_fail_missing(build, section,
			"hips = NODE, left = UPPER LOWER TIP and right = UPPER LOWER TIP");
	}
	error = add_pair(build, section, feet);
	if (error) {
		return error;
	}
	feet->height_m = build->character->motion.height_m;
	for (int side = 0; side < 2; side++) {
		struct character_foot *foot = &feet->foot[side];

		if (find_sole(build, feet->height_m, foot) != 0) {
			return character_fail_memory(build);
		}
		foot->planted_m = planted_height * feet->height_m;
		foot->length_m =
			distance(build, foot->leg.upper, foot->leg.lower) +
			distance(build, foot->leg.lower, foot->leg.tip);
	}
	return 0;
}

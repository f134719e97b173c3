#include "app/compare/technique.h"

const struct technique_rating technique_ratings[TECHNIQUE_COUNT] = {
	[TECHNIQUE_MORPHING] = {"morphing", "every vertex", "good, soft things",
		"fairly easy"},
	[TECHNIQUE_HIERARCHICAL] = {"hierarchical", "pivots",
		"solid parts only", "easiest"},
	[TECHNIQUE_SKELETAL] = {"skeletal", "bones", "good, characters",
		"most difficult"},
	[TECHNIQUE_COMBINED] = {"skeletal + morphing", "bones and vertices",
		"best", "most difficult"},
};

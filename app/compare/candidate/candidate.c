#include "app/compare/candidate/candidate.h"

void candidate_pose(struct candidate *candidate, float time_s)
{
	if (candidate->seek) {
		candidate->seek(candidate, time_s);
	}
	candidate->pose(candidate, time_s);
}

void candidate_destroy(struct candidate *candidate)
{
	if (candidate->destroy) {
		candidate->destroy(candidate);
	}
	*candidate = (struct candidate){0};
}

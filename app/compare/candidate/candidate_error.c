#include "app/compare/candidate/candidate_error.h"

#include "app/scene/stage/light.h"
#include "platform/base/scalar.h"
#include "platform/process/jobs.h"

#include <errno.h>
#include <stdlib.h>

enum {
	DIVISIONS_MAX = 10,  /* how often an interval is halved */
	MOMENTS_AT_ONCE = 16 /* that a thread takes */
};

/*
 * Refining stops once the true peak can exceed the found one by this at most.
 */
static const float tolerance_px = 0.025f;
static const float tolerance_share = 0.025f;
/* An outline: the cosine between normal and view direction is at most this. */
static const float outline_cosine = 0.2f;
static const float green_steps = 63.0f;

struct comparer {
	struct candidate *candidate;
	struct reference *reference;
	const struct screen_view *screen;
	float light[3];
	float (*position)[3]; /* [candidate->vertex_count] */
	float (*normal)[3];
	struct candidate_error error;
	struct candidate_excess *excess;
	float chord; /* the largest squared distance of two unit normals */
	float near_square; /* screen_view_near_square() of the farthest vertex */
	double sum_px;
	double sum_count;
};

/* The largest error of any vertex at one moment. */
struct sample {
	float time_s, px;
};

static float dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void keep_larger(float *most, float value)
{
	*most = value > *most ? value : *most;
}

/*
 * Writes the normal's direction on the screen to across[]. Returns false if the
 * vertex is not on an outline.
 */
static bool find_across(const struct screen_view *screen,
	const float position[3], const float normal[3], float across[2])
{
	const vec4 *view = screen->view;
	float eye[3], facing[3], length;

	for (int row = 0; row < 3; row++) {
		eye[row] = view[0][row] * position[0] +
			view[1][row] * position[1] +
			view[2][row] * position[2] + view[3][row];
		facing[row] = view[0][row] * normal[0] +
			view[1][row] * normal[1] + view[2][row] * normal[2];
	}
	length = scalar_sqrt(dot(eye, eye) * dot(facing, facing));
	if (!(length > 0.0f) ||
		scalar_abs(dot(eye, facing)) > outline_cosine * length) {
		return false;
	}
	length = scalar_sqrt(facing[0] * facing[0] + facing[1] * facing[1]);
	across[0] = length > 0.0f ? facing[0] / length : 0.0f;
	across[1] = length > 0.0f ? facing[1] / length : 0.0f;
	return true;
}

static float brightness(const float light[3], const float normal[3])
{
	float lambert = dot(light, normal);

	return lambert > 0.0f ? lambert : 0.0f;
}

static void compare_normals(struct comparer *comparer, const float position[3],
	const float wanted[3], const float shown[3], const float moved_px[2])
{
	struct candidate_error *error = &comparer->error;
	float apart[3], across[2];

	if (dot(wanted, wanted) < 0.5f || dot(shown, shown) < 0.5f) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		apart[axis] = wanted[axis] - shown[axis];
	}
	keep_larger(&comparer->chord, dot(apart, apart));
	keep_larger(&error->shade_steps,
		green_steps *
			scalar_abs(brightness(comparer->light, wanted) -
				brightness(comparer->light, shown)));
	if (find_across(comparer->screen, position, wanted, across)) {
		keep_larger(&error->outline_px,
			scalar_abs(moved_px[0] * across[0] +
				moved_px[1] * across[1]));
	}
}

static void note_excess(
	struct candidate_excess *excess, const struct sample *sample)
{
	if (excess && sample->px > excess->bound_px &&
		excess->count < (int)ARRAY_COUNT(excess->time_s)) {
		excess->time_s[excess->count++] = sample->time_s;
	}
}

/* Whether a vertex is no farther off than the farthest one so far. */
static bool is_near(
	const struct comparer *comparer, int source, int vertex, float px)
{
	return screen_view_within(comparer->screen,
		comparer->reference->position[source],
		comparer->position[vertex], px, comparer->near_square);
}

/* Compares a vertex of the candidate; sample has the farthest one so far. */
static void compare_vertex(struct comparer *comparer, int vertex, bool normals,
	struct sample *sample)
{
	const struct candidate *candidate = comparer->candidate;
	const struct reference *reference = comparer->reference;
	int source = candidate->source ? candidate->source[vertex] : vertex;
	const float *at = reference->position[source];
	float wanted[2], moved[2], px;

	if (!normals && is_near(comparer, source, vertex, sample->px)) {
		return;
	}
	screen_view_project(comparer->screen, at, wanted);
	screen_view_project(comparer->screen, comparer->position[vertex], moved);
	moved[0] -= wanted[0];
	moved[1] -= wanted[1];
	px = scalar_sqrt(moved[0] * moved[0] + moved[1] * moved[1]);
	if (px > sample->px) {
		sample->px = px;
		comparer->near_square =
			screen_view_near_square(comparer->screen, px);
	}
	if (normals) {
		comparer->sum_px += (double)px;
		compare_normals(comparer, at, reference->normal[source],
			comparer->normal[vertex], moved);
	}
}

/* Poses candidate and reference at time_s and compares all vertices. */
static struct sample compare_at(
	struct comparer *comparer, float time_s, bool normals)
{
	struct candidate *candidate = comparer->candidate;
	struct sample sample = {time_s, 0.0f};

	candidate->positions_only = !normals;
	candidate_pose(candidate, time_s);
	candidate->take(candidate, comparer->position,
		normals ? comparer->normal : NULL);
	reference_pose(comparer->reference, time_s, normals);
	comparer->near_square = screen_view_near_square(comparer->screen, 0.0f);
	for (int v = 0; v < candidate->vertex_count; v++) {
		compare_vertex(comparer, v, normals, &sample);
	}
	comparer->error.samples++;
	note_excess(comparer->excess, &sample);
	if (sample.px > comparer->error.peak_px) {
		comparer->error.peak_px = sample.px;
		comparer->error.peak_s = time_s;
	}
	comparer->sum_count += normals ? candidate->vertex_count : 0;
	return sample;
}

/*
 * The most that the error may be between three evenly spaced moments: a
 * parabola through them exceeds them by an eighth of their second difference;
 * four times that allows for errors that are no parabolas.
 */
static float most_between(const struct sample s[3])
{
	float most = s[0].px > s[1].px ? s[0].px : s[1].px;
	float bend = scalar_abs(s[0].px - 2.0f * s[1].px + s[2].px);

	return (s[2].px > most ? s[2].px : most) + 0.5f * bend;
}

static void refine(
	struct comparer *comparer, const struct sample s[3], int divisions)
{
	float peak_px = comparer->error.peak_px;
	float spare_px = tolerance_share * peak_px;
	struct sample half[3];

	spare_px = spare_px > tolerance_px ? spare_px : tolerance_px;
	if (divisions == 0 || most_between(s) <= peak_px + spare_px ||
		!(s[0].time_s < s[1].time_s && s[1].time_s < s[2].time_s)) {
		return;
	}
	for (int i = 0; i < 2; i++) {
		half[0] = s[i];
		half[2] = s[i + 1];
		half[1] = compare_at(comparer,
			0.5f * (half[0].time_s + half[2].time_s), false);
		refine(comparer, half, divisions - 1);
	}
}

/*
 * Samples one of the grid's moments (i even) or the time halfway to the next
 * one (i odd), if that is not a gap.
 */
static void sample_moment(struct comparer *comparer,
	const struct time_grid *grid, int i, bool normals, struct sample *sample)
{
	const float *at = grid->time_s + i / 2;
	float time_s = i % 2 ? 0.5f * (at[0] + at[1]) : at[0];

	if (i % 2 == 0 || !time_grid_is_gap(grid, i / 2)) {
		sample[i] = compare_at(comparer, time_s, normals);
	}
}

/*
 * Samples the grid's moments and the times halfway between them, but for gaps:
 * up to 2 count - 1 samples. Normals and the mean are taken at some of the
 * moments only.
 */
static void sample_grid(struct comparer *comparer, const struct time_grid *grid,
	int normal_moments, struct sample *sample)
{
	int step = 2 * (grid->count / normal_moments + 1);

	for (int i = 0; i < 2 * grid->count - 1; i++) {
		sample_moment(comparer, grid, i, i % step == 0, sample);
	}
}

static int comparer_init(struct comparer *comparer, struct candidate *candidate,
	const struct screen_view *screen)
{
	size_t bytes = ((size_t)candidate->vertex_count + 1) * sizeof(float[3]);

	*comparer = (struct comparer){
		.candidate = candidate,
		.reference = candidate->reference,
		.screen = screen,
		.position = malloc(bytes),
		.normal = malloc(bytes),
	};
	light_direction(comparer->light);
	return comparer->position && comparer->normal ? 0 : -ENOMEM;
}

static void comparer_release(struct comparer *comparer)
{
	comparer->candidate->positions_only = false;
	free(comparer->position);
	free(comparer->normal);
}

static void refine_all(struct comparer *comparer, const struct time_grid *grid,
	const struct sample *sample)
{
	for (int i = 0; i + 2 < 2 * grid->count - 1; i += 2) {
		if (!time_grid_is_gap(grid, i / 2)) {
			refine(comparer, sample + i, DIVISIONS_MAX);
		}
	}
}

int candidate_error_measure(struct candidate *candidate,
	const struct screen_view *screen, const struct time_grid *grid,
	int normal_moments, struct candidate_excess *excess,
	struct candidate_error *out)
{
	struct sample *sample =
		malloc((2 * (size_t)grid->count) * sizeof(*sample));
	struct comparer comparer;
	int error = comparer_init(&comparer, candidate, screen);

	if (sample && !error) {
		comparer.excess = excess;
		sample_grid(&comparer, grid, normal_moments, sample);
		refine_all(&comparer, grid, sample);
		comparer.error.mean_px =
			(float)(comparer.sum_px / comparer.sum_count);
		comparer.error.normal_deg = 2.0f * 180.0f / SCALAR_PI *
			(0.5f * SCALAR_PI -
				scalar_acos(0.5f * scalar_sqrt(comparer.chord)));
		*out = comparer.error;
	}
	error = sample ? error : -ENOMEM;
	free(sample);
	comparer_release(&comparer);
	return error;
}

/* The state of candidate_error_find_peak(): one comparer a thread. */
struct peak_search {
	const struct time_grid *grid;
	struct comparer *comparer;
	struct sample *sample; /* [2 grid->count]: all moments */
	int next;              /* the first moment that no thread has taken */
};

/* Takes the next moments. Returns the first of them. */
static int take_moments(struct jobs *jobs, struct peak_search *search)
{
	int first;

	jobs_lock(jobs);
	first = search->next;
	search->next += MOMENTS_AT_ONCE;
	jobs_unlock(jobs);
	return first;
}

static int search_moments(struct jobs *jobs, int job, void *context)
{
	struct peak_search *search = context;
	const struct time_grid *grid = search->grid;
	int count = 2 * grid->count - 1;
	int first = take_moments(jobs, search);

	for (; first < count; first = take_moments(jobs, search)) {
		for (int i = first; i < count && i < first + MOMENTS_AT_ONCE;
			i++) {
			sample_moment(&search->comparer[job], grid, i, false,
				search->sample);
		}
	}
	return 0;
}

/* What the threads have found does not depend on their number. */
static float find_peak(struct peak_search *search, int threads)
{
	struct comparer *first = &search->comparer[0];

	jobs_run(threads, threads, search_moments, search);
	for (int i = 0; i < 2 * search->grid->count - 1; i++) {
		keep_larger(&first->error.peak_px, search->sample[i].px);
	}
	refine_all(first, search->grid, search->sample);
	return first->error.peak_px;
}

int candidate_error_find_peak(struct candidate *candidates, int count,
	const struct screen_view *screen, const struct time_grid *grid,
	float *peak_px)
{
	struct peak_search search = {
		.grid = grid,
		.comparer = malloc((size_t)count * sizeof(*search.comparer)),
		.sample =
			calloc(2 * (size_t)grid->count, sizeof(*search.sample)),
	};
	int error = search.comparer && search.sample ? 0 : -ENOMEM, begun = 0;

	while (begun < count && !error) {
		error = comparer_init(
			&search.comparer[begun], &candidates[begun], screen);
		begun++;
	}
	if (!error) {
		*peak_px = find_peak(&search, count);
	}
	while (begun > 0) {
		comparer_release(&search.comparer[--begun]);
	}
	free(search.comparer);
	free(search.sample);
	return error;
}

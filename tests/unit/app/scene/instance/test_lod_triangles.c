/* The triangles of the levels of detail that the models in assets/ have. */
#include "app/model/model_stats.h"
#include "app/scene/instance/lod.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"
#include "tests/unit/app/scene/instance/asset_levels.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
	INDICES_MAX = 65536
};

static int compare_triangles(const void *left, const void *right)
{
	const uint64_t *a = left, *b = right;

	return *a < *b ? -1 : *a > *b;
}

/* Triangles in ascending order, each from its least corner on. */
static void sort_triangles(const uint32_t *index, int count, uint64_t *out)
{
	assert_true(count <= INDICES_MAX);
	for (int i = 0; i < count; i += 3) {
		const uint32_t *t = index + i;
		int k = t[0] < t[1] && t[0] < t[2] ? 0 : t[1] < t[2] ? 1 : 2;

		out[i / 3] = (uint64_t)t[k] << 40 |
			(uint64_t)t[(k + 1) % 3] << 20 | t[(k + 2) % 3];
	}
	qsort(out, (size_t)count / 3, sizeof(out[0]), compare_triangles);
}

/* Lists may be in another order, which is better for the vertex cache. */
static void test_fixed_point_draws_the_same_triangles(void **state)
{
	struct log nowhere = log_to_nowhere();
	struct model *model = load(assets[0]);
	struct instance *instance;
	static uint32_t index[INDICES_MAX];
	static uint64_t drawn[INDICES_MAX / 3], expected[INDICES_MAX / 3];
	int lists = 0;

	(void)state;
	assert_int_equal(instance_create(model, kernel_find("fixed"), &nowhere,
				 &instance),
		0);
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		const struct batch *batch = drawable->batch;
		const struct model_lod *from = drawable->primitive->lod;

		for (int k = 0; k < batch->lod_count; k++, lists++, from++) {
			const uint32_t *order = drawable->fixed->order;
			const struct batch_lod *lod = &batch->lod[k];

			while (from->shadow_only) {
				from++;
			}
			assert_int_equal(lod->index_count, from->index_count);
			sort_triangles(from->index, lod->index_count, expected);
			for (int v = 0; v < lod->index_count; v++) {
				uint32_t at = lod->index[v];

				index[v] = order ? order[at] : at;
			}
			sort_triangles(index, lod->index_count, drawn);
			assert_memory_equal(drawn, expected,
				(size_t)(lod->index_count / 3) *
					sizeof(drawn[0]));
		}
	}
	assert_true(lists >= 12);
	instance_destroy(instance);
	model_destroy(model);
}

struct edge {
	float end[2][3]; /* in ascending order */
	int turns;       /* 1 if the triangle has that order, else -1 */
};

static int compare_points(const float *a, const float *b)
{
	for (int axis = 0; axis < 3; axis++) {
		if (a[axis] != b[axis]) {
			return a[axis] < b[axis] ? -1 : 1;
		}
	}
	return 0;
}

static int compare_ends(const void *left, const void *right)
{
	return compare_points(left, right);
}

static int compare_edges(const void *left, const void *right)
{
	const struct edge *a = left, *b = right;
	int first = compare_points(a->end[0], b->end[0]);

	return first ? first : compare_points(a->end[1], b->end[1]);
}

static void add_triangles(const struct model_primitive *primitive,
	const uint32_t *index, int count, struct edge *edge, int *edges)
{
	for (int i = 0; i < count; i++) {
		const float *a = primitive->position[index[i]];
		const float *b =
			primitive->position[index[i % 3 < 2 ? i + 1 : i - 2]];
		bool turned = compare_points(a, b) > 0;

		memcpy(edge[*edges].end[turned], a, sizeof(float[3]));
		memcpy(edge[*edges].end[!turned], b, sizeof(float[3]));
		edge[(*edges)++].turns = turned ? -1 : 1;
	}
}

/* The sorted ends of a level's border edges; level -1 is the full mesh. */
static int open_ends(const struct model_mesh *mesh, int level, float (**out)[3])
{
	struct edge *edge = calloc(100000, sizeof(*edge));
	int edges = 0, ends = 0;

	*out = calloc(200000, sizeof(**out));
	assert_non_null(edge);
	assert_non_null(*out);
	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];
		const struct model_lod *lod = &primitive->lod[level];

		if (level < 0) {
			add_triangles(primitive, primitive->index,
				primitive->index_count, edge, &edges);
		} else {
			add_triangles(primitive, lod->index, lod->index_count,
				edge, &edges);
		}
	}
	qsort(edge, (size_t)edges, sizeof(*edge), compare_edges);
	for (int i = 0, next; i < edges; i = next) {
		int turns = 0;

		for (next = i; next < edges &&
			compare_edges(&edge[i], &edge[next]) == 0;
			next++) {
			turns += edge[next].turns;
		}
		if (turns != 0 &&
			compare_points(edge[i].end[0], edge[i].end[1]) != 0) {
			memcpy((*out)[ends], edge[i].end, sizeof(edge[i].end));
			ends += 2;
		}
	}
	qsort(*out, (size_t)ends, sizeof(**out), compare_ends);
	free(edge);
	return ends;
}

/* How many levels all primitives of a mesh have. */
static int common_levels(const struct model_mesh *mesh)
{
	int count = INT_MAX;

	for (int p = 0; p < mesh->primitive_count; p++) {
		int own = mesh->primitive[p].lod_count;

		count = own < count ? own : count;
	}
	return count;
}

/* A level's border edges end at border vertices of the full mesh. */
static void test_levels_have_no_cracks(void **state)
{
	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(assets); a++) {
		struct model *model = load(assets[a]);

		for (int m = 0; m < model->mesh_count; m++) {
			const struct model_mesh *mesh = &model->mesh[m];
			float(*full)[3], (*few)[3];
			int full_count = open_ends(mesh, -1, &full);

			assert_true(common_levels(mesh) > 0);
			for (int k = 0; k < common_levels(mesh); k++) {
				int count = open_ends(mesh, k, &few);

				for (int i = 0; i < count; i++) {
					assert_non_null(bsearch(few[i], full,
						(size_t)full_count,
						sizeof(*full), compare_ends));
				}
				free(few);
			}
			free(full);
		}
		model_destroy(model);
	}
}

static void test_coarser_levels_have_fewer_triangles(void **state)
{
	(void)state;
	for (size_t a = 0; a < ARRAY_COUNT(assets); a++) {
		struct model *model = load(assets[a]);

		for (int m = 0; m < model->mesh_count; m++) {
			const struct model_mesh *mesh = &model->mesh[m];
			struct model_level finer = {.triangle_count = INT_MAX};

			for (int k = 0; k < model_level_count(mesh); k++) {
				struct model_level level = model_level(mesh, k);

				assert_true(level.shadow_only ||
					(level.error_m > finer.error_m &&
						level.triangle_count <
							finer.triangle_count));
				finer = level;
			}
			assert_true(finer.shadow_only);
		}
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_fixed_point_draws_the_same_triangles),
		cmocka_unit_test(test_coarser_levels_have_fewer_triangles),
		cmocka_unit_test(test_levels_have_no_cracks),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

/*
 * Where the vertices of a moved model are: where they were in the file, less
 * the model's origin, whatever nodes, matrices and skins place them.
 */
#include "app/model/origin/model_origin.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>
#include <string.h>

enum {
	NODES = 4,
	MESHES = 3,
	VERTICES = 6
};

/* A chain of nodes, each below the one before, and three meshes. */
struct fixture {
	struct model_node node[NODES];
	float matrix[NODES][4][4];
	float position[MESHES][VERTICES][3];
	struct model_primitive primitive[MESHES][2];
	struct model_mesh mesh[MESHES];
	struct model_skin skin[1];
	int joint[2];
	mat4 bind[2];
	struct model model;
	struct arena arena;
	bool turned[NODES];
	double before[MESHES][VERTICES][3];
};

static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	for (int n = 0; n < NODES; n++) {
		f->node[n] = (struct model_node){.name = "",
			.parent = n - 1,
			.in_scene = true,
			.mesh = -1,
			.skin = -1,
			.camera = -1,
			.rest = {{0}, {0, 0, 0, 1}, {1, 1, 1}}};
	}
	for (int m = 0; m < MESHES; m++) {
		for (int p = 0; p < 2; p++) {
			f->primitive[m][p] = (struct model_primitive){
				.vertex_count = VERTICES / 2,
				.position = f->position[m] + p * VERTICES / 2};
		}
		f->mesh[m] = (struct model_mesh){
			.primitive_count = 2, .primitive = f->primitive[m]};
	}
	f->skin[0] = (struct model_skin){
		.joint_count = 2, .joint = f->joint, .inverse_bind = f->bind};
	glm_mat4_identity_array(f->bind, 2);
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.mesh_count = MESHES,
		.mesh = f->mesh,
		.skin_count = 1,
		.skin = f->skin};
	f->arena = arena_empty();
}

static void end(struct fixture *f)
{
	arena_release(&f->arena);
	arena_release(&f->model.arena);
}

static bool move(struct fixture *f)
{
	float start[NODES][3];
	double(*shift)[3];

	for (int n = 0; n < NODES; n++) {
		memcpy(start[n], f->node[n].rest.translation, sizeof(start[n]));
	}
	assert_int_equal(model_origin_find(&f->model, f->turned,
				 (const float(*)[3])start, &f->arena, &shift),
		0);
	return shift != NULL;
}

static void cross(const double a[3], const double b[3], double out[3])
{
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		out[i] = a[j] * b[k] - a[k] * b[j];
	}
}

/* From a node's frame into that of the one above it. */
static void go_up(const struct model_node *node, double at[3])
{
	const struct transform *rest = &node->rest;
	double axis[3], scaled[3], once[3], twice[3];

	if (node->matrix) {
		memcpy(scaled, at, sizeof(scaled));
		for (int row = 0; row < 3; row++) {
			at[row] = (double)node->matrix[3][row];
			for (int i = 0; i < 3; i++) {
				at[row] += (double)node->matrix[i][row] *
					scaled[i];
			}
		}
		return;
	}
	for (int i = 0; i < 3; i++) {
		axis[i] = (double)rest->rotation[i];
		scaled[i] = at[i] * (double)rest->scale[i];
	}
	cross(axis, scaled, once);
	cross(axis, once, twice);
	for (int i = 0; i < 3; i++) {
		at[i] = scaled[i] + (double)rest->translation[i] +
			2 * ((double)rest->rotation[3] * once[i] + twice[i]);
	}
}

/* Where a vertex is in the scene, by the node that shows its mesh. */
static void place(
	const struct fixture *f, int node, int mesh, int vertex, double at[3])
{
	const float *from = f->position[mesh][vertex];

	for (int i = 0; i < 3; i++) {
		at[i] = (double)from[i];
	}
	for (; node >= 0; node = f->node[node].parent) {
		go_up(&f->node[node], at);
	}
}

static void keep_places(struct fixture *f)
{
	for (int n = 0; n < NODES; n++) {
		int mesh = f->node[n].mesh;

		for (int v = 0; mesh >= 0 && v < VERTICES; v++) {
			place(f, n, mesh, v, f->before[mesh][v]);
		}
	}
}

/* They are where they were less the origin, and all near to it. */
static void expect_places(const struct fixture *f, double near)
{
	for (int n = 0; n < NODES; n++) {
		int mesh = f->node[n].mesh;

		for (int v = 0; mesh >= 0 && v < VERTICES; v++) {
			double at[3];

			place(f, n, mesh, v, at);
			for (int i = 0; i < 3; i++) {
				assert_near(at[i] + f->model.origin[i],
					f->before[mesh][v][i], 0.02);
				assert_near(at[i], 0, near);
			}
		}
	}
}

/* Quaternions and sides whose products are exact. */
static void turn_randomly(struct model_node *node, uint32_t *seed)
{
	static const float scales[] = {0.5f, 1, 2, -1};

	for (int i = 0; i < 4; i++) {
		node->rest.rotation[i] = random_one_in(seed, 2) ? 0.5f : -0.5f;
	}
	if (random_one_in(seed, 2)) { /* by another angle around one axis */
		memset(node->rest.rotation, 0, sizeof(float[4]));
		node->rest.rotation[random_between(seed, 0, 2)] = 0.6f;
		node->rest.rotation[3] = 0.8f;
	}
	for (int i = 0; i < 3; i++) {
		node->rest.scale[i] = scales[random_between(seed, 0, 3)];
		node->rest.translation[i] = (float)random_within(seed, 4);
	}
}

static void scatter(struct fixture *f, uint32_t *seed)
{
	for (int i = 0; i < MESHES * VERTICES; i++) {
		for (int axis = 0; axis < 3; axis++) {
			f->position[i / VERTICES][i % VERTICES][axis] =
				(float)random_within(seed, 3);
		}
	}
}

/* A chain of nodes, each turned by chance, that show a mesh each below the top. */
static void begin_turned(struct fixture *f, uint32_t *seed)
{
	begin(f);
	scatter(f, seed);
	for (int i = 0; i < NODES; i++) {
		turn_randomly(&f->node[i], seed);
		f->node[i].mesh = i - 1;
	}
}

/* Moves the model and looks for its vertices. */
static void move_and_find(struct fixture *f, double near)
{
	keep_places(f);
	assert_true(move(f));
	expect_places(f, near);
}

static void test_a_far_root_takes_everything_along(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int n = 0; n < RANDOM_CASES(200); n++) {
		struct fixture f;

		begin_turned(&f, &seed);
		for (int axis = 0; axis < 3; axis++) {
			f.node[0].rest.translation[axis] =
				(float)random_within(&seed, 4) * 250000.0f;
		}
		f.node[0].rest.translation[n % 3] = n % 2 ? 3e6f : -3e6f;
		move_and_find(&f, 250);
		end(&f);
	}
}

static void test_matrices_place_vertices_too(void **state)
{
	uint32_t seed = 6;

	(void)state;
	for (int n = 0; n < RANDOM_CASES(100); n++) {
		struct fixture f;

		begin_turned(&f, &seed);
		for (int i = 0; i < 12; i++) {
			f.matrix[0][i / 3][i % 3] =
				(float)random_within(&seed, 2);
			f.matrix[2][i / 3][i % 3] =
				(float)random_within(&seed, 2);
		}
		f.matrix[0][3][n % 3] = 3e6f;
		f.node[0].matrix = (const float(*)[4])f.matrix[0];
		f.node[2].matrix = (const float(*)[4])f.matrix[2];
		f.matrix[0][3][3] = f.matrix[2][3][3] = 1;
		f.matrix[0][0][0] = f.matrix[0][1][1] = f.matrix[0][2][2] = 5;
		f.matrix[2][0][0] = f.matrix[2][1][1] = f.matrix[2][2][2] = 5;
		move_and_find(&f, 4000);
		end(&f);
	}
}

/*
 * The vertices of node 1 are far from it, and so are the nodes below it, which
 * stay where they were in the scene.
 */
static void begin_far_mesh(struct fixture *f, uint32_t *seed)
{
	begin_turned(f, seed);
	for (int axis = 0; axis < 3; axis++) {
		float far = (float)random_within(seed, 4) * 250000.0f;

		f->node[2].rest.translation[axis] += far;
		for (int v = 0; v < VERTICES; v++) {
			f->position[0][v][axis] += far;
		}
	}
	f->node[1].parent = -1;
	f->node[2].rest.translation[0] += 4e6f;
	for (int v = 0; v < VERTICES; v++) {
		f->position[0][v][0] += 4e6f;
	}
}

static void test_far_vertices_move_but_stay_in_place(void **state)
{
	uint32_t seed = 7;

	(void)state;
	for (int n = 0; n < RANDOM_CASES(200); n++) {
		struct fixture f;

		begin_far_mesh(&f, &seed);
		move_and_find(&f, 250);
		for (int v = 0; v < VERTICES; v++) {
			assert_near(f.position[0][v][0], 0, 250);
		}
		for (int i = 0; i < 3; i++) {
			assert_near(f.node[1].rest.translation[i], 0, 500);
			assert_near(f.node[2].rest.translation[i], 0, 500);
			assert_near(f.node[3].rest.translation[i], 0, 5);
		}
		end(&f);
	}
}

/* What reads a node's own place, and a shape that shares it, forbids it. */
static void test_vertices_stay_where_the_node_itself_matters(void **state)
{
	static struct model_target target[2];

	(void)state;
	for (int reason = 0; reason < 7; reason++) {
		uint32_t seed = 8;
		struct fixture f;
		float first;

		begin_far_mesh(&f, &seed);
		f.node[1].camera = reason == 1 ? 0 : -1;
		f.joint[0] = reason == 2 ? 1 : 3;
		f.joint[1] = 3;
		f.turned[1] = reason == 3;
		if (reason == 4 || reason == 5) { /* two nodes show it */
			f.node[2] = f.node[1];
			f.node[3].mesh = -1;
			f.turned[2] = reason == 5;
		}
		f.mesh[0].target_count = reason == 6;
		f.primitive[0][0].target = f.primitive[0][1].target = target;
		first = f.position[0][0][0];
		assert_true(move(&f));
		if (f.position[0][0][0] == first) {
			assert_true(reason != 0 && reason != 4);
		} else if (reason != 0 && reason != 4) {
			fail_msg("reason %d", reason);
		}
		end(&f);
	}
}

/* A skinned mesh is where its joints put it, wherever its node is. */
static void test_joints_place_the_vertices_of_a_skin(void **state)
{
	uint32_t seed = 9;

	(void)state;
	for (int n = 0; n < RANDOM_CASES(100); n++) {
		struct fixture f;
		float first;

		begin(&f);
		scatter(&f, &seed);
		for (int i = 0; i < NODES; i++) {
			turn_randomly(&f.node[i], &seed);
		}
		f.node[0].rest.translation[n % 3] = 3e6f;
		f.node[3].parent =
			-1; /* as exporters put it: beside the bones */
		f.node[3].mesh = 0;
		f.node[3].skin = 0;
		f.joint[0] = 1;
		f.joint[1] = 2;
		for (int j = 0; j < 2; j++) {
			for (int i = 0; i < 3; i++) {
				f.bind[j][i][i] =
					random_one_in(&seed, 2) ? 2 : 1;
				f.bind[j][3][i] = (float)random_within(&seed, 4);
			}
		}
		for (int v = 0; v < VERTICES; v++) { /* which the bind undoes */
			f.position[0][v][n % 3] += 1e6f;
		}
		f.bind[0][3][n % 3] -= 1e6f * f.bind[0][n % 3][n % 3];
		f.bind[1][3][n % 3] -= 1e6f * f.bind[1][n % 3][n % 3];
		first = f.position[0][0][0];
		assert_true(move(&f));
		assert_near(f.model.origin[n % 3], 3e6, 600);
		assert_near(f.model.origin[(n + 1) % 3], 0, 0);
		assert_near(f.model.origin[(n + 2) % 3], 0, 0);
		assert_near(f.position[0][0][0], first, 0);
		assert_near(f.node[0].rest.translation[n % 3], 0, 600);
		end(&f);
	}
}

/* A joint near the origin holds a part of the mesh there: the model is large. */
static void test_every_joint_counts_for_a_models_place(void **state)
{
	(void)state;
	for (int near = 0; near < 3; near++) {
		uint32_t seed = 10;
		struct fixture f;

		begin(&f);
		scatter(&f, &seed);
		f.node[2].parent = f.node[3].parent = -1;
		f.node[3].mesh = 0;
		f.node[3].skin = 0;
		for (int j = 0; j < 2; j++) {
			f.joint[j] = 1 + j;
			f.node[1 + j].rest.translation[0] = j == near ? 0 : 3e6f;
		}
		assert_int_equal(move(&f), near == 2);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_far_root_takes_everything_along),
		cmocka_unit_test(test_matrices_place_vertices_too),
		cmocka_unit_test(test_far_vertices_move_but_stay_in_place),
		cmocka_unit_test(
			test_vertices_stay_where_the_node_itself_matters),
		cmocka_unit_test(test_joints_place_the_vertices_of_a_skin),
		cmocka_unit_test(test_every_joint_counts_for_a_models_place),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

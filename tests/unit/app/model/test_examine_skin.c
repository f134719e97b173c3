/* What limber doctor says about skins, their nodes and meshes. */
#include "app/model/examine/examine.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>
#include <stdio.h>
#include <string.h>

enum {
	HIPS, /* a root, a joint */
	KNEE, /* its child, a joint */
	BODY, /* a root with the mesh and the skin */
	HOLDER,
	NODES
};

struct fixture {
	struct bones bones;
	int joint[2][2];
	struct model_skin skin[2];
	float point[1][3];
	uint32_t index[3];
	struct model_primitive primitive;
	char heard[2000]; /* the findings, each with a newline */
};

static void keep(void *context, const char *finding)
{
	struct fixture *f = context;

	snprintf(f->heard + strlen(f->heard),
		sizeof(f->heard) - strlen(f->heard), "%s\n", finding);
}

/* A model of which there is nothing to say. */
static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 1, 2, 3);
	bones_add(&f->bones, HIPS, 4, 5, 6);
	bones_add(&f->bones, -1, 0, 0, 0);
	bones_add(&f->bones, -1, 0, 0, 0);
	f->bones.node[BODY].mesh = f->bones.node[BODY].skin = 0;
	f->primitive = (struct model_primitive){.vertex_count = 1,
		.position = f->point,
		.normal = f->point,
		.index_count = 3,
		.index = f->index};
	f->bones.mesh[0] = (struct model_mesh){
		.primitive_count = 1, .primitive = &f->primitive};
	f->bones.model.skin = f->skin;
	f->bones.model.skin_count = 2;
	for (int s = 0; s < 2; s++) {
		f->joint[s][0] = HIPS;
		f->joint[s][1] = KNEE;
		f->skin[s] = (struct model_skin){
			.joint_count = 2, .joint = f->joint[s]};
	}
}

static void expect(struct fixture *f, const char *wanted)
{
	const struct examiner examiner = {keep, f};
	struct log log = log_to_stderr(LOG_WARNING);

	f->heard[0] = '\0';
	assert_int_equal(examine_skins(&f->bones.model, &examiner, &log), 0);
	assert_string_equal(f->heard, wanted);
}

static void end(struct fixture *f)
{
	bones_end(&f->bones);
}

static void test_a_plain_skin_has_no_findings(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	expect(&f, "");
	end(&f);
}

static void test_a_figure_that_lies_is_told(void **state)
{
	struct fixture f;
	struct model_node *node = f.bones.node;

	(void)state;
	begin(&f);
	node[KNEE].name = "foot";
	node[KNEE].rest =
		(struct transform){{0, 0, -1}, {0, 0, 0, 1}, {1, 1, 1}};
	node[HOLDER] = node[KNEE];
	node[HOLDER].name = "Head";
	node[HOLDER].rest.translation[2] = 1;
	f.joint[1][1] = HOLDER;
	expect(&f,
		"a figure that lies at rest (from foot to Head): limber takes +Y as up, as glTF says; if it should stand, export it with +Y up\n");
	end(&f);
}

/* Each number of a transform decides alone, and -1 turns like 1. */
static void test_transforms_of_skinned_nodes_are_counted(void **state)
{
	static const char finding[] =
		"skinned nodes with a transform of their own (1): limber "
		"ignores it, because only the joints move a skin\n";
	static const float matrix[4][4] = {{0}};
	struct fixture f;
	struct transform *rest = &f.bones.node[BODY].rest;

	(void)state;
	begin(&f);
	for (int i = 0; i < 3; i++) {
		rest->translation[i] = -2e-5f;
		expect(&f, finding);
		rest->translation[i] = 5e-6f;
		expect(&f, "");
		rest->scale[i] = 1.00003f;
		expect(&f, finding);
		rest->scale[i] = 1.0f;
	}
	rest->rotation[3] = -1.0f;
	expect(&f, "");
	rest->rotation[3] = 0.5f;
	expect(&f, finding);
	rest->rotation[3] = 1.0f;
	f.bones.node[BODY].matrix = matrix;
	expect(&f, finding);
	end(&f);
}

static void test_transforms_above_joints_are_counted(void **state)
{
	static const char finding[] =
		"joints whose parent is not a joint but has a transform (1): "
		"limber applies that transform\n";
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[HIPS].parent = HOLDER;
	expect(&f, "");
	f.bones.node[HOLDER].rest.translation[1] = 1.0f;
	expect(&f, finding);
	/* Its own joint is no such parent. */
	f.joint[1][1] = HOLDER;
	f.skin[1].joint_count = 2;
	expect(&f, "");
	end(&f);
}

static void test_meshes_on_joints_are_counted(void **state)
{
	static const char finding[] =
		"meshes without a skin that are attached to joints (1): "
		"limber moves each rigidly with its joint\n";
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[HOLDER].mesh = 0;
	expect(&f, "");
	f.bones.node[HOLDER].parent = KNEE;
	expect(&f, finding);
	f.bones.node[HOLDER].parent = HIPS; /* node 0 */
	expect(&f, finding);
	f.bones.node[HOLDER].mesh = -1;
	expect(&f, "");
	f.bones.node[KNEE].mesh = 0;
	expect(&f, finding);
	end(&f);
}

static void test_scaled_joints_are_counted(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[HOLDER].rest.scale[2] = 2.0f;
	expect(&f, "");
	f.bones.node[HIPS].rest.scale[0] = 2.0f;
	f.bones.node[KNEE].rest.scale[2] = 0.5f;
	expect(&f,
		"joints with a scale (2): limber transforms normals by the "
		"joint matrix, or where the scale is uneven by its inverse "
		"transpose, and normalises them\n");
	end(&f);
}

static void test_joints_in_another_order_are_counted(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.joint[1][0] = KNEE;
	f.joint[1][1] = HIPS;
	expect(&f,
		"skins that list their joints in another order than the nodes "
		"(1): limber takes the joint numbers of vertices as indices "
		"into the skin's list\n");
	end(&f);
}

/* A model has its nodes by depth, a file may have them by breadth. */
static void test_the_order_of_joints_is_that_of_the_file(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[HIPS].file_index = KNEE;
	f.bones.node[KNEE].file_index = HIPS;
	for (int s = 0; s < 2; s++) {
		f.joint[s][0] = KNEE;
		f.joint[s][1] = HIPS;
	}
	expect(&f, "");
	end(&f);
}

/* Nodes that share a skin count once, whatever their order. */
static void test_the_skins_of_a_mesh_are_counted(void **state)
{
	static const struct {
		int skin[3];
		const char *finding;
	} cases[] = {
		{{0, 0, 0}, ""},
		{{1, 1, -1}, ""},
#define TWO "mesh 0 is drawn with 2 skins; limber poses it once for each skin\n"
		{{0, 1, -1}, TWO},
		{{0, 1, 1}, TWO},
		{{1, 0, 1}, TWO},
		{{-1, 1, 0}, TWO},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		begin(&f);
		bones_add(&f.bones, -1, 0, 0, 0);
		for (int n = 0; n < 3; n++) {
			f.bones.node[BODY + n].mesh = 0;
			f.bones.node[BODY + n].skin = cases[i].skin[n];
		}
		expect(&f, cases[i].finding);
		end(&f);
	}
}

static void test_the_skins_of_each_mesh_are_counted(void **state)
{
	for (int other = 0; other < 2; other++) {
		struct fixture f;
		struct model_mesh mesh[2];

		(void)state;
		begin(&f);
		mesh[0] = mesh[1] = f.bones.mesh[0];
		f.bones.model.mesh = mesh;
		f.bones.model.mesh_count = 2;
		bones_add(&f.bones, -1, 0, 0, 0);
		for (int n = 0; n < 3; n++) {
			f.bones.node[BODY + n].mesh = n == 2 ? other : !other;
			f.bones.node[BODY + n].skin = n % 2;
		}
		expect(&f,
			other ? TWO
			      : "mesh 1 is drawn with 2 skins; limber poses it once for each skin\n");
		end(&f);
	}
}

static void test_what_primitives_lack_or_have_is_counted(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.primitive.normal = NULL;
	expect(&f,
		"primitives without normals (1): limber lights the posed "
		"triangles with flat normals, as glTF requires\n");
	f.primitive.normal = f.point;
	f.primitive.influences = 4;
	expect(&f, "");
	f.primitive.influences = 8;
	expect(&f,
		"primitives with a second set of joints and weights (1): "
		"limber uses all eight influences of a vertex\n");
	end(&f);
}

static void test_a_file_without_triangles_shows_nothing(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.mesh[0].primitive_count = 0;
	expect(&f,
		"the file has no triangles, so limber shows an empty stage: "
		"export it with its meshes\n");
	end(&f);
}

static void test_nodes_that_are_morphed_and_skinned_are_named(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[BODY].file_index = 17;
	f.bones.node[HOLDER].skin = 0;
	f.bones.mesh[0].target_count = 1;
	expect(&f,
		"node 17 is morphed and skinned; limber morphs first, then "
		"skins, then normalises the normals\n");
	f.bones.node[BODY].skin = -1;
	expect(&f, "");
	end(&f);
}

static const char turned_away[] =
	"primitives whose normals point to the back of their triangles (1): limber lights them as the file says, so that the lit side is dark; export them with the normals turned\n";
static float front[3][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0.6f, 0.8f}};
static float back[3][3] = {{0, 0, -1}, {0, 0, -1}, {0, 0.6f, 0.8f}};

/* Makes the mesh a triangle. */
static void begin_triangle(struct fixture *f)
{
	static float corner[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

	begin(f);
	f->primitive.vertex_count = 3;
	f->primitive.position = corner;
	f->index[1] = 1;
	f->index[2] = 2;
}

static void test_normals_that_point_to_the_back_are_counted(void **state)
{
	struct fixture f;

	(void)state;
	begin_triangle(&f);
	f.primitive.normal = front;
	expect(&f, "");
	f.primitive.normal = back;
	expect(&f, turned_away);
	end(&f);
}

/* Whether normals are found to point to the back, beside other findings. */
static bool finds_turned(struct fixture *f, float (*normal)[3])
{
	const struct examiner examiner = {keep, f};
	struct log log = log_to_stderr(LOG_WARNING);

	f->heard[0] = '\0';
	f->primitive.normal = normal;
	assert_int_equal(examine_skins(&f->bones.model, &examiner, &log), 0);
	return strstr(f->heard, turned_away) != NULL;
}

/*
 * A mirroring node turns the triangles below it. Blender mirrors the vertices
 * of a skin in the file, and the inverse bind matrices mirror them back.
 */
static void test_a_mirroring_node_turns_the_triangles_of_its_skin(void **state)
{
	static const float mirror[4][4] = {
		{0, 2, 0, 0}, {3, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	mat4 bind[2] = {GLM_MAT4_ZERO_INIT, GLM_MAT4_IDENTITY_INIT};
	struct fixture f;

	(void)state;
	begin_triangle(&f);
	f.skin[0].inverse_bind = bind;
	f.bones.node[BODY].parent = HIPS;
	for (int way = 0; way < 2; way++) {
		struct model_node *hips = &f.bones.node[HIPS];

		hips->rest.scale[0] = way == 0 ? -1.0f : 1.0f;
		hips->matrix = way == 0 ? NULL : mirror;
		bind[1][1][1] = 1.0f; /* the joints mirror as the node does */
		assert_false(finds_turned(&f, front));
		assert_true(finds_turned(&f, back));
		bind[1][1][1] = -1.0f;
		assert_true(finds_turned(&f, front));
		assert_false(finds_turned(&f, back));
		f.bones.node[BODY].skin = -1;
		assert_false(finds_turned(&f, front));
		assert_true(finds_turned(&f, back));
		f.bones.node[BODY].skin = 0;
	}
	end(&f);
}

static void test_a_mesh_of_no_node_is_lit_from_no_side(void **state)
{
	struct fixture f;

	(void)state;
	begin_triangle(&f);
	f.bones.node[BODY].mesh = -1;
	assert_false(finds_turned(&f, back));
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_plain_skin_has_no_findings),
		cmocka_unit_test(test_a_figure_that_lies_is_told),
		cmocka_unit_test(test_transforms_of_skinned_nodes_are_counted),
		cmocka_unit_test(test_transforms_above_joints_are_counted),
		cmocka_unit_test(test_meshes_on_joints_are_counted),
		cmocka_unit_test(test_scaled_joints_are_counted),
		cmocka_unit_test(test_joints_in_another_order_are_counted),
		cmocka_unit_test(test_the_order_of_joints_is_that_of_the_file),
		cmocka_unit_test(test_the_skins_of_a_mesh_are_counted),
		cmocka_unit_test(test_the_skins_of_each_mesh_are_counted),
		cmocka_unit_test(test_what_primitives_lack_or_have_is_counted),
		cmocka_unit_test(test_normals_that_point_to_the_back_are_counted),
		cmocka_unit_test(
			test_a_mirroring_node_turns_the_triangles_of_its_skin),
		cmocka_unit_test(test_a_mesh_of_no_node_is_lit_from_no_side),
		cmocka_unit_test(test_a_file_without_triangles_shows_nothing),
		cmocka_unit_test(
			test_nodes_that_are_morphed_and_skinned_are_named),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

#include "app/model/origin/model_origin.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <string.h>

/* A model stays if it is less far from the origin than this, in its sizes. */
static const double far_sizes = 128;

/* Columns of a matrix, the last one being the translation. */
struct frame {
	double column[4][3];
};

struct box {
	double low[3], high[3];
};

struct search {
	struct model *model;
	const bool *turned;
	bool *joint;         /* [node_count] */
	struct frame *world; /* [node_count]: at rest */
	struct box *box;     /* [mesh_count]: of its vertices */
	double size;         /* of the model */
	double (*mesh)[3];   /* [mesh_count]: by how much vertices move */
	double (*shift)[3];  /* [node_count] */
};

static const struct box nowhere = {
	{DBL_MAX, DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX, -DBL_MAX}};

static void add_point(struct box *box, const double point[3])
{
	/* fmin() and fmax() are calls, which delay the first picture. */
	for (int axis = 0; axis < 3; axis++) {
		double at = point[axis];

		box->low[axis] = at < box->low[axis] ? at : box->low[axis];
		box->high[axis] = at > box->high[axis] ? at : box->high[axis];
	}
}

static double size_of(const struct box *box)
{
	double size = 0;

	for (int axis = 0; axis < 3; axis++) {
		size = fmax(size, box->high[axis] - box->low[axis]);
	}
	return size;
}

/* The three columns of a rotation and a scale. */
static void turn_frame(const struct transform *rest, struct frame *out)
{
	double x = (double)rest->rotation[0], y = (double)rest->rotation[1],
	       z = (double)rest->rotation[2], w = (double)rest->rotation[3];
	const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z),
					   2 * (x * z - w * y)},
		{2 * (x * y - w * z), 1 - 2 * (x * x + z * z),
			2 * (y * z + w * x)},
		{2 * (x * z + w * y), 2 * (y * z - w * x),
			1 - 2 * (x * x + y * y)}};

	for (int column = 0; column < 3; column++) {
		for (int row = 0; row < 3; row++) {
			out->column[column][row] =
				turn[column][row] * (double)rest->scale[column];
		}
	}
}

static struct frame frame_of_matrix(const float (*matrix)[4])
{
	struct frame frame;

	for (int i = 0; i < 12; i++) {
		frame.column[i / 3][i % 3] = (double)matrix[i / 3][i % 3];
	}
	return frame;
}

static struct frame frame_of(const struct model_node *node)
{
	struct frame frame;

	if (node->matrix) {
		return frame_of_matrix(node->matrix);
	}
	turn_frame(&node->rest, &frame);
	for (int row = 0; row < 3; row++) {
		frame.column[3][row] = (double)node->rest.translation[row];
	}
	return frame;
}

/* Applies only the first three columns if w is 0. */
static void apply(const struct frame *frame, const double point[3], double w,
	double out[3])
{
	for (int row = 0; row < 3; row++) {
		out[row] = w * frame->column[3][row];
		for (int column = 0; column < 3; column++) {
			out[row] += frame->column[column][row] * point[column];
		}
	}
}

static struct frame multiply(const struct frame *a, const struct frame *b)
{
	struct frame out;

	for (int column = 0; column < 4; column++) {
		apply(a, b->column[column], column == 3, out.column[column]);
	}
	return out;
}

static void find_world(struct search *search)
{
	const struct model *model = search->model;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];
		struct frame own = frame_of(node);

		search->world[n] = node->parent < 0
			? own
			: multiply(&search->world[node->parent], &own);
	}
}

static struct box box_of_mesh(const struct model_mesh *mesh)
{
	struct box box = nowhere;

	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		for (int v = 0; v < primitive->vertex_count; v++) {
			const float *at = primitive->position[v];

			add_point(&box,
				(double[3]){(double)at[0], (double)at[1],
					(double)at[2]});
		}
	}
	return box;
}

/* Adds the corners of a mesh's box where the frame puts them. */
static void add_box(
	struct box *out, const struct box *box, const struct frame *frame)
{
	for (int corner = 0; corner < 8; corner++) {
		double at[3], placed[3];

		for (int axis = 0; axis < 3; axis++) {
			at[axis] = corner >> axis & 1 ? box->high[axis]
						      : box->low[axis];
		}
		apply(frame, at, 1, placed);
		add_point(out, placed);
	}
}

/* Adds what a skinned mesh spans at rest, or a little more. */
static void add_skinned(const struct search *search,
	const struct model_node *node, struct box *out)
{
	const struct model_skin *skin = &search->model->skin[node->skin];

	for (int j = 0; j < skin->joint_count; j++) {
		const struct frame bind = frame_of_matrix(
			(const float(*)[4])skin->inverse_bind[j]);
		const struct frame placed =
			multiply(&search->world[skin->joint[j]], &bind);

		add_box(out, &search->box[node->mesh], &placed);
	}
}

static bool is_empty(const struct box *box)
{
	return !(box->low[0] <= box->high[0]);
}

static struct box box_of_model(const struct search *search)
{
	const struct model *model = search->model;
	struct box all = nowhere;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];

		if (!model_node_shows_mesh(node) ||
			is_empty(&search->box[node->mesh])) {
			continue;
		}
		if (node->skin >= 0) {
			add_skinned(search, node, &all);
		} else {
			add_box(&all, &search->box[node->mesh],
				&search->world[n]);
		}
	}
	return all;
}

/*
 * Finds the middle of a box that is far from the origin for something of this
 * size; 0 along an axis on which it is not. Multiples of a power of two that is
 * about as large as the size can be subtracted without rounding.
 */
static bool find_far(const struct box *box, double size, double out[3])
{
	double unit = exp2(ceil(log2(size)));
	bool is_far = false;

	for (int axis = 0; axis < 3; axis++) {
		double middle = 0.5 * (box->low[axis] + box->high[axis]);

		out[axis] = 0;
		if (fabs(middle) > far_sizes * size) {
			out[axis] = unit * round(middle / unit);
			is_far = true;
		}
	}
	return is_far;
}

/* Whether a node's own origin may move into the middle of its mesh. */
static bool may_move(const struct search *search, int node)
{
	const struct model_node *of = &search->model->node[node];

	return of->skin < 0 && of->camera < 0 && !search->joint[node] &&
		!search->turned[node];
}

/* Finds meshes whose vertices are far from the origins of their nodes. */
static void find_meshes(const struct search *search)
{
	const struct model *model = search->model;

	for (int m = 0; m < model->mesh_count; m++) {
		if (is_empty(&search->box[m]) ||
			model->mesh[m].target_count > 0 ||
			!find_far(&search->box[m], search->size,
				search->mesh[m])) {
			memset(search->mesh[m], 0, sizeof(search->mesh[m]));
		}
	}
	for (int n = 0; n < model->node_count; n++) {
		int mesh = model->node[n].mesh;

		if (mesh >= 0 && !may_move(search, n)) {
			memset(search->mesh[mesh], 0,
				sizeof(search->mesh[mesh]));
		}
	}
}

/* A node moves into its mesh, and its children stay where they are. */
static void find_shifts(const struct search *search)
{
	const struct model *model = search->model;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];
		const struct frame own = frame_of(node);
		double inwards[3] = {0, 0, 0};

		if (node->mesh >= 0) {
			apply(&own, search->mesh[node->mesh], 0, inwards);
		}
		for (int axis = 0; axis < 3; axis++) {
			const struct model_node *parent = node->parent < 0
				? NULL
				: &model->node[node->parent];

			search->shift[n][axis] = -inwards[axis] +
				(!parent ? model->origin[axis]
						: parent->mesh < 0
						? 0
						: search->mesh[parent->mesh][axis]);
		}
	}
}

static void shift_floats(const double shift[3], int count, float *value)
{
	for (int i = 0; i < count; i++) {
		value[i] = (float)((double)value[i] - shift[i % 3]);
	}
}

static int shift_matrix(
	struct model *model, struct model_node *node, const double shift[3])
{
	float(*matrix)[4] = arena_alloc(&model->arena, 4, sizeof(*matrix));

	if (!matrix) {
		return -ENOMEM;
	}
	memcpy(matrix, node->matrix, 4 * sizeof(*matrix));
	shift_floats(shift, 3, matrix[3]);
	node->matrix = (const float(*)[4])matrix;
	return 0;
}

static int move_nodes(struct model *model, double (*shift)[3])
{
	int error = 0;

	for (int n = 0; n < model->node_count && !error; n++) {
		struct model_node *node = &model->node[n];

		shift_floats(shift[n], 3, node->rest.translation);
		if (node->matrix) {
			error = shift_matrix(model, node, shift[n]);
		}
	}
	return error;
}

static void move_vertices(const struct search *search)
{
	for (int m = 0; m < search->model->mesh_count; m++) {
		const struct model_mesh *mesh = &search->model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			shift_floats(search->mesh[m],
				3 * mesh->primitive[p].vertex_count,
				(float *)mesh->primitive[p].position);
		}
	}
}

static bool allocate(struct search *search, struct arena *arena)
{
	size_t nodes = (size_t)search->model->node_count;
	size_t meshes = (size_t)search->model->mesh_count;

	search->world = ARENA_ARRAY(arena, struct frame, nodes);
	search->box = ARENA_ARRAY(arena, struct box, meshes);
	search->joint = model_find_joints(search->model, arena);
	search->mesh = arena_alloc(arena, meshes, sizeof(double[3]));
	search->shift = arena_alloc(arena, nodes, sizeof(double[3]));
	return search->world && search->box && search->joint && search->mesh &&
		search->shift;
}

/* Whether the clips begin in about the same place as the rest pose. */
static bool starts_there(const struct search *search, const float (*start)[3])
{
	const struct model *model = search->model;

	for (int n = 0; n < model->node_count; n++) {
		const struct model_node *node = &model->node[n];

		for (int axis = 0; axis < 3 && node->parent < 0; axis++) {
			double way = (double)start[n][axis] -
				(double)node->rest.translation[axis];

			if (fabs(way) > far_sizes * search->size) {
				return false;
			}
		}
	}
	return true;
}

int model_origin_find(struct model *model, const bool *turned,
	const float (*start)[3], struct arena *arena, double (**shift)[3])
{
	struct search search = {.model = model, .turned = turned};
	struct box all;

	*shift = NULL;
	if (!allocate(&search, arena)) {
		return -ENOMEM;
	}
	for (int m = 0; m < model->mesh_count; m++) {
		search.box[m] = box_of_mesh(&model->mesh[m]);
	}
	find_world(&search);
	all = box_of_model(&search);
	search.size = size_of(&all);
	if (is_empty(&all) || !(search.size > 0) ||
		!starts_there(&search, start) ||
		!find_far(&all, search.size, model->origin)) {
		return 0;
	}
	find_meshes(&search);
	find_shifts(&search);
	move_vertices(&search);
	*shift = search.shift;
	return move_nodes(model, search.shift);
}

void model_origin_shift_keys(const double shift[3],
	const struct model_channel *channel, float *value)
{
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;

	for (int k = 0; k < channel->key_count; k++) {
		/* Of a cubic key, the middle three numbers are the value. */
		shift_floats(shift, 3, value + (cubic ? 9 * k + 3 : 3 * k));
	}
}

void model_origin_to_file(
	const struct model *model, const float point[3], double out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = (double)point[axis];
		if (model->origin[axis] != 0) { /* else -0 stays -0 */
			out[axis] += model->origin[axis];
		}
	}
}

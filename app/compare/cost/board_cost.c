#include "app/compare/cost/board_cost.h"

#include "app/anim/kernel/arm11_cost.h"
#include "app/anim/skin.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>

/*
 * Converting a joint's matrix to fixed point. arm11_cost[] has no row for it:
 * this is what cesium-normals and walker-normals (tests/bench/arm11.figures)
 * cost beyond their loops.
 */
static const struct board_cost palette_joint = {270.0, 250.0};

/*
 * Other costs without a row, in cycles and instructions: fitted by least
 * squares to what tests/bench/play_cost.c counts for models and exports of many
 * kinds (figures.md).
 */
static const struct board_cost sample_frame = {1315.0, 120.0};
static const struct board_cost sample_node = {75.0, 7.1};
static const struct board_cost sample_turn = {344.0, 35.4}; /* struct turn */
/* Keys far apart need sines, whose constants are read anew once a frame. */
static const struct board_cost wide_frame = {1150.0, 0.0};
static const struct board_cost wide_turn = {480.0, 203.0};
static const struct board_cost middle_turn = {40.0, 11.5};
/* Rotations whose keys are no unit quaternions: added for each, and if wide. */
static const struct board_cost loose_turn = {300.0, 100.0};
static const struct board_cost wide_loose_turn = {950.0, 145.0};
static const struct board_cost turn_times = {121.0, 12.4}; /* own key times */
static const struct board_cost sample_channel = {653.0, 82.0}; /* not constant */
static const struct board_cost sample_times = {60.0, 9.2}; /* own key times */
static const struct board_cost sample_weight = {72.0, 5.8};
static const struct board_cost matrix_frame = {1000.0, 125.0};
static const struct board_cost matrix_node = {413.0, 93.0};
/* Nodes without a parent take this less: their matrix is not multiplied. */
static const struct board_cost matrix_root = {-120.0, -21.0};
static const struct board_cost palette_row = {620.0, 54.0}; /* a joint */
static const struct board_cost solid_drawable = {347.0, 54.0};
static const struct board_cost keys_drawable = {1000.0, 287.0};
static const struct board_cost keys_weight = {25.0, 7.4};
static const struct board_cost keys_vertex = {19.1, 11.1};
/* The first 16 vertices, which are loaded before a preload can reach them. */
static const struct board_cost keys_begun = {26.0, 0.0};
static const struct board_cost targets_weight = {135.0, 33.5};
static const struct board_cost targets_copied = {13.8, 1.6};
static const struct board_cost targets_span = {110.0, 31.3};
/*
 * Several pairs of targets with weights: the instructions of the loops in
 * app/anim/kernel/run/fixed_morph_run.c and arm/morph.S, and the cycles that
 * the timing model counts in them.
 */
static const struct board_cost targets_begun = {16.7, 8.2};
static const struct board_cost targets_visit = {30.0, 12.0};
static const struct board_cost targets_search = {95.0, 16.0};
static const struct board_cost targets_step = {20.0, 13.0};
static const struct board_cost targets_piece = {62.0, 35.3};
static const struct board_cost targets_added = {17.8, 7.5};
static const struct board_cost targets_rebased = {40.0, 14.0};
/* Shadows on hills, from the timing model's counts of a model with hills. */
static const struct board_cost laid_point = {970.0, 455.0};
static const struct board_cost laid_ray = {640.0, 240.0};

static struct board_cost cost_of(enum arm11_work work, double count)
{
	return (struct board_cost){
		.cycles = count * (double)arm11_cost[work].cycles,
		.instructions = count * (double)arm11_cost[work].instructions,
	};
}

/* Interpolates linearly: a at t = 0, b at t = 1. */
static struct board_cost lerp_cost(
	enum arm11_work a, enum arm11_work b, double t)
{
	struct board_cost low = cost_of(a, 1.0 - t);
	struct board_cost high = cost_of(b, t);

	board_cost_add(&low, &high);
	return low;
}

double board_cost_us(const struct board_cost *cost)
{
	return cost->cycles / ARM11_MHZ;
}

void board_cost_add(struct board_cost *cost, const struct board_cost *more)
{
	cost->cycles += more->cycles;
	cost->instructions += more->instructions;
}

struct board_cost board_frame_sum(const struct board_frame *frame)
{
	struct board_cost sum = board_frame_posing(frame);

	board_cost_add(&sum, &frame->draw);
	return sum;
}

struct board_cost board_frame_posing(const struct board_frame *frame)
{
	struct board_cost sum = frame->sample;

	board_cost_add(&sum, &frame->matrices);
	board_cost_add(&sum, &frame->vertices);
	return sum;
}

static void add_times(
	struct board_cost *sum, const struct board_cost *each, double count)
{
	sum->cycles += each->cycles * count;
	sum->instructions += each->instructions * count;
}

/* What sampling a clip costs: numbers of nodes, channels and key times. */
struct sampled {
	int nodes, turns, turn_times, channels, times, weights;
	/* turns between keys so far apart, by their shares of the time */
	double middle_turns, wide_turns;
	/* the same of rotations whose keys are no unit quaternions */
	int loose_turns;
	double wide_loose_turns;
};

static struct board_cost sample_of(const struct sampled *of)
{
	struct board_cost sum = sample_frame;

	add_times(&sum, &sample_node, of->nodes);
	add_times(&sum, &sample_turn, of->turns);
	add_times(&sum, &turn_times, of->turn_times);
	add_times(&sum, &middle_turn, of->middle_turns);
	add_times(&sum, &wide_turn, of->wide_turns);
	add_times(&sum, &wide_frame, fmin(of->wide_turns, 1.0));
	add_times(&sum, &loose_turn, of->loose_turns);
	add_times(&sum, &wide_loose_turn, of->wide_loose_turns);
	add_times(&sum, &sample_channel, of->channels);
	add_times(&sum, &sample_times, of->times);
	add_times(&sum, &sample_weight, of->weights);
	return sum;
}

static bool is_turn(const struct model_channel *channel)
{
	return channel->unit && channel->interpolation == MODEL_LINEAR;
}

enum {
	TIMES_BLOCK = 1024,
	TIMES_SLOTS = 2048, /* more than a block has channels */
	TIMES_SHIFT = 21    /* from a hash of 32 bits to a slot */
};

/* The slot of a channel's number with these key times, or the free one for it. */
static int *find_slot(
	int *slots, const struct model_channel *channel, const float *time_s)
{
	uint32_t hash = (uint32_t)((uintptr_t)time_s / sizeof(*time_s));
	uint32_t at = hash * 2654435761u >> TIMES_SHIFT;

	while (slots[at] && channel[slots[at] - 1].time_s != time_s) {
		at = (at + 1) % TIMES_SLOTS;
	}
	return &slots[at];
}

/* Counts the channels from begin to end whose key times no earlier one has. */
static void count_own_times(struct sampled *sum,
	const struct model_channel *channel, int begin, int end)
{
	int first[TIMES_SLOTS] = {0}; /* numbers of channels, from 1 on */

	for (int i = end - 1; i >= 0; i--) {
		int *slot = find_slot(first, channel, channel[i].time_s);

		if (!channel[i].constant && (*slot || i >= begin)) {
			*slot = i + 1;
		}
	}
	for (int i = 0; i < TIMES_SLOTS; i++) {
		if (first[i] > begin) {
			int turn = is_turn(&channel[first[i] - 1]);

			sum->turn_times += turn;
			sum->times += !turn;
		}
	}
}

/* Blocks, whose channels fit into a table, spare most comparisons. */
static void count_all_own_times(
	struct sampled *sum, const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i += TIMES_BLOCK) {
		int left = clip->channel_count - i;

		count_own_times(sum, clip->channel, i,
			i + (left < TIMES_BLOCK ? left : TIMES_BLOCK));
	}
}

/* 1 less the cosines of keys that app/anim/portable/turns.c treats alike. */
static const float middle_apart = 0.0078125f; /* 14 degrees of rotation */
static const float wide_apart = 0.055f;       /* 38 degrees */

/* How far apart two keys are, as 1 less the cosine of their angle. */
static float apart_of(const struct model_channel *channel, int key)
{
	float a[4], b[4], product[3] = {0};

	model_channel_key(channel, key, a);
	model_channel_key(channel, key + 1, b);
	for (int i = 0; i < 4; i++) {
		product[0] += a[i] * a[i];
		product[1] += b[i] * b[i];
		product[2] += a[i] * b[i];
	}
	return channel->unit
		? 1.0f - fabsf(product[2])
		: 1.0f - fabsf(product[2]) / sqrtf(product[0] * product[1]);
}

/*
 * Finds the shares of the channel's time in which it turns between keys that
 * are middle_apart or wide_apart.
 */
static void find_turn_shares(
	const struct model_channel *channel, double *middle, double *wide)
{
	const float *time_s = channel->time_s;
	int last = channel->key_count - 1;
	double middle_s = 0.0, wide_s = 0.0;

	for (int i = 0; i < last; i++) {
		double step_s = (double)(time_s[i + 1] - time_s[i]);
		float apart = apart_of(channel, i);

		if (apart > wide_apart) {
			wide_s += step_s;
		} else if (apart > middle_apart) {
			middle_s += step_s;
		}
	}
	if (last > 0) {
		double whole_s = (double)(time_s[last] - time_s[0]);

		*middle += middle_s / whole_s;
		*wide += wide_s / whole_s;
	}
}

static void add_loose_turn(
	struct sampled *sum, const struct model_channel *channel)
{
	double middle = 0.0;

	if (channel->path == MODEL_ROTATION &&
		channel->interpolation == MODEL_LINEAR) {
		sum->loose_turns++;
		find_turn_shares(channel, &middle, &sum->wide_loose_turns);
	}
}

struct board_cost board_cost_sample(
	const struct model_clip *clip, int node_count)
{
	struct sampled sum = {.nodes = node_count};

	count_all_own_times(&sum, clip);
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];

		if (channel->constant) {
			continue;
		}
		if (is_turn(channel)) {
			sum.turns++;
			find_turn_shares(
				channel, &sum.middle_turns, &sum.wide_turns);
		} else {
			sum.channels++;
			add_loose_turn(&sum, channel);
			sum.weights += channel->path == MODEL_WEIGHTS
				? channel->width
				: 0;
		}
	}
	return sample_of(&sum);
}

struct board_cost board_cost_sample_keys(int key_count)
{
	return sample_of(&(struct sampled){
		.nodes = 1, .channels = 1, .times = 1, .weights = key_count});
}

struct board_cost board_cost_matrices(
	int node_count, int root_count, int joint_count)
{
	struct board_cost sum = matrix_frame;

	add_times(&sum, &matrix_node, node_count);
	add_times(&sum, &matrix_root, root_count);
	add_times(&sum, &palette_row, joint_count);
	return sum;
}

int board_cost_count_roots(const struct model *model)
{
	int roots = 0;

	for (int i = 0; i < model->node_count; i++) {
		roots += model->node[i].parent < 0;
	}
	return roots;
}

struct board_cost board_cost_solid(int drawable_count)
{
	struct board_cost sum = {0.0, 0.0};

	add_times(&sum, &solid_drawable, drawable_count);
	return sum;
}

/* The cost of a vertex that has 1 to SKIN_INFLUENCES_MAX influences. */
static struct board_cost vertex_cost(int influences, bool normals)
{
	static const enum arm11_work plain[] = {
		ARM11_SKIN_1, ARM11_SKIN_2, ARM11_SKIN_3, ARM11_SKIN_4};

	if (influences > 4) {
		return lerp_cost(normals ? ARM11_SKIN_NORMALS_4 : ARM11_SKIN_4,
			normals ? ARM11_SKIN_NORMALS_8 : ARM11_SKIN_8,
			0.25 * (influences - 4));
	}
	if (!normals) {
		return cost_of(plain[influences - 1], 1.0);
	}
	return influences < 2
		? cost_of(ARM11_SKIN_NORMALS_1, 1.0)
		: lerp_cost(ARM11_SKIN_NORMALS_2, ARM11_SKIN_NORMALS_4,
			  0.5 * (influences - 2));
}

/* The loops treat a vertex without weights as one with one influence. */
static int influences_of(
	const struct model_primitive *primitive, int vertex, int max_influences)
{
	const float *weight = primitive->weight +
		(size_t)vertex * (size_t)primitive->influences;
	int most = max_influences > 0 ? max_influences : SKIN_INFLUENCES_MAX;
	int count = 0;

	for (int i = 0; i < primitive->influences; i++) {
		count += weight[i] > 0.0f;
	}
	count = count < most ? count : most;
	return count > 0 ? count : 1;
}

static int joints_of(const struct model_primitive *primitive)
{
	uint8_t seen[(UINT16_MAX + 1) / 8] = {0};
	int count = primitive->vertex_count * primitive->influences;
	int joints = 0;

	for (int i = 0; i < count; i++) {
		int joint = primitive->joint[i], bit = 1 << joint % 8;

		if (primitive->weight[i] > 0.0f && !(seen[joint / 8] & bit)) {
			seen[joint / 8] |= (uint8_t)bit;
			joints++;
		}
	}
	return joints;
}

struct board_cost board_cost_skin_vertices(
	const struct model_primitive *primitive, const uint32_t *vertex,
	int count, int max_influences)
{
	bool normals = primitive->normal != NULL;
	struct board_cost cost = {0.0, 0.0};

	for (int i = 0; i < count; i++) {
		int v = vertex ? (int)vertex[i] : i;
		struct board_cost one = vertex_cost(
			influences_of(primitive, v, max_influences), normals);

		board_cost_add(&cost, &one);
	}
	return cost;
}

struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences)
{
	int joints = joints_of(primitive);
	struct board_cost cost = board_cost_skin_vertices(
		primitive, NULL, primitive->vertex_count, max_influences);

	add_times(&cost, &palette_joint, joints);
	return cost;
}

struct board_cost board_cost_keys(int vertex_count, bool normals, int key_count)
{
	struct board_cost sum = keys_drawable;
	double streams = normals ? 2.0 : 1.0;

	add_times(&sum, &keys_weight, key_count);
	add_times(&sum, &keys_vertex, streams * vertex_count);
	add_times(&sum, &keys_begun, streams * fmin(vertex_count, 16.0));
	return sum;
}

struct board_cost board_cost_lay(double points, double rays)
{
	struct board_cost sum = {0.0, 0.0};

	add_times(&sum, &laid_point, points);
	add_times(&sum, &laid_ray, rays);
	return sum;
}

struct board_cost board_cost_targets(const struct board_targets *targets)
{
	struct board_cost sum = cost_of(ARM11_TARGETS_2, targets->paired);

	add_times(&sum, &targets_weight, targets->weights);
	add_times(&sum, &targets_copied, targets->copied);
	add_times(&sum, &targets_begun, targets->begun);
	add_times(&sum, &targets_span, targets->spans);
	add_times(&sum, &targets_visit, targets->visits);
	add_times(&sum, &targets_search, targets->searches);
	add_times(&sum, &targets_step, targets->steps);
	add_times(&sum, &targets_piece, targets->pieces);
	add_times(&sum, &targets_added, targets->added);
	add_times(&sum, &targets_rebased, targets->rebased);
	return sum;
}

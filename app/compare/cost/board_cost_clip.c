/*
 * Predicts the cost of a whole clip from the loops that run in each frame.
 */
#include "app/compare/cost/board_cost.h"

#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/anim/kernel/run/fixed_skin_run.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

#include <string.h>

enum {
	FRAMES_MAX = 10000 /* enough for an average */
};

/* Added for a skinned drawable, and for each run of its vertices. */
static const struct board_cost skin_drawable = {3200.0, 430.0};
static const struct board_cost skin_run = {200.0, 87.0};
static const struct board_cost skin_run_1 = {60.0, 75.0}; /* if one influence */
/*
 * Runs of vertices with the same joints take this share of the cycles and
 * instructions in arm11_cost[], whose vertices have mixed joints.
 */
static const struct board_cost skin_share = {0.88, 0.96};

/*
 * Joints with uneven scale need a matrix of their own for normals: the cost of
 * computing it, and of converting it to fixed point for a drawable.
 */
static const struct board_cost uneven_joint = {660.0, 265.0};
static const struct board_cost uneven_matrix = {220.0, 59.0};
/* If any node has an uneven scale, all nodes are looked through for others. */
static const struct board_cost uneven_node = {96.0, 10.0};

/* Added for a drawable with weighted targets. */
static const struct board_cost morph_drawable = {1900.0, 370.0};

struct playback {
	const struct model_clip *clip;
	double rate_hz;
	int frame_count;
	struct instance *instance;
	struct clip_cursor *cursor;
};

/* Counts a pair's spans, cut at chunk ends as fixed_morph_run() does. */
static int count_pieces(const struct fixed_deltas *deltas)
{
	int pieces = 0;

	for (int i = 0; i < deltas->span_count; i++) {
		const struct fixed_span *span = &deltas->span[i];
		int last = span->first + span->count - 1;

		pieces += last / FIXED_MORPH_CHUNK -
			span->first / FIXED_MORPH_CHUNK + 1;
	}
	return pieces;
}

/* Returns the number of vertices that a pair moves. */
static double count_moved(const struct fixed_deltas *deltas)
{
	double moved = 0.0;

	for (int i = 0; i < deltas->span_count; i++) {
		moved += (double)deltas->span[i].count;
	}
	return moved;
}

/* Counts what several pairs with weights take to find the spans of chunks. */
static void add_searches(const struct fixed_morph *morph,
	const struct fixed_morph_stream *stream, struct board_targets *sum)
{
	for (int first = 0; first < morph->vertex_count;
		first += FIXED_MORPH_CHUNK) {
		sum->visits += (double)morph->pair_count;
		for (int p = 0; p < morph->pair_count; p++) {
			const struct fixed_deltas *deltas = &stream->deltas[p];
			int steps = 0;

			if (fixed_deltas_active(deltas)) {
				sum->searches += 1.0;
				(void)fixed_deltas_find(deltas, first, &steps);
				sum->steps += (double)steps;
			}
		}
	}
}

/* Counts one attribute of a frame. The frame's weights are set. */
static void count_stream(const struct fixed_morph *morph,
	const struct fixed_morph_stream *stream, struct board_targets *sum)
{
	double moved = 0.0, spans = 0.0, pieces = 0.0;
	int active = 0;

	sum->weights += (double)morph->target_count;
	for (int p = 0; p < morph->pair_count; p++) {
		const struct fixed_deltas *deltas = &stream->deltas[p];

		if (fixed_deltas_active(deltas)) {
			active++;
			moved += count_moved(deltas);
			spans += (double)deltas->span_count;
			pieces += (double)count_pieces(deltas);
		}
	}
	if (active == 1) {
		sum->paired += moved;
		sum->spans += spans;
		sum->copied += (double)morph->vertex_count - moved;
	} else if (active > 1) {
		sum->begun += (double)morph->vertex_count;
		sum->added += moved;
		sum->pieces += pieces;
		add_searches(morph, stream, sum);
	} else {
		sum->copied += (double)morph->vertex_count;
	}
}

static void count_streams(
	const struct fixed_morph *morph, struct board_targets *sum)
{
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (morph->stream[a].base) {
			count_stream(morph, &morph->stream[a], sum);
		}
	}
}

static void count_morph(struct fixed_morph *morph, const float *weight,
	struct board_targets *sum)
{
	if (fixed_morph_set_weights(morph, weight) == 0) {
		count_streams(morph, sum);
	}
}

/*
 * Counts the work of morphing a skin, whose base vectors are rewritten only if
 * weights have changed.
 */
static void count_rebase(struct drawable_fixed *fixed, const float *weight,
	struct board_targets *sum)
{
	struct fixed_skin *skin = &fixed->skin;
	struct fixed_skin_targets *targets = &skin->targets;
	size_t size = (size_t)targets->deltas.target_count * sizeof(*weight);

	if (memcmp(weight, targets->weight, size) == 0 ||
		fixed_skin_set_weights(skin, fixed->loops, weight) != 0) {
		return;
	}
	count_streams(&targets->deltas, sum);
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		sum->rebased +=
			targets->rebase[a] ? (double)targets->rebase_count : 0;
	}
}

static const float *weights_at(
	const struct playback *playback, const struct drawable *drawable, int i)
{
	struct instance *instance = playback->instance;

	clip_pose(playback->clip, (float)((double)i / playback->rate_hz),
		CLIP_AUTO, playback->cursor, &instance->pose);
	return instance->pose.weight +
		instance->model->node[drawable->node].weight_offset;
}

static struct board_targets count_targets(
	const struct playback *playback, struct drawable *drawable)
{
	struct drawable_fixed *fixed = drawable->fixed;
	struct board_targets sum = {0};
	double share = 1.0 / (double)playback->frame_count;

	for (int i = 0; i < playback->frame_count && !interrupt_pending(); i++) {
		const float *weight = weights_at(playback, drawable, i);

		if (drawable->skin < 0) {
			count_morph(&fixed->morph, weight, &sum);
		} else {
			count_rebase(fixed, weight, &sum);
		}
	}
	return (struct board_targets){
		.weights = sum.weights * share,
		.copied = sum.copied * share,
		.paired = sum.paired * share,
		.spans = sum.spans * share,
		.begun = sum.begun * share,
		.visits = sum.visits * share,
		.searches = sum.searches * share,
		.steps = sum.steps * share,
		.pieces = sum.pieces * share,
		.added = sum.added * share,
		.rebased = sum.rebased * share,
	};
}

/*
 * Counts the runs with one influence a vertex, or else those with more, from
 * the first group on.
 */
static double count_runs(const struct fixed_skin *skin, int first, bool of_one)
{
	int runs = 0;

	for (int i = first; i < skin->group_count; i++) {
		if ((skin->group[i].influences == 1) == of_one) {
			runs += skin->group[i].run_count;
		}
	}
	return (double)runs;
}

static struct board_cost scaled(
	const struct board_cost *cost, const struct board_cost *share)
{
	return (struct board_cost){cost->cycles * share->cycles,
		cost->instructions * share->instructions};
}

static void add_runs(
	struct board_cost *sum, const struct board_cost *run, double count)
{
	sum->cycles += run->cycles * count;
	sum->instructions += run->instructions * count;
}

static bool has_scale(const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path == MODEL_SCALE) {
			return true;
		}
	}
	return false;
}

/* How many of the skin's joints need a matrix for normals in this pose. */
static int count_uneven_now(struct instance *instance, int skin)
{
	const struct model_skin *s = &instance->model->skin[skin];
	struct pose_normals *normals = &instance->normals;
	int count = 0;

	if (pose_normals_find(normals, &instance->pose)) {
		for (int j = 0; j < s->joint_count; j++) {
			count += normals->uneven_bind[skin] ||
				normals->uneven[s->joint[j]];
		}
	}
	return count;
}

/* The same, as a mean over the clip's frames. */
static double count_uneven(const struct playback *playback, int skin)
{
	struct instance *instance = playback->instance;
	int frames = has_scale(playback->clip) ? playback->frame_count : 1;
	double sum = 0.0;

	for (int i = 0; i < frames && !interrupt_pending(); i++) {
		clip_pose(playback->clip, (float)((double)i / playback->rate_hz),
			CLIP_AUTO, playback->cursor, &instance->pose);
		sum += (double)count_uneven_now(instance, skin);
	}
	return sum / (double)frames;
}

/* What looking for uneven scales takes in the frames that have any. */
static void add_uneven_nodes(
	struct board_cost *sum, const struct playback *playback)
{
	struct instance *instance = playback->instance;
	int frames = has_scale(playback->clip) ? playback->frame_count : 1;
	int uneven = 0;

	for (int i = 0; i < frames && !interrupt_pending(); i++) {
		clip_pose(playback->clip, (float)((double)i / playback->rate_hz),
			CLIP_AUTO, playback->cursor, &instance->pose);
		uneven += pose_normals_find(&instance->normals, &instance->pose);
	}
	add_runs(sum, &uneven_node,
		(double)instance->model->node_count * uneven / frames);
}

static void add_normal_palettes(
	struct board_cost *sum, const struct playback *playback)
{
	const struct instance *instance = playback->instance;

	for (int i = 0; i < instance->model->skin_count; i++) {
		double uneven = count_uneven(playback, i);

		add_runs(sum, &uneven_joint, uneven);
		for (int d = 0; d < instance->drawable_count; d++) {
			const struct drawable *drawable = &instance->drawable[d];

			if (drawable->skin == i && drawable->primitive->normal) {
				add_runs(sum, &uneven_matrix, uneven);
			}
		}
	}
}

static void add_all_runs(
	struct board_cost *sum, const struct fixed_skin *skin, int first)
{
	add_runs(sum, &skin_run_1, count_runs(skin, first, true));
	add_runs(sum, &skin_run, count_runs(skin, first, false));
}

struct board_cost board_cost_skin_left_out(const struct drawable *drawable)
{
	const struct fixed_skin *skin;
	struct board_cost cost = {0.0, 0.0};
	int posed;

	if (!drawable->fixed) {
		return cost;
	}
	skin = &drawable->fixed->skin;
	posed = fixed_skin_posed_count(skin, drawable->posed_lod);
	cost = board_cost_skin_vertices(drawable->primitive, skin->order + posed,
		skin->vertex_count - posed, skin->max_influences);
	cost = scaled(&cost, &skin_share);
	add_all_runs(
		&cost, skin, fixed_skin_group_count(skin, drawable->posed_lod));
	return cost;
}

static void add_skin(
	struct board_cost *sum, struct drawable *drawable, int max_influences)
{
	struct board_cost cost =
		board_cost_skin(drawable->primitive, max_influences);

	cost = scaled(&cost, &skin_share);
	board_cost_add(sum, &cost);
	if (drawable->fixed) {
		fixed_skin_set_cap(&drawable->fixed->skin, max_influences);
		add_all_runs(sum, &drawable->fixed->skin, 0);
	}
	board_cost_add(sum, &skin_drawable);
}

static void add_drawable(struct board_cost *sum, const struct playback *playback,
	struct drawable *drawable, int max_influences)
{
	const struct model_primitive *primitive = drawable->primitive;
	struct board_cost cost;

	if (drawable->skin >= 0) {
		add_skin(sum, drawable, max_influences);
	}
	if (drawable->fixed && drawable->fixed->keys) {
		cost = board_cost_keys(primitive->vertex_count,
			primitive->normal != NULL,
			drawable_target_count(playback->instance, drawable));
		board_cost_add(sum, &cost);
	} else if (drawable->morphed && drawable->fixed) {
		struct board_targets targets = count_targets(playback, drawable);

		cost = board_cost_targets(&targets);
		board_cost_add(sum, &cost);
		if (drawable->skin < 0) {
			board_cost_add(sum, &morph_drawable);
		}
	} else if (drawable->skin < 0) {
		cost = board_cost_solid(1);
		board_cost_add(sum, &cost);
		return;
	}
	cost = board_cost_gather(drawable);
	board_cost_add(sum, &cost);
}

static int count_joints(const struct model *model)
{
	int joints = 0;

	for (int i = 0; i < model->skin_count; i++) {
		joints += model->skin[i].joint_count;
	}
	return joints;
}

struct board_frame board_cost_clip(const struct model_clip *clip,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences, double rate_hz)
{
	const struct model *model = instance->model;
	const struct playback playback = {
		.clip = clip,
		.rate_hz = rate_hz,
		.frame_count = scalar_to_int(
			(double)clip->duration_s * rate_hz, 1, FRAMES_MAX),
		.instance = instance,
		.cursor = cursor,
	};
	struct board_frame frame = {
		.sample = board_cost_sample(clip, model->node_count),
		.matrices = board_cost_matrices(model->node_count,
			board_cost_count_roots(model), count_joints(model)),
	};

	add_uneven_nodes(&frame.matrices, &playback);
	add_normal_palettes(&frame.matrices, &playback);
	for (int i = 0; i < instance->drawable_count; i++) {
		add_drawable(&frame.vertices, &playback, &instance->drawable[i],
			max_influences);
	}
	return frame;
}

#include "app/cmd/command.h"

#include "app/anim/clip.h"
#include "app/cmd/options/options_kernel.h"
#include "app/model/origin/model_origin.h"
#include "app/scene/instance/bounds.h"
#include "app/scene/instance/instance.h"
#include "platform/base/output_file.h"

#include <errno.h>
#include <stdio.h>

/*
 * Successive drawables that are parts of one primitive of the file (split.h).
 */
struct parts {
	const struct drawable *drawable;
	int count;
	int vertex_count; /* of the file's primitive */
};

static struct parts find_parts(const struct instance *instance, int first)
{
	struct parts parts = {.drawable = &instance->drawable[first]};
	const struct drawable *drawable = parts.drawable;

	for (int i = first; i < instance->drawable_count &&
		drawable->node == parts.drawable->node &&
		drawable->primitive->file_index ==
			parts.drawable->primitive->file_index;
		i++, drawable++) {
		parts.count++;
		parts.vertex_count += drawable->primitive->vertex_count -
			drawable->primitive->repeated_count;
	}
	return parts;
}

/* The index that a part's vertex has in the file's primitive. */
static uint32_t file_vertex(
	const struct model_primitive *primitive, uint32_t vertex)
{
	return primitive->file_vertex ? primitive->file_vertex[vertex] : vertex;
}

/* A mirrored drawable's triangles are turned, so that they face outwards. */
static void write_triangles(FILE *out, const struct instance *instance,
	const struct drawable *drawable, uint32_t first_vertex)
{
	const struct model_primitive *primitive = drawable->primitive;
	int second = instance_is_mirrored(instance, drawable) ? 2 : 1;

	for (int i = 0; i + 2 < primitive->index_count; i += 3) {
		const uint32_t *index = primitive->index + i;

		fprintf(out, "f %u %u %u\n",
			file_vertex(primitive, index[0]) + first_vertex,
			file_vertex(primitive, index[second]) + first_vertex,
			file_vertex(primitive, index[3 - second]) + first_vertex);
	}
}

enum {
	DECIMALS = 6,
	DECIMALS_MOST = 45 /* of the least float */
};

/* Returns more decimals than usual for a model so small that it needs them. */
static int choose_decimals(const struct instance *instance)
{
	struct bounds box = bounds_of_instance(instance);
	float extent = bounds_extent(&box) / instance->unit_scale;
	int decimals = DECIMALS;

	while (extent > 0.0f && extent < 0.1f && decimals < DECIMALS_MOST) {
		extent *= 10.0f;
		decimals++;
	}
	return decimals;
}

/*
 * Writes an object. printf() writes decimal points: limber never sets a locale.
 */
static int write_parts(FILE *out, const struct instance *instance,
	const struct parts *parts, int decimals, uint32_t first_vertex)
{
	struct arena scratch = arena_within(instance->model->budget);
	float(*position)[3] = arena_alloc(
		&scratch, (size_t)parts->vertex_count, sizeof(*position));

	if (!position) {
		return -ENOMEM;
	}
	for (int i = 0; i < parts->count; i++) {
		const struct drawable *drawable = &parts->drawable[i];
		const struct model_primitive *primitive = drawable->primitive;

		for (int v = 0; v < primitive->vertex_count; v++) {
			instance_world_vertex(instance, drawable, v,
				position[file_vertex(primitive, (uint32_t)v)]);
		}
	}
	fprintf(out, "o node%d_prim%d\n",
		instance->model->node[parts->drawable->node].file_index,
		parts->drawable->primitive->file_index);
	for (int v = 0; v < parts->vertex_count; v++) {
		double p[3];

		model_origin_to_file(instance->model, position[v], p);
		fprintf(out, "v %.*f %.*f %.*f\n", decimals, p[0], decimals,
			p[1], decimals, p[2]);
	}
	arena_release(&scratch);
	for (int i = 0; i < parts->count; i++) {
		write_triangles(
			out, instance, &parts->drawable[i], first_vertex);
	}
	return 0;
}

static int write_obj(const struct instance *instance, const char *path,
	const struct log *log)
{
	struct output_file *file;
	struct parts parts;
	uint32_t first_vertex = 1;
	int decimals = choose_decimals(instance);
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	for (int i = 0; i < instance->drawable_count; i += parts.count) {
		parts = find_parts(instance, i);
		error = write_parts(output_file_stream(file), instance, &parts,
			decimals, first_vertex);
		if (error) {
			output_file_discard(file);
			return memory_budget_fail(instance->model->budget,
				instance->model->path, log);
		}
		first_vertex += (uint32_t)parts.vertex_count;
	}
	return output_file_commit(file);
}

static int pose_instance(struct instance *instance,
	const struct options *options, const struct log *log)
{
	struct clip_cursor cursor;
	int clip;
	int error = model_choose_clip(
		instance->model, options->motion.clip, -1, log, &clip);

	if (error) {
		return error;
	}
	error = clip_cursor_init(&cursor, instance->model, &instance->arena);
	if (error) {
		log_error(log, "%s: there is not enough memory to pose it",
			instance->model->path);
		return error;
	}
	if (clip >= 0) {
		/* More exact than clip_pose() if the file packs rotations. */
		clip_sample_as(&instance->model->clip[clip],
			(float)options->motion.time_s,
			options->motion.interpolation, &cursor, &instance->pose);
	}
	/* There is no camera, so auto means all influences. */
	if (options->vertices.influences.kind != INFLUENCE_CAP_DISTANCE) {
		instance->max_influences = influence_cap_choose(
			&options->vertices.influences, instance, NULL, 0.0f, 0);
	}
	instance_update(instance);
	if (instance_overflowed(instance)) {
		log_error(log,
			"%s: the pose exceeds the range of 16 bits: use --math float",
			instance->model->path);
		return -ERANGE;
	}
	return 0;
}

/* Poses are references for other programs, so float is the default. */
static const struct kernel *choose_kernel(
	const struct options *options, const struct log *log)
{
	struct options_vertices vertices = options->vertices;

	if (!vertices.kernel && vertices.math == MATH_ANY) {
		vertices.math = MATH_FLOAT;
	}
	return options_kernel(&vertices, log);
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	const struct kernel *kernel = choose_kernel(options, log);
	struct instance *instance;
	int error = instance_create(model, kernel, log, &instance);

	if (error) {
		return error;
	}
	error = pose_instance(instance, options, log);
	if (!error) {
		error = write_obj(instance, options->screen.output, log);
	}
	instance_destroy(instance);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	if (options->model_path && !options->screen.output) {
		log_error(log,
			"pose: there is no file to write: add -o FILE.obj");
		return EXIT_USAGE;
	}
	if (!choose_kernel(options, log)) {
		return EXIT_USAGE;
	}
	return command_run_with_model(
		&command_pose, options, log, run_with_model);
}

const struct command command_pose = {
	.name = "pose",
	.bit = FOR_POSE,
	.usage = "MODEL -o FILE.obj",
	.summary = "write posed vertices as Wavefront OBJ",
	.detail =
		"limber writes the vertices at one moment of a clip, in world space. Each primitive of each\n"
		"node becomes an object named node<N>_prim<P>, where N and P are its numbers in the model\n"
		"file; vertices keep their order. Times outside the clip are clamped. Without --clip limber\n"
		"writes the rest pose.\n"
		"\n"
		"  limber pose robot.glb --clip walk --time 0.4 -o walk.obj",
	.run = run,
};

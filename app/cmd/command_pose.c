#include "app/cmd/command.h"

#include "app/anim/clip.h"
#include "app/cmd/options/options_kernel.h"
#include "app/scene/instance/instance.h"
#include "platform/base/output_file.h"

#include <errno.h>
#include <stdio.h>

/* The decimal sign is a point: limber never sets a locale. */
static void write_drawable(FILE *out, const struct instance *instance,
	const struct drawable *drawable, int first_vertex)
{
	const struct model_primitive *primitive = drawable->primitive;

	fprintf(out, "o node%d_prim%d\n",
		instance->model->node[drawable->node].file_index,
		primitive->file_index);
	for (int i = 0; i < primitive->vertex_count; i++) {
		float p[3];

		instance_world_vertex(instance, drawable, i, p);
		fprintf(out, "v %.6f %.6f %.6f\n", p[0], p[1], p[2]);
	}
	for (int i = 0; i + 2 < primitive->index_count; i += 3) {
		fprintf(out, "f %u %u %u\n",
			primitive->index[i] + (uint32_t)first_vertex,
			primitive->index[i + 1] + (uint32_t)first_vertex,
			primitive->index[i + 2] + (uint32_t)first_vertex);
	}
}

static int write_obj(const struct instance *instance, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int first_vertex = 1;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		write_drawable(output_file_stream(file), instance,
			&instance->drawable[i], first_vertex);
		first_vertex += instance->drawable[i].primitive->vertex_count;
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
		/* More exact than clip_pose() where a file packs rotations. */
		clip_sample_as(&instance->model->clip[clip],
			(float)options->motion.time_s,
			options->motion.interpolation, &cursor, &instance->pose);
	}
	/* Without a camera, auto means all influences. */
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

/* Poses serve as references for other programs, so float is the default. */
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

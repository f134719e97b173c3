#include "app/model/xfile/xfile_scene.h"

#include <stddef.h>

static int parse_frame(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name);

static int parse_frame_matrix(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	int error = xfile_read_floats(
		reader, "a frame's matrix element", 16, scope->frame->matrix);

	(void)name;
	return error ? error : xfile_skip_rest(reader);
}

static int refer_in_frame(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name, size_t location)
{
	struct xfile_frame *frame = scope->frame;
	struct xfile_reference *reference =
		ARENA_NEW(reader->scratch, struct xfile_reference);

	if (!reference) {
		return xfile_no_memory(&reader->context);
	}
	reference->name = name;
	reference->location = location;
	XFILE_APPEND(frame->references, frame->last_reference, reference);
	return 0;
}

static const struct xfile_grammar frame_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"Frame", parse_frame},
			{"FrameTransformMatrix", parse_frame_matrix},
			{"Mesh", xfile_parse_mesh},
			{0},
		},
	.reference = refer_in_frame,
};

static int parse_frame(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_scope inner = *scope;
	struct xfile_scene *scene = scope->scene;
	struct xfile_frame *frame =
		ARENA_NEW(reader->scratch, struct xfile_frame);

	if (!frame) {
		return xfile_no_memory(&reader->context);
	}
	frame->name = name;
	frame->parent = scope->frame_index;
	for (int i = 0; i < 16; i += 5) {
		frame->matrix[i] = 1;
	}
	inner.frame = frame;
	inner.frame_index = scene->frame_count++;
	XFILE_APPEND(scene->frames, scene->last_frame, frame);
	return xfile_read_children(reader, &frame_grammar, &inner);
}

static int parse_ticks(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	size_t location = reader->token.location;
	double ticks;
	int error = xfile_read_double(reader, "AnimTicksPerSecond", &ticks);

	(void)name;
	if (error) {
		return error;
	}
	if (!(ticks > 0)) {
		return xfile_fail_at(&reader->context, location,
			"AnimTicksPerSecond is %g, but must be greater than 0",
			ticks);
	}
	scope->scene->ticks_per_second = ticks;
	scope->scene->has_ticks = true;
	return xfile_skip_rest(reader);
}

static const struct xfile_grammar top_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"AnimTicksPerSecond", parse_ticks},
			{"AnimationSet", xfile_parse_animation_set},
			{"Frame", parse_frame},
			{"Material", xfile_parse_material},
			{"Mesh", xfile_parse_mesh},
			{0},
		},
};

int xfile_parse(struct xfile_reader *reader, struct xfile_scene *scene)
{
	const struct xfile_scope scope = {.scene = scene, .frame_index = -1};

	scene->ticks_per_second = XFILE_TICKS_PER_SECOND;
	return xfile_read_top(reader, &top_grammar, &scope);
}

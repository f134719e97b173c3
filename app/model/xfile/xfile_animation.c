#include "app/model/xfile/xfile_scene.h"

static int read_key(
	struct xfile_reader *reader, struct xfile_keys *keys, uint32_t index)
{
	size_t width = (size_t)keys->width;
	size_t location = reader->token.location;
	uint32_t count;
	int error =
		xfile_read_double(reader, "a key's time", &keys->tick[index]);

	if (!error && keys->tick[index] < 0) {
		return xfile_fail_at(
			&reader->context, location, "a key's time is negative");
	}
	location = reader->token.location;
	if (!error) {
		error = xfile_read_integer(
			reader, "a key's number of values", &count);
	}
	if (!error && count != width) {
		return xfile_fail_at(&reader->context, location,
			"a key has %u values, but its type has %d",
			(unsigned)count, keys->width);
	}
	return error ? error
		     : xfile_read_floats(reader, "a key's value", width,
			       keys->value + index * width);
}

static int read_type(struct xfile_reader *reader, struct xfile_keys *keys)
{
	static const int width[] = {4, 3, 3, 16, 16};
	size_t location = reader->token.location;
	uint32_t type;
	int error = xfile_read_integer(reader, "an animation key's type", &type);

	if (error) {
		return error;
	}
	if (type > 4) {
		return xfile_fail_at(&reader->context, location,
			"the type of an animation key is %u, but must be 0 to 4",
			(unsigned)type);
	}
	keys->width = width[type];
	keys->type = type > XFILE_KEY_MATRIX ? XFILE_KEY_MATRIX
					     : (enum xfile_key_type)type;
	return 0;
}

static int parse_keys(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_animation *animation = scope->animation;
	struct xfile_keys *keys = ARENA_NEW(reader->scratch, struct xfile_keys);
	int error;

	(void)name;
	if (!keys) {
		return xfile_no_memory(&reader->context);
	}
	error = read_type(reader, keys);
	if (!error) {
		error = xfile_read_count(reader, "the count of keys",
			2 + (size_t)keys->width, &keys->count);
	}
	if (error) {
		return error;
	}
	keys->tick = ARENA_ARRAY(reader->scratch, double, keys->count);
	keys->value = ARENA_ARRAY(reader->scratch, float,
		(size_t)keys->count *(size_t)keys->width);
	if (!keys->tick || !keys->value) {
		return xfile_no_memory(&reader->context);
	}
	for (uint32_t i = 0; !error && i < keys->count; i++) {
		error = read_key(reader, keys, i);
	}
	if (keys->count) {
		XFILE_APPEND(animation->keys, animation->last_keys, keys);
	}
	return error ? error : xfile_skip_rest(reader);
}

static int refer_to_frame(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name, size_t location)
{
	(void)reader;
	scope->animation->frame = name;
	scope->animation->location = location;
	return 0;
}

static const struct xfile_grammar animation_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"AnimationKey", parse_keys},
			{0},
		},
	.reference = refer_to_frame,
};

static int parse_animation(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_scope inner = *scope;
	struct xfile_set *set = scope->set;
	struct xfile_animation *animation =
		ARENA_NEW(reader->scratch, struct xfile_animation);

	(void)name;
	if (!animation) {
		return xfile_no_memory(&reader->context);
	}
	inner.animation = animation;
	animation->location = reader->token.location;
	XFILE_APPEND(set->animations, set->last_animation, animation);
	return xfile_read_children(reader, &animation_grammar, &inner);
}

static const struct xfile_grammar set_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"Animation", parse_animation},
			{0},
		},
};

int xfile_parse_animation_set(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_scope inner = *scope;
	struct xfile_scene *scene = scope->scene;
	struct xfile_set *set = ARENA_NEW(reader->scratch, struct xfile_set);

	if (!set) {
		return xfile_no_memory(&reader->context);
	}
	inner.set = set;
	set->name = name;
	set->location = reader->token.location;
	scene->set_count++;
	XFILE_APPEND(scene->sets, scene->last_set, set);
	return xfile_read_children(reader, &set_grammar, &inner);
}

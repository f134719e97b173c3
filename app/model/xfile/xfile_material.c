#include "app/model/xfile/xfile_scene.h"

static int parse_texture(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	struct xfile_material *material = scope->material;
	int error;

	(void)name;
	material->texture_location = reader->token.location;
	error = xfile_read_string(
		reader, "a texture's file name", &material->texture);
	return error ? error : xfile_skip_rest(reader);
}

static const struct xfile_grammar material_grammar = {
	.kinds =
		(const struct xfile_kind[]){
			{"TextureFilename", parse_texture},
			{0},
		},
};

int xfile_parse_material(struct xfile_reader *reader,
	const struct xfile_scope *scope, const char *name)
{
	static const char what[] = "a material's colour or power";
	struct xfile_scope inner = *scope;
	struct xfile_scene *scene = scope->scene;
	struct xfile_material *material =
		ARENA_NEW(reader->scratch, struct xfile_material);
	int error;

	if (!material) {
		return xfile_no_memory(&reader->context);
	}
	inner.material = material;
	material->name = name;
	material->index = scene->material_count++;
	XFILE_APPEND(scene->materials, scene->last_material, material);
	error = xfile_read_floats(reader, what, 4, material->color);
	if (!error) {
		error = xfile_read_floats(reader, what, 1, &material->power);
	}
	if (!error) {
		error = xfile_read_floats(reader, what, 3, material->specular);
	}
	if (!error) {
		error = xfile_read_floats(reader, what, 3, material->emissive);
	}
	return error ? error
		     : xfile_read_children(reader, &material_grammar, &inner);
}

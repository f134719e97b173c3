#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <string.h>

static int read_positive(const struct gltf_at *at, const char *key, float *out)
{
	struct gltf_at member = gltf_member(at, key);
	int error = gltf_require(at, key);

	if (!error) {
		error = gltf_maybe_number(at, key, out);
	}
	if (!error && !(*out > 0)) {
		error = gltf_fail(&member, -EINVAL, "is not greater than 0");
	}
	return error;
}

static int read_far(const struct gltf_at *at, struct model_camera *out)
{
	struct gltf_at member = gltf_member(at, "zfar");
	int error = gltf_maybe_number(at, "zfar", &out->zfar);

	if (!error && member.json && !(out->zfar > out->znear)) {
		error = gltf_fail(&member, -EINVAL, "is not greater than znear");
	}
	return error;
}

static int read_perspective(const struct gltf_at *at, struct model_camera *out)
{
	struct gltf_at member = gltf_member(at, "aspectRatio");
	int error = read_positive(at, "yfov", &out->yfov_rad);

	out->perspective = true;
	if (!error) {
		error = read_positive(at, "znear", &out->znear);
	}
	if (!error) {
		error = gltf_maybe_number(at, "aspectRatio", &out->aspect);
	}
	if (!error && member.json && !(out->aspect > 0)) {
		error = gltf_fail(&member, -EINVAL, "is not greater than 0");
	}
	return error ? error : read_far(at, out);
}

static int read_orthographic(const struct gltf_at *at, struct model_camera *out)
{
	struct gltf_at member = gltf_member(at, "znear");
	int error = read_positive(at, "xmag", &out->xmag);

	if (!error) {
		error = read_positive(at, "ymag", &out->ymag);
	}
	if (!error) {
		error = gltf_require(at, "znear");
	}
	if (!error) {
		error = gltf_maybe_number(at, "znear", &out->znear);
	}
	if (!error && out->znear < 0) {
		error = gltf_fail(&member, -EINVAL, "is negative");
	}
	if (!error) {
		error = gltf_require(at, "zfar");
	}
	return error ? error : read_far(at, out);
}

static int read_camera(const struct gltf_at *at)
{
	struct model_camera *out = &at->gltf->model->camera[at->index];
	struct gltf_at member = gltf_member(at, "type");
	struct gltf_at details;
	const char *type = "";
	int error = gltf_name(at, &out->name);

	if (!error) {
		error = gltf_require(at, "type");
	}
	if (!error) {
		error = gltf_maybe_string(at, "type", &type);
	}
	if (error) {
		return error;
	}
	if (strcmp(type, "perspective") == 0) {
		error = gltf_object(at, "perspective", &details);
		return error ? error : read_perspective(&details, out);
	}
	if (strcmp(type, "orthographic") == 0) {
		error = gltf_object(at, "orthographic", &details);
		return error ? error : read_orthographic(&details, out);
	}
	return gltf_fail(
		&member, -EINVAL, "\"%.40s\" is not defined by glTF 2.0", type);
}

int gltf_read_cameras(struct gltf *gltf)
{
	struct model *model = gltf->model;
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "cameras", &array, &count);

	if (error) {
		return error;
	}
	model->camera = GLTF_KEEP(&array, struct model_camera, count);
	if (!model->camera) {
		return -ENOMEM;
	}
	model->camera_count = count;
	return gltf_for_each(&array, count, read_camera);
}

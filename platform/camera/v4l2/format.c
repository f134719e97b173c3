#include "platform/camera/v4l2/format.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "platform/base/compiler.h"

enum {
	OFFERED_MAX = 64,
	ROW_BYTES_MAX = 65536
};

/* The cheapest to convert comes first. */
static const struct {
	uint32_t fourcc;
	enum camera_format format;
} known[] = {
	{V4L2_PIX_FMT_RGB565, CAMERA_RGB565},
	{V4L2_PIX_FMT_UYVY, CAMERA_UYVY},
	{V4L2_PIX_FMT_YUYV, CAMERA_YUYV},
	{V4L2_PIX_FMT_NV12, CAMERA_NV12},
	{V4L2_PIX_FMT_YUV420, CAMERA_YUV420},
	{V4L2_PIX_FMT_RGB24, CAMERA_RGB24},
	{V4L2_PIX_FMT_BGR24, CAMERA_BGR24},
};

enum camera_format v4l2_format_of(uint32_t fourcc)
{
	for (size_t i = 0; i < ARRAY_COUNT(known); i++) {
		if (known[i].fourcc == fourcc) {
			return known[i].format;
		}
	}
	return CAMERA_FORMATS;
}

uint32_t v4l2_format_find(const char *name)
{
	enum camera_format format = camera_format_find(name);
	uint32_t fourcc = 0;

	for (size_t i = 0; i < ARRAY_COUNT(known); i++) {
		if (known[i].format == format) {
			return known[i].fourcc;
		}
	}
	if (strlen(name) != 4) {
		return 0;
	}
	for (int i = 0; i < 4; i++) {
		fourcc |= (uint32_t)toupper((unsigned char)name[i]) << 8 * i;
	}
	return fourcc;
}

void v4l2_format_text(uint32_t fourcc, char text[5])
{
	for (int i = 0; i < 4; i++) {
		unsigned char letter = (unsigned char)(fourcc >> 8 * i);

		text[i] = (char)(isprint(letter) ? letter : '?');
	}
	text[4] = '\0';
}

/* Lists the device's formats. Some drivers list none. */
static int list_offered(const struct v4l2_device *device, uint32_t *fourcc)
{
	int count = 0;

	while (count < OFFERED_MAX) {
		struct v4l2_fmtdesc offer = {
			.index = (uint32_t)count,
			.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		};

		if (device->calls->ioctl(device->calls->user, device->fd,
			    VIDIOC_ENUM_FMT, &offer) != 0) {
			break;
		}
		fourcc[count++] = offer.pixelformat;
	}
	return count;
}

/*
 * Whether a buffer is one picture to look at: a progressive one, both fields of
 * an interlaced one row by row, or always the same field. Others hold one field
 * behind the other, or either of them in turn, whose rows are not the same.
 */
static bool is_one_picture(uint32_t field)
{
	switch (field) {
	case V4L2_FIELD_ANY: /* old drivers leave it so */
	case V4L2_FIELD_NONE:
	case V4L2_FIELD_TOP:
	case V4L2_FIELD_BOTTOM:
	case V4L2_FIELD_INTERLACED:
	case V4L2_FIELD_INTERLACED_TB:
	case V4L2_FIELD_INTERLACED_BT:
		return true;
	default:
		return false;
	}
}

static bool is_readable(const struct v4l2_pix_format *pix)
{
	return pix->width >= 1 && pix->width <= CAMERA_SIDE_MAX &&
		pix->height >= 1 && pix->height <= CAMERA_SIDE_MAX &&
		pix->bytesperline <= ROW_BYTES_MAX;
}

/*
 * Sets a format. Returns -EINVAL when the device chose another one, -ENOTSUP
 * when it delivers fields apart from each other, -EFBIG when its size, which
 * is then in its answer, is not one that limber reads.
 */
static int try_field(struct v4l2_device *device,
	const struct v4l2_request *request, uint32_t fourcc, uint32_t field)
{
	struct v4l2_format wanted = {.type = V4L2_BUF_TYPE_VIDEO_CAPTURE};
	int error;

	/* priv must be zero: the i.MX31 vendor driver reads a pointer there. */
	wanted.fmt.pix.width = (uint32_t)request->width;
	wanted.fmt.pix.height = (uint32_t)request->height;
	wanted.fmt.pix.pixelformat = fourcc;
	wanted.fmt.pix.field = field;
	error = device->calls->ioctl(
		device->calls->user, device->fd, VIDIOC_S_FMT, &wanted);
	if (!error && wanted.fmt.pix.pixelformat != fourcc) {
		error = -EINVAL;
	}
	if (!error && !is_one_picture(wanted.fmt.pix.field)) {
		error = -ENOTSUP;
	}
	if (!error) {
		device->answer = wanted;
		error = is_readable(&wanted.fmt.pix) ? 0 : -EFBIG;
	}
	return error;
}

/*
 * Asks for progressive pictures. Some devices answer with separate fields, and
 * weave them into pictures only if asked to.
 */
static int try_fourcc(struct v4l2_device *device,
	const struct v4l2_request *request, uint32_t fourcc)
{
	int error = try_field(device, request, fourcc, V4L2_FIELD_NONE);

	return error == -ENOTSUP
		? try_field(device, request, fourcc, V4L2_FIELD_INTERLACED)
		: error;
}

static bool is_in(uint32_t fourcc, const uint32_t *list, int count)
{
	for (int i = 0; i < count; i++) {
		if (list[i] == fourcc) {
			return true;
		}
	}
	return false;
}

/* Keeps an error such as -EBUSY or -ENODEV rather than a refusal (-EINVAL). */
static int worse(int error, int other)
{
	return error == 0 || error == -EINVAL ? other : error;
}

static int choose(struct v4l2_device *device, const struct v4l2_request *request)
{
	uint32_t offered[OFFERED_MAX];
	int count = list_offered(device, offered);
	int error = -EINVAL;

	if (request->fourcc) {
		return try_fourcc(device, request, request->fourcc);
	}
	for (size_t i = 0; i < ARRAY_COUNT(known); i++) {
		int result;

		if (count && !is_in(known[i].fourcc, offered, count)) {
			continue;
		}
		result = try_fourcc(device, request, known[i].fourcc);
		if (!result) {
			return 0;
		}
		error = worse(error, result);
	}
	for (int i = 0; i < count; i++) {
		int result = try_fourcc(device, request, offered[i]);

		if (!result) {
			return 0;
		}
		error = worse(error, result);
	}
	return error;
}

/*
 * A device answers with the size nearest to the one that it was asked for.
 * Tells apart one that has smaller pictures, too.
 */
static void refuse_size(
	struct v4l2_device *device, const struct v4l2_request *request)
{
	const struct v4l2_pix_format *pix = &device->answer.fmt.pix;
	const struct v4l2_pix_format nearest = *pix;
	struct v4l2_request least = *request;

	least.width = least.height = 1;
	if (try_fourcc(device, &least, nearest.pixelformat) == 0) {
		snprintf(device->reason, sizeof(device->reason),
			"its pictures of %ux%u are too large: give a smaller size, such as %ux%u",
			nearest.width, nearest.height, pix->width, pix->height);
	} else {
		snprintf(device->reason, sizeof(device->reason),
			"it has no pictures that limber can read, of 1x1 to %dx%d pixels, but %ux%u in rows of %u bytes: choose another camera",
			CAMERA_SIDE_MAX, CAMERA_SIDE_MAX, nearest.width,
			nearest.height, nearest.bytesperline);
	}
}

static int refuse(struct v4l2_device *device,
	const struct v4l2_request *request, int error)
{
	char text[5];

	if (error == -EBUSY) {
		snprintf(device->reason, sizeof(device->reason),
			"another program is using it: close that program");
	} else if (error == -ENOTSUP) {
		snprintf(device->reason, sizeof(device->reason),
			"it delivers the two fields of interlaced video apart: choose a progressive input or another camera");
	} else if (error == -EFBIG) {
		refuse_size(device, request);
	} else if (error != -EINVAL) {
		snprintf(device->reason, sizeof(device->reason),
			"its format cannot be set (%s)", strerror(-error));
	} else if (request->fourcc) {
		v4l2_format_text(request->fourcc, text);
		snprintf(device->reason, sizeof(device->reason),
			"it does not deliver %s: give no format", text);
	} else {
		snprintf(device->reason, sizeof(device->reason),
			"it has no format of single-planar video: choose another camera");
	}
	return error;
}

int v4l2_format_negotiate(
	struct v4l2_device *device, const struct v4l2_request *request)
{
	const struct v4l2_pix_format *pix = &device->answer.fmt.pix;
	int error = choose(device, request);

	if (error) {
		return refuse(device, request, error);
	}
	device->width = (int)pix->width;
	device->height = (int)pix->height;
	device->format = v4l2_format_of(pix->pixelformat);
	return 0;
}

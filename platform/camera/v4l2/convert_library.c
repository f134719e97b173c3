#include "platform/camera/v4l2/convert_library.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include <libv4l-plugin.h>

#include "platform/base/compiler.h"
#include "platform/process/library.h"

enum {
	LIST_MAX = 64
};

struct v4lconvert_data;

struct convert_library {
	struct v4lconvert_data *data;
	struct v4l2_format source, rgb;

	struct v4lconvert_data *(*create)(
		int fd, void *user, const struct libv4l_dev_ops *calls);
	void (*destroy)(struct v4lconvert_data *data);
	int (*convert)(struct v4lconvert_data *data,
		const struct v4l2_format *source,
		const struct v4l2_format *destination, unsigned char *from,
		int from_size, unsigned char *to, int to_size);
};

static const struct library_slot slots[] = {
	{"v4lconvert_create_with_dev_ops",
		offsetof(struct convert_library, create)},
	{"v4lconvert_destroy", offsetof(struct convert_library, destroy)},
	{"v4lconvert_convert", offsetof(struct convert_library, convert)},
};

/* The functions of library must be NULL. */
static int load(struct convert_library *library)
{
	static const char *const names[] = {"libv4lconvert.so.0", NULL};
	void *handle = library_open(names, NULL);

	if (!handle ||
		library_fill(library, slots, (int)ARRAY_COUNT(slots),
			library_find, handle)) {
		return -ENOENT;
	}
	return 0;
}

bool convert_library_is_available(void)
{
	struct convert_library library = {.data = NULL};

	return load(&library) == 0;
}

/*
 * The library asks for the formats and sizes of index 0, 1, ... until the
 * device has no more. The limit ends this for a device whose lists never end.
 */
static bool is_beyond_lists(unsigned long request, const void *argument)
{
	uint32_t index; /* the first member of what these requests pass */

	if (request != VIDIOC_ENUM_FMT && request != VIDIOC_ENUM_FRAMESIZES &&
		request != VIDIOC_ENUM_FRAMEINTERVALS) {
		return false;
	}
	memcpy(&index, argument, sizeof(index));
	return index >= LIST_MAX;
}

/* The library queries the device through the driver's calls. */
static int query(void *user, int fd, unsigned long request, void *argument)
{
	const struct v4l2_calls *calls = user;
	int error = is_beyond_lists(request, argument)
		? -EINVAL
		: calls->ioctl(calls->user, fd, request, argument);

	errno = -error;
	return error ? -1 : 0;
}

static const struct libv4l_dev_ops operations = {.ioctl = query};

int convert_library_open(const struct v4l2_calls *calls, int fd,
	const struct v4l2_format *format, struct convert_library **out)
{
	struct convert_library *library = calloc(1, sizeof(*library));
	struct v4l2_pix_format *rgb;
	int error = -ENOMEM;

	if (!library) {
		return error;
	}
	error = load(library);
	if (error) {
		goto fail;
	}
	library->source = library->rgb = *format;
	rgb = &library->rgb.fmt.pix;
	rgb->pixelformat = V4L2_PIX_FMT_RGB24;
	rgb->bytesperline = rgb->width * 3;
	rgb->sizeimage = rgb->bytesperline * rgb->height;
	library->data = library->create(fd, (void *)calls, &operations);
	if (!library->data) {
		error = -EINVAL;
		goto fail;
	}
	*out = library;
	return 0;
fail:
	free(library);
	return error;
}

int convert_library_run(struct convert_library *library, const uint8_t *data,
	uint32_t size, uint8_t *rgb, int rgb_size)
{
	int written = library->convert(library->data, &library->source,
		&library->rgb, (unsigned char *)data, (int)size, rgb, rgb_size);

	return written == rgb_size ? 0 : -EIO;
}

void convert_library_close(struct convert_library *library)
{
	if (library) {
		library->destroy(library->data);
		free(library);
	}
}

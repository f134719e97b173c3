#include "app/model/gltf.h"

#include <errno.h>
#include <string.h>

bool gltf_recognise(const uint8_t *data, size_t size)
{
	size_t i = 0;

	if (size >= 4 && memcmp(data, "glTF", 4) == 0) {
		return true;
	}
	if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0) {
		i = 3;
	}
	while (i < size && strchr(" \t\r\n", data[i]) && data[i]) {
		i++;
	}
	return i < size && data[i] == '{';
}

int gltf_load(const struct model_source *source, const struct log *log,
	struct model **out)
{
	*out = NULL;
	log_error(log, "%s: cannot be read yet", source->name);
	return -ENOTSUP;
}

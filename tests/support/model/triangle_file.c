#include "tests/support/model/triangle_file.h"

#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdio.h>

void triangle_file_write(const char *path, const char *nodes)
{
	char text[4096];
	int length = snprintf(text, sizeof(text),
		"{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],"
		"\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/"
		"octet-stream;base64,"
		"AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}],"
		"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
		"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,"
		"\"count\":3,\"type\":\"VEC3\",\"min\":[0,0,0],"
		"\"max\":[1,1,0]}],\"meshes\":[{\"primitives\":"
		"[{\"attributes\":{\"POSITION\":0}}]}],\"nodes\":[%s]}",
		nodes);

	assert_in_range(length, 1, sizeof(text) - 1);
	file_write(path, text, (size_t)length);
}

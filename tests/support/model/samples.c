#include "tests/support/model/samples.h"

#include "tests/support/test.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct test_path samples_path(const char *name)
{
	const char *samples = getenv("SAMPLES");
	struct test_path path;

	snprintf(path.text, sizeof(path.text), "%s/models/%s",
		samples && *samples ? samples : "../shared", name);
	return path;
}

void samples_require(const char *name)
{
	struct test_path path = samples_path(name);

	if (access(path.text, R_OK) != 0) {
		skip_because(
			"the sample models are missing; SAMPLES=DIR names their folder");
	}
}

static bool is_model(const char *name)
{
	const char *dot = strrchr(name, '.');

	return dot &&
		(!strcmp(dot, ".glb") || !strcmp(dot, ".gltf") ||
			!strcmp(dot, ".x"));
}

int samples_each_model(const char *folder, void (*use)(const char *path))
{
	DIR *directory = opendir(folder);
	struct test_path parent;
	struct dirent *entry;
	int count = 0;

	if (!directory) {
		return 0;
	}
	snprintf(parent.text, sizeof(parent.text), "%s", folder);
	while ((entry = readdir(directory))) {
		if (is_model(entry->d_name)) {
			use(path_join(&parent, entry->d_name).text);
			count++;
		}
	}
	closedir(directory);
	return count;
}

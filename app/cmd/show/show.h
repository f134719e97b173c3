/*
 * Showing a demo or a model: what play and render have in common.
 */
#ifndef APP_CMD_SHOW_SHOW_H
#define APP_CMD_SHOW_SHOW_H

#include "app/cmd/options/options.h"
#include "app/demo/demo.h"

/* What differs between the commands that show. */
struct show_plan {
	const struct demo_driver *demo;
	const char *model_path;
	const char *display; /* a driver's name, or NULL to choose one */
	struct clock clock;
	double begin_s; /* frames before this are not drawn */
	int frames;     /* 0: until closed; -1: one period of the demo */
	bool unattended;
	/* Called when everything is open; or NULL. */
	void (*opened)(const struct demo_driver *demo, bool camera);
	bool follow_file; /* a model that changes is shown anew */
	bool progress;    /* show a bar on a terminal */
};

/*
 * The demo and the model file that the options ask for; the default demo when
 * they ask for none. path receives an asset's path. 0, -EINVAL after a
 * sentence for wrong usage, or -ENOENT.
 */
int show_choose(const struct options *options, const struct log *log,
	struct show_plan *plan, char *path, size_t size);

/* Opens all it needs, runs, closes. 0, or -errno after a sentence. */
int show_run(const struct show_plan *plan, const struct options *options,
	const struct log *log);

#endif

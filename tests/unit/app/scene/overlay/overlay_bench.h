/*
 * The overlays of a demo that runs without drawing, for tests that draw them by
 * themselves.
 */
#ifndef TESTS_UNIT_APP_SCENE_OVERLAY_OVERLAY_BENCH_H
#define TESTS_UNIT_APP_SCENE_OVERLAY_OVERLAY_BENCH_H

#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "tests/support/model/demo_run.h"

#include <cglm/cglm.h>

/* Tests set overlay->gl to gl, once that records. */
struct overlay_bench {
	struct demo_run run;
	struct gl gl;
	struct overlay *overlay;
	struct overlay_figure figure;
};

static inline void overlay_bench_begin(
	struct overlay_bench *bench, const char *name, unsigned kinds)
{
	const struct demo_base *base;

	demo_run_begin(&bench->run, name);
	demo_run_to(&bench->run, 0.2, 20.0, NULL, 0);
	base = (const struct demo_base *)bench->run.demo;
	demo_show_next_overlay(bench->run.driver, bench->run.demo);
	bench->overlay = base->overlay;
	bench->overlay->kinds = kinds;
	bench->overlay->camera = &base->stage.camera;
	bench->figure =
		(struct overlay_figure){.instance = base->actor.instance};
	glm_mat4_identity(bench->figure.place);
}

static inline void overlay_bench_end(struct overlay_bench *bench)
{
	bench->overlay->gl = &bench->run.gl;
	demo_run_end(&bench->run);
}

#endif

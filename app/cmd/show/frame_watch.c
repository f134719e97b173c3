#include "app/cmd/show/frame_watch.h"

#include "platform/process/clock.h"
#include "platform/process/process_memory.h"

#include <string.h>

enum {
	MEMORY_FRAMES = 32 /* between two readings of memory */
};

static const float ms_per_ns = 1e-6f;

void frame_watch_begin(struct frame_watch *watch)
{
	memset(watch->stage_ms, 0, sizeof(watch->stage_ms));
	watch->mark_ns = clock_monotonic_ns();
}

void frame_watch_stage(struct frame_watch *watch, enum hud_stage stage)
{
	int64_t now_ns = clock_monotonic_ns();

	watch->stage_ms[stage] += (float)(now_ns - watch->mark_ns) * ms_per_ns;
	watch->mark_ns = now_ns;
}

void frame_watch_end(struct frame_watch *watch)
{
	int64_t apart_ns =
		watch->ended_ns ? watch->mark_ns - watch->ended_ns : 0;

	watch->ended_ns = watch->mark_ns;
	if (apart_ns > 0) {
		hud_graph_add(&watch->graph, watch->stage_ms,
			(float)apart_ns * ms_per_ns);
	}
}

void frame_watch_show(struct frame_watch *watch, const struct demo_facts *facts,
	const char *driver, const char *reduction,
	const struct hud_place *beside, struct hud *hud)
{
	if (!watch->shown) {
		return;
	}
	if (watch->memory_wait-- == 0) {
		watch->memory_bytes = process_memory_bytes();
		watch->memory_wait = MEMORY_FRAMES;
	}
	hud_graph_show(&watch->graph,
		&(struct hud_facts){
			.technique = facts->technique,
			.driver = driver,
			.triangles = facts->triangles,
			.memory_bytes = watch->memory_bytes,
			.reduction = reduction,
		},
		beside, hud);
}

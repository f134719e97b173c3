/* Counts the runs that span functions draw, for counts.c. */
#include "platform/gl/soft/vertex/draw.h"

static void count_and_draw(const struct soft_run *run)
{
	run->draw->counted_runs += run->row_count;
	run->draw->spans.counted(run);
}

static void count_and_draw_anywhere(const struct soft_run *run)
{
	run->draw->counted_runs++;
	run->draw->counted_across++;
	run->draw->counted_across_pixels += run->row.count;
	run->draw->spans.counted_anywhere(run);
}

void soft_count_runs(struct soft_spans *spans)
{
	spans->counted = spans->draw;
	spans->draw = count_and_draw;
	if (spans->draw_anywhere != count_and_draw_anywhere) {
		spans->counted_anywhere = spans->draw_anywhere;
		spans->draw_anywhere = count_and_draw_anywhere;
	}
}

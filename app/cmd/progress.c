#include "app/cmd/progress.h"

#include "platform/process/clock.h"

#include <string.h>
#include <unistd.h>

enum {
	BAR_WIDTH = 40,
	DELAY_MS = 1000,
	REDRAW_MS = 100
};

struct progress progress_begin(int total, const char *unit, FILE *out)
{
	struct progress progress = {
		.total = total, .unit = unit, .start_ms = clock_monotonic_ms()};

	if (total > 1 && isatty(fileno(out))) {
		progress.out = out;
	}
	return progress;
}

void progress_step(struct progress *progress, int done)
{
	char bar[BAR_WIDTH + 1];
	int64_t now;
	int filled;

	if (!progress->out) {
		return;
	}
	now = clock_monotonic_ms();
	if (now - progress->start_ms < DELAY_MS ||
		now - progress->shown_ms < REDRAW_MS) {
		return;
	}
	filled = (int)((int64_t)done * BAR_WIDTH / progress->total);
	memset(bar, '-', BAR_WIDTH);
	memset(bar, '#', (size_t)(filled > BAR_WIDTH ? BAR_WIDTH : filled));
	bar[BAR_WIDTH] = '\0';
	fprintf(progress->out, "\r[%s] %d/%d %s", bar, done, progress->total,
		progress->unit);
	fflush(progress->out);
	progress->shown_ms = now;
	progress->visible = true;
}

void progress_end(struct progress *progress)
{
	if (progress->visible) {
		fprintf(progress->out, "\r%*s\r", BAR_WIDTH + 32, "");
		fflush(progress->out);
		progress->visible = false;
	}
}

#include "platform/buttons/button_batch.h"

void button_batch_add(struct button_batch *batch, struct button_event event)
{
	if (batch->count == BUTTON_BATCH_CAPACITY) {
		batch->count--;
	}
	batch->event[batch->count++] = event;
}

static void sort(struct button_batch *batch)
{
	for (int i = 1; i < batch->count; i++) {
		struct button_event event = batch->event[i];
		int at = i;

		for (; at > 0 && batch->event[at - 1].time_ms > event.time_ms;
			at--) {
			batch->event[at] = batch->event[at - 1];
		}
		batch->event[at] = event;
	}
}

void button_batch_push(struct button_batch *batch, struct button_queue *queue)
{
	sort(batch);
	for (int i = 0; i < batch->count; i++) {
		button_queue_push(queue, batch->event[i]);
	}
	batch->count = 0;
}

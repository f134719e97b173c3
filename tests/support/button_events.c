#include "tests/support/button_events.h"

#include "tests/support/test.h"

void button_push(
	struct button_queue *queue, int time_ms, enum button button, bool down)
{
	button_queue_push(queue,
		(struct button_event){
			.time_ms = time_ms, .button = button, .down = down});
}

void button_expect(
	struct button_queue *queue, int time_ms, enum button button, bool down)
{
	struct button_event event;

	assert_true(button_queue_pop(queue, &event));
	assert_int_equal(event.time_ms, time_ms);
	assert_int_equal(event.button, button);
	assert_int_equal(event.down, down);
	assert_int_equal(event.holder, 0);
}

void button_expect_nothing(struct button_queue *queue)
{
	struct button_event event;

	assert_false(button_queue_pop(queue, &event));
}

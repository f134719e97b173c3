#include "app/character/run/gestures.h"

#include "app/character/run/condition.h"
#include "app/character/run/pending.h"

static void add_all(struct character *character, enum button button,
	enum character_gesture gesture, float times)
{
	for (struct character_binding *one = character->binding; one;
		one = one->next) {
		if (one->button == button && one->gesture == gesture &&
			character_condition_holds(one->when)) {
			one->held = gesture == CHARACTER_HOLD;
			character_pending_add(character, one->action, times);
		}
	}
}

/* Runs what is bound to two buttons, if both are down now. */
static bool press_together(struct character *character, enum button button)
{
	for (const struct character_binding *one = character->binding; one;
		one = one->next) {
		enum button other = one->button == button ? one->second
			: one->second == button           ? one->button
							  : BUTTON_COUNT;

		if (one->gesture == CHARACTER_TOGETHER &&
			character_condition_holds(one->when) &&
			other != BUTTON_COUNT && character->button[other].down &&
			character->button[other].pending) {
			character->button[other].pending = false;
			character->button[other].used = true;
			character->button[button].used = true;
			character_pending_add(character, one->action, 1);
			return true;
		}
	}
	return false;
}

static void press(struct character *character, enum button which)
{
	struct character_button *button = &character->button[which];

	*button = (struct character_button){
		.joins = button->joins,
		.has_long = button->has_long,
		.down = true,
		.since_s = character->seen_s,
	};
	if (button->joins && press_together(character, which)) {
		return;
	}
	button->pending = button->joins || button->has_long;
	if (!button->pending) {
		add_all(character, which, CHARACTER_PRESS, 1);
	}
}

/*
 * What a held button has set goes back when it is released, whether or not the
 * section's conditions still hold.
 */
static void end_hold(struct character *character, enum button which)
{
	for (struct character_binding *one = character->binding; one;
		one = one->next) {
		if (one->button == which && one->held) {
			one->held = false;
			character_pending_add(character, one->after, 1);
		}
	}
}

static void release(struct character *character, enum button which)
{
	struct character_button *button = &character->button[which];

	if (!button->down) {
		return;
	}
	button->down = false;
	if (button->pending) {
		add_all(character, which, CHARACTER_PRESS, 1);
	}
	end_hold(character, which);
	if (!button->used) {
		add_all(character, which, CHARACTER_RELEASE, 1);
	}
}

void character_gestures_press(
	struct character *character, const struct button_event *event)
{
	if (event->button >= BUTTON_COUNT) {
		return;
	}
	if (event->down) {
		character->touring = false;
		press(character, event->button);
	} else {
		release(character, event->button);
	}
}

/* Ends the wait of a press: it is long, or it is not one of two. */
static void settle(struct character *character, enum button which)
{
	struct character_button *button = &character->button[which];
	double held_ms = (character->seen_s - button->since_s) * 1000;

	if (button->has_long) {
		if (!button->used && held_ms >= CHARACTER_LONG_MS) {
			button->pending = false;
			button->used = true;
			add_all(character, which, CHARACTER_LONG, 1);
		}
	} else if (button->pending && held_ms >= CHARACTER_TOGETHER_MS) {
		button->pending = false;
		add_all(character, which, CHARACTER_PRESS, 1);
	}
}

void character_gestures_update(struct character *character)
{
	for (int i = 0; i < BUTTON_COUNT; i++) {
		if (!character->button[i].down) {
			continue;
		}
		settle(character, (enum button)i);
		if (!character->button[i].used) {
			add_all(character, (enum button)i, CHARACTER_HOLD,
				character->real_s);
		}
	}
}

static void tour_to(struct character *character, double elapsed_s)
{
	while (character->tour_next &&
		character->tour_next->time_s <= elapsed_s) {
		character_pending_add(
			character, character->tour_next->action, 1);
		add_all(character, character->tour_next->button,
			CHARACTER_PRESS, 1);
		character->tour_next = character->tour_next->next;
	}
}

void character_tour_update(struct character *character)
{
	double period_s = character->scene.tour_s;
	double elapsed_s = character->now_s - character->tour_from_s;

	if (!character->touring || period_s <= 0) {
		return;
	}
	if (elapsed_s >= period_s) {
		/* What is due between the last frame and the period's end. */
		tour_to(character, period_s);
		character->tour_from_s += period_s;
		character->tour_next = character->scene.tour;
		elapsed_s -= period_s;
	}
	tour_to(character, elapsed_s);
}

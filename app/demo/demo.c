#include "app/demo/demo.h"

#include <string.h>

extern const struct demo_driver demo_driver_walker;
extern const struct demo_driver demo_driver_arm;
extern const struct demo_driver demo_driver_face;

const struct demo_driver *const demo_registry[] = {
	&demo_driver_walker,
	&demo_driver_arm,
	&demo_driver_face,
	NULL,
};

const struct demo_driver *demo_find(const char *name)
{
	for (int i = 0; demo_registry[i]; i++) {
		if (strcmp(demo_registry[i]->name, name) == 0) {
			return demo_registry[i];
		}
	}
	return NULL;
}

void demo_press(const struct demo_driver *driver, struct demo *demo,
	const struct button_event *event)
{
	for (const struct demo_action *action = driver->action; action->run;
		action++) {
		if (action->button == event->button) {
			action->run(demo, event->down);
		}
	}
}

#include "platform/buttons/buttons.h"

#define BUTTON_DRIVER(name) \
	extern const struct button_driver button_driver_##name;
#include "button_drivers.h"
#undef BUTTON_DRIVER

const struct button_driver *const button_registry[] = {
#define BUTTON_DRIVER(name) &button_driver_##name,
#include "button_drivers.h"
#undef BUTTON_DRIVER
	0,
};

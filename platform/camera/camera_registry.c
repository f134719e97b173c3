#include "platform/camera/camera.h"

#define CAMERA_DRIVER(name) \
	extern const struct camera_driver camera_driver_##name;
#include "camera_drivers.h"
#undef CAMERA_DRIVER

const struct camera_driver *const camera_registry[] = {
#define CAMERA_DRIVER(name) &camera_driver_##name,
#include "camera_drivers.h"
#undef CAMERA_DRIVER
	0,
};

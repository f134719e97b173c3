#include "platform/buttons/evdev/decode.h"

#include <string.h>

struct evdev_event evdev_decode(const unsigned char *bytes, size_t size)
{
	struct evdev_event event;

	if (size == EVDEV_SIZE_64) {
		int64_t time[2];

		memcpy(time, bytes, sizeof(time));
		event.stamp_ns = time[0] * 1000000000 + time[1] * 1000;
	} else {
		uint32_t time[2];

		memcpy(time, bytes, sizeof(time));
		event.stamp_ns =
			(int64_t)time[0] * 1000000000 + (int64_t)time[1] * 1000;
	}
	bytes += size - 8;
	memcpy(&event.type, bytes, sizeof(event.type));
	memcpy(&event.code, bytes + 2, sizeof(event.code));
	memcpy(&event.value, bytes + 4, sizeof(event.value));
	return event;
}

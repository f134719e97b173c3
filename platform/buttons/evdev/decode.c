#include "platform/buttons/evdev/decode.h"

#include <string.h>

/* Returns -1 for numbers that are no time, which a driver may send. */
static int64_t stamp_of(int64_t seconds, int64_t microseconds)
{
	static const int64_t seconds_max = INT64_C(9000000000);

	if (seconds < 0 || seconds > seconds_max || microseconds < 0 ||
		microseconds > 999999) {
		return -1;
	}
	return seconds * 1000000000 + microseconds * 1000;
}

struct evdev_event evdev_decode(const unsigned char *bytes, size_t size)
{
	struct evdev_event event;

	if (size == EVDEV_SIZE_64) {
		int64_t time[2];

		memcpy(time, bytes, sizeof(time));
		event.stamp_ns = stamp_of(time[0], time[1]);
	} else {
		uint32_t time[2];

		memcpy(time, bytes, sizeof(time));
		event.stamp_ns = stamp_of(time[0], time[1]);
	}
	bytes += size - 8;
	memcpy(&event.type, bytes, sizeof(event.type));
	memcpy(&event.code, bytes + 2, sizeof(event.code));
	memcpy(&event.value, bytes + 4, sizeof(event.value));
	return event;
}

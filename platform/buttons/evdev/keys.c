#include "platform/buttons/evdev/keys.h"

#include <errno.h>
#include <linux/input-event-codes.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"

static const struct {
	uint16_t code;
	uint8_t button;
} defaults[] = {
	{KEY_UP, BUTTON_UP},
	{KEY_DOWN, BUTTON_DOWN},
	{KEY_LEFT, BUTTON_LEFT},
	{KEY_RIGHT, BUTTON_RIGHT},
	{KEY_ENTER, BUTTON_ENTER},
	{KEY_F6, BUTTON_F6},
	{KEY_F8, BUTTON_F8},
	{KEY_F9, BUTTON_F9},
	{KEY_F10, BUTTON_F10},
	{KEY_KP8, BUTTON_UP},
	{KEY_KP2, BUTTON_DOWN},
	{KEY_KP4, BUTTON_LEFT},
	{KEY_KP6, BUTTON_RIGHT},
	{KEY_KPENTER, BUTTON_ENTER},
	{KEY_OK, BUTTON_ENTER},
	{KEY_SELECT, BUTTON_ENTER},
	{BTN_DPAD_UP, BUTTON_UP},
	{BTN_DPAD_DOWN, BUTTON_DOWN},
	{BTN_DPAD_LEFT, BUTTON_LEFT},
	{BTN_DPAD_RIGHT, BUTTON_RIGHT},
};

#define NAMED(code)         \
	{                   \
#code, code \
	}
/* clang-format off */
static const struct {
	const char *name;
	uint16_t code;
} names[] = {
	NAMED(KEY_ESC), NAMED(KEY_1), NAMED(KEY_2), NAMED(KEY_3),
	NAMED(KEY_4), NAMED(KEY_5), NAMED(KEY_6), NAMED(KEY_7),
	NAMED(KEY_8), NAMED(KEY_9), NAMED(KEY_0), NAMED(KEY_MINUS),
	NAMED(KEY_EQUAL), NAMED(KEY_BACKSPACE), NAMED(KEY_TAB),
	NAMED(KEY_A), NAMED(KEY_B), NAMED(KEY_C), NAMED(KEY_D),
	NAMED(KEY_E), NAMED(KEY_F), NAMED(KEY_G), NAMED(KEY_H),
	NAMED(KEY_I), NAMED(KEY_J), NAMED(KEY_K), NAMED(KEY_L),
	NAMED(KEY_M), NAMED(KEY_N), NAMED(KEY_O), NAMED(KEY_P),
	NAMED(KEY_Q), NAMED(KEY_R), NAMED(KEY_S), NAMED(KEY_T),
	NAMED(KEY_U), NAMED(KEY_V), NAMED(KEY_W), NAMED(KEY_X),
	NAMED(KEY_Y), NAMED(KEY_Z), NAMED(KEY_ENTER), NAMED(KEY_SPACE),
	NAMED(KEY_LEFTCTRL), NAMED(KEY_LEFTSHIFT), NAMED(KEY_LEFTALT),
	NAMED(KEY_RIGHTCTRL), NAMED(KEY_RIGHTSHIFT), NAMED(KEY_RIGHTALT),
	NAMED(KEY_F1), NAMED(KEY_F2), NAMED(KEY_F3), NAMED(KEY_F4),
	NAMED(KEY_F5), NAMED(KEY_F6), NAMED(KEY_F7), NAMED(KEY_F8),
	NAMED(KEY_F9), NAMED(KEY_F10), NAMED(KEY_F11), NAMED(KEY_F12),
	NAMED(KEY_KP0), NAMED(KEY_KP1), NAMED(KEY_KP2), NAMED(KEY_KP3),
	NAMED(KEY_KP4), NAMED(KEY_KP5), NAMED(KEY_KP6), NAMED(KEY_KP7),
	NAMED(KEY_KP8), NAMED(KEY_KP9), NAMED(KEY_KPENTER),
	NAMED(KEY_KPPLUS), NAMED(KEY_KPMINUS), NAMED(KEY_KPASTERISK),
	NAMED(KEY_KPSLASH), NAMED(KEY_KPDOT), NAMED(KEY_HOME),
	NAMED(KEY_END), NAMED(KEY_PAGEUP), NAMED(KEY_PAGEDOWN),
	NAMED(KEY_INSERT), NAMED(KEY_DELETE), NAMED(KEY_UP),
	NAMED(KEY_DOWN), NAMED(KEY_LEFT), NAMED(KEY_RIGHT),
	NAMED(KEY_MENU), NAMED(KEY_BACK), NAMED(KEY_HOMEPAGE),
	NAMED(KEY_POWER), NAMED(KEY_VOLUMEUP), NAMED(KEY_VOLUMEDOWN),
	NAMED(KEY_MUTE), NAMED(KEY_PLAYPAUSE), NAMED(KEY_CAMERA),
	NAMED(KEY_SEARCH), NAMED(KEY_OK), NAMED(KEY_SELECT),
	NAMED(BTN_0), NAMED(BTN_1), NAMED(BTN_2), NAMED(BTN_3),
	NAMED(BTN_SOUTH), NAMED(BTN_EAST), NAMED(BTN_NORTH),
	NAMED(BTN_WEST), NAMED(BTN_TL), NAMED(BTN_TR), NAMED(BTN_SELECT),
	NAMED(BTN_START), NAMED(BTN_DPAD_UP), NAMED(BTN_DPAD_DOWN),
	NAMED(BTN_DPAD_LEFT), NAMED(BTN_DPAD_RIGHT),
};
/* clang-format on */

struct evdev_keys evdev_keys_default(void)
{
	struct evdev_keys keys;

	memset(keys.button, BUTTON_COUNT, sizeof(keys.button));
	for (size_t i = 0; i < ARRAY_COUNT(defaults); i++) {
		keys.button[defaults[i].code] = defaults[i].button;
	}
	return keys;
}

/* The code of a key's name or number, or -1. */
static int find_code(const char *name)
{
	char *end;
	long value;

	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		if (strcmp(names[i].name, name) == 0) {
			return names[i].code;
		}
	}
	if (*name < '0' || *name > '9') {
		return -1;
	}
	errno = 0;
	value = strtol(name, &end, 0);
	return errno || *end || value < 1 || value >= EVDEV_KEYS ? -1
								 : (int)value;
}

int evdev_keys_read(
	struct evdev_keys *keys, const char *text, const struct log *log)
{
	size_t length = strcspn(text, "=");
	char name[8];
	enum button button = BUTTON_COUNT;
	int code;

	if (length < sizeof(name)) {
		memcpy(name, text, length);
		name[length] = '\0';
		button = button_from_name(name);
	}
	if (button == BUTTON_COUNT) {
		log_error(log,
			"evdev:%s: no such button: choose UP, DOWN, LEFT, RIGHT, ENTER, F6, F8, F9 or F10",
			text);
		return -EINVAL;
	}
	code = find_code(text + length + (text[length] == '='));
	if (code < 0) {
		log_error(log,
			"evdev:%s: no such key: give a name such as KEY_W, or a number from 1 to 767 that evtest shows",
			text);
		return -EINVAL;
	}
	keys->button[code] = (uint8_t)button;
	return 0;
}

enum button evdev_keys_find(const struct evdev_keys *keys, unsigned int code)
{
	return code < EVDEV_KEYS ? (enum button)keys->button[code]
				 : BUTTON_COUNT;
}

bool evdev_key_bit(const uint8_t bits[EVDEV_KEY_BYTES], unsigned int code)
{
	return code < EVDEV_KEYS && (bits[code / 8] >> code % 8 & 1);
}

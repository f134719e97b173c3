/*
 * A program for the emulated board, for what its shell cannot do.
 *
 *   guest key NAME...        plugs a keyboard in, presses the keys, unplugs it
 *   guest control DEV ID N   sets a V4L2 control; numbers may be hexadecimal
 *   guest ubi N              attaches UBI to the flash partition mtdN
 */
#include <errno.h>
#include <fcntl.h>
#include <linux/uinput.h>
#include <linux/videodev2.h>
#include <mtd/ubi-user.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

static const struct {
	const char *name;
	unsigned short code;
} keys[] = {
	{"UP", KEY_UP},
	{"DOWN", KEY_DOWN},
	{"LEFT", KEY_LEFT},
	{"RIGHT", KEY_RIGHT},
	{"ENTER", KEY_ENTER},
	{"F6", KEY_F6},
	{"F8", KEY_F8},
	{"F9", KEY_F9},
	{"F10", KEY_F10},
};

enum {
	KEY_COUNT = sizeof(keys) / sizeof(keys[0])
};

static int fail(const char *what)
{
	fprintf(stderr, "guest: %s: %s\n", what, strerror(errno));
	return 1;
}

static void wait_ms(long ms)
{
	struct timespec time = {ms / 1000, ms % 1000 * 1000000};

	nanosleep(&time, NULL);
}

static void emit(int fd, unsigned short type, unsigned short code, int value)
{
	struct input_event event = {.type = type, .code = code, .value = value};

	if (write(fd, &event, sizeof(event)) != (ssize_t)sizeof(event)) {
		exit(fail("/dev/uinput"));
	}
}

static int press_keys(char **names)
{
	struct uinput_setup setup = {
		.id = {.bustype = BUS_USB}, .name = "test keyboard"};
	int fd = open("/dev/uinput", O_WRONLY);

	if (fd < 0 || ioctl(fd, UI_SET_EVBIT, EV_KEY)) {
		return fail("/dev/uinput");
	}
	for (int i = 0; i < KEY_COUNT; i++) {
		ioctl(fd, UI_SET_KEYBIT, keys[i].code);
	}
	if (ioctl(fd, UI_DEV_SETUP, &setup) || ioctl(fd, UI_DEV_CREATE)) {
		return fail("/dev/uinput");
	}
	wait_ms(3000);
	for (; *names; names++) {
		for (int i = 0; i < KEY_COUNT; i++) {
			if (strcmp(*names, keys[i].name) == 0) {
				emit(fd, EV_KEY, keys[i].code, 1);
				emit(fd, EV_SYN, SYN_REPORT, 0);
				wait_ms(100);
				emit(fd, EV_KEY, keys[i].code, 0);
				emit(fd, EV_SYN, SYN_REPORT, 0);
				wait_ms(100);
			}
		}
	}
	wait_ms(200);
	ioctl(fd, UI_DEV_DESTROY);
	close(fd);
	return 0;
}

static int set_control(const char *path, const char *id, const char *value)
{
	struct v4l2_control control = {
		.id = (unsigned int)strtoul(id, NULL, 0),
		.value = (int)strtol(value, NULL, 0),
	};
	int fd = open(path, O_RDWR);

	if (fd < 0 || ioctl(fd, VIDIOC_S_CTRL, &control)) {
		return fail(path);
	}
	close(fd);
	return 0;
}

static int attach_ubi(const char *number)
{
	struct ubi_attach_req request = {
		.ubi_num = UBI_DEV_NUM_AUTO, .mtd_num = atoi(number)};
	int fd = open("/dev/ubi_ctrl", O_RDONLY);

	if (fd < 0 || ioctl(fd, UBI_IOCATT, &request)) {
		return fail("/dev/ubi_ctrl");
	}
	close(fd);
	return 0;
}

int main(int argc, char **argv)
{
	if (argc > 2 && strcmp(argv[1], "key") == 0) {
		return press_keys(argv + 2);
	}
	if (argc == 5 && strcmp(argv[1], "control") == 0) {
		return set_control(argv[2], argv[3], argv[4]);
	}
	if (argc == 3 && strcmp(argv[1], "ubi") == 0) {
		return attach_ubi(argv[2]);
	}
	fputs("usage: guest key NAME... | control DEV ID N | ubi N\n", stderr);
	return 2;
}

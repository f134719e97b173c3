/*
 * A program for the emulated board, for what its shell cannot do.
 *
 *   guest key NAME...        plugs a keyboard in, presses the keys, unplugs it
 *   guest control DEV ID N   sets a V4L2 control; numbers may be hexadecimal
 *   guest ubi N              attaches UBI to the flash partition mtdN
 *   guest flip N             shows N pictures of one colour on two pages, and
 *                            prints the time and the processor's time in us
 */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/uinput.h>
#include <linux/videodev2.h>
#include <mtd/ubi-user.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
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

static long long now_us(clockid_t clock)
{
	struct timespec time;

	clock_gettime(clock, &time);
	return (long long)time.tv_sec * 1000000 + time.tv_nsec / 1000;
}

static int flip_pages(const char *path, int flips)
{
	struct fb_fix_screeninfo fix;
	struct fb_var_screeninfo var;
	long long begun_us, spent_us = 0;
	size_t page_bytes;
	char *pages;
	int fd = open(path, O_RDWR);

	if (fd < 0 || ioctl(fd, FBIOGET_FSCREENINFO, &fix) ||
		ioctl(fd, FBIOGET_VSCREENINFO, &var)) {
		return fail(path);
	}
	page_bytes = (size_t)fix.line_length * var.yres;
	pages = mmap(NULL, 2 * page_bytes, PROT_READ | PROT_WRITE, MAP_SHARED,
		fd, 0);
	if (pages == MAP_FAILED) {
		return fail(path);
	}
	begun_us = now_us(CLOCK_MONOTONIC);
	for (int i = 0; i < flips; i++) {
		var.yoffset = var.yoffset ? 0 : var.yres;
		memset(pages + (var.yoffset ? page_bytes : 0), 1 + i,
			page_bytes);
		spent_us -= now_us(CLOCK_PROCESS_CPUTIME_ID);
		if (ioctl(fd, FBIOPAN_DISPLAY, &var)) {
			return fail("FBIOPAN_DISPLAY");
		}
		spent_us += now_us(CLOCK_PROCESS_CPUTIME_ID);
	}
	printf("%lld us\n%lld us of the processor\n",
		now_us(CLOCK_MONOTONIC) - begun_us, spent_us);
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
	if (argc == 3 && strcmp(argv[1], "flip") == 0) {
		return flip_pages("/dev/fb0", atoi(argv[2]));
	}
	fputs("usage: guest key NAME... | control DEV ID N | ubi N | flip N\n",
		stderr);
	return 2;
}

/* The buffers of the made-up card. */
#include "tests/support/fake/fake_card_parts.h"

#include <errno.h>

#include "tests/support/test.h"

enum {
	EXTRA_PITCH = 8
};

int fake_card_create_dumb(int fd, uint32_t width, uint32_t height, uint32_t bits,
	uint32_t flags, uint32_t *handle, uint32_t *pitch, uint64_t *size)
{
	int i = fake_card.buffers[0].used;

	(void)fd;
	assert_int_equal(flags, 0);
	if (fake_card_fails(CALL_CREATE)) {
		return -fake_card.fail_error;
	}
	assert_false(fake_card.buffers[i].used);
	fake_card.buffers[i].used = true;
	fake_card.buffers[i].pitch = width * bits / 8 + EXTRA_PITCH;
	*handle = (uint32_t)i + 1;
	*pitch = fake_card.buffers[i].pitch;
	*size = (uint64_t)*pitch * height;
	return 0;
}

int fake_card_map_dumb(int fd, uint32_t handle, uint64_t *offset)
{
	(void)fd;
	if (fake_card_fails(CALL_MAP_DUMB)) {
		return -fake_card.fail_error;
	}
	*offset = handle * 4096;
	return 0;
}

int fake_card_destroy_dumb(int fd, uint32_t handle)
{
	(void)fd;
	assert_true(fake_card.buffers[handle - 1].used);
	fake_card.buffers[handle - 1].used = false;
	return 0;
}

int fake_card_add_fb(int fd, uint32_t width, uint32_t height, uint32_t fourcc,
	const uint32_t handles[4], const uint32_t pitches[4],
	const uint32_t offsets[4], uint32_t *id, uint32_t flags)
{
	(void)fd;
	assert_int_equal(flags + offsets[0] + handles[1], 0);
	assert_true(pitches[0] >= width && height > 0);
	if (fake_card_fails(CALL_ADD)) {
		return -fake_card.fail_error;
	}
	for (int i = 0; i < 3; i++) {
		if (fake_card.fourccs[i] == fourcc) {
			fake_card.buffers[handles[0] - 1].added = true;
			fake_card.buffers[handles[0] - 1].fourcc = fourcc;
			*id = handles[0];
			return 0;
		}
	}
	errno = EINVAL;
	return -EINVAL;
}

int fake_card_remove_fb(int fd, uint32_t id)
{
	(void)fd;
	assert_true(fake_card.buffers[id - 1].added);
	assert_int_not_equal(fake_card.flip_fb, id);
	fake_card.buffers[id - 1].added = false;
	return 0;
}

/*
 * Decompression of .x files: blocks of all sizes, and the sentence and the byte
 * of each mistake. The blocks are stored ones, which every inflater reads.
 */
#include "app/model/xfile/xfile_inflate.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

enum {
	STORED_BYTES = 5, /* before the bytes of a stored block */
	MOST = 3 * 33000
};

/* A compressed body that is being written. */
static struct {
	uint8_t byte[MOST];
	size_t size;
} body;

static void put(size_t number, int bytes)
{
	for (int i = 0; i < bytes; i++) {
		body.byte[body.size++] = (uint8_t)(number >> 8 * i);
	}
}

static void begin(size_t total)
{
	body.size = 0;
	put(total, 4);
}

static uint8_t content(size_t at)
{
	return (uint8_t)(at * 31 + at / 256);
}

/* A block of bytes that go on from those before it, and its sizes. */
static void put_block(size_t from, size_t bytes)
{
	put(bytes, 2);
	put(bytes + STORED_BYTES + 2, 2);
	put('C' | 'K' << 8, 2);
	put(1, 1);
	put(bytes, 2);
	put(~bytes, 2);
	for (size_t i = 0; i < bytes; i++) {
		body.byte[body.size++] = content(from + i);
	}
}

/* Decompresses the body and gives back all memory. */
static int unpack(struct log_capture *heard, size_t *size)
{
	struct log log = log_capture_begin(heard);
	struct memory_budget budget = {.limit_bytes = 1 << 20};
	const struct xfile_context context = {
		.path = "x", .log = &log, .budget = &budget};
	struct xfile_unpacked unpacked;
	int error = xfile_inflate(&context, body.byte, body.size, &unpacked);

	*size = unpacked.size;
	if (!error) {
		assert_true(unpacked.taken_bytes > unpacked.size);
		assert_int_equal(budget.used_bytes, unpacked.taken_bytes);
		for (size_t i = 0; i < unpacked.size; i++) {
			assert_int_equal(unpacked.data[i], content(i));
		}
		xfile_unpacked_release(&unpacked, &context);
	}
	assert_null(unpacked.data);
	assert_int_equal(budget.used_bytes, 0);
	return error;
}

static void expect_error(int wanted, const char *sentence)
{
	struct log_capture heard;
	size_t size;

	assert_int_equal(unpack(&heard, &size), wanted);
	assert_int_equal(heard.count, 1);
	assert_string_equal(heard.sentence[0], sentence);
}

static void test_blocks_follow_each_other(void **state)
{
	static const size_t blocks[][3] = {{0}, {1}, {258}, {32768},
		{32767, 1, 258}, {1, 32768, 32768}, {32768, 32768, 1}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(blocks); i++) {
		const size_t *block = blocks[i];
		struct log_capture heard;
		size_t size, at = 0;

		begin(16 + block[0] + block[1] + block[2]);
		for (int b = 0; b < 3 && block[b]; at += block[b++]) {
			put_block(at, block[b]);
		}
		assert_int_equal(unpack(&heard, &size), 0);
		assert_int_equal(size, at);
		assert_int_equal(heard.count, 0);
	}
}

static void test_the_size_has_four_bytes_and_a_limit(void **state)
{
	(void)state;
	begin(0x12345678);
	expect_error(-EFBIG,
		"x: the decompressed file has 305419896 bytes; limber reads up to 268435456");
	begin(XFILE_UNPACKED_MAX + 1);
	expect_error(-EFBIG,
		"x: the decompressed file has 268435457 bytes; limber reads up to 268435456");
	begin(XFILE_UNPACKED_MAX);
	expect_error(-EINVAL, "x: byte 20: the compressed data is truncated");
	begin(15);
	expect_error(-EINVAL,
		"x: byte 16: the decompressed size is smaller than a header");
	body.size = 3;
	expect_error(-EINVAL, "x: byte 16: the compressed data is truncated");
}

static void test_a_block_that_ends_early_is_refused(void **state)
{
	const size_t whole = 4 + 6 + STORED_BYTES + 300;

	(void)state;
	for (size_t size = 4; size < whole; size++) {
		begin(16 + 300);
		put_block(0, 300);
		assert_int_equal(body.size, whole);
		body.size = size;
		expect_error(-EINVAL,
			"x: byte 20: the compressed data is truncated");
	}
}

/* The second block begins at byte 16 + 4 + 6 + 5 + 3. */
static void test_a_wrong_block_is_refused_with_its_place(void **state)
{
	static const struct {
		size_t at; /* behind the begin of the second block */
		uint8_t byte;
		const char *sentence;
	} rows[] = {
		{0, 6, "x: byte 40: the compressed data is longer than the header claims"},
		{0, 4, "x: byte 40: the compressed block is damaged"},
		{1, 0x80,
			"x: byte 40: a compressed block has more than 32768 bytes"},
		{2, 1, "x: byte 34: the compressed data is truncated"},
		{2, 2, "x: byte 40: the compressed block is damaged"},
		{2, 11, "x: byte 40: the compressed block is damaged"},
		{2, 13, "x: byte 34: the compressed data is truncated"},
		{3, 1, "x: byte 34: the compressed data is truncated"},
		{4, 'D', "x: byte 34: a compressed block does not begin with CK"},
		{5, 'L', "x: byte 34: a compressed block does not begin with CK"},
		{7, 4, "x: byte 40: the compressed block is damaged"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		begin(16 + 8);
		put_block(0, 3);
		put_block(3, 5);
		body.byte[18 + rows[i].at] = rows[i].byte;
		expect_error(-EINVAL, rows[i].sentence);
	}
}

static void test_the_budget_limits_what_is_decompressed(void **state)
{
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);
	struct memory_budget budget = {.limit_bytes = 32768};
	const struct xfile_context context = {
		.path = "x", .log = &log, .budget = &budget};
	struct xfile_unpacked unpacked;

	(void)state;
	begin(16 + 32767);
	put_block(0, 32767);
	assert_int_equal(
		xfile_inflate(&context, body.byte, body.size, &unpacked), 0);
	assert_int_equal(unpacked.size, 32767);
	assert_int_equal(unpacked.taken_bytes, 32768);
	xfile_unpacked_release(&unpacked, &context);
	/* A zero behind the bytes needs room, too. */
	begin(16 + 32768);
	put_block(0, 32768);
	assert_int_equal(
		xfile_inflate(&context, body.byte, body.size, &unpacked),
		-ENOMEM);
	assert_null(unpacked.data);
	assert_int_equal(budget.used_bytes, 0);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_blocks_follow_each_other),
		cmocka_unit_test(test_the_size_has_four_bytes_and_a_limit),
		cmocka_unit_test(test_a_block_that_ends_early_is_refused),
		cmocka_unit_test(test_a_wrong_block_is_refused_with_its_place),
		cmocka_unit_test(test_the_budget_limits_what_is_decompressed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

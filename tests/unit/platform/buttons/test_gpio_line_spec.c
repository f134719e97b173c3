#include "platform/buttons/gpiod/gpio_line_spec.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define NAME_63 \
	"a23456789b123456789c123456789d123456789e123456789f123456789g123"

/* What stands behind "BUTTON=", or alone for an output, and what it means. */
static const struct {
	const char *text, *chip, *name;
	unsigned int offset;
	bool active_low;
	enum gpio_bias bias;
	int debounce_ms;
} right[] = {
	{"gpio0/5", "gpio0", "", 5, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/0", "gpio0", "", 0, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/9", "gpio0", "", 9, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/+5", "gpio0", "+5", 0, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/:", "gpio0", ":", 0, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/65535", "gpio0", "", 65535, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/KEY", "gpio0", "KEY", 0, false, GPIO_BIAS_AS_IS, 0},
	{"KEY", "", "KEY", 0, false, GPIO_BIAS_AS_IS, 0},
	{"7up", "", "7up", 0, false, GPIO_BIAS_AS_IS, 0},
	{"gpio0/65536", "gpio0", "65536", 0, false, GPIO_BIAS_AS_IS, 0},
	{NAME_63, "", NAME_63, 0, false, GPIO_BIAS_AS_IS, 0},
	{NAME_63 "/" NAME_63, NAME_63, NAME_63, 0, false, GPIO_BIAS_AS_IS, 0},
	{"c/1/active-low", "c", "", 1, true, GPIO_BIAS_AS_IS, 0},
	{"c/1/active-high", "c", "", 1, false, GPIO_BIAS_AS_IS, 0},
	{"c/1/pull-up", "c", "", 1, false, GPIO_BIAS_PULL_UP, 0},
	{"pull-down/c/1", "c", "", 1, false, GPIO_BIAS_PULL_DOWN, 0},
	{"c/no-pull/1", "c", "", 1, false, GPIO_BIAS_NONE, 0},
	{"c/1/debounce=1", "c", "", 1, false, GPIO_BIAS_AS_IS, 1},
	{"c/1/debounce=1000/active-low/pull-up", "c", "", 1, true,
		GPIO_BIAS_PULL_UP, 1000},
	{"c  a/b\tactive-low", "c", "a/b", 0, true, GPIO_BIAS_AS_IS, 0},
};

static const struct {
	const char *text, *sentence;
} wrong[] = {
	{"", "the line is missing"},
	{"/", "the line is missing"},
	{"active-low", "the line is missing"},
	{"5", "a number needs its chip"},
	{"5/pull-up", "a number needs its chip"},
	{"a/b/c", "give CHIP/LINE"},
	{"a/1/debounce:5", "give CHIP/LINE"},
	{"a/b/c/d", "give CHIP/LINE"},
	{"a/1/debounce=0", "from 1 to 1000"},
	{"a/1/debounce=1001", "from 1 to 1000"},
	{"a/1/debounce=", "from 1 to 1000"},
	{"a/1/debounce=-1", "from 1 to 1000"},
	{"a/1/debounce=5ms", "from 1 to 1000"},
	{"a/1/debounce=9x", "from 1 to 1000"},
	{"a/1/debounce=:", "from 1 to 1000"},
	{"a/1/debounce=99999999999999999999", "from 1 to 1000"},
	{NAME_63 "h", "at most 63"},
	{NAME_63 "h/1", "at most 63"},
	{"a/" NAME_63 "h", "at most 63"},
};

static void expect_right(const struct gpio_line_spec *spec, size_t i)
{
	assert_string_equal(spec->chip, right[i].chip);
	assert_string_equal(spec->name, right[i].name);
	assert_int_equal(spec->offset, right[i].offset);
	assert_int_equal(spec->settings.active_low, right[i].active_low);
	assert_int_equal(spec->settings.bias, right[i].bias);
	assert_int_equal(spec->debounce_ms, right[i].debounce_ms);
}

static void test_each_text_means_its_line(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gpio_line_spec spec;
	char text[256];

	(void)state;
	for (size_t i = 0; i < sizeof(right) / sizeof(right[0]); i++) {
		assert_int_equal(
			gpio_line_spec_parse_output(right[i].text, &spec, &log),
			0);
		expect_right(&spec, i);
		assert_true(spec.settings.output);
		assert_int_equal(spec.button, BUTTON_COUNT);
		snprintf(text, sizeof(text), "F8=%s", right[i].text);
		assert_int_equal(gpio_line_spec_parse(text, &spec, &log), 0);
		expect_right(&spec, i);
		assert_false(spec.settings.output);
		assert_int_equal(spec.button, BUTTON_F8);
	}
	assert_int_equal(capture.count, 0);
}

/* Whether one error was logged, of the text and with the sentence. */
static void expect_refused(
	struct log_capture *capture, const char *text, const char *sentence)
{
	assert_int_equal(capture->count, 1);
	assert_int_equal(capture->level[0], LOG_ERROR);
	assert_contains(capture->sentence[0], text);
	assert_contains(capture->sentence[0], sentence);
	capture->count = 0;
}

static void test_each_mistake_is_one_sentence(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gpio_line_spec spec;
	char text[256];

	(void)state;
	for (size_t i = 0; i < sizeof(wrong) / sizeof(wrong[0]); i++) {
		assert_int_equal(
			gpio_line_spec_parse_output(wrong[i].text, &spec, &log),
			-EINVAL);
		expect_refused(&capture, wrong[i].text, wrong[i].sentence);
		snprintf(text, sizeof(text), "UP=%s", wrong[i].text);
		assert_int_equal(
			gpio_line_spec_parse(text, &spec, &log), -EINVAL);
		expect_refused(&capture, text, wrong[i].sentence);
	}
	assert_int_equal(gpio_line_spec_parse("UP", &spec, &log), -EINVAL);
	expect_refused(&capture, "gpiod:UP: ", "give BUTTON=");
	assert_int_equal(gpio_line_spec_parse("F7=a/1", &spec, &log), -EINVAL);
	expect_refused(&capture, "gpiod:F7=a/1: ", "no such button");
}

static void test_a_text_has_a_length(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct gpio_line_spec spec;
	char text[257];

	(void)state;
	memset(text, '/', sizeof(text));
	memcpy(text, "UP=c/1", 6);
	text[255] = '\0';
	assert_int_equal(gpio_line_spec_parse(text, &spec, &log), 0);
	memcpy(text, "c//////1", 8);
	assert_int_equal(gpio_line_spec_parse_output(text, &spec, &log), 0);
	assert_int_equal(capture.count, 0);
	text[255] = '/';
	text[256] = '\0';
	assert_int_equal(
		gpio_line_spec_parse_output(text, &spec, &log), -EINVAL);
	expect_refused(&capture, "c//////1", "at most 255 characters");
	memcpy(text, "UP=c/1", 6);
	assert_int_equal(gpio_line_spec_parse(text, &spec, &log), -EINVAL);
	expect_refused(&capture, "gpiod:UP=c/1", "at most 255 characters");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_text_means_its_line),
		cmocka_unit_test(test_each_mistake_is_one_sentence),
		cmocka_unit_test(test_a_text_has_a_length),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

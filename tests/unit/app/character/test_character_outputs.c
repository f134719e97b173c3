/* Which GPIO lines a character opens, and when it switches them. */
#include "app/character/run/outputs.h"
#include "platform/buttons/gpio_output.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

/* The functions below replace those of the GPIO chips. */
struct gpio_output {
	bool open, on;
	char where[200], name[64], line[64];
};

static struct gpio_output board[CHARACTER_OUTPUTS_MAX];
static int opened;
static bool refuses;

int gpio_output_check(const char *line, const struct log *log)
{
	(void)line;
	(void)log;
	return 0;
}

struct gpio_output *gpio_output_open(const char *where, const char *name,
	const char *line, const struct log *log)
{
	struct gpio_output *output = &board[opened];

	(void)log;
	if (refuses) {
		return NULL;
	}
	assert_in_range(opened, 0, CHARACTER_OUTPUTS_MAX - 1);
	opened++;
	output->open = true;
	snprintf(output->where, sizeof(output->where), "%s", where);
	snprintf(output->name, sizeof(output->name), "%s", name);
	snprintf(output->line, sizeof(output->line), "%s", line);
	return output;
}

void gpio_output_set(struct gpio_output *output, bool on)
{
	if (output) {
		assert_true(output->open);
		output->on = on;
	}
}

static int checks;

void gpio_output_check_all(struct gpio_output *const *outputs, int count)
{
	assert_int_equal(count, CHARACTER_OUTPUTS_MAX);
	assert_ptr_equal(outputs[0], &board[0]);
	checks++;
}

void gpio_output_close(struct gpio_output *output)
{
	if (output) {
		assert_true(output->open);
		output->open = output->on = false;
	}
}

struct bench {
	struct acting acting;
	struct character_outputs outputs;
	struct log log;
};

static void begin(struct bench *bench)
{
	*bench = (struct bench){.log = log_to_stderr(LOG_ERROR)};
	memset(board, 0, sizeof(board));
	opened = 0;
	refuses = false;
	acting_begin(&bench->acting, "assets/walker.glb");
	acting_expect(&bench->acting,
		"[state a]\nclip = walk\n"
		"[output led]\nline = gpiochip0/18\n"
		"[output horn]\nline = HORN/active-low\n"
		"[buttons]\nUP = output led on\nDOWN = output led off\n"
		"F6 = output horn 200\n");
}

static void end(struct bench *bench)
{
	character_outputs_close(&bench->outputs);
	acting_end(&bench->acting);
}

static void press(struct bench *bench, enum button button)
{
	acting_tap(&bench->acting, button, 0.1, rate_hz);
}

static void test_each_output_opens_the_line_of_its_section(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	assert_int_equal(opened, 2);
	assert_string_equal(board[0].name, "led");
	assert_string_equal(board[0].line, "gpiochip0/18");
	assert_string_equal(
		board[0].where, "test.character:4: [output led] line");
	assert_string_equal(board[1].name, "horn");
	assert_string_equal(board[1].line, "HORN/active-low");
	assert_string_equal(
		board[1].where, "test.character:6: [output horn] line");
	/* Lines that are open stay so. */
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	assert_int_equal(opened, 2);
	character_outputs_close(&bench.outputs);
	assert_false(board[0].open || board[1].open);
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	assert_int_equal(opened, 4);
	end(&bench);
}

static void test_buttons_switch_lines_and_end_pulses(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	acting_run_to(&bench.acting, 0.1, rate_hz);
	assert_false(board[0].on || board[1].on);
	press(&bench, BUTTON_UP);
	assert_true(board[0].on && !board[1].on);
	press(&bench, BUTTON_F6);
	assert_true(board[0].on && board[1].on);
	acting_run_to(&bench.acting, bench.acting.now_s + 0.25, rate_hz);
	assert_true(board[0].on && !board[1].on);
	press(&bench, BUTTON_DOWN);
	assert_false(board[0].on || board[1].on);
	end(&bench);
}

/* A file for a board with LEDs plays on a machine without them, too. */
static void test_a_line_that_cannot_be_opened_is_left_out(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	refuses = true;
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	press(&bench, BUTTON_UP);
	assert_true(bench.acting.character->output[0].on);
	assert_null(bench.outputs.line[0]);
	refuses = false;
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	assert_int_equal(opened, 2);
	end(&bench);
}

/* An LED may be unplugged; looking for it in every frame would be slow. */
static void test_lost_lines_are_looked_for_once_a_second(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	character_outputs_open(
		&bench.outputs, bench.acting.character, &bench.log);
	checks = 0;
	for (int i = 0; i <= 100; i++) {
		character_outputs_check(&bench.outputs, i * 0.03125);
	}
	assert_int_equal(checks, 4);
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_output_opens_the_line_of_its_section),
		cmocka_unit_test(test_buttons_switch_lines_and_end_pulses),
		cmocka_unit_test(test_a_line_that_cannot_be_opened_is_left_out),
		cmocka_unit_test(test_lost_lines_are_looked_for_once_a_second),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

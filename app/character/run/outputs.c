#include "app/character/run/outputs.h"

#include "platform/buttons/gpio_output.h"

#include <limits.h>
#include <stdio.h>

static const double check_s = 1.0;

static void drive(void *user, int output, bool on)
{
	struct character_outputs *outputs = user;

	gpio_output_set(outputs->line[output], on);
}

void character_outputs_open(struct character_outputs *outputs,
	struct character *character, const struct log *log)
{
	for (int i = 0; i < character->output_count; i++) {
		const struct character_output *output = &character->output[i];
		char where[PATH_MAX + 64];

		snprintf(where, sizeof(where), "%s:%d: [output %s] line",
			output->file, output->number, output->name);
		if (!outputs->line[i]) {
			outputs->line[i] = gpio_output_open(
				where, output->name, output->line, log);
			gpio_output_set(outputs->line[i], output->on);
		}
	}
	character->drive = drive;
	character->drive_user = outputs;
}

void character_outputs_check(struct character_outputs *outputs, double now_s)
{
	if (now_s >= outputs->next_s) {
		outputs->next_s = now_s + check_s;
		gpio_output_check_all(outputs->line, CHARACTER_OUTPUTS_MAX);
	}
}

void character_outputs_close(struct character_outputs *outputs)
{
	for (int i = 0; i < CHARACTER_OUTPUTS_MAX; i++) {
		gpio_output_close(outputs->line[i]);
		outputs->line[i] = NULL;
	}
}

void character_output_drive(struct character *character, int index, float amount)
{
	struct character_output *output = &character->output[index];

	output->on = amount != 0;
	output->until_s =
		amount > 0 ? character->seen_s + (double)amount / 1000 : -1;
	if (character->drive) {
		character->drive(character->drive_user, index, output->on);
	}
}

void character_outputs_update(struct character *character)
{
	for (int i = 0; i < character->output_count; i++) {
		struct character_output *output = &character->output[i];

		if (output->on && output->until_s >= 0 &&
			character->seen_s >= output->until_s) {
			character_output_drive(character, i, 0);
		}
	}
}

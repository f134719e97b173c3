#include "platform/base/name_list.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum {
	LETTERS_MAX = 64,    /* that are compared */
	CONTAINED_LEAST = 3, /* letters that are no chance */
	SHORT_MAX = 5,
	MORE_BYTES = 24 /* " and 2147483647 more" */
};

bool name_list_add(struct name_list *list, const char *name)
{
	size_t used = strlen(list->text);
	size_t left = sizeof(list->text) - used;
	const char *quote = strpbrk(name, ", ") ? "\"" : "";
	int length = snprintf(list->text + used, left, "%s%s%s%s",
		used ? ", " : "", quote, name, quote);

	if (length < 0 || (size_t)length >= left) {
		list->text[used] = '\0';
		return false;
	}
	return true;
}

/* Copies letters and digits in lower case. Returns their number. */
static int keep_letters(const char *name, char out[LETTERS_MAX])
{
	int count = 0;

	for (; *name && count < LETTERS_MAX - 1; name++) {
		unsigned char byte = (unsigned char)*name;

		if (isalnum(byte) || byte & 0x80) {
			out[count++] = (char)tolower(byte);
		}
	}
	out[count] = '\0';
	return count;
}

static int least(int a, int b)
{
	return a < b ? a : b;
}

/* How many letters must be changed, added or left out (Levenshtein). */
static int count_changes(const char *a, int a_count, const char *b, int b_count)
{
	int row[LETTERS_MAX];

	for (int j = 0; j <= b_count; j++) {
		row[j] = j;
	}
	for (int i = 1; i <= a_count; i++) {
		int diagonal = row[0];

		row[0] = i;
		for (int j = 1; j <= b_count; j++) {
			int changed = diagonal + (a[i - 1] != b[j - 1]);

			diagonal = row[j];
			row[j] = least(changed, least(row[j], row[j - 1]) + 1);
		}
	}
	return row[b_count];
}

static bool is_like(const char *one, const char *other)
{
	char a[LETTERS_MAX], b[LETTERS_MAX];
	int a_count = keep_letters(one, a), b_count = keep_letters(other, b);
	int shorter = least(a_count, b_count);

	if (shorter < CONTAINED_LEAST) {
		return shorter > 0 && strcmp(a, b) == 0;
	}
	return strstr(a, b) || strstr(b, a) ||
		count_changes(a, a_count, b, b_count) <=
		(shorter > SHORT_MAX ? 2 : 1);
}

void name_choice_add(struct name_choice *choice, const char *name)
{
	size_t room = sizeof(choice->list.text) - MORE_BYTES;
	size_t used = strlen(choice->list.text);

	if (is_like(name, choice->wanted) == choice->others) {
		return;
	}
	if (!name_list_add(&choice->list, name)) {
		choice->left_out++;
	} else if (strlen(choice->list.text) >= room) {
		choice->list.text[used] = '\0';
		choice->left_out++;
	}
}

void name_choice_list(struct name_choice *choice,
	void (*add_all)(struct name_choice *choice, const void *context),
	const void *context)
{
	size_t used;

	choice->others = false;
	add_all(choice, context);
	choice->others = true;
	add_all(choice, context);
	used = strlen(choice->list.text);

	if (choice->left_out > 0) {
		snprintf(choice->list.text + used,
			sizeof(choice->list.text) - used, " and %d more",
			choice->left_out);
	}
}

#include "platform/base/name_list.h"

#include <stdio.h>
#include <string.h>

void name_list_add(struct name_list *list, const char *name)
{
	size_t used = strlen(list->text);
	size_t left = sizeof(list->text) - used;
	const char *quote = strpbrk(name, ", ") ? "\"" : "";
	int length = snprintf(list->text + used, left, "%s%s%s%s",
		used ? ", " : "", quote, name, quote);

	if (length < 0 || (size_t)length >= left) {
		list->text[used] = '\0';
	}
}

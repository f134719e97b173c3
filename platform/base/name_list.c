#include "platform/base/name_list.h"

#include <stdio.h>
#include <string.h>

void name_list_add(struct name_list *list, const char *name)
{
	size_t used = strlen(list->text);
	size_t room = sizeof(list->text) - used;
	int length = snprintf(
		list->text + used, room, "%s%s", used ? ", " : "", name);

	if (length < 0 || (size_t)length >= room) {
		list->text[used] = '\0';
	}
}

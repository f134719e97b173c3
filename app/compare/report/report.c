#include "app/compare/report/report.h"

#include <string.h>

const struct report_format report_formats[] = {
	{"text", report_print_text},
	{"json", report_print_json},
	{"csv", report_print_csv},
	{"md", report_print_markdown},
	{NULL, NULL},
};

const struct report_format *report_find(const char *name)
{
	for (int i = 0; report_formats[i].name; i++) {
		if (strcmp(report_formats[i].name, name) == 0) {
			return &report_formats[i];
		}
	}
	return NULL;
}

#include "app/cmd/doctor/doctor_machine.h"

#include "app/character/presets/preset_file.h"
#include "app/cmd/command.h"
#include "app/cmd/doctor/doctor_report.h"
#include "app/cmd/options/config.h"
#include "app/cmd/options/options_files.h"
#include "app/cmd/options/options_kernel.h"
#include "app/cmd/show/show.h"
#include "app/demo/demo.h"
#include "app/model/model_file.h"
#include "platform/base/file.h"
#include "platform/camera/camera.h"
#include "platform/display/display.h"
#include "platform/gl/gl_survey.h"
#include "platform/watchdog/watchdog.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* The display that works, if any. */
struct choice {
	const char *name; /* NULL: none works */
	bool automatic;   /* limber play chooses it without --display */
};

static struct gl_request request_of(const struct options *options)
{
	return (struct gl_request){
		.format = options->screen.format,
		.egl_library = options->screen.egl_library,
		.gles_library = options->screen.gles_library,
	};
}

static bool survey_display(struct doctor_report *report,
	const struct display_driver *driver, const struct options *options)
{
	const struct survey survey = doctor_report_survey(report);
	const struct gl_request request = request_of(options);

	report->works = 0;
	report->driver = driver->name;
	if (driver->get_surface) {
		gl_survey_screen(&request, driver->name, &survey);
	} else if (driver->survey) {
		driver->survey(&survey);
	}
	return report->works > 0;
}

static struct choice survey_displays(
	struct doctor_report *report, const struct options *options)
{
	struct choice choice = {0};

	doctor_report_section(report, "Displays", "displays");
	for (int i = 0; display_registry[i]; i++) {
		const struct display_driver *driver = display_registry[i];
		bool automatic = !driver->probe || driver->probe();

		if (survey_display(report, driver, options) &&
			(!choice.name || (automatic && !choice.automatic))) {
			choice = (struct choice){driver->name, automatic};
		}
	}
	return choice;
}

static bool survey_gl(
	struct doctor_report *report, const struct options *options)
{
	const struct survey survey = doctor_report_survey(report);
	const struct gl_request request = request_of(options);

	doctor_report_section(report, "GL drivers", "gl");
	report->works = 0;
	gl_survey(&request, &survey);
	return report->works > 0;
}

static void survey_kernels(struct doctor_report *report, const struct log *log)
{
	const struct survey survey = doctor_report_survey(report);
	const struct options usual = options_default();
	const struct kernel *chosen = options_kernel(&usual.vertices, log);

	doctor_report_section(report, "Kernels", "kernels");
	for (int i = 0; kernel_registry[i]; i++) {
		const struct kernel *kernel = kernel_registry[i];

		survey_report(&survey, SURVEY_WORKS, kernel->name, NULL, "%s%s",
			kernel->summary,
			kernel == chosen ? "; this is the default" : "");
	}
}

static void survey_devices(struct doctor_report *report)
{
	const struct survey survey = doctor_report_survey(report);

	doctor_report_section(report, "Buttons", "buttons");
	for (int i = 0; button_registry[i]; i++) {
		report->driver = button_registry[i]->name;
		if (button_registry[i]->survey) {
			button_registry[i]->survey(&survey);
		}
	}
	doctor_report_section(report, "Cameras", "cameras");
	for (int i = 0; camera_registry[i]; i++) {
		report->driver = camera_registry[i]->name;
		if (camera_registry[i]->survey) {
			camera_registry[i]->survey(&survey);
		}
	}
	doctor_report_section(report, "Watchdogs", "watchdogs");
	watchdog_survey("/dev", &survey);
}

/* Whether limber play accepts the file; if not, logs the reason. */
static bool is_valid_config(const char *path, const struct log *log)
{
	struct config config = {arena_empty()};
	struct options options = options_default();
	struct show_plan plan = {.display = NULL};
	bool fine = config_load(&config, path, FOR_PLAY, &options, log) == 0;

	plan.display = options.screen.display;
	fine = fine && options_check_files(&options, FOR_PLAY, log) == 0 &&
		show_check(&options, log, &plan) == EXIT_OK &&
		(!options.model_path ||
			model_file_check(options.model_path, log) == 0) &&
		(!options.input.camera ||
			camera_feed_check(options.input.camera, log) == 0);
	config_release(&config);
	return fine;
}

static void survey_config(
	struct doctor_report *report, const struct options *options)
{
	const struct survey survey = doctor_report_survey(report);
	struct survey_message sentence;
	struct log config_log = survey_log(&sentence);
	char path[PATH_MAX];
	int found;

	doctor_report_section(report, "Configuration", "configuration");
	found = config_find(
		options->common.config, true, path, sizeof(path), &config_log);
	if (found < 0) {
		survey_report_message(
			&survey, SURVEY_BROKEN, "limber.conf", &sentence, NULL);
	} else if (!found) {
		survey_report(&survey, SURVEY_UNUSED, "limber.conf", NULL,
			"there is none: limber uses its default options");
	} else if (access(path, R_OK) != 0) {
		survey_report(&survey, SURVEY_BROKEN, path,
			"name another file with --config FILE, or read none with --config none",
			"cannot be read: %s", strerror(errno));
	} else if (is_valid_config(path, &config_log)) {
		survey_report(&survey, SURVEY_WORKS, path, NULL,
			"limber play reads it without errors");
	} else {
		survey_report_message(
			&survey, SURVEY_BROKEN, path, &sentence, NULL);
	}
}

static void survey_file(const struct survey *survey, const char *name)
{
	const struct log nowhere = log_to_nowhere();
	char path[PATH_MAX], remedy[PATH_MAX + 32];

	if (file_find_asset(name, &nowhere, path, sizeof(path)) != 0) {
		survey_report(survey, SURVEY_MISSING, name,
			"export LIMBER_ASSETS=FOLDER with the folder of limber's models",
			"this file was not found");
	} else if (access(path, R_OK) != 0) {
		int error = errno;

		snprintf(remedy, sizeof(remedy), "sudo chmod a+r %s", path);
		survey_report(survey, SURVEY_BROKEN, name,
			error == EACCES ? remedy : NULL,
			"%s: cannot be read: %s", path, strerror(error));
	} else {
		survey_report(survey, SURVEY_WORKS, name, NULL, "%s", path);
	}
}

/* Whether an earlier demo uses the same file. */
static bool is_known_asset(int demo)
{
	const char *asset = demo_registry[demo]->asset;

	for (int i = 0; i < demo; i++) {
		if (demo_registry[i]->asset &&
			strcmp(demo_registry[i]->asset, asset) == 0) {
			return true;
		}
	}
	return false;
}

static void survey_files(struct doctor_report *report)
{
	const struct survey survey = doctor_report_survey(report);

	doctor_report_section(report, "The demos' files", "files");
	for (int i = 0; demo_registry[i]; i++) {
		if (demo_registry[i]->asset && !is_known_asset(i)) {
			survey_file(&survey, demo_registry[i]->asset);
		}
	}
	survey_file(&survey, preset_file_asset);
}

int doctor_examine_machine(const struct options *options, const struct log *log)
{
	struct doctor_report report;
	struct choice display;
	bool plays;

	if (doctor_report_begin(&report, stdout, options->common.json, log) !=
		0) {
		return EXIT_FAILED;
	}
	display = survey_displays(&report, options);
	plays = survey_gl(&report, options) && display.name;
	survey_kernels(&report, log);
	survey_devices(&report);
	survey_config(&report, options);
	survey_files(&report);
	if (doctor_report_end(&report, plays, display.name, display.automatic,
		    log) != 0) {
		return EXIT_FAILED;
	}
	return plays ? EXIT_OK : EXIT_FAILED;
}

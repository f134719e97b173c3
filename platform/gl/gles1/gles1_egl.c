#include "platform/gl/gles1/gles1_egl.h"

#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"

/* From EGL_EXT_platform_base and EGL_MESA_platform_surfaceless. */
#define PLATFORM_SURFACELESS 0x31DD
typedef EGLDisplay (*get_platform_display)(
	EGLenum platform, void *native, const EGLint *attributes);

enum {
	CONFIGS_MAX = 128
};

static const struct library_slot egl_slots[] = {
#define EGL_FUNCTION(result, name, parameters) \
	{"egl" #name, offsetof(struct egl_api, name)},
#define EGL_OPTIONAL(result, name, parameters)
#include "platform/gl/gles1/egl_functions.h"
#undef EGL_FUNCTION
#undef EGL_OPTIONAL
};

static const struct library_slot optional_slots[] = {
#define EGL_FUNCTION(result, name, parameters)
#define EGL_OPTIONAL(result, name, parameters) \
	{"egl" #name, offsetof(struct egl_api, name)},
#include "platform/gl/gles1/egl_functions.h"
#undef EGL_FUNCTION
#undef EGL_OPTIONAL
};

/* Opens the library that option or, without it, the environment variable names;
 * else the first of defaults that can be opened. */
static void *open_library(const char *option, const char *variable,
	const char *const *defaults, const char *package, const struct log *log)
{
	const char *named[2] = {option ? option : getenv(variable), NULL};
	const char *why = "";
	void *library;

	if (named[0] && named[0][0]) {
		library = gl_library_open(named, &why);
		if (!library) {
			log_error(log,
				"--gl gles1: the library that %s names cannot be opened: %s",
				option ? "an option" : variable, why);
		}
		return library;
	}
	library = gl_library_open(defaults, &why);
	if (!library) {
		log_error(log,
			"--gl gles1: there is no %s on this machine (%s): install Debian's %s, name the vendor's library in %s, or choose another --gl",
			defaults[0], why, package, variable);
	}
	return library;
}

static int open_libraries(struct egl *egl, const struct gl_request *request)
{
	static const char *const egl_names[] = {
		"libEGL.so.1", "libEGL.so", NULL};
	static const char *const gles_names[] = {"libGLESv1_CM.so.1",
		"libGLESv1_CM.so", "libGLES_CM.so", "libGLESv1_CL.so", NULL};
	const char *missing;
	void *library = open_library(request->egl_library, "LIMBER_EGL",
		egl_names, "libegl1 and libegl-mesa0", &egl->log);

	if (!library) {
		return -ENOENT;
	}
	egl->gles = open_library(request->gles_library, "LIMBER_GLES",
		gles_names, "libgles1", &egl->log);
	if (!egl->gles) {
		return -ENOENT;
	}
	missing = library_fill(&egl->api, egl_slots,
		(int)ARRAY_COUNT(egl_slots), library_find, library);
	if (missing) {
		log_error(&egl->log,
			"--gl gles1: the machine's EGL has no %s: choose another --gl",
			missing);
		return -ENOSYS;
	}
	for (size_t i = 0; i < ARRAY_COUNT(optional_slots); i++) {
		library_fill(&egl->api, &optional_slots[i], 1, library_find,
			library);
	}
	return 0;
}

/* Whether a word is in a list separated by spaces. */
static bool has_word(const char *list, const char *word)
{
	size_t length = strlen(word);

	while (list) {
		list += strspn(list, " ");
		if (strncmp(list, word, length) == 0 &&
			(list[length] == ' ' || !list[length])) {
			return true;
		}
		list = strchr(list, ' ');
	}
	return false;
}

static EGLDisplay get_surfaceless_display(const struct egl_api *api)
{
	get_platform_display get;

	if (!has_word(api->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS),
		    "EGL_MESA_platform_surfaceless")) {
		return EGL_NO_DISPLAY;
	}
	get = (get_platform_display)api->GetProcAddress(
		"eglGetPlatformDisplayEXT");
	return get ? get(PLATFORM_SURFACELESS, NULL, NULL) : EGL_NO_DISPLAY;
}

static bool initialize(struct egl *egl, EGLDisplay display)
{
	if (display == EGL_NO_DISPLAY ||
		!egl->api.Initialize(display, NULL, NULL)) {
		return false;
	}
	egl->display = display;
	return true;
}

static int open_display(struct egl *egl, const struct gl_request *request)
{
	const struct egl_api *api = &egl->api;

	if ((request->surface || !initialize(egl, get_surfaceless_display(api))) &&
		!initialize(egl, api->GetDisplay(EGL_DEFAULT_DISPLAY))) {
		log_error(&egl->log,
			"--gl gles1: EGL cannot open a display (error 0x%x): install Debian's libegl-mesa0 and libgl1-mesa-dri, or choose another --gl",
			(unsigned int)api->GetError());
		return -ENODEV;
	}
	if (api->BindAPI && !api->BindAPI(EGL_OPENGL_ES_API)) {
		log_error(&egl->log,
			"--gl gles1: this EGL has no OpenGL ES: choose another --gl");
		return -ENODEV;
	}
	return 0;
}

static int attribute(const struct egl *egl, EGLConfig config, EGLint name)
{
	EGLint value = 0;

	egl->api.GetConfigAttrib(egl->display, config, name, &value);
	return value;
}

/* Rates colour sizes highest, then a stencil buffer, then speed. */
static int rate_config(
	const struct egl *egl, EGLConfig config, enum pixel_format format)
{
	bool wide = format == PIXELS_RGBA8888;
	int score = 0;

	score += 16 * (attribute(egl, config, EGL_RED_SIZE) == (wide ? 8 : 5));
	score += 16 * (attribute(egl, config, EGL_ALPHA_SIZE) == (wide ? 8 : 0));
	score += 8 * (attribute(egl, config, EGL_STENCIL_SIZE) >= 8);
	score += 4 * (attribute(egl, config, EGL_CONFIG_CAVEAT) == EGL_NONE);
	score += 2 * (attribute(egl, config, EGL_SAMPLES) == 0);
	score += attribute(egl, config, EGL_DEPTH_SIZE) >= 24;
	return score;
}

/*
 * Lists the configurations that fit. EGL without eglBindAPI does not know
 * EGL_RENDERABLE_TYPE, so the attributes then end before it.
 */
static int list_configs(
	struct egl *egl, const struct gl_request *request, EGLConfig *configs)
{
	const EGLint wanted[] = {EGL_SURFACE_TYPE,
		request->surface ? EGL_WINDOW_BIT : EGL_PBUFFER_BIT,
		EGL_RED_SIZE, 5, EGL_GREEN_SIZE, 5, EGL_BLUE_SIZE, 5,
		EGL_DEPTH_SIZE, 16,
		egl->api.BindAPI ? EGL_RENDERABLE_TYPE : EGL_NONE,
		EGL_OPENGL_ES_BIT, EGL_NONE};
	EGLint count = 0;

	if (!egl->api.ChooseConfig(
		    egl->display, wanted, configs, CONFIGS_MAX, &count)) {
		count = 0;
	}
	return count;
}

/* Swaps the best of the configurations to the front. */
static void bring_best(const struct egl *egl, enum pixel_format format,
	EGLConfig *configs, int count)
{
	int best = 0, best_score = INT_MIN;
	EGLConfig first = configs[0];

	for (int i = 0; i < count; i++) {
		int score = rate_config(egl, configs[i], format);

		if (score > best_score) {
			best_score = score;
			best = i;
		}
	}
	configs[0] = configs[best];
	configs[best] = first;
}

static bool open_window(struct egl *egl, uintptr_t window)
{
	egl->surface = egl->api.CreateWindowSurface(
		egl->display, egl->config, (EGLNativeWindowType)window, NULL);
	return egl->surface != EGL_NO_SURFACE;
}

/*
 * Chooses a configuration. Not every one fits a window, so for a window they
 * are tried, the best first.
 */
static int choose_config(struct egl *egl, const struct gl_request *request)
{
	EGLConfig configs[CONFIGS_MAX];
	int count = list_configs(egl, request, configs);

	if (count == 0) {
		log_error(&egl->log,
			"--gl gles1: this EGL has no configuration for OpenGL ES 1.1 with 16 bits of depth: choose another --gl");
		return -ENODEV;
	}
	for (int i = 0; i < count; i++) {
		bring_best(egl, request->format, configs + i, count - i);
		egl->config = configs[i];
		if (!request->surface ||
			open_window(egl, request->surface->window)) {
			return 0;
		}
	}
	log_error(&egl->log,
		"--display egl: EGL cannot draw on window %#lx (error 0x%x): name another with --display egl:NUMBER",
		(unsigned long)request->surface->window,
		(unsigned int)egl->api.GetError());
	return -EIO;
}

static int open_context(struct egl *egl)
{
	static const EGLint version_1[] = {
		0x3098 /* EGL_CONTEXT_CLIENT_VERSION */, 1, EGL_NONE};

	egl->context = egl->api.CreateContext(egl->display, egl->config,
		EGL_NO_CONTEXT, egl->api.BindAPI ? version_1 : NULL);
	if (egl->context == EGL_NO_CONTEXT) {
		log_error(&egl->log,
			"--gl gles1: this EGL cannot create an OpenGL ES 1 context (error 0x%x; Debian 13's Mesa is built without it): choose another --gl",
			(unsigned int)egl->api.GetError());
		return -ENODEV;
	}
	return 0;
}

int egl_open(struct egl *egl, const struct gl_request *request)
{
	int error;

	*egl = (struct egl){.log = *request->log};
	error = open_libraries(egl, request);
	error = error ? error : open_display(egl, request);
	error = error ? error : choose_config(egl, request);
	error = error ? error : open_context(egl);
	if (error) {
		egl_close(egl);
	}
	return error;
}

int egl_find_screen(const struct gl_request *request)
{
	const struct native_surface none = {0};
	struct gl_request wanted = *request;
	struct egl egl = {.log = *request->log};
	EGLConfig configs[CONFIGS_MAX];
	int error;

	wanted.surface = &none;
	error = open_libraries(&egl, &wanted);
	error = error ? error : open_display(&egl, &wanted);
	if (!error && list_configs(&egl, &wanted, configs) == 0) {
		log_error(&egl.log,
			"--display egl: this EGL has no screen and no windows for OpenGL ES 1.1: choose another --display");
		error = -ENODEV;
	}
	egl_close(&egl);
	return error;
}

int egl_make_current(struct egl *egl)
{
	if (!egl->api.MakeCurrent(
		    egl->display, egl->surface, egl->surface, egl->context)) {
		log_error(&egl->log,
			"--gl gles1: EGL cannot make the context current (error 0x%x)",
			(unsigned int)egl->api.GetError());
		return -EIO;
	}
	return 0;
}

int egl_set_pbuffer(struct egl *egl, int width, int height)
{
	const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
	EGLSurface old = egl->surface;
	EGLSurface new =
		egl->api.CreatePbufferSurface(egl->display, egl->config, size);
	int error;

	if (new == EGL_NO_SURFACE) {
		log_error(&egl->log,
			"--gl gles1: EGL cannot create a pbuffer of %dx%d (error 0x%x)",
			width, height, (unsigned int)egl->api.GetError());
		return -EIO;
	}
	egl->surface = new;
	error = egl_make_current(egl);
	if (error) {
		egl->surface = old;
		old = new;
	}
	if (old != EGL_NO_SURFACE) {
		egl->api.DestroySurface(egl->display, old);
	}
	return error;
}

void egl_set_swap_interval(struct egl *egl)
{
	if (egl->api.SwapInterval) {
		egl->api.SwapInterval(egl->display, 1);
	}
}

void egl_get_size(const struct egl *egl, int *width, int *height)
{
	EGLint value = 0;

	egl->api.QuerySurface(egl->display, egl->surface, EGL_WIDTH, &value);
	*width = value;
	value = 0;
	egl->api.QuerySurface(egl->display, egl->surface, EGL_HEIGHT, &value);
	*height = value;
}

int egl_swap(struct egl *egl)
{
	if (!egl->api.SwapBuffers(egl->display, egl->surface)) {
		log_error(&egl->log,
			"--display egl: EGL cannot show a picture (error 0x%x)",
			(unsigned int)egl->api.GetError());
		return -EIO;
	}
	return 0;
}

library_function egl_get_function(void *user, const char *name)
{
	struct egl *egl = user;
	library_function function = library_find(egl->gles, name);

	return function ? function : egl->api.GetProcAddress(name);
}

void egl_close(struct egl *egl)
{
	const struct egl_api *api = &egl->api;

	if (egl->display == EGL_NO_DISPLAY) {
		return;
	}
	api->MakeCurrent(
		egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
	if (egl->surface != EGL_NO_SURFACE) {
		api->DestroySurface(egl->display, egl->surface);
	}
	if (egl->context != EGL_NO_CONTEXT) {
		api->DestroyContext(egl->display, egl->context);
	}
	/*
	 * The display stays initialized: terminating it would unload the
	 * driver, whose threads may still run.
	 */
	egl->display = EGL_NO_DISPLAY;
}

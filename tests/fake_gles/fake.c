#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/gl/gl.h"

enum {
	CONFIG_COUNT = 2
};

static int refused;
static EGLint last_error = EGL_SUCCESS;

static const char *setting(const char *name, const char *otherwise)
{
	const char *value = getenv(name);

	return value ? value : otherwise;
}

__attribute__((format(printf, 1, 2))) static void log_call(
	const char *format, ...)
{
	const char *path = getenv("FAKE_GLES_LOG");
	FILE *file = path ? fopen(path, "a") : NULL;
	va_list arguments;

	if (file) {
		va_start(arguments, format);
		vfprintf(file, format, arguments);
		va_end(arguments);
		fputc('\n', file);
		fclose(file);
	}
}

EGLDisplay eglGetDisplay(EGLNativeDisplayType native)
{
	log_call("GetDisplay %ld", (long)(intptr_t)native);
	return (EGLDisplay)1;
}

EGLBoolean eglInitialize(EGLDisplay display, EGLint *major, EGLint *minor)
{
	(void)major;
	(void)minor;
	log_call("Initialize %ld", (long)(intptr_t)display);
	return EGL_TRUE;
}

const char *eglQueryString(EGLDisplay display, EGLint name)
{
	(void)name;
	return display ? "fake" : NULL;
}

EGLint eglGetError(void)
{
	EGLint error = last_error;

	last_error = EGL_SUCCESS;
	return error;
}

#ifndef FAKE_GLES_OLD
EGLBoolean eglBindAPI(EGLenum api)
{
	log_call("BindAPI 0x%x", api);
	return EGL_TRUE;
}

EGLBoolean eglSwapInterval(EGLDisplay display, EGLint interval)
{
	(void)display;
	log_call("SwapInterval %d", interval);
	return EGL_TRUE;
}
#endif

static EGLint find(const EGLint *attributes, EGLint name)
{
	for (; *attributes != EGL_NONE; attributes += 2) {
		if (attributes[0] == name) {
			return attributes[1];
		}
	}
	return -1;
}

EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint *attributes,
	EGLConfig *configs, EGLint room, EGLint *count)
{
	(void)display;
	log_call("ChooseConfig surface %d renderable %d bits %d %d %d depth %d",
		find(attributes, EGL_SURFACE_TYPE),
		find(attributes, EGL_RENDERABLE_TYPE),
		find(attributes, EGL_RED_SIZE), find(attributes, EGL_GREEN_SIZE),
		find(attributes, EGL_BLUE_SIZE),
		find(attributes, EGL_DEPTH_SIZE));
	*count = room < CONFIG_COUNT ? room : CONFIG_COUNT;
	for (int i = 0; i < *count; i++) {
		configs[i] = (EGLConfig)(intptr_t)(i + 1);
	}
	return EGL_TRUE;
}

/* Configuration 1 has 8 bits a channel and alpha, 2 is RGB565. */
EGLBoolean eglGetConfigAttrib(
	EGLDisplay display, EGLConfig config, EGLint attribute, EGLint *value)
{
	int wide = (intptr_t)config == 1;

	(void)display;
	switch (attribute) {
	case EGL_RED_SIZE:
		*value = wide ? 8 : 5;
		break;
	case EGL_ALPHA_SIZE:
		*value = wide ? 8 : 0;
		break;
	case EGL_CONFIG_CAVEAT:
		*value = EGL_NONE;
		break;
	default:
		*value = 0;
		break;
	}
	return EGL_TRUE;
}

EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config,
	EGLNativeWindowType window, const EGLint *attributes)
{
	int limit = atoi(setting("FAKE_GLES_REFUSE", "0"));

	(void)display;
	(void)attributes;
	log_call("CreateWindowSurface config %d window 0x%lx",
		(int)(intptr_t)config, (unsigned long)(uintptr_t)window);
	if (limit == 0) {
		refused = 0;
	} else if (refused < limit) {
		refused++;
		last_error = EGL_BAD_MATCH;
		return EGL_NO_SURFACE;
	}
	return (EGLSurface)7;
}

EGLSurface eglCreatePbufferSurface(
	EGLDisplay display, EGLConfig config, const EGLint *attributes)
{
	(void)display;
	(void)config;
	log_call("CreatePbufferSurface %dx%d", find(attributes, EGL_WIDTH),
		find(attributes, EGL_HEIGHT));
	return (EGLSurface)8;
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config,
	EGLContext share, const EGLint *attributes)
{
	(void)display;
	(void)share;
	log_call("CreateContext config %d%s", (int)(intptr_t)config,
		attributes ? " version 1" : "");
	return (EGLContext)9;
}

EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read,
	EGLContext context)
{
	(void)display;
	(void)read;
	log_call("MakeCurrent %ld %ld", (long)(intptr_t)draw,
		(long)(intptr_t)context);
	return EGL_TRUE;
}

EGLBoolean eglQuerySurface(
	EGLDisplay display, EGLSurface surface, EGLint attribute, EGLint *value)
{
	int width = 0, height = 0;

	(void)display;
	(void)surface;
	sscanf(setting("FAKE_GLES_SIZE", "48x64"), "%dx%d", &width, &height);
	*value = attribute == EGL_WIDTH ? width : height;
	return EGL_TRUE;
}

EGLBoolean eglSwapBuffers(EGLDisplay display, EGLSurface surface)
{
	(void)display;
	log_call("SwapBuffers %ld", (long)(intptr_t)surface);
	return EGL_TRUE;
}

EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface)
{
	(void)display;
	log_call("DestroySurface %ld", (long)(intptr_t)surface);
	return EGL_TRUE;
}

EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context)
{
	(void)display;
	log_call("DestroyContext %ld", (long)(intptr_t)context);
	return EGL_TRUE;
}

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char *name)
{
	(void)name;
	return NULL;
}

/* The GL calls that return something or are logged. */
const GLubyte *glGetString(GLenum name);
const GLubyte *glGetString(GLenum name)
{
	switch (name) {
	case GL_RENDERER:
		return (const GLubyte *)setting(
			"FAKE_GLES_RENDERER", "PowerVR MBX Lite");
	case GL_VERSION:
		return (const GLubyte *)"OpenGL ES-CM 1.1";
	default:
		return (const GLubyte *)"";
	}
}

GLenum glGetError(void);
GLenum glGetError(void)
{
	return GL_NO_ERROR;
}

void glGetIntegerv(GLenum name, GLint *values);
void glGetIntegerv(GLenum name, GLint *values)
{
	*values = name == GL_MAX_TEXTURE_SIZE ? 1024 : 1;
}

void glGenTextures(GLsizei count, GLuint *textures);
void glGenTextures(GLsizei count, GLuint *textures)
{
	static GLuint last;

	for (GLsizei i = 0; i < count; i++) {
		textures[i] = ++last;
	}
}

void glViewport(GLint x, GLint y, GLsizei width, GLsizei height);
void glViewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
	log_call("Viewport %d %d %d %d", x, y, width, height);
}

void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height,
	GLenum format, GLenum type, void *pixels);
void glReadPixels(GLint x, GLint y, GLsizei width, GLsizei height,
	GLenum format, GLenum type, void *pixels)
{
	(void)format;
	(void)type;
	log_call("ReadPixels %d %d %d %d", x, y, width, height);
	memset(pixels, 0x40, (size_t)width * (size_t)height * 4);
}

/*
 * The EGL calls that limber uses. Like gl_functions.h, this list is included
 * several times. EGL_OPTIONAL calls are not in EGL 1.0; a missing one is NULL.
 */
EGL_OPTIONAL(EGLBoolean, BindAPI, (EGLenum api))
EGL_FUNCTION(EGLBoolean, ChooseConfig,
	(EGLDisplay display, const EGLint *attributes, EGLConfig *configs,
		EGLint capacity, EGLint *count))
EGL_FUNCTION(EGLContext, CreateContext,
	(EGLDisplay display, EGLConfig config, EGLContext share,
		const EGLint *attributes))
EGL_FUNCTION(EGLSurface, CreatePbufferSurface,
	(EGLDisplay display, EGLConfig config, const EGLint *attributes))
EGL_FUNCTION(EGLSurface, CreateWindowSurface,
	(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
		const EGLint *attributes))
EGL_FUNCTION(
	EGLBoolean, DestroyContext, (EGLDisplay display, EGLContext context))
EGL_FUNCTION(
	EGLBoolean, DestroySurface, (EGLDisplay display, EGLSurface surface))
EGL_FUNCTION(EGLBoolean, GetConfigAttrib,
	(EGLDisplay display, EGLConfig config, EGLint attribute, EGLint *value))
EGL_FUNCTION(EGLDisplay, GetDisplay, (EGLNativeDisplayType native))
EGL_FUNCTION(EGLint, GetError, (void))
EGL_FUNCTION(library_function, GetProcAddress, (const char *name))
EGL_FUNCTION(EGLBoolean, Initialize,
	(EGLDisplay display, EGLint *major, EGLint *minor))
EGL_FUNCTION(EGLBoolean, MakeCurrent,
	(EGLDisplay display, EGLSurface draw, EGLSurface read,
		EGLContext context))
EGL_FUNCTION(const char *, QueryString, (EGLDisplay display, EGLint name))
EGL_FUNCTION(EGLBoolean, QuerySurface,
	(EGLDisplay display, EGLSurface surface, EGLint attribute, EGLint *value))
EGL_FUNCTION(EGLBoolean, SwapBuffers, (EGLDisplay display, EGLSurface surface))
EGL_OPTIONAL(EGLBoolean, SwapInterval, (EGLDisplay display, EGLint interval))

/*
 * The functions of SDL that limber calls, which sdl.h includes with
 * WINDOW_FUNCTION(name) defined. SDL's own header has their types.
 */
WINDOW_FUNCTION(CreateRGBSurfaceWithFormatFrom)
WINDOW_FUNCTION(CreateWindow)
WINDOW_FUNCTION(DestroyWindow)
WINDOW_FUNCTION(FreeSurface)
WINDOW_FUNCTION(GetCurrentVideoDriver)
WINDOW_FUNCTION(GetError)
WINDOW_FUNCTION(GetNumVideoDrivers)
WINDOW_FUNCTION(GetVideoDriver)
WINDOW_FUNCTION(GetWindowSize)
WINDOW_FUNCTION(GetWindowSurface)
WINDOW_FUNCTION(InitSubSystem)
WINDOW_FUNCTION(PollEvent)
WINDOW_FUNCTION(QuitSubSystem)
WINDOW_FUNCTION(SetHint)
WINDOW_FUNCTION(SetSurfaceBlendMode)
WINDOW_FUNCTION(UpdateWindowSurface)
WINDOW_FUNCTION(UpperBlit)

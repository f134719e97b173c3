/*
 * The desktop OpenGL calls that stand behind the fixed-point ones: one list,
 * read many times, like gl_functions.h.
 */
DESKTOP_FUNCTION(void, AlphaFunc, (GLenum function, float reference))
DESKTOP_FUNCTION(
	void, ClearColor, (float red, float green, float blue, float alpha))
DESKTOP_FUNCTION(void, ClearDepth, (double depth))
DESKTOP_FUNCTION(
	void, Color4f, (float red, float green, float blue, float alpha))
DESKTOP_FUNCTION(void, Fogf, (GLenum name, float value))
DESKTOP_FUNCTION(void, Fogfv, (GLenum name, const float *values))
DESKTOP_FUNCTION(void, Frustum,
	(double left, double right, double bottom, double top, double near,
		double far))
DESKTOP_FUNCTION(void, LightModelf, (GLenum name, float value))
DESKTOP_FUNCTION(void, LightModelfv, (GLenum name, const float *values))
DESKTOP_FUNCTION(void, Lightf, (GLenum light, GLenum name, float value))
DESKTOP_FUNCTION(void, Lightfv, (GLenum light, GLenum name, const float *values))
DESKTOP_FUNCTION(void, LineWidth, (float width))
DESKTOP_FUNCTION(void, LoadMatrixf, (const float *matrix))
DESKTOP_FUNCTION(void, Materialf, (GLenum face, GLenum name, float value))
DESKTOP_FUNCTION(
	void, Materialfv, (GLenum face, GLenum name, const float *values))
DESKTOP_FUNCTION(void, MultMatrixf, (const float *matrix))
DESKTOP_FUNCTION(void, Normal3f, (float x, float y, float z))
DESKTOP_FUNCTION(void, Ortho,
	(double left, double right, double bottom, double top, double near,
		double far))
DESKTOP_FUNCTION(void, PointSize, (float size))
DESKTOP_FUNCTION(void, PolygonOffset, (float factor, float units))
DESKTOP_FUNCTION(void, Rotatef, (float degrees, float x, float y, float z))
DESKTOP_FUNCTION(void, Scalef, (float x, float y, float z))
DESKTOP_FUNCTION(void, TexEnvf, (GLenum target, GLenum name, float value))
DESKTOP_FUNCTION(
	void, TexEnvfv, (GLenum target, GLenum name, const float *values))
DESKTOP_FUNCTION(void, TexParameterf, (GLenum target, GLenum name, float value))
DESKTOP_FUNCTION(void, Translatef, (float x, float y, float z))

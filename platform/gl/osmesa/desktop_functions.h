/*
 * The desktop OpenGL calls that the shims use. Like gl_functions.h, this list
 * is included several times.
 */
DESKTOP_FUNCTION(void, AlphaFunc, (GLenum function, float reference))
DESKTOP_FUNCTION(
	void, ClearColor, (float red, float green, float blue, float alpha))
DESKTOP_FUNCTION(void, ClearDepth, (double depth))
DESKTOP_FUNCTION(void, ClientActiveTexture, (GLenum unit))
DESKTOP_FUNCTION(
	void, Color4f, (float red, float green, float blue, float alpha))
DESKTOP_FUNCTION(void, ColorPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))
DESKTOP_FUNCTION(void, DisableClientState, (GLenum array))
DESKTOP_FUNCTION(void, DrawArrays, (GLenum mode, GLint first, GLsizei count))
DESKTOP_FUNCTION(void, DrawElements,
	(GLenum mode, GLsizei count, GLenum type, const void *indices))
DESKTOP_FUNCTION(void, EnableClientState, (GLenum array))
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
DESKTOP_FUNCTION(
	void, NormalPointer, (GLenum type, GLsizei stride, const void *pointer))
DESKTOP_FUNCTION(void, Ortho,
	(double left, double right, double bottom, double top, double near,
		double far))
DESKTOP_FUNCTION(void, PointSize, (float size))
DESKTOP_FUNCTION(void, PolygonOffset, (float factor, float units))
DESKTOP_FUNCTION(void, Rotatef, (float degrees, float x, float y, float z))
DESKTOP_FUNCTION(void, Scalef, (float x, float y, float z))
DESKTOP_FUNCTION(void, TexCoordPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))
DESKTOP_FUNCTION(void, TexEnvf, (GLenum target, GLenum name, float value))
DESKTOP_FUNCTION(
	void, TexEnvfv, (GLenum target, GLenum name, const float *values))
DESKTOP_FUNCTION(void, TexParameterf, (GLenum target, GLenum name, float value))
DESKTOP_FUNCTION(void, Translatef, (float x, float y, float z))
DESKTOP_FUNCTION(void, VertexPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))

/*
 * The list of OpenGL ES 1.1 Common-Lite calls that limber uses.
 *
 * Include it with GL_FUNCTION(result, name, parameters) defined. struct gl, the
 * loader and the drivers are generated from it, so a call need only be added
 * here. It has no include guard because it is included several times.
 */
GL_FUNCTION(void, ActiveTexture, (GLenum unit))
GL_FUNCTION(void, AlphaFuncx, (GLenum function, GLfixed reference))
GL_FUNCTION(void, BindTexture, (GLenum target, GLuint texture))
GL_FUNCTION(void, BlendFunc, (GLenum source, GLenum destination))
GL_FUNCTION(void, Clear, (GLbitfield mask))
GL_FUNCTION(void, ClearColorx,
	(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha))
GL_FUNCTION(void, ClearDepthx, (GLfixed depth))
GL_FUNCTION(void, ClearStencil, (GLint value))
GL_FUNCTION(void, ClientActiveTexture, (GLenum unit))
GL_FUNCTION(void, Color4x,
	(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha))
GL_FUNCTION(void, ColorMask,
	(GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha))
GL_FUNCTION(void, ColorPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))
GL_FUNCTION(void, CullFace, (GLenum face))
GL_FUNCTION(void, DeleteTextures, (GLsizei count, const GLuint *textures))
GL_FUNCTION(void, DepthFunc, (GLenum function))
GL_FUNCTION(void, DepthMask, (GLboolean write))
GL_FUNCTION(void, Disable, (GLenum capability))
GL_FUNCTION(void, DisableClientState, (GLenum array))
GL_FUNCTION(void, DrawArrays, (GLenum mode, GLint first, GLsizei count))
GL_FUNCTION(void, DrawElements,
	(GLenum mode, GLsizei count, GLenum type, const void *indices))
GL_FUNCTION(void, Enable, (GLenum capability))
GL_FUNCTION(void, EnableClientState, (GLenum array))
GL_FUNCTION(void, Finish, (void))
GL_FUNCTION(void, Fogx, (GLenum name, GLfixed value))
GL_FUNCTION(void, Fogxv, (GLenum name, const GLfixed *values))
GL_FUNCTION(void, FrontFace, (GLenum mode))
GL_FUNCTION(void, Frustumx,
	(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near,
		GLfixed far))
GL_FUNCTION(void, GenTextures, (GLsizei count, GLuint *textures))
GL_FUNCTION(GLenum, GetError, (void))
GL_FUNCTION(void, GetIntegerv, (GLenum name, GLint *values))
GL_FUNCTION(const GLubyte *, GetString, (GLenum name))
GL_FUNCTION(void, LightModelx, (GLenum name, GLfixed value))
GL_FUNCTION(void, LightModelxv, (GLenum name, const GLfixed *values))
GL_FUNCTION(void, Lightx, (GLenum light, GLenum name, GLfixed value))
GL_FUNCTION(void, Lightxv, (GLenum light, GLenum name, const GLfixed *values))
GL_FUNCTION(void, LineWidthx, (GLfixed width))
GL_FUNCTION(void, LoadIdentity, (void))
GL_FUNCTION(void, LoadMatrixx, (const GLfixed *matrix))
GL_FUNCTION(void, Materialx, (GLenum face, GLenum name, GLfixed value))
GL_FUNCTION(void, Materialxv, (GLenum face, GLenum name, const GLfixed *values))
GL_FUNCTION(void, MatrixMode, (GLenum mode))
GL_FUNCTION(void, MultMatrixx, (const GLfixed *matrix))
GL_FUNCTION(void, Normal3x, (GLfixed x, GLfixed y, GLfixed z))
GL_FUNCTION(
	void, NormalPointer, (GLenum type, GLsizei stride, const void *pointer))
GL_FUNCTION(void, Orthox,
	(GLfixed left, GLfixed right, GLfixed bottom, GLfixed top, GLfixed near,
		GLfixed far))
GL_FUNCTION(void, PixelStorei, (GLenum name, GLint value))
GL_FUNCTION(void, PointSizex, (GLfixed size))
GL_FUNCTION(void, PolygonOffsetx, (GLfixed factor, GLfixed units))
GL_FUNCTION(void, PopMatrix, (void))
GL_FUNCTION(void, PushMatrix, (void))
GL_FUNCTION(void, ReadPixels,
	(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
		GLenum type, void *pixels))
GL_FUNCTION(void, Rotatex, (GLfixed degrees, GLfixed x, GLfixed y, GLfixed z))
GL_FUNCTION(void, Scalex, (GLfixed x, GLfixed y, GLfixed z))
GL_FUNCTION(void, Scissor, (GLint x, GLint y, GLsizei width, GLsizei height))
GL_FUNCTION(void, ShadeModel, (GLenum mode))
GL_FUNCTION(void, StencilFunc, (GLenum function, GLint reference, GLuint mask))
GL_FUNCTION(void, StencilMask, (GLuint mask))
GL_FUNCTION(void, StencilOp, (GLenum fail, GLenum depth_fail, GLenum pass))
GL_FUNCTION(void, TexCoordPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))
GL_FUNCTION(void, TexEnvx, (GLenum target, GLenum name, GLfixed value))
GL_FUNCTION(void, TexEnvxv, (GLenum target, GLenum name, const GLfixed *values))
GL_FUNCTION(void, TexImage2D,
	(GLenum target, GLint level, GLint internal_format, GLsizei width,
		GLsizei height, GLint border, GLenum format, GLenum type,
		const void *pixels))
GL_FUNCTION(void, TexParameterx, (GLenum target, GLenum name, GLfixed value))
GL_FUNCTION(void, TexSubImage2D,
	(GLenum target, GLint level, GLint x, GLint y, GLsizei width,
		GLsizei height, GLenum format, GLenum type, const void *pixels))
GL_FUNCTION(void, Translatex, (GLfixed x, GLfixed y, GLfixed z))
GL_FUNCTION(void, VertexPointer,
	(GLint size, GLenum type, GLsizei stride, const void *pointer))
GL_FUNCTION(void, Viewport, (GLint x, GLint y, GLsizei width, GLsizei height))

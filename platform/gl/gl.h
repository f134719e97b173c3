/*
 * struct gl: OpenGL ES 1.1 as a table of functions.
 *
 * The calls are spelled as in GL without the prefix: gl->PushMatrix(). Numbers
 * are 16.16 fixed point, as in the Common-Lite profile, which suits cores
 * without floating point; vertex arrays may also be GL_FLOAT. An enumerant in a
 * fixed-point parameter (TexEnvx, TexParameterx) is not scaled, as the
 * specification says.
 *
 * The values of the enumerants are those of OpenGL ES 1.1; a test compares them
 * with the Khronos header. The program includes this header instead of
 * <GLES/gl.h>, so it builds without an installed GL.
 */
#ifndef PLATFORM_GL_GL_H
#define PLATFORM_GL_GL_H

#include <stdint.h>

typedef unsigned int GLenum;
typedef unsigned char GLboolean;
typedef unsigned int GLbitfield;
typedef int8_t GLbyte;
typedef short GLshort;
typedef int GLint;
typedef int GLsizei;
typedef uint8_t GLubyte;
typedef unsigned short GLushort;
typedef unsigned int GLuint;
typedef int32_t GLfixed;

#define GL_FALSE 0
#define GL_TRUE  1

/* Clear */
#define GL_DEPTH_BUFFER_BIT   0x00000100
#define GL_STENCIL_BUFFER_BIT 0x00000400
#define GL_COLOR_BUFFER_BIT   0x00004000

/* Primitives */
#define GL_POINTS         0x0000
#define GL_LINES          0x0001
#define GL_LINE_LOOP      0x0002
#define GL_LINE_STRIP     0x0003
#define GL_TRIANGLES      0x0004
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRIANGLE_FAN   0x0006

/* Comparisons */
#define GL_NEVER    0x0200
#define GL_LESS     0x0201
#define GL_EQUAL    0x0202
#define GL_LEQUAL   0x0203
#define GL_GREATER  0x0204
#define GL_NOTEQUAL 0x0205
#define GL_GEQUAL   0x0206
#define GL_ALWAYS   0x0207

/* Blending */
#define GL_ZERO                0
#define GL_ONE                 1
#define GL_SRC_COLOR           0x0300
#define GL_ONE_MINUS_SRC_COLOR 0x0301
#define GL_SRC_ALPHA           0x0302
#define GL_ONE_MINUS_SRC_ALPHA 0x0303
#define GL_DST_ALPHA           0x0304
#define GL_ONE_MINUS_DST_ALPHA 0x0305
#define GL_DST_COLOR           0x0306
#define GL_ONE_MINUS_DST_COLOR 0x0307

/* Faces */
#define GL_FRONT          0x0404
#define GL_BACK           0x0405
#define GL_FRONT_AND_BACK 0x0408
#define GL_CW             0x0900
#define GL_CCW            0x0901

/* Capabilities */
#define GL_FOG                 0x0B60
#define GL_LIGHTING            0x0B50
#define GL_TEXTURE_2D          0x0DE1
#define GL_CULL_FACE           0x0B44
#define GL_ALPHA_TEST          0x0BC0
#define GL_BLEND               0x0BE2
#define GL_STENCIL_TEST        0x0B90
#define GL_DEPTH_TEST          0x0B71
#define GL_LIGHT0              0x4000
#define GL_LIGHT1              0x4001
#define GL_LIGHT2              0x4002
#define GL_COLOR_MATERIAL      0x0B57
#define GL_NORMALIZE           0x0BA1
#define GL_RESCALE_NORMAL      0x803A
#define GL_SCISSOR_TEST        0x0C11
#define GL_POLYGON_OFFSET_FILL 0x8037
#define GL_POINT_SMOOTH        0x0B10
#define GL_LINE_SMOOTH         0x0B20
#define GL_DITHER              0x0BD0

/* Arrays */
#define GL_VERTEX_ARRAY        0x8074
#define GL_NORMAL_ARRAY        0x8075
#define GL_COLOR_ARRAY         0x8076
#define GL_TEXTURE_COORD_ARRAY 0x8078

/* Types */
#define GL_BYTE                   0x1400
#define GL_UNSIGNED_BYTE          0x1401
#define GL_SHORT                  0x1402
#define GL_UNSIGNED_SHORT         0x1403
#define GL_FLOAT                  0x1406
#define GL_FIXED                  0x140C
#define GL_UNSIGNED_SHORT_4_4_4_4 0x8033
#define GL_UNSIGNED_SHORT_5_5_5_1 0x8034
#define GL_UNSIGNED_SHORT_5_6_5   0x8363

/* Matrices */
#define GL_MODELVIEW  0x1700
#define GL_PROJECTION 0x1701
#define GL_TEXTURE    0x1702

/* Light and material */
#define GL_LIGHT_MODEL_AMBIENT   0x0B53
#define GL_LIGHT_MODEL_TWO_SIDE  0x0B52
#define GL_AMBIENT               0x1200
#define GL_DIFFUSE               0x1201
#define GL_SPECULAR              0x1202
#define GL_POSITION              0x1203
#define GL_SPOT_DIRECTION        0x1204
#define GL_SPOT_EXPONENT         0x1205
#define GL_SPOT_CUTOFF           0x1206
#define GL_CONSTANT_ATTENUATION  0x1207
#define GL_LINEAR_ATTENUATION    0x1208
#define GL_QUADRATIC_ATTENUATION 0x1209
#define GL_EMISSION              0x1600
#define GL_SHININESS             0x1601
#define GL_AMBIENT_AND_DIFFUSE   0x1602
#define GL_FLAT                  0x1D00
#define GL_SMOOTH                0x1D01

/* Fog */
#define GL_FOG_DENSITY 0x0B62
#define GL_FOG_START   0x0B63
#define GL_FOG_END     0x0B64
#define GL_FOG_MODE    0x0B65
#define GL_FOG_COLOR   0x0B66
#define GL_EXP         0x0800
#define GL_EXP2        0x0801

/* Textures */
#define GL_TEXTURE0               0x84C0
#define GL_TEXTURE1               0x84C1
#define GL_ALPHA                  0x1906
#define GL_RGB                    0x1907
#define GL_RGBA                   0x1908
#define GL_LUMINANCE              0x1909
#define GL_LUMINANCE_ALPHA        0x190A
#define GL_UNPACK_ALIGNMENT       0x0CF5
#define GL_PACK_ALIGNMENT         0x0D05
#define GL_TEXTURE_ENV            0x2300
#define GL_TEXTURE_ENV_MODE       0x2200
#define GL_TEXTURE_ENV_COLOR      0x2201
#define GL_MODULATE               0x2100
#define GL_DECAL                  0x2101
#define GL_ADD                    0x0104
#define GL_REPLACE                0x1E01
#define GL_NEAREST                0x2600
#define GL_LINEAR                 0x2601
#define GL_NEAREST_MIPMAP_NEAREST 0x2700
#define GL_LINEAR_MIPMAP_NEAREST  0x2701
#define GL_NEAREST_MIPMAP_LINEAR  0x2702
#define GL_LINEAR_MIPMAP_LINEAR   0x2703
#define GL_TEXTURE_MAG_FILTER     0x2800
#define GL_TEXTURE_MIN_FILTER     0x2801
#define GL_TEXTURE_WRAP_S         0x2802
#define GL_TEXTURE_WRAP_T         0x2803
#define GL_REPEAT                 0x2901
#define GL_CLAMP_TO_EDGE          0x812F

/* Texture combiner */
#define GL_COMBINE       0x8570
#define GL_COMBINE_RGB   0x8571
#define GL_COMBINE_ALPHA 0x8572
#define GL_RGB_SCALE     0x8573
#define GL_CONSTANT      0x8576
#define GL_PRIMARY_COLOR 0x8577
#define GL_PREVIOUS      0x8578
#define GL_SRC0_RGB      0x8580
#define GL_SRC1_RGB      0x8581
#define GL_SRC0_ALPHA    0x8588
#define GL_SRC1_ALPHA    0x8589
#define GL_OPERAND0_RGB  0x8590
#define GL_OPERAND1_RGB  0x8591
#define GL_DOT3_RGB      0x86AE
#define GL_DOT3_RGBA     0x86AF

/* Stencil */
#define GL_KEEP   0x1E00
#define GL_INCR   0x1E02
#define GL_DECR   0x1E03
#define GL_INVERT 0x150A

/* Queries */
#define GL_VENDOR                    0x1F00
#define GL_RENDERER                  0x1F01
#define GL_VERSION                   0x1F02
#define GL_EXTENSIONS                0x1F03
#define GL_MAX_TEXTURE_SIZE          0x0D33
#define GL_MAX_TEXTURE_UNITS         0x84E2
#define GL_MAX_MODELVIEW_STACK_DEPTH 0x0D36
#define GL_STENCIL_BITS              0x0D57
#define GL_DEPTH_BITS                0x0D56
#define GL_SUBPIXEL_BITS             0x0D50
#define GL_SMOOTH_POINT_SIZE_RANGE   0x0B12
#define GL_SMOOTH_LINE_WIDTH_RANGE   0x0B22
#define GL_ALIASED_POINT_SIZE_RANGE  0x846D
#define GL_ALIASED_LINE_WIDTH_RANGE  0x846E

/* Errors */
#define GL_NO_ERROR          0
#define GL_INVALID_ENUM      0x0500
#define GL_INVALID_VALUE     0x0501
#define GL_INVALID_OPERATION 0x0502
#define GL_STACK_OVERFLOW    0x0503
#define GL_STACK_UNDERFLOW   0x0504
#define GL_OUT_OF_MEMORY     0x0505

struct gl {
#define GL_FUNCTION(result, name, parameters) result(*name) parameters;
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
};

#endif

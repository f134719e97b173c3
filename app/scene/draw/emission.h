/*
 * Light that a surface emits (glTF 2.0, section 3.9.3).
 *
 * GL adds GL_EMISSION to the light of a surface before it multiplies that by a
 * texture. So it draws what glTF asks for where the surface has no texture, or
 * where the base colour and the emission share one. Where the base colour has a
 * texture of its own, a second texture unit adds the emission, or an emissive
 * texture that is not darkened by a factor. Other surfaces, and those too where
 * GL has one unit, are drawn once more: the emission is added to the pixels
 * that they show. A surface that emits nothing takes no call of GL.
 */
#ifndef APP_SCENE_DRAW_EMISSION_H
#define APP_SCENE_DRAW_EMISSION_H

#include "app/scene/draw/texture.h"
#include "app/scene/instance/instance_data.h"

enum emission {
	EMISSION_NONE,
	EMISSION_WITH_LIGHT,   /* drawn with all other light */
	EMISSION_OVER_TEXTURE, /* by the second unit's environment */
	EMISSION_BY_TEXTURE,   /* by the second unit's texture */
	EMISSION_ADDED,        /* drawn after it, in a pass of its own */
};

/*
 * How the light is drawn that a primitive of the model emits: over bumps as if
 * GL had one unit.
 */
enum emission emission_of(const struct model *model,
	const struct model_primitive *primitive, bool two_units);

/*
 * The colour that is added to the light that the surface reflects, 0 to 1;
 * black if it emits none. instance_create() keeps it in drawable.emission. GL
 * adds sRGB-encoded colours, whose sum is brighter than that of linear ones.
 * Where the surface has one base colour, the sum is right in medium light, and
 * nowhere less than what is emitted.
 */
void emission_color(const struct model *model,
	const struct model_primitive *primitive, float out[3]);

/* Set GL_EMISSION, and reset it to black, which it is at all other times. */
void emission_begin_light(const struct gl *gl, const struct drawable *drawable);
void emission_end_light(const struct gl *gl);

/*
 * Let the second texture unit add the emission to a surface whose base colour
 * has a texture, and disable the unit, which it is at all other times. For an
 * emissive texture the caller passes the unit's texture coordinates, whose
 * array the end disables.
 */
void emission_begin_unit(const struct gl *gl, const struct model *model,
	const struct drawable *drawable, const struct texture_set *textures);
void emission_end_unit(const struct gl *gl);

/*
 * Set the state of the pass that adds light to what has been drawn; the surface's
 * alpha counts where it is blended, and so does that of its base texture, unless
 * there is an emissive one. The caller passes the positions and, where this is
 * true, the texture coordinates. The end leaves the depth function at GL_LESS.
 */
bool emission_pass_is_textured(
	const struct model *model, const struct drawable *drawable);
void emission_begin_pass(const struct gl *gl, const struct model *model,
	const struct drawable *drawable, const struct texture_set *textures);
void emission_end_pass(const struct gl *gl);

#endif

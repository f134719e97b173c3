/*
 * Relief: normal maps lit through GL ES 1.1's DOT3 texture combiner.
 *
 * A posed vertex has a frame of its own: normal, tangent and bitangent (AN4044,
 * Example 2). In it the direction of the key light becomes a colour, which the
 * combiner multiplies with the normals that a texture holds. One texture unit
 * is enough, in three passes over the same pixels:
 *
 *	the normal map with the light's direction    how much key light falls
 *	times the key light's colour and the surface's
 *	plus the surface in all other light, with the key light's highlight
 *
 * A flat normal map so looks as the surface does without it. What has relief
 * is opaque, lit, has normals, tangents and texture coordinates, and is drawn
 * from arrays of its own (see batch.h); everything else is lit plainly.
 */
#ifndef APP_SCENE_DRAW_BUMP_H
#define APP_SCENE_DRAW_BUMP_H

#include "app/scene/instance/instance.h"
#include "app/scene/stage/light.h"

/*
 * Whether the model has relief and the driver can show it. One sentence where
 * only the driver cannot. Leaves no GL error behind.
 */
bool bump_is_supported(
	const struct model *model, const struct gl *gl, const struct log *log);

/* Whether the primitive has relief at all. */
bool bump_is_mapped(
	const struct model *model, const struct model_primitive *primitive);

/*
 * Room for the tangents of a drawable that has relief, whose batches are made;
 * leaves others alone. 0 or -ENOMEM.
 */
int bump_init(struct drawable *drawable, const struct model *model,
	struct arena *arena);

/*
 * After tangents and normals are posed: bitangents, and the light's direction
 * for each vertex. Rigid drawables are lit as their nodes' world matrices
 * place them, exactly so unless these scale axes differently.
 */
void bump_update(const struct instance *instance, struct drawable *drawable);

/*
 * A unit vector towards the light in a vertex's frame as a colour, 0.5 + 0.5 x
 * for each part, alpha 255. Where the surface turns away from the light it
 * fades to no direction at all, so that relief does not shine in the dark.
 */
void bump_encode(const float light[3], const float tangent[3],
	const float bitangent[3], const float normal[3], uint8_t out[4]);

/* The state of each pass, in this order; textures and arrays are the caller's. */
void bump_begin_dot3_pass(const struct gl *gl);
void bump_begin_color_pass(const struct gl *gl);
void bump_begin_remaining_pass(const struct gl *gl);
void bump_end(const struct gl *gl);

#endif

/*
 * Bump mapping: normal maps drawn with GL ES 1.1's DOT3 texture combiner.
 *
 * Each posed vertex has a tangent space: normal, tangent and bitangent (AN4044,
 * Example 2). The direction to the key light in that space is stored as the
 * vertex colour, and the combiner takes its dot product with the normals of the
 * texture. One texture unit suffices, in three passes over the same pixels:
 *
 *	1. the normal map dotted with the light's direction
 *	2. multiplied by the key light's colour and by the surface's colour
 *	3. plus the surface in all other light and the key light's highlight
 *
 * A flat normal map therefore looks like the surface without it. A primitive is
 * bump-mapped when it is opaque (model_alpha.h) and lit, has normals, tangents
 * and texture coordinates, and is drawn from arrays of its own (batch.h). All
 * others are drawn without their normal maps, and so are those that appear so
 * small that bumps cannot be seen (LOD_BUMP_TEXELS of lod.h).
 */
#ifndef APP_SCENE_DRAW_BUMP_H
#define APP_SCENE_DRAW_BUMP_H

#include "app/scene/instance/instance_data.h"
#include "app/scene/stage/light.h"

/*
 * Returns true when the model has a bump-mapped primitive and the driver can
 * draw it. Logs a warning when only the driver cannot. Clears GL's errors.
 */
bool bump_is_supported(
	const struct model *model, const struct gl *gl, const struct log *log);

/* Returns true when the primitive's material and attributes allow bump mapping. */
bool bump_is_mapped(
	const struct model *model, const struct model_primitive *primitive);

/*
 * Allocates the tangents of a bump-mapped drawable whose batches have been
 * made. Does nothing for other drawables. Returns 0 or -ENOMEM.
 */
int bump_init(struct drawable *drawable, const struct model *model,
	struct arena *arena);

/*
 * Computes each vertex's bitangent and light direction; normals and tangents
 * have been posed. A rigid drawable is lit by its node's world matrix, which is
 * exact unless that matrix scales the axes differently.
 */
void bump_update(const struct instance *instance, struct drawable *drawable);

/*
 * Encodes a unit vector to the light, in the tangent space of a vertex, as a
 * colour: 0.5 + 0.5 x for each component, alpha 255. Where the surface faces
 * away from the light the vector fades to zero, so that bumps do not shine in
 * the dark.
 */
void bump_encode(const float light[3], const float tangent[3],
	const float bitangent[3], const float normal[3], uint8_t out[4]);

/*
 * Set the GL state of the three passes, in this order, and then reset it. The
 * caller binds textures and arrays.
 */
void bump_begin_dot3_pass(const struct gl *gl);
void bump_begin_color_pass(const struct gl *gl);
void bump_begin_remaining_pass(const struct gl *gl);
void bump_end(const struct gl *gl);

#endif

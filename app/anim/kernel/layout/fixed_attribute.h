/* Access to a primitive's arrays and a target's deltas by attribute. */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_ATTRIBUTE_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_ATTRIBUTE_H

#include "app/anim/kernel/fixed.h"
#include "app/model/model.h"

/* The x, y, z of a vertex's attribute, which the primitive must have. */
static inline const float *fixed_attribute_of(
	const struct model_primitive *primitive, enum fixed_attribute attribute,
	uint32_t vertex)
{
	return attribute == FIXED_POSITION  ? primitive->position[vertex]
		: attribute == FIXED_NORMAL ? primitive->normal[vertex]
					    : primitive->tangent[vertex];
}

/* A target's deltas of an attribute. */
static inline const struct model_deltas *fixed_attribute_deltas(
	const struct model_target *target, enum fixed_attribute attribute)
{
	return attribute == FIXED_POSITION  ? &target->position
		: attribute == FIXED_NORMAL ? &target->normal
					    : &target->tangent;
}

#endif

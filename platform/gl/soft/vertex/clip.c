/*
 * Clips polygons at the planes of the clip volume (Sutherland and Hodgman).
 * Cuts are computed from an edge's inner vertex to its outer one, so that
 * triangles with a common edge cut it at the same point.
 */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* Distance from a plane, 0 or more inside; planes are numbered as OUT_ bits. */
static int64_t distance(const struct vertex *v, int plane)
{
	int64_t value = v->clip[plane / 2];

	return plane % 2 ? v->clip[3] - value : v->clip[3] + value;
}

static int32_t mix(int32_t a, int32_t b, uint32_t share_q31)
{
	/* |b - a| <= 2^31 */
	return (int32_t)(a + (((int64_t)b - a) * share_q31 >> 31));
}

/* Sets out to where the edge from a, inside, to b, outside, meets the plane. */
static void cut_edge(const struct draw *draw, const struct vertex *a,
	const struct vertex *b, int plane, struct vertex *out)
{
	int64_t da = distance(a, plane), db = distance(b, plane);
	uint64_t all = (uint64_t)(da - db); /* below 2^34 */
	int zeros = LEADING_ZEROS_64(all);
	uint32_t part = (uint32_t)((uint64_t)da << zeros >> 32);
	uint32_t whole = (uint32_t)(all << zeros >> 32);
	uint32_t share = mul_high_unsigned(part, (uint32_t)reciprocal(whole))
		<< 1;

	for (int i = 0; i < 4; i++) {
		out->clip[i] = mix(a->clip[i], b->clip[i], share);
	}
	for (int i = 0; i < ATTRIBUTES; i++) {
		if (draw->attributes >> i & 1) {
			out->attribute[i] =
				mix(a->attribute[i], b->attribute[i], share);
		}
	}
	for (int i = 0; i < 4 && draw->shading.two_side; i++) {
		out->back[i] = mix(a->back[i], b->back[i], share);
	}
	out->shaded = true;
	out->outcode = 0;
}

struct polygon {
	struct vertex *corner[CLIP_VERTICES];
	int count;
};

static void add_corner(struct polygon *polygon, struct vertex *corner)
{
	if (polygon->count < CLIP_VERTICES) {
		polygon->corner[polygon->count++] = corner;
	}
}

static void cut_polygon(struct draw *draw, const struct polygon *from,
	int plane, struct polygon *to, int *used)
{
	to->count = 0;
	for (int i = 0; i < from->count; i++) {
		struct vertex *a = from->corner[i];
		struct vertex *b = from->corner[(i + 1) % from->count];
		bool a_in = distance(a, plane) >= 0;
		bool b_in = distance(b, plane) >= 0;

		if (a_in) {
			add_corner(to, a);
		}
		if (a_in != b_in && *used < (int)ARRAY_COUNT(draw->clipped)) {
			struct vertex *cut = &draw->clipped[(*used)++];

			cut_edge(draw, a_in ? a : b, a_in ? b : a, plane, cut);
			add_corner(to, cut);
		}
	}
}

/* Moves a cut that rounding left outside into the volume, and projects it. */
static void settle(const struct draw *draw, struct vertex *v)
{
	int32_t w = v->clip[3] < 1 ? 1 : v->clip[3];

	v->clip[3] = w;
	for (int i = 0; i < 3; i++) {
		v->clip[i] = clamp_int(v->clip[i], -w, w);
	}
	soft_project(draw, v);
}

/* Clips a polygon, or a line as one of two corners, at the planes of out. */
static void cut_all(struct draw *draw, struct polygon *polygon, unsigned out)
{
	struct polygon from;
	int used = 0;

	for (int plane = 0; plane < 6; plane++) {
		if (out >> plane & 1) {
			from = *polygon;
			cut_polygon(draw, &from, plane, polygon, &used);
		}
	}
	for (int i = 0; i < used; i++) {
		settle(draw, &draw->clipped[i]);
	}
}

void soft_clip_triangle(struct draw *draw, struct vertex *const v[3])
{
	struct polygon polygon = {{v[0], v[1], v[2]}, 3};

	for (int i = 0; i < 3; i++) {
		soft_shade(draw, v[i]);
	}
	cut_all(draw, &polygon, v[0]->outcode | v[1]->outcode | v[2]->outcode);
	for (int i = 1; i + 1 < polygon.count; i++) {
		struct vertex *corners[3] = {polygon.corner[0],
			polygon.corner[i], polygon.corner[i + 1]};

		/* skip corners with w = 0: their distance from all planes is 0 */
		if (!(corners[0]->outcode | corners[1]->outcode |
			    corners[2]->outcode)) {
			soft_fill_triangle(draw, corners);
		}
	}
}

void soft_clip_line(struct draw *draw, struct vertex *a, struct vertex *b)
{
	struct polygon line = {{a, b}, 2};

	/* A polygon of two corners gets each cut twice; the first two are ends. */
	cut_all(draw, &line, a->outcode | b->outcode);
	if (line.count >= 2 &&
		!(line.corner[0]->outcode | line.corner[1]->outcode)) {
		soft_draw_line(draw, line.corner[0], line.corner[1]);
	}
}

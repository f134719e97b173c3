#include "app/scene/draw/edge_list.h"

enum {
	TRIANGLES_A_CALL = 256,
	VERTICES_MAX = 65536
};

void edge_list_draw(const struct gl *gl, const uint16_t *index, int count)
{
	uint16_t line[TRIANGLES_A_CALL * 6];
	int used = 0;

	if (!index && count > VERTICES_MAX) {
		count = VERTICES_MAX / 3 * 3;
	}
	for (int i = 0; i + 2 < count; i += 3) {
		for (int corner = 0; corner < 3; corner++) {
			int from = i + corner, to = i + (corner + 1) % 3;

			line[used++] = index ? index[from] : (uint16_t)from;
			line[used++] = index ? index[to] : (uint16_t)to;
		}
		if (used == TRIANGLES_A_CALL * 6 || i + 5 >= count) {
			gl->DrawElements(
				GL_LINES, used, GL_UNSIGNED_SHORT, line);
			used = 0;
		}
	}
}

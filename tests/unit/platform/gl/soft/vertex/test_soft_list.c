/*
 * Lists of triangles by 16-bit indices: the loop that is made for them hands on
 * what single triangles are.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/cache.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	POOL = 700, /* more than the vertex cache has slots */
	TRIANGLES = 400,
	ROUNDS = 60,
};

struct corner {
	int16_t position[4];
	uint8_t color[4];
};

/* What a triangle is filled from. */
struct filled {
	uint32_t index[3], provoking;
	int32_t color[3][3];
	int top, middle, bottom, columns;
	int32_t extent;
	bool inside, wide, back;
	uint64_t area;
};

static struct {
	int count;
	struct filled filled[TRIANGLES * 4];
} seen;

/* Whether rows and columns lie in the box that loops of assembly look at. */
static bool is_in_packed_box(
	const struct fast_setup *fast, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	uint32_t left = (uint32_t)raster_centre(
		raster_least(v[0]->x, v[1]->x, v[2]->x));

	return left >= (fast->box_low & 0xFFFF) >> 4 &&
		left + (uint32_t)setup->columns <= (fast->box_high & 0xFFFF) >>
		4 &&
		(uint32_t)setup->top >= fast->box_low >> 20 &&
		(uint32_t)setup->bottom <= fast->box_high >> 20;
}

/* What the assembly reads agrees with what C finds, on every machine. */
static void check_fast_setup(const struct draw *draw, const struct setup *setup)
{
	const struct fast_setup *fast = &draw->fast_setup;
	bool clockwise = setup->back == draw->front_is_ccw;

	assert_true(draw->packed);
	assert_int_equal((fast->box_low | fast->box_high) & 0xF000F, 0);
	assert_int_equal(
		setup->inside, !setup->wide && is_in_packed_box(fast, setup));
	assert_int_equal(fast->back_flip, draw->front_is_ccw);
	assert_int_equal(
		fast->cull_mask != 0, draw->cull_front || draw->cull_back);
	assert_true(!fast->cull_mask ||
		fast->cull_side != (clockwise ? UINT32_MAX : 0));
}

static void record(struct draw *draw, struct setup *setup)
{
	struct filled *filled = &seen.filled[seen.count++];

	check_fast_setup(draw, setup);
	*filled = (struct filled){
		.provoking = setup->provoking->index,
		.top = setup->top,
		.middle = setup->middle,
		.bottom = setup->bottom,
		.columns = setup->columns,
		.extent = setup->extent,
		.inside = setup->inside,
		.wide = setup->wide,
		.back = setup->back,
		.area = setup->area,
	};
	for (int i = 0; i < 3; i++) {
		const struct vertex *v = setup->v[i];

		assert_true(v->shaded);
		filled->index[i] = v->index;
		memcpy(filled->color[i], v->attribute, sizeof(filled->color[i]));
	}
}

static int32_t find_near(int32_t at, int reach, uint32_t *seed)
{
	int32_t near = at + random_within(seed, reach);

	return near < -32768 ? -32768 : near > 32767 ? 32767 : near;
}

/* In groups of twelve vertices near each other. */
static void make_pool(struct corner *pool, int reach, uint32_t *seed)
{
	for (int i = 0; i < POOL; i++) {
		const int16_t *first = pool[i - i % 12].position;

		for (int axis = 0; axis < 3; axis++) {
			pool[i].position[axis] = i % 12
				? (int16_t)find_near(first[axis], reach, seed)
				: (int16_t)random_within(seed, 32767);
			pool[i].color[axis] = (uint8_t)next_random(seed);
		}
		pool[i].color[3] = 255;
	}
}

/* Some corners are the same one, or share their slot of the cache. */
static void make_list(uint16_t *list, uint32_t *seed)
{
	for (int i = 0; i < 3 * TRIANGLES; i++) {
		int group = i / 12 * 12 % (POOL - 12);
		int index = group + random_between(seed, 0, 11);

		if (random_between(seed, 0, 40) == 0) {
			index = (index + VERTEX_CACHE) % POOL;
		}
		list[i] = (uint16_t)index;
	}
}

/* An odd address takes the list triangle by triangle. */
static void draw(const struct gl *gl, const uint16_t *list, bool apart)
{
	static uint8_t room[sizeof(uint16_t) * (3 * TRIANGLES + 1)];
	uint8_t *at = room + ((uintptr_t)room % 2 == 0 ? apart : !apart);

	memcpy(at, list, sizeof(uint16_t) * 3 * TRIANGLES);
	memset(&seen, 0, sizeof(seen));
	gl->DrawElements(GL_TRIANGLES, 3 * TRIANGLES, GL_UNSIGNED_SHORT, at);
}

static void set_state(const struct gl *gl, const struct corner *pool, int round)
{
	const GLsizei stride = sizeof(*pool);
	/* Half of the corners lie outside of the picture, or none. */
	const GLfixed size = round % 2 ? FX16_ONE * 9 / 10 : FX16_ONE * 3 / 2;

	gl->LoadIdentity();
	gl->Scalex(size / 32768, size / 32768, size / 32768 / 2);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, GL_SHORT, stride, pool->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, pool->color);
	(round % 3 ? gl->Enable : gl->Disable)(GL_CULL_FACE);
	gl->CullFace(round % 3 == 1 ? GL_BACK : GL_FRONT);
	gl->FrontFace(round % 5 < 2 ? GL_CW : GL_CCW);
	(round % 7 < 3 ? gl->Enable : gl->Disable)(GL_SCISSOR_TEST);
	gl->Scissor(SOFT_SCENE_WIDTH / 4, SOFT_SCENE_HEIGHT / 5,
		SOFT_SCENE_WIDTH / 2 + round, SOFT_SCENE_HEIGHT / 2 + round);
}

static void test_lists_hand_on_what_single_triangles_are(void **state)
{
	static const int reaches[] = {400, 2000, 12000, 40000};
	static struct corner pool[POOL];
	static struct filled apart[TRIANGLES * 4];
	struct soft_scene *scene = soft_scene_open();
	uint16_t list[3 * TRIANGLES];
	uint32_t seed = 1;
	int quick = 0, all = 0;

	(void)state;
	scene->soft->fill = record;
	scene->soft->changed = GROUP_ALL;
	for (int round = 0; round < ROUNDS; round++) {
		int count;

		make_pool(pool, reaches[round % 4], &seed);
		make_list(list, &seed);
		set_state(scene->gl, pool, round);
		draw(scene->gl, list, true);
		count = seen.count;
		memcpy(apart, seen.filled, sizeof(apart));
		draw(scene->gl, list, false);
		assert_true(count > 20);
		assert_int_equal(seen.count, count);
		for (int i = 0; i < count; i++) {
			assert_memory_equal(
				&apart[i], &seen.filled[i], sizeof(apart[i]));
			quick += apart[i].inside && !apart[i].wide;
		}
		all += count;
	}
	assert_true(quick > all / 4 && quick < all);
	soft_scene_close(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lists_hand_on_what_single_triangles_are),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The pose of a clip that a state plays, in which its root does not travel. */
#include "app/character/state/entry.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <string.h>

/* In a clip of 2 s one of two nodes goes from 5 5 5 by 4 8 -2. */
struct fixture {
	struct bones bones;
	struct model_channel channel;
	struct model_clip clip;
	struct character_clip of;
	struct clip_cursor cursor;
	struct character_entry entry;
	struct character character;
};

static const float key_s[2] = {0, 2};
static const float way[6] = {5, 5, 5, 9, 13, 3};

static void begin(struct fixture *f, int node)
{
	memset(f, 0, sizeof(*f));
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 1, 2, 3);
	bones_add(&f->bones, 0, 1, 2, 3);
	f->channel = (struct model_channel){.node = node,
		.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 2,
		.time_s = key_s,
		.value = way};
	f->clip = (struct model_clip){.name = "way",
		.duration_s = 2,
		.channel_count = 1,
		.channel = &f->channel};
	f->bones.model.clip = &f->clip;
	f->bones.model.clip_count = 1;
	bones_pose(&f->bones);
	assert_int_equal(clip_cursor_init(&f->cursor, &f->bones.model,
				 &f->bones.model.arena),
		0);
	f->of.clip = &f->clip;
	memcpy(f->of.travel, ((float[]){4, 8, -2}), sizeof(f->of.travel));
	f->entry.of = &f->of;
	f->entry.cursor = &f->cursor;
	f->character.motion.root = node;
	character_entry_begin(&f->entry, 0.5);
}

static void end(struct fixture *f)
{
	bones_end(&f->bones);
}

static void expect(const struct fixture *f, int node, float x, float y, float z)
{
	const float wanted[3] = {x, y, z};

	assert_all_near(f->bones.pose.local[node].translation, wanted, 3, 1e-5);
}

/* Begins a pose with the node at 9 9 9, into which a clip is mixed. */
static void move(struct fixture *f, int node)
{
	for (int k = 0; k < 3; k++) {
		f->bones.pose.local[node].translation[k] = 9;
	}
}

static void test_the_root_of_the_motion_stays_in_its_place(void **state)
{
	(void)state;
	for (int node = 0; node < 2; node++) {
		struct fixture f;

		begin(&f, node);
		character_entry_sample(
			&f.character, &f.entry, CLIP_LOOP, &f.bones.pose);
		assert_near(f.entry.shown_s, 0.5, 0);
		expect(&f, node, 5, 5, 5);
		expect(&f, !node, 1, 2, 3);
		/* A node that is no root goes where the clip takes it. */
		f.character.motion.root = -1;
		character_entry_sample(
			&f.character, &f.entry, CLIP_LOOP, &f.bones.pose);
		expect(&f, node, 6, 7, 4.5f);
		end(&f);
	}
}

static void test_a_root_stays_as_far_as_its_clip_is_mixed_in(void **state)
{
	(void)state;
	for (int node = 0; node < 2; node++) {
		struct fixture f;

		begin(&f, node);
		move(&f, node);
		character_entry_mix(&f.character, &f.entry, CLIP_LOOP, 0.25f,
			&f.bones.pose);
		assert_near(f.entry.shown_s, 0.5, 0);
		expect(&f, node, 8, 8, 8);
		f.character.motion.root = -1;
		move(&f, node);
		character_entry_mix(&f.character, &f.entry, CLIP_LOOP, 0.25f,
			&f.bones.pose);
		expect(&f, node, 8.25f, 8.5f, 7.875f);
		end(&f);
	}
}

/* A layer moves each node by its weight in the mask. */
static void test_a_root_stays_as_far_as_a_mask_has_it(void **state)
{
	(void)state;
	for (int node = 0; node < 2; node++) {
		struct fixture f;
		float only[2] = {0.125f, 0.125f};

		begin(&f, node);
		only[node] = 0.5f;
		f.cursor.only = only;
		move(&f, node);
		character_entry_mix(
			&f.character, &f.entry, CLIP_LOOP, 0.5f, &f.bones.pose);
		expect(&f, node, 8, 8, 8);
		f.character.motion.root = -1;
		move(&f, node);
		character_entry_mix(
			&f.character, &f.entry, CLIP_LOOP, 0.5f, &f.bones.pose);
		expect(&f, node, 8.25f, 8.5f, 7.875f);
		end(&f);
	}
}

/* It has no travel, whatever the model's root is. */
static void test_without_a_clip_the_pose_is_that_at_rest(void **state)
{
	for (int node = 0; node < 2; node++) {
		struct fixture f;

		(void)state;
		begin(&f, node);
		assert_int_equal(pose_init(&f.character.still, &f.bones.model,
					 &f.bones.model.arena),
			0);
		f.of.clip = NULL;
		move(&f, node);
		character_entry_sample(
			&f.character, &f.entry, CLIP_LOOP, &f.bones.pose);
		expect(&f, node, 1, 2, 3);
		move(&f, node);
		character_entry_mix(
			&f.character, &f.entry, CLIP_LOOP, 0.5f, &f.bones.pose);
		expect(&f, node, 5, 5.5f, 6);
		assert_near(f.entry.shown_s, -1, 0);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_root_of_the_motion_stays_in_its_place),
		cmocka_unit_test(
			test_a_root_stays_as_far_as_its_clip_is_mixed_in),
		cmocka_unit_test(test_a_root_stays_as_far_as_a_mask_has_it),
		cmocka_unit_test(test_without_a_clip_the_pose_is_that_at_rest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

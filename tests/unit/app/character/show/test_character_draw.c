/* What is drawn of a character: figure, shadows, balls and capes. */
#include "app/character/run/effects.h"
#include "app/scene/stage/light.h"
#include "platform/base/fixed.h"
#include "tests/unit/app/character/show/drawn.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Of those, the ones that draw these vertices. */
static int draws_of(
	const void *position, const struct gl_recorded_draw *found[4])
{
	const struct gl_recording *all = gl_recorder_result();
	int count = 0;

	for (int i = 0; i < all->draw_count; i++) {
		if (all->draw[i].position == position) {
			assert_true(count < 4);
			found[count++] = &all->draw[i];
		}
	}
	return count;
}

static void test_a_figure_is_drawn_with_its_shadow_or_without(void **state)
{
	struct shown shown;
	int alone;

	(void)state;
	begin(&shown, "assets/walker.glb", "[scene]\nshadow = no\n");
	acting_run_to(&shown.acting, 0.1, 50.0);
	alone = draw(&shown);
	assert_true(alone >= shown.acting.instance->drawable_count);
	end(&shown);
	begin(&shown, "assets/walker.glb", "[scene]\nshadow = yes\n");
	acting_run_to(&shown.acting, 0.1, 50.0);
	assert_int_equal(
		draw(&shown), alone + shown.acting.instance->drawable_count);
	end(&shown);
}

static const char ball_text[] =
	"[target plain]\nplace = 0.3 1.4 1\nradius = 0.05\ncolor = 0.2 0.4 "
	"0.6\n[target point]\nplace = 0 1 0\n"
	"[target ball]\nplace = -1 1.6 0.5\nradius = 0.1\n"
	"[look watch]\nbone = head\ntarget = ball\non = no\n"
	"[buttons]\nUP = toggle watch\n";

static GLfixed diffuse[8][4];
static int diffuse_count;

static void note_color(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed color[4] = {red, green, blue, alpha};

	memcpy(diffuse[diffuse_count++ % 8], color, sizeof(color));
}

/* Unless an effect looks at it that is off; a target without radius never. */
static void test_balls_are_drawn_with_their_shadows(void **state)
{
	const struct gl_recorded_draw *found[4];
	struct shown shown;
	int without, with;

	(void)state;
	begin(&shown, "assets/walker.glb", ball_text);
	acting_run_to(&shown.acting, 0.1, 50.0);
	without = draw(&shown);
	assert_int_equal(draws_of(shown.drawing.ball.normal, found), 1);
	assert_near(found[0]->matrix[12], 0.3 * unit, 1e-4);
	assert_near(found[0]->matrix[13], 1.4 * unit, 1e-4);
	assert_near(found[0]->matrix[14], 1.0 * unit, 1e-4);
	assert_near(found[0]->matrix[0], 0.05 * unit, 1e-4);
	/* The ball's first vertex is its upper end. */
	assert_near(fabsf(shown.drawing.ball.normal[0][1]), 1, 1e-6);
	acting_tap(&shown.acting, BUTTON_UP, 0.1, 50.0);
	with = draw(&shown);
	assert_int_equal(with, without + 2);
	assert_int_equal(draws_of(shown.drawing.ball.normal, found), 2);
	assert_near(found[1]->matrix[12], -1.0 * unit, 1e-4);
	assert_near(found[1]->matrix[13], 1.6 * unit, 1e-4);
	assert_near(found[1]->matrix[0], 0.1 * unit, 1e-4);
	end(&shown);
}

static double least[2][3], most[2][3];
static int fans;
static void note_fan(GLenum mode, GLint first, GLsizei count)
{
	assert_int_equal(first, 0);
	if (mode != GL_TRIANGLE_FAN) {
		return;
	}
	assert_true(fans < 2);
	for (int axis = 0; axis < 3; axis++) {
		least[fans][axis] = most[fans][axis] = array[axis];
		for (int i = 1; i < count; i++) {
			least[fans][axis] =
				fmin(least[fans][axis], array[3 * i + axis]);
			most[fans][axis] =
				fmax(most[fans][axis], array[3 * i + axis]);
		}
	}
	fans++;
}

/* Its middle lies where the light through the ball's middle falls. */
static void test_the_shadow_of_a_ball_lies_where_light_falls(void **state)
{
	struct shown shown;
	float light[3];

	(void)state;
	light_direction(light);
	begin(&shown, "assets/walker.glb", ball_text);
	shown.gl.VertexPointer = note_array;
	shown.gl.DrawArrays = note_fan;
	acting_run_to(&shown.acting, 0.1, 50.0);
	fans = 0;
	character_draw(&shown.drawing, &shown.stage, &shown.textures, &shown.gl);
	assert_int_equal(fans, 1);
	for (int axis = 0; axis < 3; axis += 2) {
		float fall = 1.4f / light[1];
		double at = ((float[]){0.3f, 1.4f, 1.0f})[axis] -
			light[axis] * fall;

		assert_near(
			(least[0][axis] + most[0][axis]) / 2, at * unit, 0.03);
		assert_true(most[0][axis] - least[0][axis] > 0.1f * unit);
		assert_true(most[0][axis] - least[0][axis] < 0.16f * unit);
	}
	end(&shown);
}

static const char cape_text[] =
	"[state a]\nclip = rest\n[cape c]\nbone = chest\n"
	"place = 0 1.42 -0.1\non = no\nfade = 1\ncolor = 0.25 0.5 0.75\n"
	"[buttons]\nUP = toggle c\n";

/* Its shadow appears when it is half there. */
static void test_a_cape_is_drawn_while_it_is_worn(void **state)
{
	const struct gl_recorded_draw *found[4];
	const struct character_cape *cape;
	struct shown shown;
	int without;

	(void)state;
	begin(&shown, "assets/walker.glb", cape_text);
	cape = shown.acting.character->cape;
	acting_run_to(&shown.acting, 0.1, 50.0);
	without = draw(&shown);
	acting_tap(&shown.acting, BUTTON_UP, 0.3, 50.0);
	assert_true(cape->is.now > 0.1f && cape->is.now < 0.5f);
	assert_int_equal(draw(&shown), without + 1);
	assert_int_equal(draws_of(cape->cloth.position, found), 1);
	assert_near(found[0]->matrix[5], unit, 1e-4); /* no shadow */
	shown.acting.character->cape->is.now = 0.5f;
	assert_int_equal(draw(&shown), without + 1);
	acting_run_to(&shown.acting, 0.8, 50.0);
	assert_true(cape->is.now > 0.5f && cape->is.now < 0.9f);
	assert_int_equal(draw(&shown), without + 2);
	assert_int_equal(draws_of(cape->cloth.position, found), 2);
	for (int i = 0; i < 2; i++) {
		assert_int_equal(found[i]->count, cape->index_count);
	}
	assert_near(found[1]->matrix[0], unit, 1e-4);
	assert_near(found[1]->matrix[5], unit, 1e-4);
	assert_near(found[0]->matrix[5], 0, 1e-4); /* level */
	end(&shown);
}

/* The corners of a cape's shadow on hills; 0: it casts none. */
static int corners_on_hills(struct shown *shown)
{
	const struct shadow_sheet *sheet = shown->drawing.drape.sheet;
	int found = 0;

	character_draw_update(&shown->drawing, &shown->stage);
	for (int i = 0; i < shown->drawing.drape.sheet_count; i++) {
		found += sheet[i].cloth ? sheet[i].index_count : 0;
	}
	return found;
}

static void test_a_cape_casts_a_shadow_on_hills(void **state)
{
	static const char hills[] = "[scene]\nwaves = 0.2\n";
	const struct character_cape *cape;
	char text[sizeof(cape_text) + sizeof(hills)];
	struct shown shown;

	(void)state;
	snprintf(text, sizeof(text), "%s%s", cape_text, hills);
	begin(&shown, "assets/walker.glb", text);
	shown.stage.floor = (struct floor){
		.tile = 1.0f, .radius = 9.0f, .wave_height = 0.2f};
	cape = shown.acting.character->cape;
	acting_run_to(&shown.acting, 0.1, 50.0);
	assert_int_equal(corners_on_hills(&shown), 0);
	acting_tap(&shown.acting, BUTTON_UP, 0.3, 50.0);
	assert_int_equal(corners_on_hills(&shown), 0);
	acting_run_to(&shown.acting, 0.8, 50.0);
	assert_true(corners_on_hills(&shown) >= cape->index_count);
	end(&shown);
}

/* GL's state that matters to a cape, by the calls that set it. */
static struct {
	bool lit, colored, blended, textured, culled, two_sided;
	bool normals, colors, texcoords, vertices, dull, over;
	const void *vertex, *normal;
} gl_state;

/* The state of each draw call of the cape. */
static struct {
	const void *cloth;
	int count;
	bool lit, blended, plain, normals;
	bool had_normals; /* in the draw call before */
	const void *normal;
} cape_draws;

static void set_state(GLenum name, bool on)
{
	gl_state.lit = name == GL_LIGHTING ? on : gl_state.lit;
	gl_state.colored = name == GL_COLOR_MATERIAL ? on : gl_state.colored;
	gl_state.blended = name == GL_BLEND ? on : gl_state.blended;
	gl_state.textured = name == GL_TEXTURE_2D ? on : gl_state.textured;
	gl_state.culled = name == GL_CULL_FACE ? on : gl_state.culled;
}

static void note_enable(GLenum name)
{
	set_state(name, true);
}

static void note_disable(GLenum name)
{
	set_state(name, false);
}

static void set_array(GLenum name, bool on)
{
	gl_state.vertices = name == GL_VERTEX_ARRAY ? on : gl_state.vertices;
	gl_state.normals = name == GL_NORMAL_ARRAY ? on : gl_state.normals;
	gl_state.colors = name == GL_COLOR_ARRAY ? on : gl_state.colors;
	gl_state.texcoords =
		name == GL_TEXTURE_COORD_ARRAY ? on : gl_state.texcoords;
}

static void note_client_enable(GLenum name)
{
	set_array(name, true);
}

static void note_client_disable(GLenum name)
{
	set_array(name, false);
}

static void note_vertices(
	GLint size, GLenum type, GLsizei stride, const void *at)
{
	gl_state.vertex = at;
	if (at == cape_draws.cloth) {
		assert_int_equal(size, 3);
		assert_int_equal(type, GL_FLOAT);
		assert_int_equal(stride, 0);
	}
}

static void note_normals(GLenum type, GLsizei stride, const void *at)
{
	gl_state.normal = type == GL_FLOAT && stride == 0 ? at : NULL;
}

static void note_sides(GLenum name, GLfixed value)
{
	gl_state.two_sided = name == GL_LIGHT_MODEL_TWO_SIDE && value == 1;
}

static void note_material(GLenum face, GLenum name, const GLfixed *value)
{
	static const GLfixed black[4] = {0, 0, 0, FX16_ONE};

	if (face == GL_FRONT_AND_BACK && name == GL_SPECULAR) {
		gl_state.dull = memcmp(value, black, sizeof(black)) == 0;
	}
}

static void note_elements(
	GLenum mode, GLsizei count, GLenum type, const void *index)
{
	(void)index;
	if (gl_state.vertex != cape_draws.cloth || count == 0) {
		return;
	}
	assert_int_equal(mode, GL_TRIANGLES);
	assert_int_equal(type, GL_UNSIGNED_SHORT);
	cape_draws.count++;
	cape_draws.had_normals = cape_draws.normals;
	cape_draws.lit = gl_state.lit && gl_state.colored &&
		gl_state.two_sided && gl_state.dull;
	cape_draws.blended = gl_state.blended && gl_state.over;
	cape_draws.plain = !gl_state.textured && !gl_state.culled &&
		!gl_state.colors && !gl_state.texcoords && gl_state.vertices;
	cape_draws.normals = gl_state.normals;
	cape_draws.normal = gl_state.normal;
}

static void note_blend(GLenum source, GLenum destination)
{
	gl_state.over =
		source == GL_SRC_ALPHA && destination == GL_ONE_MINUS_SRC_ALPHA;
}

static void note_state(struct gl *gl)
{
	gl->BlendFunc = note_blend;
	gl->Color4x = note_color;
	gl->Enable = note_enable;
	gl->Disable = note_disable;
	gl->EnableClientState = note_client_enable;
	gl->DisableClientState = note_client_disable;
	gl->VertexPointer = note_vertices;
	gl->NormalPointer = note_normals;
	gl->LightModelx = note_sides;
	gl->Materialxv = note_material;
	gl->DrawElements = note_elements;
}

/* Draws with all state on, or all of it off, before; and the cape alone. */
static void draw_from(struct shown *shown, bool on, int count)
{
	struct instance *instance = shown->acting.instance;
	const struct character_cape *cape = shown->acting.character->cape;

	memset(&gl_state, on, sizeof(gl_state));
	memset(&cape_draws, 0, sizeof(cape_draws));
	cape_draws.cloth = cape->cloth.position;
	diffuse_count = 0;
	for (int i = 0; i < instance->drawable_count; i++) {
		instance->drawable[i].hidden = true;
	}
	character_draw(
		&shown->drawing, &shown->stage, &shown->textures, &shown->gl);
	assert_int_equal(cape_draws.count, count);
	assert_false(gl_state.blended);
}

static void test_a_cape_that_fades_is_blended_in_its_colour(void **state)
{
	struct shown shown;

	(void)state;
	begin(&shown, "assets/walker.glb",
		"[state a]\nclip = rest\n[scene]\nshadow = no\n"
		"[cape c]\nbone = chest\nplace = 0 1.42 -0.1\non = no\n"
		"fade = 1\ncolor = 0.25 0.5 0.75\n[buttons]\nUP = toggle c\n");
	note_state(&shown.gl);
	acting_tap(&shown.acting, BUTTON_UP, 0.5, 50.0);
	for (int i = 0; i < 4; i++) {
		const struct character_cape *cape = shown.acting.character->cape;
		const GLfixed *color;

		/* What it needs does not depend on what was drawn before. */
		draw_from(&shown, i % 2, 1);
		assert_true(cape_draws.lit);
		assert_true(cape_draws.plain);
		assert_true(cape_draws.normals);
		assert_ptr_equal(cape_draws.normal, cape->cloth.normal);
		assert_int_equal(cape_draws.blended, i < 2);
		color = diffuse[(diffuse_count - 1) % 8];
		assert_int_equal(color[0], fx16_from_float(0.25f));
		assert_int_equal(color[1], fx16_from_float(0.5f));
		assert_int_equal(color[2], fx16_from_float(0.75f));
		assert_int_equal(color[3], fx16_from_float(cape->is.now));
		if (i == 1) {
			acting_run_to(&shown.acting, 2.0, 50.0);
		}
	}
	assert_near(shown.acting.character->cape->is.now, 1.0, 0.0);
	end(&shown);
}

/* Which light does not reach. */
static void test_the_shadow_of_a_cape_is_drawn_without_normals(void **state)
{
	struct shown shown;

	(void)state;
	begin(&shown, "assets/walker.glb", cape_text);
	note_state(&shown.gl);
	acting_tap(&shown.acting, BUTTON_UP, 2.0, 50.0);
	draw_from(&shown, true, 2);
	assert_false(cape_draws.had_normals);
	assert_true(cape_draws.normals);
	end(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_figure_is_drawn_with_its_shadow_or_without),
		cmocka_unit_test(test_balls_are_drawn_with_their_shadows),
		cmocka_unit_test(
			test_the_shadow_of_a_ball_lies_where_light_falls),
		cmocka_unit_test(test_a_cape_is_drawn_while_it_is_worn),
		cmocka_unit_test(test_a_cape_casts_a_shadow_on_hills),
		cmocka_unit_test(
			test_the_shadow_of_a_cape_is_drawn_without_normals),
		cmocka_unit_test(test_a_cape_that_fades_is_blended_in_its_colour),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

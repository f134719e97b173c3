#include "app/demo/demo_figures.h"

#include "app/demo/actor.h"
#include "app/scene/draw/alpha.h"
#include "app/scene/draw/draw.h"
#include "app/scene/draw/matrix_gl.h"
#include "app/scene/shadow/shadow_figure.h"

#include <cglm/cglm.h>

bool demo_find_figure(const struct demo_driver *driver, const struct demo *demo,
	int number, struct overlay_figure *out)
{
	const struct demo_base *base = (const struct demo_base *)demo;

	*out = (struct overlay_figure){.instance = base->actor.instance,
		.shadow = base->actor.shadow,
		.among_others = driver->get_figure != NULL};
	glm_mat4_identity(out->place);
	return driver->get_figure ? driver->get_figure(demo, number, out)
				  : number == 0;
}

struct demo_facts demo_get_facts(
	const struct demo_driver *driver, const struct demo *demo)
{
	const struct demo_base *base = (const struct demo_base *)demo;
	struct demo_facts facts = {.technique = driver->technique};
	struct overlay_figure figure;

	if (!facts.technique) {
		facts.technique = instance_technique(base->actor.instance);
	}
	for (int i = 0; demo_find_figure(driver, demo, i, &figure); i++) {
		facts.triangles += lod_triangles(figure.instance);
	}
	return facts;
}

/*
 * Sorts a figure's blended triangles before it is drawn, as figures may share
 * an instance.
 */
static void sort_blended(
	const struct overlay_figure *figure, const struct camera *camera)
{
	mat4 place, into;
	vec3 eye;

	camera_eye(camera, eye);
	glm_mat4_copy((vec4 *)figure->place, place);
	glm_mat4_inv_fast(place, into);
	glm_mat4_mulv3(into, eye, 1.0f, eye);
	alpha_sort_blended(figure->instance, eye);
}

static void draw_figures(const struct demo_driver *driver,
	const struct demo *demo, enum draw_pass pass)
{
	const struct demo_base *base = (const struct demo_base *)demo;
	struct overlay_figure figure;

	for (int i = 0; demo_find_figure(driver, demo, i, &figure); i++) {
		base->gl->PushMatrix();
		matrix_gl_multiply(base->gl, (const vec4 *)figure.place);
		sort_blended(&figure, &base->stage.camera);
		draw_instance(
			base->gl, figure.instance, &base->actor.textures, pass);
		base->gl->PopMatrix();
	}
}

/* Draws ground that figures bring along, and their shadows on it. */
static void draw_grounds(
	const struct demo_driver *driver, const struct demo *demo, int height)
{
	const struct demo_base *base = (const struct demo_base *)demo;
	struct overlay_figure figure;

	for (int i = 0; demo_find_figure(driver, demo, i, &figure); i++) {
		const vec4 *place = (const vec4 *)figure.place;

		if (!figure.shadow) {
			continue;
		}
		shadow_figure_lay(figure.shadow, &base->stage, height,
			figure.instance, place);
		base->gl->PushMatrix();
		matrix_gl_multiply(base->gl, place);
		shadow_figure_draw(figure.shadow, &base->stage, base->gl,
			figure.instance, &base->actor.textures, place);
		base->gl->PopMatrix();
	}
}

static void show_grounds(
	const struct demo_driver *driver, const struct demo *demo)
{
	struct overlay_figure figure;

	for (int i = 0; demo_find_figure(driver, demo, i, &figure); i++) {
		shadow_figure_end(figure.shadow, figure.instance);
	}
}

void demo_draw_stage(const struct demo_driver *driver, struct demo *demo,
	int width, int height)
{
	struct demo_base *base = (struct demo_base *)demo;
	bool casts = !driver->casts_shadow || driver->casts_shadow(demo);
	bool grounds = casts && base->actor.ground.count > 0;

	if (driver->draw) {
		driver->draw(demo, width, height);
		return;
	}
	stage_begin(&base->stage, base->gl, width, height);
	stage_shadow_begin(&base->stage, base->gl);
	if (casts) {
		draw_figures(driver, demo, DRAW_SHADOW);
	}
	stage_shadow_end(&base->stage, base->gl);
	if (grounds) {
		draw_grounds(driver, demo, height);
	}
	draw_figures(driver, demo, DRAW_SHADED);
	if (grounds) {
		show_grounds(driver, demo);
	}
}

#include "app/demo/walker/walker_secondary.h"

#include "app/demo/actor.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <string.h>

/*
 * The cape's shape at rest: it lies around the shoulders, and its pleats become
 * deeper and wider towards the hem.
 */
static const float cape_half_width_m = 0.165f;
static const float cape_flare = 1.35f; /* width of the hem / width at the top */
static const float cape_top_m = 1.45f;
static const float cape_drop_m = 0.045f; /* of the top, from neck to shoulder */
static const float cape_length_m = 0.80f;
static const float cape_back_m = 0.118f;
static const float cape_wrap_m = 0.062f;  /* forward, from neck to shoulder */
static const float cape_pleat_m = 0.034f; /* depth at the hem, to each side */
static const float cape_pleats = 3.0f;

/* Air pushes with the square of the speed: the cape hangs while walking. */
static const float wind_s_per_m = 0.17f;

static const struct {
	const char *a, *b;
	float radius;
} body_bones[BODY_CAPSULES] = {
	{"hips", "chest", 0.135f},
	{"chest", "neck", 0.115f},
	{"head", "head", 0.135f},
	{"upper_arm.L", "forearm.L", 0.055f},
	{"upper_arm.R", "forearm.R", 0.055f},
	{"thigh.L", "shin.L", 0.095f},
	{"thigh.R", "shin.R", 0.095f},
	{"forearm.R", "hand.R", 0.045f},
};

static int init_body(struct walker_secondary *secondary,
	const struct model *model, const struct log *log)
{
	for (int i = 0; i < BODY_CAPSULES; i++) {
		struct capsule *capsule = &secondary->body[i];
		int error = actor_find_bone(
			model, body_bones[i].a, log, &capsule->node_a);

		if (!error) {
			error = actor_find_bone(
				model, body_bones[i].b, log, &capsule->node_b);
		}
		if (error) {
			return error;
		}
		capsule->radius = body_bones[i].radius;
		if (capsule->node_a == capsule->node_b) {
			capsule->offset_a[1] = capsule->offset_b[1] = 0.11f;
		}
	}
	return 0;
}

static int init_cape(struct walker_secondary *secondary,
	struct instance *instance, const struct log *log)
{
	struct cloth_settings settings = cloth_settings_default();
	float shape[CAPE_COLUMNS * CAPE_ROWS][3];
	int pin[CAPE_COLUMNS];
	int chest;
	int error = actor_find_bone(instance->model, "chest", log, &chest);

	if (error) {
		return error;
	}
	settings.columns = CAPE_COLUMNS;
	settings.rows = CAPE_ROWS;
	settings.radius = 0.015f;
	settings.bend = 0.45f;
	for (int i = 0; i < CAPE_COLUMNS * CAPE_ROWS; i++) {
		/* Columns run from the wearer's left to right: it faces back. */
		float across = 1.0f -
			2.0f * (float)(i % CAPE_COLUMNS) / (CAPE_COLUMNS - 1);
		float down = (float)(i / CAPE_COLUMNS) / (CAPE_ROWS - 1);
		float flare = 1.0f + (cape_flare - 1.0f) * down;
		float pleat = scalar_cos(across * SCALAR_PI * cape_pleats) *
			cape_pleat_m * (0.12f + 0.88f * down);

		shape[i][0] = across * cape_half_width_m * flare;
		shape[i][1] = cape_top_m - cape_length_m * down -
			cape_drop_m * across * across;
		shape[i][2] = -cape_back_m - 0.05f * down + pleat +
			cape_wrap_m * across * across * (1.0f - 0.5f * down);
	}
	for (int i = 0; i < CAPE_COLUMNS; i++) {
		pin[i] = chest;
	}
	error = cloth_init(&secondary->cape, &settings, (const float(*)[3])shape,
		pin, (const mat4 *)instance->world, &instance->arena);
	cloth_triangles(&settings, secondary->cape_index);
	if (error) {
		log_error(log, "%s: there is not enough memory for the cape",
			instance->model->path);
	}
	return error;
}

int walker_secondary_init(struct walker_secondary *secondary,
	struct instance *instance, const struct log *log)
{
	int last;
	int error = actor_find_bone(instance->model, "ponytail.4", log, &last);

	*secondary = (struct walker_secondary){0};
	if (!error) {
		error = init_body(secondary, instance->model, log);
	}
	if (!error) {
		error = spring_init(
			&secondary->ponytail, instance->model, last, 4);
	}
	if (!error) {
		secondary->ponytail.damping = 0.35f;
		secondary->ponytail.limit_rad = 1.1f;
		secondary->ponytail.radius = 0.03f;
		error = init_cape(secondary, instance, log);
	}
	return error;
}

void walker_secondary_update(struct walker_secondary *secondary,
	struct instance *instance, float speed_m_per_s, float ponytail_weight,
	bool with_cape, float step_s)
{
	struct capsule_world body[BODY_CAPSULES];
	struct spring *ponytail = &secondary->ponytail;

	capsule_to_world(secondary->body, BODY_CAPSULES,
		(const mat4 *)instance->world, body);
	/* The figure walks on the spot, so the air moves instead. */
	secondary->cape.settings.wind[2] =
		-speed_m_per_s * speed_m_per_s * wind_s_per_m;
	ponytail->gravity[2] = -3.0f * speed_m_per_s;
	ponytail->weight = ponytail_weight;
	if (with_cape) {
		cloth_update(&secondary->cape, step_s, body, BODY_CAPSULES,
			(const mat4 *)instance->world);
	}
	spring_update(ponytail, step_s, body, BODY_CAPSULES,
		(const mat4 *)instance->world, &instance->pose);
	pose_world_from(&instance->pose, instance->model, NULL,
		ponytail->node[0], instance->world);
}

void walker_secondary_reset_cape(struct walker_secondary *secondary)
{
	cloth_reset(&secondary->cape);
}

static void set_cape_material(const struct gl *gl, float weight)
{
	static const GLfixed dull[4] = {0, 0, 0, FX16_ONE};

	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, dull);
	if (weight < 1.0f) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	} else {
		gl->Disable(GL_BLEND);
	}
	gl->Disable(GL_TEXTURE_2D);
	gl->Color4x(FX16_ONE * 82 / 100, FX16_ONE * 15 / 100,
		FX16_ONE * 19 / 100, fx16_from_float(weight));
}

void walker_secondary_draw_cape(const struct walker_secondary *secondary,
	const struct gl *gl, enum draw_pass pass, float weight)
{
	if (pass == DRAW_SHADED) {
		set_cape_material(gl, weight);
		gl->EnableClientState(GL_NORMAL_ARRAY);
		gl->NormalPointer(GL_FLOAT, 0, secondary->cape.normal);
	} else {
		gl->DisableClientState(GL_NORMAL_ARRAY);
	}
	gl->Disable(GL_CULL_FACE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, secondary->cape.position);
	gl->DrawElements(GL_TRIANGLES, CAPE_INDICES, GL_UNSIGNED_SHORT,
		secondary->cape_index);
	gl->Disable(GL_BLEND);
}

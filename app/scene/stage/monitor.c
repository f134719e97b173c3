#include "app/scene/stage/monitor.h"

#include "app/scene/draw/triangle_list.h"
#include "app/scene/stage/light.h"
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <string.h>

/* In local units: the screen is 4 : 3 and 1 high. */
static const float half_width = 2.0f / 3.0f;
static const float bezel = 0.055f;
static const float foot_height = 0.55f; /* of the screen's lower edge */

/* The monitor's size and position, as fractions of the visible area there. */
static const float width_fraction = 0.46f;  /* of the width */
static const float width_of_height = 0.42f; /* at most, of the height */
static const float margin_fraction = 0.03f;
static const float behind_fraction = 0.55f; /* of the camera's radius */
static const float turn_rad = 0.14f; /* towards the middle of the picture */

static const float body_color[3] = {0.17f, 0.18f, 0.21f};

struct box {
	float low[3], high[3];
};

static void add_face(struct monitor *monitor, int face, const struct box *box)
{
	int axis = face % 6 / 2, side = face % 2 ? 1 : -1;
	int across = (axis + 1) % 3, along = (axis + 2) % 3;
	uint32_t first = (uint32_t)face * 4;
	uint16_t *index = monitor->index + face * 6;

	for (uint32_t i = 0; i < 4; i++) {
		float *p = monitor->position[first + i];
		/* Counter-clockwise as seen from outside. */
		bool far_across = (i == 1 || i == 2) == (side > 0);

		p[axis] = side > 0 ? box->high[axis] : box->low[axis];
		p[across] = far_across ? box->high[across] : box->low[across];
		p[along] = i >= 2 ? box->high[along] : box->low[along];
		memset(monitor->normal[first + i], 0, 4);
		monitor->normal[first + i][axis] = (int8_t)(side * 127);
	}
	index = triangle_list_add(index, first, first + 1, first + 2);
	triangle_list_add(index, first, first + 2, first + 3);
}

static void make_boxes(struct monitor *monitor)
{
	const float out = half_width + bezel;
	const float low = foot_height - 1.6f * bezel;
	const float top = foot_height + 1.0f + bezel;
	const struct box box[MONITOR_BOXES] = {
		{{-out, low, -0.06f}, {out, top, 0.0f}},
		{{-0.4f * out, low + 0.15f, -0.13f},
			{0.4f * out, top - 0.2f, -0.06f}},
		{{-0.06f, 0.03f, -0.13f}, {0.06f, low + 0.3f, -0.065f}},
		{{-0.36f, 0.0f, -0.30f}, {0.36f, 0.035f, 0.16f}},
	};

	for (int i = 0; i < MONITOR_BOXES * 6; i++) {
		add_face(monitor, i, &box[i / 6]);
	}
}

void monitor_init(struct monitor *monitor)
{
	make_boxes(monitor);
}

void monitor_place(struct monitor *monitor, const struct camera *camera,
	float aspect, float floor_y)
{
	float yaw = camera->yaw_rad;
	float right[2] = {scalar_cos(yaw), -scalar_sin(yaw)};
	float back[2] = {scalar_sin(yaw), scalar_cos(yaw)};
	float behind = behind_fraction * camera->radius;
	float half = aspect * (camera->distance + behind) *
		camera_tan_half(camera->yfov_rad);
	float fraction = width_fraction * aspect < width_of_height
		? width_fraction
		: width_of_height / aspect;
	float width = fraction * 2.0f * half;
	float offset = (1.0f + camera->shift_x - 2.0f * margin_fraction) * half -
		0.5f * width;

	monitor->scale = width / (2.0f * (half_width + bezel));
	monitor->origin[0] =
		camera->target[0] - offset * right[0] - behind * back[0];
	monitor->origin[1] = floor_y;
	monitor->origin[2] =
		camera->target[2] - offset * right[1] - behind * back[1];
	monitor->yaw_rad = yaw + turn_rad;
}

static void push_matrix(const struct monitor *monitor, const struct gl *gl)
{
	GLfixed scale = fx16_from_float(monitor->scale);

	gl->PushMatrix();
	gl->Translatex(fx16_from_float(monitor->origin[0]),
		fx16_from_float(monitor->origin[1]),
		fx16_from_float(monitor->origin[2]));
	gl->Rotatex(fx16_from_float(monitor->yaw_rad * (180.0f / SCALAR_PI)), 0,
		FX16_ONE, 0);
	gl->Scalex(scale, scale, scale);
}

static void draw_body(const struct monitor *monitor, const struct gl *gl)
{
	light_set_material(gl, body_color, 0.25f, 20);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->NormalPointer(GL_BYTE, sizeof(monitor->normal[0]), monitor->normal);
	monitor_draw_geometry(monitor, gl);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->Disable(GL_LIGHTING);
}

/* Unlit, and a little darker at the lower edge. */
static void draw_picture(const struct live_texture *picture, const struct gl *gl)
{
	const float top = foot_height + 1.0f, front = 0.004f;
	const float position[4][3] = {{-half_width, top, front},
		{-half_width, foot_height, front}, {half_width, top, front},
		{half_width, foot_height, front}};
	static const int8_t texcoord[4][2] = {{0, 0}, {0, 1}, {1, 0}, {1, 1}};
	static const uint8_t lit[4][4] = {{255, 255, 255, 255},
		{226, 226, 230, 255}, {255, 255, 255, 255},
		{226, 226, 230, 255}};
	static const uint8_t dark[4][4] = {{52, 60, 74, 255}, {24, 28, 36, 255},
		{38, 45, 57, 255}, {18, 21, 28, 255}};

	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, picture ? lit : dark);
	if (picture) {
		live_texture_bind(picture, gl);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_BYTE, 0, texcoord);
	}
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	if (picture) {
		gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
		live_texture_unbind(gl);
	}
}

void monitor_draw(const struct monitor *monitor,
	const struct live_texture *picture, const struct gl *gl)
{
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	draw_body(monitor, gl);
	push_matrix(monitor, gl);
	draw_picture(picture, gl);
	gl->PopMatrix();
	gl->Disable(GL_CULL_FACE);
}

void monitor_draw_geometry(const struct monitor *monitor, const struct gl *gl)
{
	push_matrix(monitor, gl);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, monitor->position);
	gl->DrawElements(GL_TRIANGLES, MONITOR_INDICES, GL_UNSIGNED_SHORT,
		monitor->index);
	gl->PopMatrix();
}

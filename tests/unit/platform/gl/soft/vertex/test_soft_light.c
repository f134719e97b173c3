/* Each term of lighting by itself, against GL ES 1.1 section 2.12 in double. */
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <string.h>

/* What a case tells GL; all else is black, or GL's default. */
struct lit_case {
	const char *name;
	double scene[3];                            /* the model's ambient */
	double ambient[3], diffuse[3], specular[3]; /* the light's */
	double material_ambient[3], material_diffuse[4], material_specular[3];
	double emission[3], shininess;
	double position[4], attenuation[3];
	double direction[3], cutoff, exponent; /* given where cutoff > 0 */
	double normal[3];
	double scale[3]; /* of the model-view matrix; 0 is 1 */
	double color[4]; /* tracked where alpha > 0 */
	bool two_side, clockwise, normalize, rescale;
};

#define GRAY                  \
	{                     \
		0.5, 0.5, 0.5 \
	}
#define WHITE           \
	{               \
		1, 1, 1 \
	}
#define AHEAD        .position = {0, 0, 1, 0}
#define FRONT        AHEAD, .normal = {0, 0, 1}
#define MATT         .diffuse = WHITE, .material_diffuse = {0.8, 0.6, 0.2, 1}
#define GLOSS        .specular = WHITE, .material_specular = {0.9, 0.5, 0.3}
#define LIGHT_SOURCE .position = {0.3, -0.2, 1.5, 1}, .normal = {0, 0, 1}

static const struct lit_case cases[] = {
	{"nothing is black", FRONT},
	{"global ambient", .scene = {0.5, 1, 0.25},
		.material_ambient = {1, 0.5, 0.75}, FRONT},
	{"a light's ambient", .ambient = {0.5, 1, 0.25},
		.material_ambient = {1, 0.5, 0.75}, FRONT},
	{"both ambients add", .scene = GRAY, .ambient = {0.1, 0.2, 0.3},
		.material_ambient = WHITE, FRONT},
	{"emission", .emission = {0.25, 0.5, 0.75}, FRONT},
	{"too much is cut", .emission = {0.9, 0.5, 0}, MATT, FRONT},
	{"diffuse from the front", MATT, FRONT},
	{"diffuse from 60 degrees", MATT, .position = {0.8660254, 0, 0.5, 0},
		.normal = {0, 0, 1}},
	{"diffuse of a long position", MATT, .position = {0, 3, 4, 0},
		.normal = {0, 0, 1}},
	{"diffuse from behind", MATT, .position = {0, 0, -1, 0},
		.normal = {0, 0, 1}},
	{"a light that is coloured", .diffuse = {0.25, 0.5, 1},
		.material_diffuse = {0.8, 0.6, 0.2, 1}, FRONT},
	{"specular straight on", GLOSS, .shininess = 20, FRONT},
	{"specular without shininess", GLOSS, .position = {0.6, 0, 0.8, 0},
		.normal = {0, 0, 1}},
	{"specular, shininess 0.5", GLOSS, .shininess = 0.5,
		.position = {0.6, 0, 0.8, 0}, .normal = {0, 0, 1}},
	{"specular, shininess 1", GLOSS, .shininess = 1,
		.position = {0.6, 0, 0.8, 0}, .normal = {0, 0, 1}},
	{"specular, shininess 8", GLOSS, .shininess = 8,
		.position = {0.6, 0, 0.8, 0}, .normal = {0, 0, 1}},
	{"specular, shininess 33.5", GLOSS, .shininess = 33.5,
		.position = {0, 0.28, 0.96, 0}, .normal = {0, 0, 1}},
	{"specular, shininess 128", GLOSS, .shininess = 128,
		.position = {0.28, 0, 0.96, 0}, .normal = {0, 0, 1}},
	{"no specular where no diffuse", GLOSS, .position = {0.98, 0, -0.2, 0},
		.normal = {0, 0, 1}, .shininess = 2},
	{"a light brighter than 2", .diffuse = {9, 3, -5}, .scene = WHITE,
		.material_ambient = GRAY, .material_diffuse = WHITE,
		.position = {0.98, 0, 0.1, 0}, .normal = {0, 0, 1}},
	{"a point light", MATT, LIGHT_SOURCE},
	{"a point light with w", MATT, .position = {0.6, -0.4, 3, 2},
		.normal = {0, 0, 1}},
	{"a point light's specular", GLOSS, LIGHT_SOURCE, .shininess = 4},
	{"a light that takes light away", .scene = WHITE,
		.material_ambient = {1, 0.5, 0.75}, .diffuse = {-0.25, 0.5, -1},
		.material_diffuse = WHITE, FRONT},
	{"a point light that takes light away", .scene = WHITE,
		.material_ambient = {1, 0.5, 0.75}, .diffuse = {-0.25, 0.5, -1},
		.material_diffuse = WHITE, LIGHT_SOURCE},
	{"a point light's specular takes light away", .scene = WHITE,
		.material_ambient = WHITE, .specular = {-0.25, 0, -0.5},
		.material_specular = WHITE, LIGHT_SOURCE, .shininess = 2},
	{"a point's ambient dims", .scene = WHITE, .material_ambient = WHITE,
		.ambient = {-0.25, 0, -0.5}, LIGHT_SOURCE},
	{"constant attenuation", MATT, LIGHT_SOURCE, .attenuation = {2, 0, 0}},
	{"linear attenuation", MATT, LIGHT_SOURCE, .attenuation = {1, 0.5, 0}},
	{"quadratic attenuation", MATT, LIGHT_SOURCE, .attenuation = {1, 0, 0.5}},
	{"attenuation alone", MATT, LIGHT_SOURCE, .attenuation = {0, 0, 1}},
	{"attenuation of ambient", .ambient = WHITE, .material_ambient = WHITE,
		LIGHT_SOURCE, .attenuation = {1, 1, 1}},
	{"attenuation of specular", GLOSS, LIGHT_SOURCE,
		.attenuation = {1, 0.25, 0.5}, .shininess = 3},
	{"a direction does not fade", MATT, FRONT, .attenuation = {4, 1, 1}},
	{"a wide spot", MATT, LIGHT_SOURCE, .direction = {0, 0, -1},
		.cutoff = 89},
	{"a spot's exponent", MATT, LIGHT_SOURCE, .direction = {0, 0, -1},
		.cutoff = 80, .exponent = 3},
	{"a spot aside", MATT, LIGHT_SOURCE, .direction = {-1, 0, -1},
		.cutoff = 85, .exponent = 1},
	{"180 degrees are no spot", MATT, LIGHT_SOURCE, .direction = {1, 0, -1},
		.cutoff = 180, .exponent = 3},
	{"a spot that looks away", MATT, LIGHT_SOURCE, .direction = {0, 0, 1},
		.cutoff = 60},
	{"a spot has no ambient outside", .ambient = WHITE,
		.material_ambient = WHITE, LIGHT_SOURCE, .direction = {0, 0, 1},
		.cutoff = 60},
	{"a directional spot", MATT, FRONT, .ambient = GRAY, .cutoff = 80,
		.direction = {0.5, 0, -1}, .exponent = 5},
	{"a directional spot aside", MATT, FRONT, .ambient = WHITE,
		.direction = {0, 1, 0}, .cutoff = 60},
	{"a tilted normal", MATT, AHEAD, .normal = {0.6, 0, 0.8}},
	{"a long normal is taken as it is", MATT, AHEAD, .normal = {0, 0, 0.5}},
	{"a long normal is normalised", MATT, AHEAD, .normal = {1.8, 0, 2.4},
		.normalize = true},
	{"a very long one is normalised", MATT, AHEAD,
		.normal = {-1200, 0, 900}, .normalize = true},
	{"a long normal, normalised, uneven scale", MATT, AHEAD,
		.normal = {1.9, 1.9, 1.5}, .scale = {1, 1, 2}, .normalize = true},
	{"a short normal is normalised", MATT, AHEAD, .normal = {0.15, 0, 0.2},
		.normalize = true},
	{"scaled normals shrink", MATT, AHEAD, .normal = {0, 0.6, 0.8},
		.scale = {2, 2, 2}},
	{"small scales make normals long", MATT, .position = {0.98, 0, 0.2, 0},
		.normal = {0, 0, 1}, .scale = {0.25, 0.25, 0.25}},
	{"very long normals", MATT, .position = {0.98, 0, 0.2, 0},
		.normal = {0.004, 0, 0.003}, .scale = {0.01, 0.01, 0.01}},
	{"very long normals and a point", MATT, .ambient = GRAY,
		.normal = {0, 0.004, 0.003}, .position = {0.3, -0.2, 1.5, 1},
		.scale = {0.01, 0.01, 0.01}, .material_ambient = GRAY},
	{"uneven scale is rescaled", MATT, AHEAD, .normal = {0, 0.6, 0.8},
		.scale = {1, 2, 0.5}, .rescale = true},
	{"scaled normals are rescaled", MATT, AHEAD, .normal = {0, 0.6, 0.8},
		.scale = {4, 4, 4}, .rescale = true},
	{"rescaling keeps own lengths", MATT, AHEAD, .normal = {0, 0.3, 0.4},
		.scale = {0.5, 0.5, 0.5}, .rescale = true},
	{"uneven scale is normalised", MATT, AHEAD, .normal = {0.6, 0, 0.8},
		.scale = {2, 1, 0.5}, .normalize = true},
	{"scale and a point light", MATT, LIGHT_SOURCE, .scale = {3, 3, 3},
		.normalize = true},
	{"one side: the back is lit as the front", MATT, FRONT,
		.clockwise = true},
	{"two sides: the front", MATT, FRONT, .two_side = true},
	{"two sides: the back turns its normal", MATT, FRONT, .two_side = true,
		.clockwise = true},
	{"two sides: the back from behind", MATT, .position = {0, 0.6, -0.8, 0},
		.normal = {0, 0, 1}, .two_side = true, .clockwise = true},
	{"two sides: the back's specular", GLOSS, .shininess = 2, AHEAD,
		.normal = {0, 0.6, -0.8}, .two_side = true, .clockwise = true},
	{"colour material is diffuse", .diffuse = WHITE,
		.color = {0.3, 0.7, 0.1, 1}, FRONT},
	{"colour material is ambient", .scene = GRAY, .ambient = {0.2, 0.1, 0},
		.color = {0.3, 0.7, 1, 1}, .normal = {0, 0, 1},
		.position = {0, 0, -1, 0}},
	{"colour material is not emission", .emission = GRAY, .diffuse = GRAY,
		.color = {0.2, 0.4, 0.9, 1}, FRONT},
	{"colour material and a point light", .diffuse = WHITE, LIGHT_SOURCE,
		.attenuation = {1, 0.5, 0}, .color = {1, 0.5, 0.25, 1}},
};

static const double corners[3][3] = {{-1, -1, 0.1}, {1, -1, 0.1}, {0, 1, 0.1}};

static double dot(const double *a, const double *b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normalize(double *v)
{
	double length = sqrt(dot(v, v));

	for (int i = 0; i < 3 && length > 0; i++) {
		v[i] /= length;
	}
}

static double scale_of(const struct lit_case *c, int i)
{
	return c->scale[i] != 0 ? c->scale[i] : 1;
}

/* By the inverse of the model-view matrix, which only scales. */
static void find_normal(const struct lit_case *c, double n[3])
{
	for (int i = 0; i < 3; i++) {
		n[i] = c->normal[i] / scale_of(c, i);
		n[i] *= c->rescale ? scale_of(c, 2) : 1;
	}
	if (c->normalize) {
		normalize(n);
	}
	for (int i = 0; i < 3 && c->two_side && c->clockwise; i++) {
		n[i] = -n[i];
	}
}

/* How much arrives, and the unit vector that points at the light. */
static double find_light(
	const struct lit_case *c, const double eye[3], double towards[3])
{
	double distance, along, share, axis[3], w = c->position[3];

	for (int i = 0; i < 3; i++) {
		towards[i] = c->position[i];
		towards[i] = w == 0 ? towards[i] : towards[i] / w - eye[i];
	}
	distance = sqrt(dot(towards, towards));
	normalize(towards);
	share = c->attenuation[0] + c->attenuation[1] * distance +
		c->attenuation[2] * distance * distance;
	share = w != 0 && share > 0 ? 1 / share : 1;
	if (c->cutoff == 0 || c->cutoff == 180) {
		return share;
	}
	memcpy(axis, c->direction, sizeof(axis));
	normalize(axis);
	along = -dot(axis, towards);
	return along < cos(c->cutoff * acos(-1) / 180)
		? 0
		: share * pow(along, c->exponent);
}

static void light_vertex(
	const struct lit_case *c, const double eye[3], double out[3])
{
	double n[3], towards[3], half[3], share, diffuse, spec_table;
	bool tracked = c->color[3] > 0;

	find_normal(c, n);
	share = find_light(c, eye, towards);
	memcpy(half, towards, sizeof(half));
	half[2] += 1;
	normalize(half);
	diffuse = fmax(dot(n, towards), 0);
	spec_table = diffuse > 0 ? pow(fmax(dot(n, half), 0), c->shininess) : 0;
	for (int i = 0; i < 3; i++) {
		double dull = tracked ? c->color[i] : c->material_diffuse[i];
		double dark = tracked ? c->color[i] : c->material_ambient[i];

		out[i] = c->emission[i] + dark * c->scene[i] +
			share *
				(dark * c->ambient[i] +
					diffuse * dull * c->diffuse[i] +
					spec_table * c->material_specular[i] *
						c->specular[i]);
		out[i] = fmin(fmax(out[i], 0), 1);
	}
}

static void set_light(struct gl *gl, GLenum name, const double *rgb)
{
	GLfixed fixed[4] = {[3] = 65536};

	gl_fixed_all(rgb, 3, fixed);
	gl->Lightxv(GL_LIGHT0, name, fixed);
}

static void set_material(struct gl *gl, GLenum name, const double *rgb)
{
	GLfixed fixed[4] = {[3] = 65536};

	gl_fixed_all(rgb, 3, fixed);
	gl->Materialxv(GL_FRONT_AND_BACK, name, fixed);
}

static void tell_light(struct gl *gl, const struct lit_case *c)
{
	GLfixed fixed[4];

	set_light(gl, GL_AMBIENT, c->ambient);
	set_light(gl, GL_DIFFUSE, c->diffuse);
	set_light(gl, GL_SPECULAR, c->specular);
	gl_fixed_all(c->position, 4, fixed);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, fixed);
	for (GLenum i = 0; i < 3; i++) {
		bool given = c->attenuation[0] + c->attenuation[1] +
				c->attenuation[2] >
			0;

		gl->Lightx(GL_LIGHT0, GL_CONSTANT_ATTENUATION + i,
			gl_fixed(given ? c->attenuation[i] : i == 0));
	}
	if (c->cutoff > 0) {
		gl_fixed_all(c->direction, 3, fixed);
		gl->Lightxv(GL_LIGHT0, GL_SPOT_DIRECTION, fixed);
		gl->Lightx(GL_LIGHT0, GL_SPOT_CUTOFF, gl_fixed(c->cutoff));
		gl->Lightx(GL_LIGHT0, GL_SPOT_EXPONENT, gl_fixed(c->exponent));
	}
	gl->Enable(GL_LIGHT0);
	gl->Enable(GL_LIGHTING);
}

static void tell_material(struct gl *gl, const struct lit_case *c)
{
	GLfixed fixed[4] = {[3] = 65536};

	gl_fixed_all(c->scene, 3, fixed);
	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, fixed);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, c->two_side);
	set_material(gl, GL_AMBIENT, c->material_ambient);
	set_material(gl, GL_DIFFUSE, c->material_diffuse);
	set_material(gl, GL_SPECULAR, c->material_specular);
	set_material(gl, GL_EMISSION, c->emission);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, gl_fixed(c->shininess));
	(c->color[3] > 0 ? gl->Enable : gl->Disable)(GL_COLOR_MATERIAL);
	(c->normalize ? gl->Enable : gl->Disable)(GL_NORMALIZE);
	(c->rescale ? gl->Enable : gl->Disable)(GL_RESCALE_NORMAL);
	gl_set_color(gl, c->color);
	gl->Normal3x(gl_fixed(c->normal[0]), gl_fixed(c->normal[1]),
		gl_fixed(c->normal[2]));
}

/* Where normals and tracked colours come from. */
enum given {
	CURRENT,
	FLOATS,
	SHORTS
};

/* What the arrays of draw_case() point to. */
struct lit_arrays {
	float vertex[3][3], normal[3][3];
	int16_t short_normal[3][3];
	uint8_t color[3][4];
};

static void tell_arrays(struct gl *gl, const struct lit_case *c,
	enum given given, struct lit_arrays *arrays)
{
	double most = fmax(fmax(fabs(c->normal[0]), fabs(c->normal[1])),
		fabs(c->normal[2]));

	for (int i = 0; i < 9; i++) {
		double n = c->normal[i % 3];

		arrays->normal[i / 3][i % 3] = (float)n;
		arrays->short_normal[i / 3][i % 3] =
			(int16_t)lrint(n * 20000 / most);
	}
	for (int i = 0; i < 12; i++) {
		arrays->color[i / 4][i % 4] =
			(uint8_t)lrint(c->color[i % 4] * 255);
	}
	if (given != CURRENT) {
		gl->EnableClientState(GL_NORMAL_ARRAY);
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, arrays->color);
		gl->NormalPointer(GL_FLOAT, 0, arrays->normal);
	}
	if (given == SHORTS) {
		gl->NormalPointer(GL_SHORT, 0, arrays->short_normal);
	}
}

static void draw_case(struct gl *gl, const struct lit_case *c, enum given given,
	struct lit_arrays *arrays)
{
	float(*vertex)[3] = arrays->vertex;

	tell_light(gl, c);
	tell_material(gl, c);
	tell_arrays(gl, c, given, arrays);
	for (int i = 0; i < 9; i++) {
		int corner = c->clockwise ? 2 - i / 3 : i / 3;

		vertex[i / 3][i % 3] =
			(float)(corners[corner][i % 3] / scale_of(c, i % 3));
	}
	gl->Scalex(gl_fixed(scale_of(c, 0)), gl_fixed(scale_of(c, 1)),
		gl_fixed(scale_of(c, 2)));
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, vertex);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

/* The colours of the corners, mixed at a pixel's centre. */
static void expect_lit(
	const struct gl_canvas *canvas, const struct lit_case *c, int x, int y)
{
	double px = (x + 0.5) * 2 / GL_CANVAS_WIDTH - 1;
	double py = 1 - (y + 0.5) * 2 / GL_CANVAS_HEIGHT;
	double top = (py + 1) / 2;
	double right = (px + 1 - top) / 2;
	const double share[3] = {1 - top - right, right, top};
	double color[3] = {0, 0, 0};

	for (int i = 0; i < 3; i++) {
		double lit[3];

		light_vertex(c, corners[i], lit);
		for (int j = 0; j < 3; j++) {
			color[j] += share[i] * lit[j];
		}
	}
	gl_expect_color(canvas, c->name, x, y, color);
}

static void check_cases(enum pixel_format format, enum given given)
{
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas = gl_canvas_open("soft", format);
		struct lit_case c = cases[i];
		struct lit_arrays arrays;

		/* Shorts have no length of use. */
		c.normalize |= given == SHORTS;
		draw_case(canvas.gl, &c, given, &arrays);
		expect_lit(&canvas, &c, 2, 22);
		expect_lit(&canvas, &c, 29, 22);
		expect_lit(&canvas, &c, 15, 3);
		expect_lit(&canvas, &c, 17, 14);
		gl_canvas_end_frame(&canvas);
		gl_canvas_close(&canvas);
	}
}

static void test_each_term_is_the_formulas(void **state)
{
	(void)state;
	check_cases(PIXELS_RGBA8888, CURRENT);
}

static void test_each_term_is_the_formulas_in_565(void **state)
{
	(void)state;
	check_cases(PIXELS_RGB565, CURRENT);
}

static void test_each_term_is_the_formulas_by_arrays(void **state)
{
	(void)state;
	check_cases(PIXELS_RGBA8888, FLOATS);
	check_cases(PIXELS_RGBA8888, SHORTS);
}

/* Eight lights of an eighth each; then one goes out. */
static void test_every_light_counts(void **state)
{
	static const GLfixed eighth[] = {8192, 8192, 8192, 65536};
	static const GLfixed white[] = {65536, 65536, 65536, 65536};
	static const GLfixed black[] = {0, 0, 0, 65536};
	static const GLfixed from_front[] = {0, 0, 65536, 0};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	for (GLenum i = 0; i < 8; i++) {
		gl->Lightxv(GL_LIGHT0 + i, GL_DIFFUSE, eighth);
		gl->Lightxv(GL_LIGHT0 + i, GL_SPECULAR, black);
		gl->Lightxv(GL_LIGHT0 + i, GL_POSITION, from_front);
		gl->Enable(GL_LIGHT0 + i);
	}
	gl_canvas_draw_all(gl);
	gl_expect_color(&canvas, "eight", 9, 9, (double[]){1, 1, 1});
	gl->Disable(GL_LIGHT0 + 5);
	gl_canvas_draw_all(gl);
	gl_expect_color(&canvas, "seven", 9, 9, (double[]){0.875, 0.875, 0.875});
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* A position is turned by the matrix of when it is told, not of drawing. */
static void test_a_position_goes_to_eye_space_at_once(void **state)
{
	static const GLfixed along_x[] = {65536, 0, 0, 0};
	static const GLfixed white[] = {65536, 65536, 65536, 65536};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->PushMatrix();
	gl->Rotatex(-60 * 65536, 0, 65536, 0);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, along_x);
	gl->PopMatrix();
	gl_canvas_draw_all(gl);
	/* (cos 60, 0, sin 60) */
	gl_expect_color(&canvas, "turned", 9, 9,
		(double[]){0.8660254, 0.8660254, 0.8660254});
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_term_is_the_formulas),
		cmocka_unit_test(test_each_term_is_the_formulas_in_565),
		cmocka_unit_test(test_each_term_is_the_formulas_by_arrays),
		cmocka_unit_test(test_every_light_counts),
		cmocka_unit_test(test_a_position_goes_to_eye_space_at_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

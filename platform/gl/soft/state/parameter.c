/* Setting a parameter by its name. */
#include "platform/gl/soft/state/parameter.h"

void soft_set_error(struct soft *soft, GLenum error)
{
	if (soft->error == GL_NO_ERROR) {
		soft->error = error;
	}
}

bool soft_is_one_of(GLenum value, const GLenum *known, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (known[i] == value) {
			return true;
		}
	}
	return false;
}

void soft_set_parameter(const struct soft_parameter *table, size_t count,
	void *object, GLenum name, const GLfixed *values, int given)
{
	const struct soft_parameter *p = table, *end = table + count;

	while (p != end && (p->name != name || p->count > given)) {
		p++;
	}
	if (soft_check(p != end, GL_INVALID_ENUM) &&
		soft_check(!p->takes || p->takes(values[0]), p->error)) {
		GLfixed *out = (GLfixed *)(void *)((char *)object + p->offset);

		for (int i = 0; i < p->count; i++) {
			out[i] = values[i];
		}
	}
}

/*
 * What calls of GL share that set state: their errors, and parameters that have
 * names. A table for each kind of object tells which parameters it has.
 */
#ifndef PLATFORM_GL_SOFT_STATE_PARAMETER_H
#define PLATFORM_GL_SOFT_STATE_PARAMETER_H

#include "platform/base/compiler.h"
#include "platform/gl/soft/soft.h"

/* Whether a call of the current context may go on; else it sets the error. */
static inline bool soft_check(bool may_go_on, GLenum error)
{
	if (!may_go_on) {
		soft_set_error(soft_current(), error);
	}
	return may_go_on;
}

bool soft_is_one_of(GLenum value, const GLenum *known, size_t count);

/* Whether a value is one of those listed. */
#define IS_ONE_OF(value, ...)                                \
	soft_is_one_of(value, (const GLenum[]){__VA_ARGS__}, \
		sizeof((const GLenum[]){__VA_ARGS__}) / sizeof(GLenum))

/* Values of 32 bits, enumerants or 16.16, that follow one another in a struct. */
struct soft_parameter {
	GLenum name;
	int count;
	size_t offset;
	bool (*takes)(GLfixed value); /* a single one, or NULL: all */
	GLenum error;                 /* of others */
};

/* Entries of tables: a member of a struct that may be anything, and others. */
#define SOFT_ANY(name, type, member)                                 \
	{                                                            \
		name, sizeof(((type *)0)->member) / sizeof(GLfixed), \
			offsetof(type, member), NULL, GL_NO_ERROR    \
	}
#define SOFT_ENUM(name, type, member, takes)                            \
	{                                                               \
		name, 1, offsetof(type, member), takes, GL_INVALID_ENUM \
	}
#define SOFT_NUMBER(name, type, member, takes)                           \
	{                                                                \
		name, 1, offsetof(type, member), takes, GL_INVALID_VALUE \
	}

/*
 * Sets the parameter of an object that has the name, or GL's error. given is
 * how many values there are: 1 by the calls for scalars, else 4.
 */
void soft_set_parameter(const struct soft_parameter *table, size_t count,
	void *object, GLenum name, const GLfixed *values, int given);

#define SET_PARAMETER(table, ...) \
	soft_set_parameter(table, ARRAY_COUNT(table), __VA_ARGS__)

#endif

/*
 * Collects the accessors of the file to write. Accessors with equal content are
 * stored once, and accessors of one layout share a buffer view.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_OUTPUT_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_OUTPUT_H

#include "app/compare/export/glb.h"

/* What a buffer view holds. */
enum optimize_view {
	OPTIMIZE_DATA,     /* keys and sparse values, tightly packed */
	OPTIMIZE_MATRICES, /* inverse bind matrices */
	OPTIMIZE_INDICES,
	OPTIMIZE_VERTICES, /* padded to 4 bytes; + stride / 4 is the view */
	OPTIMIZE_VIEWS = OPTIMIZE_VERTICES + 5
};

/* An accessor's elements: numbers that fit the component's type. */
struct optimize_array {
	int count, width;
	int rows; /* components of a matrix's column; 0: no matrix */
	enum glb_component component;
	bool normalized;
	bool bounded;          /* write min and max */
	bool sparse;           /* may leave out elements that are 0 */
	const float *value;    /* [count * width], or NULL */
	const uint32_t *index; /* [count * width], if value is NULL */
};

struct optimize_output {
	struct glb glb;
	struct optimize_bytes {
		uint8_t *data;
		size_t size, capacity;
	} view[OPTIMIZE_VIEWS];
	int count, capacity;
	struct optimize_accessor {
		enum optimize_view view;
		size_t offset, size;
		uint64_t hash;
		int component, width, rows;
		bool normalized, bounded;
		json_t *json; /* glb.accessors owns it */
		bool dense;
		int next; /* next in the hash bucket, or -1 */
	} * accessor;
	int bucket[1024];
};

void optimize_output_begin(struct optimize_output *output);

/* Returns the index of the accessor, or -1 after setting glb.error. */
int optimize_output_add(struct optimize_output *output, enum optimize_view view,
	const struct optimize_array *array);

/* Adds the buffer views, after which glb can be written. Releases all else. */
void optimize_output_end(struct optimize_output *output);

/* The decimal of the fewest digits, at most 9, that is read back as value. */
double optimize_decimal(float value);

#endif

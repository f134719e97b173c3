/*
 * The numbers of the file to write: accessors of equal content are stored once,
 * and all accessors of one layout share a buffer view.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_OUTPUT_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_OUTPUT_H

#include "app/compare/export/glb.h"

/* What a buffer view holds. */
enum optimize_view {
	OPTIMIZE_DATA,     /* keys and sparse values; without gaps */
	OPTIMIZE_MATRICES, /* of skins */
	OPTIMIZE_INDICES,
	OPTIMIZE_VERTICES, /* elements padded to 4 bytes, one view a stride */
	OPTIMIZE_VIEWS = OPTIMIZE_VERTICES + 5
};

/* Elements as numbers of the component's type. */
struct optimize_array {
	int count, width;
	enum glb_component component;
	bool normalized;
	bool bounded;       /* write the least and the most of each component */
	bool sparse;        /* may leave out elements that are 0 */
	const float *value; /* [count * width], or NULL */
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
		int component, width;
		bool normalized;
		json_t *json; /* glb.accessors owns it */
		bool dense;
		int next; /* with the same hash, or -1 */
	} * accessor;
	int bucket[1024];
};

void optimize_output_begin(struct optimize_output *output);

/*
 * Returns the number of the accessor, or -1 after a failure, which
 * glb.error keeps.
 */
int optimize_output_add(struct optimize_output *output, enum optimize_view view,
	const struct optimize_array *array);

/* Adds the buffer views; glb can be written then. Releases everything else. */
void optimize_output_end(struct optimize_output *output);

/* The nearest decimal fraction of 9 digits at most that is read as value. */
double optimize_decimal(float value);

#endif

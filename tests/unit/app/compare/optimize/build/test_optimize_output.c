/* Where the numbers of an optimised file lie, byte by byte. */
#include "app/compare/optimize/build/optimize_output.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

static int begin(void **state)
{
	static struct optimize_output output;

	/* Memory that nothing wrote to has this byte. */
	mallopt(M_PERTURB, 0x5A);
	optimize_output_begin(&output);
	*state = &output;
	return 0;
}

static int end(void **state)
{
	struct optimize_output *output = *state;

	optimize_output_end(output);
	glb_discard(&output->glb);
	mallopt(M_PERTURB, 0);
	return 0;
}

static json_t *accessor(const struct optimize_output *output, int number)
{
	json_t *json = json_array_get(output->glb.accessors, (size_t)number);

	assert_non_null(json);
	return json;
}

static int integer(json_t *object, const char *key)
{
	return (int)json_integer_value(json_object_get(object, key));
}

/* A number from some bytes, the lowest first. */
static uint32_t read_number(const uint8_t *bytes, size_t size)
{
	uint32_t number = 0;

	for (size_t i = 0; i < size; i++) {
		number |= (uint32_t)bytes[i] << 8 * i;
	}
	return number;
}

/* Elements of integers lie at a stride, with zeros between and behind them. */
static void expect_elements(const struct optimize_output *output, int number,
	const struct optimize_array *array, size_t stride, size_t padded)
{
	json_t *json = accessor(output, number);
	size_t bytes = glb_component_bytes(array->component);
	size_t used = (size_t)array->width * bytes;
	const uint8_t *data = output->view[integer(json, "bufferView")].data +
		integer(json, "byteOffset");

	assert_int_equal(integer(json, "count"), array->count);
	assert_int_equal(integer(json, "componentType"), array->component);
	for (size_t i = 0; i < padded; i++) {
		size_t element = i / stride, within = i % stride;
		size_t at = element * (size_t)array->width + within / bytes;

		if (element >= (size_t)array->count || within >= used) {
			assert_int_equal(data[i], 0);
		} else if (within % bytes == 0) {
			assert_int_equal(
				read_number(data + i, bytes), array->index[at]);
		}
	}
}

static void test_elements_are_padded_with_zeros(void **state)
{
	struct optimize_output *output = *state;
	static const uint32_t index[20] = {200, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
		11, 12, 13, 14, 15, 16, 17, 18, 19};
	static const enum glb_component components[] = {
		GLB_UBYTE, GLB_USHORT, GLB_UINT};

	for (size_t i = 0; i < 4 * ARRAY_COUNT(components); i++) {
		struct optimize_array array = {.count = 5,
			.width = 1 + (int)i % 4,
			.component = components[i / 4],
			.index = index};
		size_t element = (size_t)array.width *
			glb_component_bytes(array.component);
		size_t stride = (element + 3) / 4 * 4;
		int number =
			optimize_output_add(output, OPTIMIZE_VERTICES, &array);

		expect_elements(output, number, &array, stride, 5 * stride);
		assert_int_equal(integer(accessor(output, number), "bufferView"),
			(int)OPTIMIZE_VERTICES + (int)stride / 4);
		number = optimize_output_add(output, OPTIMIZE_INDICES, &array);
		expect_elements(output, number, &array, element,
			(5 * element + 3) / 4 * 4);
		assert_int_equal(integer(accessor(output, number), "bufferView"),
			OPTIMIZE_INDICES);
		assert_int_equal(output->view[OPTIMIZE_INDICES].size % 4, 0);
	}
}

/* What differs in bytes, type, width or view is stored apart. */
static void test_equal_arrays_are_stored_once(void **state)
{
	struct optimize_output *output = *state;
	static const uint32_t index[6] = {1, 2, 3, 4, 5, 6};
	static const uint32_t other[6] = {1, 2, 3, 4, 5, 7};
	const struct optimize_array first = {
		.count = 6, .width = 1, .component = GLB_USHORT, .index = index};
	struct optimize_array array = first;
	size_t size;

	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 0);
	size = output->view[OPTIMIZE_DATA].size;
	assert_int_equal(size, 12);
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 0);
	assert_int_equal(output->view[OPTIMIZE_DATA].size, size);
	array.index = other;
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 1);
	array = first;
	array.normalized = true;
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 2);
	array = first;
	array.width = 2;
	array.count = 3;
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 3);
	array = first;
	array.count = 5;
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &array), 4);
	assert_int_equal(
		optimize_output_add(output, OPTIMIZE_INDICES, &first), 5);
	assert_int_equal(
		optimize_output_add(output, OPTIMIZE_INDICES, &first), 5);
	assert_int_equal(optimize_output_add(output, OPTIMIZE_DATA, &first), 0);
	assert_int_equal(json_array_size(output->glb.accessors), 6);
}

static void test_many_arrays_are_told_apart(void **state)
{
	enum {
		COUNT = 3000
	};
	struct optimize_output *output = *state;

	for (int pass = 0; pass < 2; pass++) {
		for (uint32_t i = 0; i < COUNT; i++) {
			const uint32_t index[2] = {i, COUNT - i};
			const struct optimize_array array = {.count = 2,
				.width = 1,
				.component = GLB_UINT,
				.index = index};

			assert_int_equal(optimize_output_add(
						 output, OPTIMIZE_DATA, &array),
				i);
		}
	}
	assert_int_equal(output->view[OPTIMIZE_DATA].size, COUNT * 8);
}

enum {
	SPARSE_COUNT = 300
};

static struct optimize_array sparse_array(const uint32_t *index)
{
	return (struct optimize_array){.count = SPARSE_COUNT,
		.width = 3,
		.component = GLB_USHORT,
		.sparse = true,
		.index = index};
}

/* Expects that an accessor's sparse values are these shorts, zeros included. */
static void expect_values(const struct optimize_output *output,
	const json_t *sparse, const uint32_t *wanted, size_t count)
{
	json_t *json = json_object_get(sparse, "values");
	const uint8_t *data =
		output->view[OPTIMIZE_DATA].data + integer(json, "byteOffset");

	for (size_t i = 0; i < count; i++) {
		assert_int_equal(read_number(data + 2 * i, 2), wanted[i]);
	}
}

/* Where few elements are not 0, those and their numbers take fewer bytes. */
static void test_few_elements_are_stored_sparsely(void **state)
{
	static const uint32_t wanted[10] = {0, 0, 5, 0, 6, 0, 0x1234, 0, 0, 0};
	static uint32_t index[SPARSE_COUNT * 3];
	struct optimize_output *output = *state;
	const struct optimize_array array = sparse_array(index);
	const uint8_t *numbers;
	json_t *json, *sparse;

	index[3 * 7 + 2] = 5;
	index[3 * 8 + 1] = 6;
	index[3 * 299] = 0x1234;
	json = accessor(
		output, optimize_output_add(output, OPTIMIZE_VERTICES, &array));
	assert_null(json_object_get(json, "bufferView"));
	sparse = json_object_get(json, "sparse");
	assert_int_equal(integer(sparse, "count"), 3);
	json = json_object_get(sparse, "indices");
	assert_int_equal(integer(json, "componentType"), GLB_USHORT);
	numbers = output->view[OPTIMIZE_DATA].data + integer(json, "byteOffset");
	assert_int_equal(read_number(numbers, 2), 7);
	assert_int_equal(read_number(numbers + 2, 2), 8);
	/* The last one, and zeros up to a multiple of 4 bytes. */
	assert_int_equal(read_number(numbers + 4, 4), 299);
	expect_values(output, sparse, wanted, ARRAY_COUNT(wanted));
}

static void test_a_sparse_array_may_begin_with_its_first_element(void **state)
{
	static const uint32_t wanted[6] = {0, 0, 8, 0, 9, 0};
	static uint32_t index[SPARSE_COUNT * 3];
	struct optimize_output *output = *state;
	const struct optimize_array array = sparse_array(index);
	json_t *json, *sparse;

	/* Another one lies before it. */
	index[3 * 7 + 2] = 5;
	optimize_output_add(output, OPTIMIZE_VERTICES, &array);
	index[3 * 7 + 2] = 0;
	index[2] = 8;
	index[3 * 299 + 1] = 9;
	json = accessor(
		output, optimize_output_add(output, OPTIMIZE_VERTICES, &array));
	sparse = json_object_get(json, "sparse");
	assert_int_equal(integer(sparse, "count"), 2);
	json = json_object_get(sparse, "indices");
	assert_int_equal(read_number(output->view[OPTIMIZE_DATA].data +
					 integer(json, "byteOffset"),
				 4),
		299 << 16);
	expect_values(output, sparse, wanted, ARRAY_COUNT(wanted));
}

static void test_full_arrays_and_those_of_others_are_not_sparse(void **state)
{
	static uint32_t index[SPARSE_COUNT * 3];
	struct optimize_output *output = *state;
	struct optimize_array array = sparse_array(index);
	json_t *json;

	index[2] = 8;
	index[3 * 299 + 1] = 9;
	array.sparse = false;
	json = accessor(
		output, optimize_output_add(output, OPTIMIZE_VERTICES, &array));
	assert_null(json_object_get(json, "sparse"));
	array.sparse = true;
	for (int i = 0; i < SPARSE_COUNT * 3; i++) {
		index[i] = 1;
	}
	json = accessor(
		output, optimize_output_add(output, OPTIMIZE_VERTICES, &array));
	assert_null(json_object_get(json, "sparse"));
}

static void test_bounds_are_the_least_and_the_most(void **state)
{
	struct optimize_output *output = *state;
	static const float value[4][2] = {
		{0.5f, -1.0f}, {-0.25f, 7.0f}, {3.0f, 0.1f}, {0.0f, -2.0f}};
	static const double low[2] = {-0.25, -2.0}, high[2] = {3.0, 7.0};
	const struct optimize_array array = {.count = 4,
		.width = 2,
		.component = GLB_FLOAT,
		.bounded = true,
		.value = value[0]};
	json_t *json = accessor(
		output, optimize_output_add(output, OPTIMIZE_DATA, &array));

	assert_memory_equal(
		output->view[OPTIMIZE_DATA].data, value, sizeof(value));
	for (size_t i = 0; i < 2; i++) {
		assert_near(json_number_value(json_array_get(
				    json_object_get(json, "min"), i)),
			low[i], 0.0);
		assert_near(json_number_value(json_array_get(
				    json_object_get(json, "max"), i)),
			high[i], 0.0);
	}
	assert_string_equal(
		json_string_value(json_object_get(json, "type")), "VEC2");
}

/* Weights may be equal to the times of their keys. */
static void test_times_do_not_share_an_accessor_with_values(void **state)
{
	struct optimize_output *output = *state;
	static const float value[2] = {0.0f, 2.0f};
	struct optimize_array array = {
		.count = 2, .width = 1, .component = GLB_FLOAT, .value = value};

	for (int i = 0; i < 2; i++) {
		for (int bounded = 0; bounded < 2; bounded++) {
			array.bounded = bounded != 0;
			assert_int_equal(optimize_output_add(
						 output, OPTIMIZE_DATA, &array),
				bounded);
		}
	}
	assert_null(json_object_get(accessor(output, 0), "min"));
	assert_non_null(json_object_get(accessor(output, 1), "min"));
}

/* The text is what JSON holds; each needs one digit more than the one before. */
static void test_a_decimal_has_the_fewest_digits(void **state)
{
	static const double decimals[] = {0.0, 0.1, -1.1, 4.56, 123.4, 4.5678,
		0.300001, 0.1000001, 0.10000001, 0.100000024, 3e38, -1e-40};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(decimals); i++) {
		assert_near(
			optimize_decimal((float)decimals[i]), decimals[i], 0);
	}
}

/* Indices of sparse elements are shorts where all of the array's are. */
static void test_indices_of_sparse_elements_fit_their_type(void **state)
{
	struct optimize_output *output = *state;
	static float value[65537];

	for (int count = 65534; count <= 65537; count++) {
		struct optimize_array array = {.count = count,
			.width = 1,
			.component = GLB_FLOAT,
			.sparse = true,
			.value = value};
		size_t size = count <= 65535 ? 2 : 4;
		json_t *sparse, *indices;
		const uint8_t *index;
		int number;

		memset(value, 0, sizeof(value));
		value[1] = 0.5f;
		value[count - 1] = (float)count;
		number = optimize_output_add(output, OPTIMIZE_DATA, &array);
		sparse = json_object_get(accessor(output, number), "sparse");
		indices = json_object_get(sparse, "indices");
		assert_int_equal(integer(sparse, "count"), 2);
		assert_int_equal(integer(indices, "componentType"),
			size == 2 ? GLB_USHORT : GLB_UINT);
		index = output->view[OPTIMIZE_DATA].data +
			integer(indices, "byteOffset");
		assert_int_equal(read_number(index, size), 1);
		assert_int_equal(read_number(index + size, size), count - 1);
	}
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, begin, end)
	const struct CMUnitTest tests[] = {
		CASE(test_elements_are_padded_with_zeros),
		CASE(test_equal_arrays_are_stored_once),
		CASE(test_many_arrays_are_told_apart),
		CASE(test_few_elements_are_stored_sparsely),
		CASE(test_a_sparse_array_may_begin_with_its_first_element),
		CASE(test_indices_of_sparse_elements_fit_their_type),
		CASE(test_full_arrays_and_those_of_others_are_not_sparse),
		CASE(test_bounds_are_the_least_and_the_most),
		CASE(test_times_do_not_share_an_accessor_with_values),
		cmocka_unit_test(test_a_decimal_has_the_fewest_digits),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}

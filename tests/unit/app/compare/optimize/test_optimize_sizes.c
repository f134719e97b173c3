/* What the bytes of a glTF file are used for. */
#include "app/compare/optimize/optimize_sizes.h"
#include "tests/support/test.h"

#include <string.h>

/*
 * Accessors of 1, 2, 4... bytes, so that each sum tells which are in it; the
 * last is used by nothing. They have as many elements.
 */
static const char accessors[] =
	"\"buffers\":[{\"byteLength\":512}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":512}],\"accessors\":["
	"{\"bufferView\":0,\"componentType\":5121,\"count\":1,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":2,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":4,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":8,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":16,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":32,\"type\":\"SCALAR\"},"
	"{\"bufferView\":0,\"componentType\":5121,\"count\":64,\"type\":\"SCALAR\"}]}";

static struct optimize_sizes sizes_with(const char *users, const char *arrays)
{
	/* A binary glTF file: two headers, the JSON, one header, the bytes. */
	static uint8_t file[4096];
	const struct log log = log_to_stderr(LOG_WARNING);
	uint32_t json_bytes = 2048, all = 12 + 8 + json_bytes + 8 + 512;
	const uint32_t head[5] = {0x46546C67, 2, all, json_bytes, 0x4E4F534A};
	const uint32_t binary[2] = {512, 0x004E4942};
	struct model_source source = {.name = "sizes.glb",
		.data = file,
		.size = all,
		.memory_bytes = MODEL_MEMORY_BYTES};
	struct gltf_document *document;
	struct optimize_sizes sizes;

	memset(file, ' ', sizeof(file));
	memcpy(file, head, sizeof(head));
	memcpy(file + 20 + json_bytes, binary, sizeof(binary));
	memset(file + 20 + json_bytes + sizeof(binary), 0, 512);
	snprintf((char *)file + 20, json_bytes,
		"{\"asset\":{\"version\":\"2.0\"},%s%s", users, arrays);
	file[20 + strlen((char *)file + 20)] = ' ';
	assert_int_equal(gltf_document_open(&source, &log, &document), 0);
	assert_int_equal(optimize_sizes_of(document, &sizes), 0);
	gltf_document_close(document);
	assert_int_equal(sizes.file, all);
	assert_int_equal(
		sizes.rest, all - sizes.keys - sizes.vertices - sizes.indices);
	return sizes;
}

static void expect(const char *users, size_t keys, long key_count,
	size_t vertices, size_t indices)
{
	struct optimize_sizes sizes = sizes_with(users, accessors);

	assert_int_equal(sizes.keys, keys);
	assert_int_equal(sizes.key_count, key_count);
	assert_int_equal(sizes.vertices, vertices);
	assert_int_equal(sizes.indices, indices);
}

static void test_a_file_without_users_is_all_rest(void **state)
{
	(void)state;
	expect("", 0, 0, 0, 0);
}

static void test_attributes_and_targets_are_vertices(void **state)
{
	(void)state;
	expect("\"meshes\":[{\"primitives\":[{\"attributes\":"
	       "{\"POSITION\":0,\"NORMAL\":1},\"indices\":5,\"targets\":["
	       "{\"POSITION\":2},{\"POSITION\":3,\"NORMAL\":4}]}]}],",
		0, 0, 1 + 2 + 4 + 8 + 16, 32);
}

/* Each mesh and primitive has its turn, and what they share counts once. */
static void test_an_accessor_counts_once(void **state)
{
	(void)state;
	expect("\"meshes\":[{\"primitives\":["
	       "{\"attributes\":{\"POSITION\":0},\"indices\":3},"
	       "{\"attributes\":{\"POSITION\":0,\"NORMAL\":1},\"indices\":3}]},"
	       "{\"primitives\":[{\"attributes\":{\"POSITION\":1},"
	       "\"indices\":4}]}],",
		0, 0, 1 + 2, 8 + 16);
}

/*
 * Columns of matrices are aligned to 4 bytes, those of sparse values too: three
 * MAT2 of bytes, one MAT3 of shorts, one of floats, and of two MAT3 of bytes
 * the second alone with its index.
 */
static void test_columns_of_matrices_are_padded(void **state)
{
	struct optimize_sizes sizes = sizes_with(
		"\"meshes\":[{\"primitives\":[{\"attributes\":"
		"{\"_A\":0,\"_B\":1,\"_C\":2,\"_D\":3}}]}],",
		"\"buffers\":[{\"byteLength\":512}],\"bufferViews\":["
		"{\"buffer\":0,\"byteLength\":64},"
		"{\"buffer\":0,\"byteOffset\":64,\"byteLength\":64}],"
		"\"accessors\":["
		"{\"bufferView\":0,\"componentType\":5121,\"count\":3,"
		"\"type\":\"MAT2\"},"
		"{\"bufferView\":0,\"componentType\":5123,\"count\":1,"
		"\"type\":\"MAT3\"},"
		"{\"bufferView\":0,\"componentType\":5126,\"count\":1,"
		"\"type\":\"MAT3\"},"
		"{\"componentType\":5121,\"count\":2,\"type\":\"MAT3\","
		"\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":1,"
		"\"componentType\":5121},\"values\":{\"bufferView\":1}}}]}");

	(void)state;
	assert_int_equal(sizes.vertices, 3 * 8 + 3 * 8 + 36 + (12 + 1));
}

/* The bytes of shared times count once, the keys of each channel. */
static void test_channels_count_their_samplers(void **state)
{
	(void)state;
	expect("\"animations\":[{\"samplers\":["
	       "{\"input\":0,\"output\":1},{\"input\":2,\"output\":3},"
	       "{\"input\":2,\"output\":4}],\"channels\":["
	       "{\"sampler\":1},{\"sampler\":2}]},"
	       "{\"samplers\":[{\"input\":5,\"output\":4}],\"channels\":["
	       "{\"sampler\":0}]}],",
		4 + 8 + 16 + 32, 4 + 4 + 32, 0, 0);
}

static void test_numbers_of_no_accessor_count_nothing(void **state)
{
	(void)state;
	expect("\"meshes\":[{\"primitives\":[{\"attributes\":"
	       "{\"POSITION\":7,\"NORMAL\":-1,\"_A\":\"x\",\"_B\":6},"
	       "\"indices\":99}]}],\"animations\":[{\"samplers\":["
	       "{\"input\":7,\"output\":-3},{\"input\":\"x\"},{\"output\":5}],"
	       "\"channels\":[{\"sampler\":0},{\"sampler\":1},{\"sampler\":2},"
	       "{\"sampler\":9}]}],",
		32, 0, 64, 0);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_file_without_users_is_all_rest),
		cmocka_unit_test(test_attributes_and_targets_are_vertices),
		cmocka_unit_test(test_an_accessor_counts_once),
		cmocka_unit_test(test_columns_of_matrices_are_padded),
		cmocka_unit_test(test_channels_count_their_samplers),
		cmocka_unit_test(test_numbers_of_no_accessor_count_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

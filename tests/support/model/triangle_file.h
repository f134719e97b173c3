/*
 * A glTF file of triangles, for tests that need models of a certain size.
 */
#ifndef TESTS_SUPPORT_MODEL_TRIANGLE_FILE_H
#define TESTS_SUPPORT_MODEL_TRIANGLE_FILE_H

/*
 * Writes a file whose mesh 0 is a triangle with the corners 0 0 0, 1 0 0 and
 * 0 1 0, and whose only root is node 0. nodes is the list of nodes, such as
 * "{\"mesh\":0}".
 */
void triangle_file_write(const char *path, const char *nodes);

#endif

/* PLY files whose data are not what their headers say are refused in one line that says where; what is right is read,
 * as text and as bytes. */
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "scene/load.h"

/* A pyramid: three corners on the floor, a tip 1 above, and four faces. */
#define HEAD(format)                                                                                         \
    "ply\nformat " format " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"   \
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
static const char whole[] = HEAD("ascii") "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

/* The pyramid with the first FROM become TO. */
static char *changed(const char *from, const char *to)
{
    struct aob_text text = {0};
    const char *at = strstr(whole, from);
    assert_non_null(at);
    aob_text_add(&text, "%.*s%s%s", (int)(at - whole), whole, to, at + strlen(from));
    return text.data;
}

static void wrong_texts_are_told(void **state)
{
    static const char *const cases[][3] = {
        {"3 1 2 3\n", "", ": line 17: it ends before face 3 of 4"},
        {"3 1 2 3\n", "3 1 2", ": line 17: it ends within face 3 of 4"},
        {"\n1 0 0\n", "\n1 0\n", ": line 11: vertex 1 has no z"},
        {"\n1 0 0\n", "\n1 O 0\n", ": line 11: vertex 1: its y is no number"},
        {"\n1 0 0\n", "\n1 0 0 7\n", ": line 11: vertex 1 has more numbers than the header says"},
        {"\n1 0 0\n", "\n1 0 0x1\n", ": line 11: vertex 1: its z is no number"},
        {"3 0 3 2", "3 0 9 2", ": line 16: face 2 names vertex 9 of 4"},
        {"3 0 3 2", "3 0 -1 2", ": line 16: face 2 names vertex -1 of 4"},
        {"3 0 3 2", "3 0 4 2", ": line 16: face 2 names vertex 4 of 4"},
        {"3 0 3 2", "3 0 3.5 2", ": line 16: face 2: its vertex_indices is no whole number"},
        {"3 0 3 2", "5 0 3 2", ": line 16: face 2 ends within its vertex_indices"},
        {"3 0 3 2", "2 0 3 2", ": line 16: face 2 has more numbers than the header says"},
        {"3 0 3 2", "0", ": line 16: face 2: its vertex_indices has 0 values"},
        {"3 0 3 2", "-3 0 3 2", ": line 16: face 2: its vertex_indices has -3 values"},
        {"3 0 3 2", "300000000 0 3 2", ": line 16: face 2 ends within its vertex_indices"},
        {"vertex 4", "vertex 4000000000", ": line 14: vertex 4 has more numbers than the header says"},
        {"vertex 4", "vertex -4", ": line 3: the number of its element 'vertex' is '-4'"},
        {"face 4", "face 4000000000", ": line 18: it ends before face 4 of 4000000000"},
        {"face 4", "face 3", ": line 17: it goes on behind the last element"},
        {"float x", "flaot x", ": line 4: a property of its element 'vertex' has the type 'flaot'"},
        {"list uchar", "list float", ": line 8: a property of its element 'face' has the type 'float'"},
        {"ascii", "asci", ": line 2: its format is 'asci'"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_error error;
        char *text = changed(cases[i][0], cases[i][1]);
        refuse_text("ply", text, &error);
        assert_contains(error.text, cases[i][2]);
        assert_contains(error.text, "the file is damaged");
        free(text);
    }
}

/* Six times the volume within the faces. */
static double volume(const struct aob_mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        sum +=
            aob_vec_dot(mesh->positions[t[0]], aob_vec_cross(mesh->positions[t[1]], mesh->positions[t[2]]));
    }
    return sum;
}

static void assert_pyramid(struct aob_mesh *mesh)
{
    assert_int_equal(mesh->triangle_count, 4);
    assert_near(volume(mesh), 1, 1e-12);
    aob_mesh_finish(mesh);
}

/* What people and programs write, and the format allows. */
static void right_texts_are_read(void **state)
{
    static const char *const cases[][2] = {
        {"\n1 0 0\n", "\n1 0 0\n"},
        {"\n1 0 0\n", "\n\n 1\t0   0 \n\n"},
        {"\n1 0 0\n", "\n+1.0e0 .0 -0\n"},
        {"\n1 0 0\n", "\r\n1 0 0\r\n"},
        {"3 1 2 3\n", "3 1 2 3"},
        {"3 1 2 3\n", "3 1 2 3\n\n \n"},
        {"element vertex", "comment element face 9\nobj_info property float\nelement vertex"},
        {"vertex_indices", "vertex_index"},
        {"list uchar int", "list uint8 int32"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        char *text = changed(cases[i][0], cases[i][1]);
        load_text(&mesh, "ply", text);
        assert_pyramid(&mesh);
        free(text);
    }
    struct aob_mesh mesh;
    char *text = changed("ply", "ply");
    for (char *c = text; *c; c++)
        *c = *c == '\n' ? '\r' : *c;
    load_text(&mesh, "ply", text);
    assert_pyramid(&mesh);
    free(text);
}

/* A number of `size` bytes, the lowest first unless `big`. */
static void put(struct aob_text *text, const void *number, size_t size, bool big)
{
    const char *bytes = number;
    for (size_t i = 0; i < size; i++)
        aob_text_add_bytes(text, bytes + (big ? size - 1 - i : i), 1);
}

/* The numbers of the text, as bytes. */
static void make_bytes(struct aob_text *text, bool big)
{
    const char *at = whole + strlen(HEAD("ascii"));
    aob_text_add(text, "%s", big ? HEAD("binary_big_endian") : HEAD("binary_little_endian"));
    for (int i = 0; i < 12; i++) {
        char *end;
        float value = strtof(at, &end);
        put(text, &value, 4, big);
        at = end;
    }
    for (int i = 0; i < 16; i++) {
        char *end;
        int32_t value = (int32_t)strtol(at, &end, 10);
        put(text, &value, i % 4 ? 4 : 1, big);
        at = end;
    }
}

static void refuse_bytes(const struct paths *paths, const char *bytes, size_t size, const char *why)
{
    struct aob_error error;
    assert_true(aob_file_write(paths->source, bytes, size, NULL));
    refuse_file(paths->source, &error);
    assert_contains(error.text, why);
}

static void bytes_are_held_to_their_header(void **state)
{
    (void)state;
    for (int big = 0; big < 2; big++) {
        struct aob_text text = {0};
        struct paths paths;
        struct aob_mesh mesh;
        make_paths(&paths, "ply");
        make_bytes(&text, big);
        assert_true(aob_file_write(paths.source, text.data, text.size, NULL));
        assert_int_equal(load(paths.source, paths.flat), LOADED);
        assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
        assert_pyramid(&mesh);
        refuse_bytes(&paths, text.data, text.size - 1, ": it ends within face 3 of 4: the file is damaged");
        refuse_bytes(&paths, text.data, text.size - 13, ": it ends before face 3 of 4: the file is damaged");
        refuse_bytes(&paths, text.data, text.size - 4 * 13 - 5, ": it ends within vertex 3 of 4");
        text.data[text.size - 13] = 0;
        refuse_bytes(&paths, text.data, text.size, ": face 3: its vertex_indices has 0 values");
        text.data[text.size - 13] = 3;
        text.data[text.size - (big ? 1 : 4)] = 4;
        refuse_bytes(&paths, text.data, text.size, ": face 3 names vertex 4 of 4: the file is damaged");
        unlink(paths.source);
        unlink(paths.flat);
        aob_text_finish(&text);
    }
}

/* A cloud of points is a right file. */
static void points_are_no_mesh(void **state)
{
    struct aob_error error;
    (void)state;
    refuse_text("ply",
                "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n1 2 3\n",
                &error);
    assert_string_equal(error.text, ": it has no triangles: there is nothing to render");
}

/* assimp knows a PLY by its first line, so we do. */
static void endings_do_not_matter(void **state)
{
    struct aob_error error;
    (void)state;
    refuse_text("off", "ply\nformat ascii 1.0\nelement vertex 1\n", &error);
    assert_contains(error.text, "no end_header");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_texts_are_told),           cmocka_unit_test(right_texts_are_read),
        cmocka_unit_test(bytes_are_held_to_their_header), cmocka_unit_test(points_are_no_mesh),
        cmocka_unit_test(endings_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

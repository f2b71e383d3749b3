#include "second_reader.h"
#include <assimp/cimport.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"

/* Numbers of a line, all of it. How many there are; -1: something else is there. */
static int read_numbers(const char *line, double *values, int most)
{
    int count = 0;
    for (line += strspn(line, " \t"); *line && *line != '\r'; line += strspn(line, " \t")) {
        char *end;
        if (count == most || strspn(line, "+-.0123456789") == 0)
            return -1;
        values[count++] = strtod(line, &end);
        if (end == line || !strchr(" \t\r", *end))
            return -1;
        line = end;
    }
    return count;
}

/* v, vn, vt, f, o, g, s, usemtl, mtllib and comments; no negative indices. */
static bool read_obj_line(char *line, struct faces *faces)
{
    static const char *const skipped[] = {"vn ", "vt ", "o ", "g ", "s ", "usemtl ", "mtllib ", "#"};
    double p[3];
    if (strncmp(line, "v ", 2) == 0) {
        if (read_numbers(line + 2, p, 3) != 3)
            return false;
        faces_add_point(faces, p[0], p[1], p[2]);
        return true;
    }
    if (strncmp(line, "f ", 2) == 0) {
        double corner[8];
        int count = read_numbers(line + 2, corner, 8);
        for (int i = 0; i < count; i++) {
            if (corner[i] < 1 || corner[i] > 1e9 || corner[i] != floor(corner[i]))
                return false;
            *AOB_PUSH(faces->corners, faces->corner_count, faces->corner_capacity) = (uint32_t)corner[i] - 1;
        }
        *AOB_PUSH(faces->sizes, faces->face_count, faces->face_capacity) = (uint32_t)count;
        return count >= 3;
    }
    for (size_t i = 0; i < AOB_COUNT(skipped); i++)
        if (strncmp(line, skipped[i], strlen(skipped[i])) == 0)
            return true;
    return !line[strspn(line, " \t\r")];
}

static bool read_obj(char *bytes, size_t size, struct faces *faces)
{
    if (strlen(bytes) != size)
        return false;
    for (char *line = bytes, *next; line && *line; line = next) {
        next = strchr(line, '\n');
        if (next)
            *next++ = '\0';
        if (!read_obj_line(line, faces))
            return false;
    }
    return true;
}

static const char ply_head[] = "element vertex %zu\nproperty float x\nproperty float y\nproperty float z\n"
                               "element face %zu\nproperty list uchar int vertex_indices\nend_header\n%n";

static bool read_ply_text(char *body, size_t points, size_t triangles, struct faces *faces)
{
    double v[9];
    for (size_t i = 0; i < points + triangles; i++) {
        char *next = strchr(body, '\n');
        if (!next)
            return false;
        *next++ = '\0';
        int count = read_numbers(body, v, 9);
        if (i < points) {
            if (count != 3)
                return false;
            faces_add_point(faces, v[0], v[1], v[2]);
        } else {
            if (count < 4 || v[0] != count - 1)
                return false;
            for (int k = 1; k < count; k++)
                if (v[k] < 0 || v[k] > 1e9 || v[k] != floor(v[k]))
                    return false;
                else
                    *AOB_PUSH(faces->corners, faces->corner_count, faces->corner_capacity) = (uint32_t)v[k];
            *AOB_PUSH(faces->sizes, faces->face_count, faces->face_capacity) = (uint32_t)count - 1;
        }
        body = next;
    }
    return !*body;
}

static bool read_ply_bytes(const char *body, size_t size, size_t points, size_t triangles,
                           struct faces *faces)
{
    if (points > size || triangles > size || size != 12 * points + 13 * triangles)
        return false;
    for (size_t i = 0; i < points; i++, body += 12) {
        float p[3];
        memcpy(p, body, 12);
        faces_add_point(faces, (double)p[0], (double)p[1], (double)p[2]);
    }
    for (size_t i = 0; i < triangles; i++, body += 13) {
        if (*body != 3)
            return false;
        for (int k = 0; k < 3; k++)
            memcpy(AOB_PUSH(faces->corners, faces->corner_count, faces->corner_capacity), body + 1 + 4 * k,
                   4);
        *AOB_PUSH(faces->sizes, faces->face_count, faces->face_capacity) = 3;
    }
    return true;
}

static bool read_ply(char *bytes, size_t size, struct faces *faces)
{
    static const char text[] = "ply\nformat ascii 1.0\n", binary[] = "ply\nformat binary_little_endian 1.0\n";
    bool is_text = strncmp(bytes, text, sizeof text - 1) == 0;
    size_t points, triangles;
    int head = 0;
    if (!is_text && strncmp(bytes, binary, sizeof binary - 1) != 0)
        return false;
    char *rest = bytes + (is_text ? sizeof text : sizeof binary) - 1;
    if (sscanf(rest, ply_head, &points, &triangles, &head) != 2 || !head || points > 1e6 || triangles > 1e6)
        return false;
    /* scanf takes any white space; what stands there must be what this reader expects. */
    char *exact = NULL;
    if (asprintf(&exact,
                 "element vertex %zu\nproperty float x\nproperty float y\nproperty float z\nelement face "
                 "%zu\nproperty list uchar int vertex_indices\nend_header\n",
                 points, triangles) < 0)
        return false;
    size_t length = strlen(exact);
    bool same = strncmp(rest, exact, length) == 0;
    free(exact);
    rest += length;
    if (!same)
        return false;
    return is_text ? strlen(bytes) == size && read_ply_text(rest, points, triangles, faces)
                   : read_ply_bytes(rest, size - (size_t)(rest - bytes), points, triangles, faces);
}

static bool read_stl(const char *bytes, size_t size, struct faces *faces)
{
    uint32_t triangles = 0;
    if (size >= 84)
        memcpy(&triangles, bytes + 80, 4);
    if (size < 84 || size != 84 + 50 * (size_t)triangles || strncmp(bytes, "solid", 5) == 0)
        return false;
    for (uint32_t i = 0; i < triangles; i++) {
        float p[9];
        memcpy(p, bytes + 84 + 50 * (size_t)i + 12, sizeof p);
        for (int k = 0; k < 3; k++) {
            faces_add_point(faces, (double)p[3 * k], (double)p[3 * k + 1], (double)p[3 * k + 2]);
            *AOB_PUSH(faces->corners, faces->corner_count, faces->corner_capacity) =
                (uint32_t)faces->point_count - 1;
        }
        *AOB_PUSH(faces->sizes, faces->face_count, faces->face_capacity) = 3;
    }
    return true;
}

/* --- glTF ------------------------------------------------------------------------------------------------- */

static struct aiVector3D transformed(const struct aiMatrix4x4 *m, struct aiVector3D v)
{
    return (struct aiVector3D){m->a1 * v.x + m->a2 * v.y + m->a3 * v.z + m->a4,
                               m->b1 * v.x + m->b2 * v.y + m->b3 * v.z + m->b4,
                               m->c1 * v.x + m->c2 * v.y + m->c3 * v.z + m->c4};
}

static void add_node(const struct aiScene *scene, const struct aiNode *node, struct aiMatrix4x4 place,
                     struct faces *faces)
{
    aiMultiplyMatrix4(&place, &node->mTransformation);
    for (unsigned m = 0; m < node->mNumMeshes; m++) {
        const struct aiMesh *mesh = scene->mMeshes[node->mMeshes[m]];
        uint32_t first = (uint32_t)faces->point_count;
        for (unsigned i = 0; i < mesh->mNumVertices; i++) {
            struct aiVector3D p = transformed(&place, mesh->mVertices[i]);
            faces_add_point(faces, (double)p.x, (double)p.y, (double)p.z);
        }
        for (unsigned i = 0; i < mesh->mNumFaces; i++) {
            if (mesh->mFaces[i].mNumIndices != 3)
                continue;
            for (int k = 0; k < 3; k++)
                *AOB_PUSH(faces->corners, faces->corner_count, faces->corner_capacity) =
                    first + mesh->mFaces[i].mIndices[k];
            *AOB_PUSH(faces->sizes, faces->face_count, faces->face_capacity) = 3;
        }
    }
    for (unsigned i = 0; i < node->mNumChildren; i++)
        add_node(scene, node->mChildren[i], place, faces);
}

static bool read_by_assimp(const char *file, struct mesh_sums *sums)
{
    const struct aiScene *scene = aiImportFile(file, aiProcess_Triangulate | aiProcess_ValidateDataStructure);
    struct aiMatrix4x4 identity;
    struct faces faces = {0};
    if (!scene)
        return false;
    aiIdentityMatrix4(&identity);
    add_node(scene, scene->mRootNode, identity, &faces);
    return faces_sum(&faces, sums);
}

/* assimp may crash or never end, so it runs in a process of its own. */
static bool read_apart(const char *file, struct mesh_sums *sums)
{
    int ends[2], status;
    if (pipe(ends) != 0)
        return false;
    fflush(NULL);
    pid_t pid = fork();
    if (pid == 0) {
        const struct rlimit seconds = {20, 20}, core = {0, 0};
        setrlimit(RLIMIT_CPU, &seconds);
        setrlimit(RLIMIT_CORE, &core);
        if (!freopen("/dev/null", "w", stderr))
            _exit(1);
        bool ok = read_by_assimp(file, sums);
        _exit(!(ok && write(ends[1], sums, sizeof *sums) == (ssize_t)sizeof *sums));
    }
    close(ends[1]);
    bool ok = pid > 0 && read(ends[0], sums, sizeof *sums) == (ssize_t)sizeof *sums;
    close(ends[0]);
    return pid > 0 && waitpid(pid, &status, 0) == pid && ok && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/* What assimp is known to read wrongly: positions that are no floats, skins, morph targets, and documents whose numbers
 * say other things than a strict reader takes. */
static bool assimp_can_judge(const char *bytes, size_t size)
{
    static const char *const beyond[] = {"KHR_", "EXT_", "\"skin", "\"targets", "\"sparse"};
    for (size_t i = 0; i < AOB_COUNT(beyond); i++)
        if (memmem(bytes, size, beyond[i], strlen(beyond[i])))
            return false;
    return true;
}

bool second_reader(const char *file, struct mesh_sums *sums)
{
    const char *ending = strrchr(file, '.');
    size_t size;
    char *bytes = aob_file_read(file, (size_t)1 << 28, &size, NULL);
    struct faces faces = {0};
    bool ok = false;
    if (!bytes)
        return false;
    if (strcmp(ending, ".obj") == 0)
        ok = read_obj(bytes, size, &faces) && faces_sum(&faces, sums);
    else if (strcmp(ending, ".ply") == 0)
        ok = read_ply(bytes, size, &faces) && faces_sum(&faces, sums);
    else if (strcmp(ending, ".stl") == 0)
        ok = read_stl(bytes, size, &faces) && faces_sum(&faces, sums);
    else if (strcmp(ending, ".gltf") == 0 || strcmp(ending, ".glb") == 0)
        ok = assimp_can_judge(bytes, size) && read_apart(file, sums);
    faces_finish(&faces);
    free(bytes);
    return ok;
}

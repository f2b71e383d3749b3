#include "damaged_mesh.h"
#include "gltf_document.h"
#include "job/mesh_job.h"
#include "random.h"
#include "second_reader.h"

static uint32_t seed;

/* A quarter are cut off, a quarter have a bit turned anywhere, a quarter one within the first 400 bytes, and a quarter
 * four bytes set to an extreme. */
static size_t damage(char *bytes, size_t size, int variant)
{
    static const uint32_t extremes[] = {0xffffffffu, 0x7fffffffu, 0x80000000u, 0, 0x7f800000u};
    size_t reach = variant % 4 == 1 || size < 400 ? size : 400;
    if (variant % 4 == 0)
        return random_below(&seed, size);
    if (variant % 4 == 3)
        memcpy(bytes + random_below(&seed, size - 4), &extremes[random_below(&seed, 5)], 4);
    else
        bytes[random_below(&seed, reach)] ^= (char)(1 << random_below(&seed, 8));
    return size;
}

static json_t *job(const struct damaged *d)
{
    return aob_mesh_job_to_json(&(struct aob_mesh_job){d->file, d->out});
}

static const char *judge(const struct damaged *d)
{
    struct mesh_sums ours, second;
    struct aob_mesh mesh;
    if (!second_reader(d->file, &second))
        return NULL;
    if (!aob_mesh_restore(&mesh, d->out, NULL))
        return "the flat file cannot be read";
    mesh_sums_of(&mesh, &ours);
    aob_mesh_finish(&mesh);
    return mesh_sums_agree(&ours, &second) ? "" : "a second reader reads something else";
}

/* A sphere, for formats that are written here. */
static void make_sphere(struct aob_mesh *mesh)
{
    *mesh = (struct aob_mesh){0};
    aob_mesh_add_sphere(mesh, aob_vec(0.5, 1, -2), 1.5, 12);
}

static void put_place(struct aob_text *text, const struct aob_mesh *mesh, size_t vertex)
{
    const float p[3] = {(float)mesh->positions[vertex].x, (float)mesh->positions[vertex].y,
                        (float)mesh->positions[vertex].z};
    aob_text_add_bytes(text, (const char *)p, sizeof p);
}

static void make_ply(struct aob_text *text, bool binary)
{
    struct aob_mesh mesh;
    make_sphere(&mesh);
    aob_text_add(
        text,
        "ply\nformat %s 1.0\nelement vertex %zu\nproperty float x\nproperty float y\nproperty float z\n"
        "element face %zu\nproperty list uchar int vertex_indices\nend_header\n",
        binary ? "binary_little_endian" : "ascii", mesh.vertex_count, mesh.triangle_count);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        if (binary)
            put_place(text, &mesh, i);
        else
            aob_text_add(text, "%.9g %.9g %.9g\n", mesh.positions[i].x, mesh.positions[i].y,
                         mesh.positions[i].z);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        const uint32_t *t = mesh.triangles[i];
        aob_text_add_bytes(text, "\3", binary);
        if (binary)
            aob_text_add_bytes(text, (const char *)t, 12);
        else
            aob_text_add(text, "3 %u %u %u\n", t[0], t[1], t[2]);
    }
    aob_mesh_finish(&mesh);
}

static void make_text_ply(struct aob_text *text)
{
    make_ply(text, false);
}

static void make_binary_ply(struct aob_text *text)
{
    make_ply(text, true);
}

static void make_stl(struct aob_text *text)
{
    static const char head[80] = "a sphere", normal[12] = "", rest[2] = "";
    struct aob_mesh mesh;
    make_sphere(&mesh);
    uint32_t count = (uint32_t)mesh.triangle_count;
    aob_text_add_bytes(text, head, sizeof head);
    aob_text_add_bytes(text, (const char *)&count, 4);
    for (uint32_t i = 0; i < count; i++) {
        aob_text_add_bytes(text, normal, sizeof normal);
        for (int k = 0; k < 3; k++)
            put_place(text, &mesh, mesh.triangles[i][k]);
        aob_text_add_bytes(text, rest, sizeof rest);
    }
    aob_mesh_finish(&mesh);
}

/* Two boxes, one of them below a node that is turned and moved. */
static const char two_nodes[] =
    "'scene': 0, 'scenes': [{'nodes': [0, 1]}], 'nodes': [{'mesh': 0}, {'rotation': [0.6, 0, 0, 0.8], "
    "'children': [2]}, "
    "{'mesh': 0, 'translation': [4, 1, 0.5], 'scale': [2, 1, 1]}], 'meshes': [{'primitives': [{" BOX
    ", 'material': 0}]}], 'materials': [{'name': 'paint', 'pbrMetallicRoughness': {'baseColorFactor': [1, "
    "0.5, 0.25, 1]}}]";
/* The same with a morph target and an instance of it. */
static const char deformed[] = "'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0, 'weights': [0.5], "
                               "'extensions': {'EXT_mesh_gpu_instancing': "
                               "{'attributes': {'TRANSLATION': 0}}}}], 'meshes': [{'primitives': [{" BOX
                               ", 'targets': [{'POSITION': 0}]}]}]";

static void make_gltf(struct aob_text *text, const char *rest)
{
    struct document d = {0};
    document_put_box(&d);
    aob_text_add(&d.rest, "%s", rest);
    char *json = document_json(&d, NULL);
    aob_text_add(text, "%s", json);
    free(json);
    document_finish(&d);
}

static void make_plain_gltf(struct aob_text *text)
{
    make_gltf(text, two_nodes);
}

static void make_deformed_gltf(struct aob_text *text)
{
    make_gltf(text, deformed);
}

static void make_glb(struct aob_text *text)
{
    struct document d = {0};
    document_put_box(&d);
    aob_text_add(&d.rest, "%s", two_nodes);
    document_binary(&d, text);
    document_finish(&d);
}

static void read_packaged(struct aob_text *text, const char *file)
{
    size_t size;
    char *bytes = aob_file_read(file, 1 << 26, &size, NULL);
    assert_non_null(bytes); /* ./dev installs these */
    aob_text_add_bytes(text, bytes, size);
    free(bytes);
}

static void read_obj(struct aob_text *text)
{
    read_packaged(text, "/usr/share/doc/embree3/models/cornell_box.obj");
}

static void read_3ds(struct aob_text *text)
{
    read_packaged(text, "/usr/share/glmark2/models/asteroid-low.3ds");
}

static const struct kind {
    const char *ending;
    void (*make)(struct aob_text *text);
    int share; /* of ten */
} kinds[] = {{".obj", read_obj, 2},
             {".ply", make_text_ply, 1},
             {".ply", make_binary_ply, 1},
             {".stl", make_stl, 1},
             {".3ds", read_3ds, 1},
             {".gltf", make_plain_gltf, 2},
             {".gltf", make_deformed_gltf, 1},
             {".glb", make_glb, 1}};

/* The time limit is for files that never end; no right one comes near it, however busy the machine is. */
void damaged_meshes(int files, struct damaged_counts *counts)
{
    seed = 1;
    for (size_t i = 0; i < AOB_COUNT(kinds); i++) {
        struct aob_text text = {0};
        char file[64], out[64];
        snprintf(file, sizeof file, "/tmp/aobudget-damaged-%ld%s", (long)getpid(), kinds[i].ending);
        snprintf(out, sizeof out, "/tmp/aobudget-damaged-%ld.mesh", (long)getpid());
        kinds[i].make(&text);
        damaged_run(&(struct damaged){.what = kinds[i].ending,
                                      .file = file,
                                      .out = out,
                                      .job = job,
                                      .answer = "triangles",
                                      .timeout_s = 60,
                                      .memory_limit = (size_t)1 << 29,
                                      .damage = damage,
                                      .variants = files * kinds[i].share / 10,
                                      .may_crash = true, /* assimp is not ours */
                                      .judge = judge},
                    text.data, text.size, counts);
        aob_text_finish(&text);
    }
}

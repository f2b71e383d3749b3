#include "worker.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "scene/camera.h"
#include "scene/mesh.h"
#include "technique/definition.h"
#include "technique/graph.h"
#include "technique/param.h"

void aob_worker_reply(struct aob_worker *worker, json_t *answer)
{
    char *line = aob_json_line(answer, 17);
    size_t size = strlen(line), sent = 0;
    line[size++] = '\n';
    while (sent < size) {
        ssize_t n = write(worker->reply, line + sent, size - sent);
        if (n <= 0)
            exit(AOB_EXIT_USAGE); /* nobody listens any more */
        sent += (size_t)n;
    }
    free(line);
    json_decref(answer);
}

bool aob_worker_registry(struct aob_worker *worker, struct aob_registry *registry, struct aob_error *error)
{
    const json_t *modules = json_object_get(worker->job, "modules");
    aob_registry_init(registry);
    for (size_t i = 0; i < json_array_size(modules); i++)
        if (!aob_registry_load(registry, json_string_value(json_array_get(modules, i)), error)) {
            aob_registry_finish(registry);
            return false;
        }
    return true;
}

bool aob_worker_params(const struct aob_technique *technique, const json_t *numbers, void *values,
                       struct aob_error *error)
{
    double params[AOB_MAX_PARAM];
    if (!aob_json_to_vector(numbers, params, technique->param_count))
        return aob_fail(error, "%s: the job has not %u parameters", technique->name, technique->param_count);
    aob_param_pack(technique->params, technique->param_count, params, values, 4 * AOB_MAX_PARAM);
    return true;
}

static bool get_pose(const json_t *object, struct aob_vec3 *eye, struct aob_vec3 *target)
{
    double e[3], t[3];
    if (!aob_json_to_vector(json_object_get(object, "eye"), e, 3) ||
        !aob_json_to_vector(json_object_get(object, "target"), t, 3))
        return false;
    *eye = aob_vec(e[0], e[1], e[2]);
    *target = aob_vec(t[0], t[1], t[2]);
    return true;
}

bool aob_worker_camera(const json_t *object, struct aob_camera *camera, struct aob_error *error)
{
    const json_t *previous = json_object_get(object, "previous");
    *camera = (struct aob_camera){.moves = json_is_object(previous)};
    if (!get_pose(object, &camera->eye, &camera->target) ||
        !aob_json_to_vector(json_object_get(object, "shift"), camera->shift, 2) ||
        (camera->moves && !get_pose(previous, &camera->previous_eye, &camera->previous_target)))
        return aob_fail(error, "the job has no camera");
    camera->fov_deg = json_number_value(json_object_get(object, "fov_deg"));
    camera->ortho_height = json_number_value(json_object_get(object, "ortho_height"));
    return aob_camera_check(camera, error);
}

static bool describe(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_registry registry;
    if (!aob_worker_registry(worker, &registry, error))
        return false;
    for (size_t i = 0; i < registry.count; i++)
        aob_worker_reply(worker, aob_technique_to_json(&registry.entries[i]));
    aob_registry_finish(&registry);
    return true;
}

/* null where the technique has no radius to trace; NULL with a line if the definition makes no sense. */
static json_t *definition_to_json(const struct aob_technique *technique, const void *values,
                                  struct aob_error *error)
{
    struct aob_definition_table table;
    json_t *falloff = json_null();
    if (!aob_definition_tabulate(technique, values, &table, error))
        return NULL;
    if (!table.claims)
        return json_null();
    if (table.fades)
        falloff = json_array();
    for (int i = 0; table.fades && i < AOB_FALLOFF_ROWS; i++)
        json_array_append_new(falloff, aob_json_number((double)table.falloff[i]));
    return json_pack("{s:o, s:b, s:o, s:b}", "radius", aob_json_number((double)table.radius), "uniform",
                     table.uniform, "falloff", falloff, "of_triangle", table.of_triangle);
}

static json_t *laid_out(const struct aob_pass_graph *graph, const void *values, int index, json_t *definition)
{
    struct aob_text dot = {0};
    char key[AOB_KEY_SIZE];
    aob_graph_digest(graph, values, key);
    aob_graph_dot(graph, &dot);
    json_t *answer = json_pack("{s:i, s:s, s:s, s:s, s:b, s:o, s:b}", "index", index, "status", "ok", "graph",
                               key, "dot", dot.data, "triangles", aob_graph_needs_triangles(graph),
                               "definition", definition, "mapped", graph->technique->definition.map != NULL);
    aob_text_finish(&dot);
    return answer;
}

static json_t *layout_case(const struct aob_technique *technique, const json_t *numbers, int index)
{
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    json_t *definition = NULL, *answer;
    bool ok = aob_worker_params(technique, numbers, values, &error) &&
              aob_graph_build(graph, technique, values, AOB_OUTPUTS_REQUIRED, AOB_OUTPUTS_WANTED, &error);
    if (ok && !(definition = definition_to_json(technique, values, &error)))
        ok = aob_fail_in(&error, "%s", technique->name);
    answer = ok ? laid_out(graph, values, index, definition)
                : json_pack("{s:i, s:s, s:s}", "index", index, "status", "invalid", "reason", error.text);
    free(graph);
    return answer;
}

static bool layout(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_registry registry;
    const char *name = json_string_value(json_object_get(worker->job, "technique"));
    const json_t *cases = json_object_get(worker->job, "cases");
    if (!aob_worker_registry(worker, &registry, error))
        return false;
    const struct aob_registry_entry *entry = aob_registry_find(&registry, name ? name : "");
    for (size_t i = 0; entry && i < json_array_size(cases); i++)
        aob_worker_reply(worker, layout_case(entry->technique, json_array_get(cases, i), (int)i));
    aob_registry_finish(&registry);
    return entry || aob_fail(error, "no technique '%s'", name);
}

static bool load_mesh(struct aob_worker *worker, struct aob_error *error)
{
    const char *file, *out;
    struct aob_mesh mesh = {0};
    struct aob_vec3 low, high;
    if (json_unpack((json_t *)(uintptr_t)worker->job, "{s:s, s:s}", "file", &file, "out", &out) != 0)
        return aob_fail(error, "a mesh job needs file and out");
    /* A cached file that is damaged or of an older form is made again. */
    bool ok = (aob_file_exists(out) && aob_mesh_restore(&mesh, out, NULL)) ||
              (aob_mesh_import(&mesh, file, error) && aob_mesh_save(&mesh, out, error));
    if (!ok)
        return false;
    aob_mesh_bounds(&mesh, &low, &high);
    struct aob_error warnings[AOB_MESH_WARNINGS];
    json_t *lines = json_array();
    size_t count = aob_mesh_suspect(&mesh, file, warnings);
    for (size_t i = 0; i < count; i++)
        json_array_append_new(lines, json_string(warnings[i].text));
    aob_worker_reply(worker,
                     json_pack("{s:[fff], s:[fff], s:I, s:I, s:o}", "low", low.x, low.y, low.z, "high",
                               high.x, high.y, high.z, "vertices", (json_int_t)mesh.vertex_count, "triangles",
                               (json_int_t)mesh.triangle_count, "warnings", lines));
    aob_mesh_finish(&mesh);
    return true;
}

static bool probe(struct aob_worker *worker, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(worker->job, "backend"));
    struct aob_gpu *gpu = aob_gpu_open(backend ? backend : "", &(struct aob_gpu_desc){0}, error);
    if (!gpu)
        return false;
    aob_worker_reply(worker, json_pack("{s:s, s:s, s:b}", "device", gpu->info.device, "driver",
                                       gpu->info.driver, "software", gpu->info.software));
    aob_gpu_close(gpu);
    return true;
}

static bool do_job(struct aob_worker *worker, struct aob_error *error)
{
    static const struct {
        const char *name;
        bool (*run)(struct aob_worker *, struct aob_error *);
    } jobs[] = {{"describe", describe},
                {"probe", probe},
                {"layout", layout},
                {"mesh", load_mesh},
                {"view", aob_worker_view},
                {"block", aob_worker_block},
                {"capture", aob_worker_capture}};
    const char *name = json_string_value(json_object_get(worker->job, "job"));
    for (size_t i = 0; name && i < AOB_COUNT(jobs); i++)
        if (strcmp(jobs[i].name, name) == 0)
            return jobs[i].run(worker, error);
    return aob_fail(error, "worker: no such job; this command is the program's own");
}

int aob_worker_main(void)
{
    struct aob_error error = {{0}};
    json_error_t problem;
    struct aob_worker worker = {.reply = dup(STDOUT_FILENO)};
    dup2(STDERR_FILENO, STDOUT_FILENO);
    json_t *job = json_loadf(stdin, JSON_REJECT_DUPLICATES, &problem);
    worker.job = job;
    bool ok = job ? do_job(&worker, &error) : aob_fail(&error, "worker: standard input is not a job");
    json_decref(job);
    if (!ok)
        aob_error_print(&error);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

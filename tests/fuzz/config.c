/* Configs of a sweep. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "config/config.h"
#include "fuzz.h"

static bool finite3(const double v[3])
{
    return isfinite(v[0]) && isfinite(v[1]) && isfinite(v[2]);
}

static bool is_text(const char *text)
{
    return text && *text;
}

static void check_scene(const struct aob_scene_choice *s)
{
    fuzz_require(!s->name + !s->file + !s->capture == 2, "a scene is one of name, file and capture");
    fuzz_require(is_text(s->name ? s->name : s->file ? s->file : s->capture), "what a scene is has a text");
    fuzz_require(!s->name == is_text(s->given), "a path is kept as it was written");
    fuzz_require(finite3(s->eye) && finite3(s->target), "a camera is somewhere");
    fuzz_require(isfinite(s->shift[0]) && isfinite(s->shift[1]), "a shift is finite");
    fuzz_require(s->fov_deg == 0 ? s->capture != NULL : s->fov_deg >= 1 && s->fov_deg <= 170,
                 "an angle is 1 .. 170 degrees");
    fuzz_require(!s->ortho || s->ortho_height > 0, "a height is positive");
    fuzz_require(s->metres_per_unit == 0 ||
                     (s->metres_per_unit >= AOB_CONFIG_MIN_UNIT && s->metres_per_unit <= AOB_CONFIG_MAX_UNIT),
                 "a unit is within its bounds");
    fuzz_require(!s->moves || (finite3(s->previous.eye) && finite3(s->previous.target)),
                 "an earlier camera was somewhere");
    fuzz_require(!s->motion.frames ||
                     (s->motion.frames >= AOB_CONFIG_MIN_FRAMES && s->motion.frames <= AOB_CONFIG_MAX_FRAMES),
                 "a sequence has 2 .. 128 frames");
    fuzz_require(!s->motion.frames || (!s->capture && !s->moves),
                 "a sequence is no capture and has no earlier camera");
    fuzz_require(finite3(s->motion.last.eye) && finite3(s->motion.last.target), "a motion ends somewhere");
}

static double check_axes(const struct aob_axis *axes, size_t count)
{
    double product = 1;
    for (size_t i = 0; i < count; i++) {
        fuzz_require(is_text(axes[i].name) && axes[i].count, "an axis has a name and values");
        for (size_t v = 0; v < axes[i].count; v++)
            fuzz_require(is_text(axes[i].values[v].text), "a value has a text");
        product *= (double)axes[i].count;
    }
    return product;
}

static double check_techniques(const struct aob_config *config)
{
    double sum = 0;
    for (size_t i = 0; i < config->technique_count; i++) {
        const struct aob_technique_choice *choice = &config->techniques[i];
        const struct aob_backend_choice *backends = aob_config_backends(config, choice);
        fuzz_require(is_text(choice->name.text) && backends->count, "a technique has a name and backends");
        for (size_t b = 0; b < backends->count; b++)
            fuzz_require(is_text(backends->names[b].text), "a backend has a name");
        sum += (double)backends->count * check_axes(choice->axes, choice->axis_count);
    }
    return sum;
}

static void check_measure(const struct aob_config *config)
{
    fuzz_require(config->spp >= 2 && config->spp <= 65536 && config->spp % 2 == 0, "spp is even");
    fuzz_require(config->seconds >= 0.01 && config->seconds <= 3600, "seconds are within their bounds");
    fuzz_require(config->precision >= AOB_CONFIG_MIN_PRECISION &&
                     config->precision <= AOB_CONFIG_MAX_PRECISION,
                 "a precision is within its bounds");
    fuzz_require(config->thickness == -1 || config->thickness >= 0, "a thickness is none or a length");
    fuzz_require(config->target_count <= AOB_CONFIG_MAX_TARGETS, "the targets are not too many");
    for (size_t i = 0; i < config->target_count; i++)
        fuzz_require(config->targets[i].radius > 0, "a target has a radius");
}

static void check_config(const struct aob_config *config)
{
    double places = 0;
    fuzz_require(is_text(config->name) && strlen(config->name) <= 60, "a config has a name");
    fuzz_require(config->scene_count && config->technique_count, "a config has scenes and techniques");
    for (size_t i = 0; i < config->scene_count; i++) {
        check_scene(&config->scenes[i]);
        places += config->scenes[i].capture ? 1 : (double)config->size_count;
    }
    for (size_t i = 0; i < config->size_count; i++) {
        const struct aob_size *size = &config->sizes[i];
        fuzz_require(size->width >= 1 && size->width <= 16384 && size->height >= 1 && size->height <= 16384,
                     "a resolution is 1 .. 16384 pixels to a side");
    }
    check_measure(config);
    double cases = places * check_axes(config->options, config->option_count) * check_techniques(config);
    fuzz_require(cases >= 1 && cases <= AOB_CONFIG_MAX_CASES, "the cases are neither none nor too many");
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct aob_config config;
    struct aob_error error = {{0}};
    char *path = fuzz_file("input", bytes, size);
    if (fuzz_answer(aob_config_read(&config, path, &error), &error, path)) {
        check_config(&config);
        fuzz_require(config.size == size && memcmp(config.text, bytes, size) == 0, "a config keeps its text");
        aob_config_finish(&config);
    }
    free(path);
    return 0;
}

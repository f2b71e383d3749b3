#include "gl.h"
#include "base/clock.h"
#include "gpu/backends.h"

static void stamp(const struct gl *gl, size_t index)
{
    gl->api.QueryCounter(gl->stamps[index], GL_TIMESTAMP);
}

static void draw_stamped(const struct gl *gl, const struct aob_gpu_run_desc *desc)
{
    size_t at = 0;
    stamp(gl, at++);
    for (int r = 0; r < desc->repeats; r++)
        for (size_t i = 0; i < desc->count; i++) {
            stamp(gl, at++);
            aob_gl_pass_bind(gl, desc->passes[i]);
            aob_gl_pass_draw(gl, desc->passes[i]);
            stamp(gl, at++);
        }
    stamp(gl, at);
}

static void draw_plain(const struct gl *gl, const struct aob_gpu_run_desc *desc)
{
    for (int r = 0; r < desc->repeats; r++)
        for (size_t i = 0; i < desc->count; i++) {
            aob_gl_pass_bind(gl, desc->passes[i]);
            aob_gl_pass_draw(gl, desc->passes[i]);
        }
}

static int64_t between(const struct gl *gl, size_t from, size_t to)
{
    GLuint64 begin = 0, end = 0;
    gl->api.GetQueryObjectui64v(gl->stamps[from], GL_QUERY_RESULT, &begin);
    gl->api.GetQueryObjectui64v(gl->stamps[to], GL_QUERY_RESULT, &end);
    return aob_gpu_ticks_ns(begin, end, (unsigned)gl->stamp_bits, 1);
}

static void read_stamps(const struct gl *gl, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                        struct aob_gpu_time *whole)
{
    size_t at = 1;
    for (int r = 0; r < desc->repeats; r++)
        for (size_t i = 0; i < desc->count; i++, at += 2)
            times[i].device_ns += between(gl, at, at + 1);
    whole->device_ns += between(gl, 0, at);
}

bool aob_gl_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error)
{
    const struct gl *gl = (const struct gl *)gpu;
    bool stamped = gpu->lists && gl->stamp_bits;
    aob_gl_use(gpu);
    if (!gpu->lists) /* one pass, whose binding is no part of its time on a processor */
        aob_gl_pass_bind(gl, desc->passes[0]);
    gl->api.Finish();
    int64_t cpu = aob_clock_cpu_ns(), wall = aob_clock_wall_ns();
    if (!gpu->lists)
        aob_gl_pass_draw(gl, desc->passes[0]);
    else
        (stamped ? draw_stamped : draw_plain)(gl, desc);
    gl->api.Finish();
    whole->wall_ns += aob_clock_wall_ns() - wall;
    whole->cpu_ns += aob_clock_cpu_ns() - cpu;
    if (stamped)
        read_stamps(gl, desc, times, whole);
    return aob_gl_ok(gpu, "run passes", error);
}

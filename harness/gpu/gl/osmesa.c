#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <dlfcn.h>
#include <stdlib.h>
/* osmesa.h would include GL/gl.h, whose prototypes fight with glcorearb.h. */
#define __gl_h_
#define GLAPIENTRY APIENTRY
#include <GL/osmesa.h>

enum { BUFFER_SIDE = 16 }; /* OSMesa wants a buffer to draw to, though every pass has its own targets */

struct osmesa {
    struct gl_context base;
    OSMesaContext (*create)(const int *attributes, OSMesaContext share);
    void (*destroy)(OSMesaContext context);
    GLboolean (*make_current)(OSMesaContext context, void *buffer, GLenum type, GLsizei width,
                              GLsizei height);
    OSMESAproc (*find)(const char *name);
    OSMesaContext context;
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4];
};

static bool load_osmesa(struct osmesa *osmesa, struct aob_error *error)
{
    /* Never closed: the driver leaves threads and exit handlers behind. */
    void *library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return aob_fail(error, "gl-osmesa: libOSMesa.so.8 is missing: install libosmesa6");
    *(void **)&osmesa->create = dlsym(library, "OSMesaCreateContextAttribs");
    *(void **)&osmesa->destroy = dlsym(library, "OSMesaDestroyContext");
    *(void **)&osmesa->make_current = dlsym(library, "OSMesaMakeCurrent");
    *(void **)&osmesa->find = dlsym(library, "OSMesaGetProcAddress");
    return (osmesa->create && osmesa->destroy && osmesa->make_current && osmesa->find) ||
           aob_fail(error, "gl-osmesa: libOSMesa.so.8 is too old: use Mesa 12 or newer");
}

static void osmesa_destroy(struct gl_context *context)
{
    struct osmesa *osmesa = (struct osmesa *)context;
    if (osmesa->context) {
        osmesa->make_current(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
        osmesa->destroy(osmesa->context);
    }
    free(osmesa);
}

static bool osmesa_make_current(struct gl_context *context)
{
    struct osmesa *osmesa = (struct osmesa *)context;
    return osmesa->make_current(osmesa->context, osmesa->buffer, GL_UNSIGNED_BYTE, BUFFER_SIDE, BUFFER_SIDE);
}

static gl_function osmesa_find(struct gl_context *context, const char *name)
{
    return (gl_function)((struct osmesa *)context)->find(name);
}

static const struct gl_context_fns context_fns = {
    .destroy = osmesa_destroy,
    .make_current = osmesa_make_current,
    .find = osmesa_find,
};

static struct gl_context *osmesa_create(struct aob_error *error)
{
    static const int attributes[] = {
        OSMESA_FORMAT,
        OSMESA_RGBA,
        OSMESA_PROFILE,
        OSMESA_CORE_PROFILE,
        OSMESA_CONTEXT_MAJOR_VERSION,
        4,
        OSMESA_CONTEXT_MINOR_VERSION,
        5,
        0,
    };
    struct osmesa *osmesa = AOB_NEW(struct osmesa);
    osmesa->base.fns = &context_fns;
    if (load_osmesa(osmesa, error)) {
        osmesa->context = osmesa->create(attributes, NULL);
        if (osmesa->context && osmesa_make_current(&osmesa->base))
            return &osmesa->base;
        aob_fail(error, "gl-osmesa: libOSMesa.so.8 gives no OpenGL 4.5: install a newer libosmesa6");
    }
    osmesa_destroy(&osmesa->base);
    return NULL;
}

static struct aob_gpu *osmesa_open(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    return aob_gpu_keep_single(aob_gl_open(&aob_gpu_gl_osmesa, osmesa_create(error), error), desc, error);
}

static bool osmesa_devices(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    return aob_gpu_single_device(&aob_gpu_gl_osmesa, list, chosen, error);
}

const struct aob_gpu_fns aob_gpu_gl_osmesa = {
    .name = "gl-osmesa",
    .title = "OpenGL 4.5 with ARB_gl_spirv, through OSMesa: always the processor (llvmpipe)",
    .devices = osmesa_devices,
    .open = osmesa_open,
    AOB_GL_SLOTS,
};

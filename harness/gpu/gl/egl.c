#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#define EGL_FUNCTIONS(X)                                                                                     \
    X(PFNEGLQUERYSTRINGPROC, QueryString)                                                                    \
    X(PFNEGLGETPLATFORMDISPLAYPROC, GetPlatformDisplay)                                                      \
    X(PFNEGLINITIALIZEPROC, Initialize)                                                                      \
    X(PFNEGLBINDAPIPROC, BindAPI)                                                                            \
    X(PFNEGLCREATECONTEXTPROC, CreateContext)                                                                \
    X(PFNEGLDESTROYCONTEXTPROC, DestroyContext)                                                              \
    X(PFNEGLMAKECURRENTPROC, MakeCurrent)                                                                    \
    X(PFNEGLGETPROCADDRESSPROC, GetProcAddress)

struct egl {
    struct gl_context base;
#define X(type, name) type name;
    EGL_FUNCTIONS(X)
#undef X
    EGLDisplay display;
    EGLContext context;
};

static bool load_egl(struct egl *egl, struct aob_error *error)
{
    /* Never closed: a driver leaves threads and exit handlers behind. */
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return aob_fail(error, "gl-egl: libEGL.so.1 is missing: install libegl1");
#define X(type, name)                                                                                        \
    egl->name = (type)dlsym(library, "egl" #name);                                                           \
    if (!egl->name)                                                                                          \
        return aob_fail(error, "gl-egl: libEGL.so.1 lacks egl%s: it needs EGL 1.5", #name);
    EGL_FUNCTIONS(X)
#undef X
    return true;
}

static bool try_display(struct egl *egl, EGLenum platform, void *native)
{
    static const EGLint attributes[] = {
        EGL_CONTEXT_MAJOR_VERSION,
        4,
        EGL_CONTEXT_MINOR_VERSION,
        5,
        EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
        EGL_NONE,
    };
    egl->display = egl->GetPlatformDisplay(platform, native, NULL);
    if (!egl->display || !egl->Initialize(egl->display, NULL, NULL) || !egl->BindAPI(EGL_OPENGL_API))
        return false;
    egl->context = egl->CreateContext(egl->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    if (!egl->context)
        return false;
    if (egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context))
        return true;
    egl->DestroyContext(egl->display, egl->context);
    egl->context = NULL;
    return false;
}

static bool try_devices(struct egl *egl)
{
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)egl->GetProcAddress("eglQueryDevicesEXT");
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (!query || !query(AOB_COUNT(devices), devices, &count))
        return false;
    for (EGLint i = 0; i < count; i++)
        if (try_display(egl, EGL_PLATFORM_DEVICE_EXT, devices[i]))
            return true;
    return false;
}

static bool has_extension(struct egl *egl, const char *name)
{
    const char *all = egl->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    return all && strstr(all, name);
}

/* The display stays initialised: it is the process's, not ours. */
static void egl_destroy(struct gl_context *context)
{
    struct egl *egl = (struct egl *)context;
    if (egl->context) {
        egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl->DestroyContext(egl->display, egl->context);
    }
    free(egl);
}

static bool egl_make_current(struct gl_context *context)
{
    struct egl *egl = (struct egl *)context;
    return egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context);
}

static gl_function egl_find(struct gl_context *context, const char *name)
{
    return (gl_function)((struct egl *)context)->GetProcAddress(name);
}

static struct gl_context *egl_create(struct aob_error *error);

static const struct gl_context_fns context_fns = {
    .create = egl_create,
    .destroy = egl_destroy,
    .make_current = egl_make_current,
    .find = egl_find,
};

static struct gl_context *egl_create(struct aob_error *error)
{
    struct egl *egl = AOB_NEW(struct egl);
    egl->base.fns = &context_fns;
    if (!load_egl(egl, error))
        goto error;
    if (has_extension(egl, "EGL_MESA_platform_surfaceless") &&
        try_display(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY))
        return &egl->base;
    if (has_extension(egl, "EGL_EXT_platform_device") && try_devices(egl))
        return &egl->base;
    aob_fail(error,
             "gl-egl: no driver gives OpenGL 4.5 without a window: install libegl-mesa0 and libgl1-mesa-dri");
error:
    egl_destroy(&egl->base);
    return NULL;
}

static struct aob_gpu *egl_open(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    (void)desc;
    return aob_gl_open(&aob_gpu_gl_egl, &context_fns, error);
}

const struct aob_gpu_fns aob_gpu_gl_egl = {
    .name = "gl-egl",
    .title = "OpenGL 4.5 with ARB_gl_spirv, through EGL without a window (llvmpipe where there is no GPU)",
    .open = egl_open,
    AOB_GL_SLOTS,
};

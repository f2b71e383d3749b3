#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define EGL_FUNCTIONS(X)                                                                                     \
    X(PFNEGLGETERRORPROC, GetError)                                                                          \
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
    PFNEGLQUERYDEVICESEXTPROC QueryDevices; /* NULL: EGL has one device, and does not say which */
    PFNEGLQUERYDEVICESTRINGEXTPROC QueryDeviceString;
    EGLDeviceEXT devices[AOB_GPU_MAX_DEVICES]; /* by number */
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

static bool has_extension(const char *all, const char *name)
{
    return all && strstr(all, name);
}

static void find_devices(struct egl *egl)
{
    const char *all = egl->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_extension(all, "EGL_EXT_platform_device"))
        return;
    egl->QueryDevices = (PFNEGLQUERYDEVICESEXTPROC)egl->GetProcAddress("eglQueryDevicesEXT");
    egl->QueryDeviceString = (PFNEGLQUERYDEVICESTRINGEXTPROC)egl->GetProcAddress("eglQueryDeviceStringEXT");
    if (!egl->QueryDeviceString)
        egl->QueryDevices = NULL;
}

static void leave(struct egl *egl)
{
    if (!egl->context)
        return;
    egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl->DestroyContext(egl->display, egl->context);
    egl->context = NULL;
}

static bool get_display(struct egl *egl, size_t number)
{
    egl->display = egl->QueryDevices
                       ? egl->GetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, egl->devices[number], NULL)
                       : egl->GetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    return egl->display;
}

static bool create_context(struct egl *egl)
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
    egl->context = egl->CreateContext(egl->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
    return egl->context;
}

/* A current context on the device of that number. What it lacks for that; NULL: it is there. */
static const char *enter(struct egl *egl, size_t number)
{
    if (!get_display(egl, number))
        return "an EGL display without a window";
    if (!egl->Initialize(egl->display, NULL, NULL))
        return "a driver that starts";
    if (!egl->BindAPI(EGL_OPENGL_API))
        return "OpenGL";
    if (!create_context(egl))
        return "OpenGL 4.5";
    if (egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context))
        return NULL;
    leave(egl);
    return "contexts without a surface";
}

static uint64_t node_of(const struct egl *egl, size_t number)
{
    struct stat node;
    const char *all = egl->QueryDeviceString(egl->devices[number], EGL_EXTENSIONS);
    const char *file = has_extension(all, "EGL_EXT_device_drm_render_node")
                           ? egl->QueryDeviceString(egl->devices[number], EGL_DRM_RENDER_NODE_FILE_EXT)
                           : NULL;
    return file && stat(file, &node) == 0 ? (uint64_t)node.st_rdev : 0;
}

/* EGL knows no names of devices: a context says what it runs on. */
static void describe_device(struct egl *egl, size_t number, struct aob_gpu_device *device)
{
    *device = (struct aob_gpu_device){.device_class = "gpu"};
    if (egl->QueryDevices)
        device->node = node_of(egl, number);
    const char *lacks = enter(egl, number);
    if (lacks) {
        snprintf(device->name, sizeof device->name, "EGL device %zu", number);
        snprintf(device->driver, sizeof device->driver, "no driver known");
        snprintf(device->lacks, sizeof device->lacks, "%s (EGL error 0x%x)", lacks, egl->GetError());
        return;
    }
    GLint bits = 0;
    PFNGLGETQUERYIVPROC query = (PFNGLGETQUERYIVPROC)egl->GetProcAddress("glGetQueryiv");
    aob_gl_describe((PFNGLGETSTRINGPROC)egl->GetProcAddress("glGetString"), device);
    query(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    device->timer = bits > 0;
    leave(egl);
}

static void list_devices(struct egl *egl, struct aob_gpu_device_list *list)
{
    EGLint count = 0;
    if (!egl->QueryDevices)
        count = get_display(egl, 0); /* without a driver EGL has no display either */
    else if (!egl->QueryDevices(AOB_GPU_MAX_DEVICES, egl->devices, &count))
        count = 0;
    for (list->count = 0; list->count < (size_t)count; list->count++)
        describe_device(egl, list->count, &list->items[list->count]);
}

/* The default of Vulkan, which is to be ours too. */
static bool find_like(struct aob_gpu_device *like)
{
    struct aob_gpu_device_list *list = AOB_NEW(struct aob_gpu_device_list);
    size_t chosen;
    bool ok = aob_gpu_devices(aob_gpu_find("vulkan"), list, &chosen, NULL) && chosen < list->count;
    if (ok)
        *like = list->items[chosen];
    free(list);
    return ok;
}

static bool choose_default(const struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    struct aob_gpu_device like;
    size_t best = aob_gpu_default_device(list);
    bool gpu = find_like(&like);
    *chosen = gpu ? aob_gpu_default_like(list, &like) : best;
    if (*chosen < list->count)
        return true;
    if (!list->count)
        return aob_fail(error,
                        "gl-egl: no driver gives OpenGL 4.5 without a window: install libegl-mesa0 and "
                        "libgl1-mesa-dri");
    if (best == list->count)
        return aob_fail(error,
                        "gl-egl: no device can be opened; the first of %zu lacks %s: use a newer driver",
                        list->count, list->items[0].lacks);
    return aob_fail(
        error,
        "gl-egl: %s has a driver for Vulkan and none for EGL, which offers processors only: install "
        "its EGL driver, or say --device %zu for %s",
        like.name, best, list->items[best].name);
}

/* The display stays initialised: it is the process's, not ours. */
static void egl_destroy(struct gl_context *context)
{
    leave((struct egl *)context);
    free(context);
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

static const struct gl_context_fns context_fns = {
    .destroy = egl_destroy,
    .make_current = egl_make_current,
    .find = egl_find,
};

static struct egl *egl_create(struct aob_error *error)
{
    struct egl *egl = AOB_NEW(struct egl);
    egl->base.fns = &context_fns;
    if (load_egl(egl, error)) {
        find_devices(egl);
        return egl;
    }
    free(egl);
    return NULL;
}

static bool egl_devices(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    struct egl *egl = egl_create(error);
    if (!egl)
        return false;
    list_devices(egl, list);
    egl_destroy(&egl->base);
    if (!choose_default(list, chosen, &list->none))
        *chosen = list->count;
    return true;
}

static bool choose(const struct aob_gpu_device_list *list, const char *wanted, size_t *chosen,
                   struct aob_error *error)
{
    return wanted ? aob_gpu_choose(list, "gl-egl", wanted, chosen, error)
                  : choose_default(list, chosen, error);
}

static bool enter_chosen(struct egl *egl, const char *wanted, struct aob_error *error)
{
    struct aob_gpu_device_list *list = AOB_NEW(struct aob_gpu_device_list);
    size_t chosen;
    list_devices(egl, list);
    bool ok = choose(list, wanted, &chosen, error);
    const char *lacks = ok ? enter(egl, chosen) : NULL;
    if (lacks)
        ok = aob_fail(error, "gl-egl: %s lacks %s by now", list->items[chosen].name, lacks);
    free(list);
    return ok;
}

static struct aob_gpu *egl_open(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    struct egl *egl = egl_create(error);
    if (!egl)
        return NULL;
    if (enter_chosen(egl, desc->device, error))
        return aob_gl_open(&aob_gpu_gl_egl, &egl->base, error);
    egl_destroy(&egl->base);
    return NULL;
}

const struct aob_gpu_fns aob_gpu_gl_egl = {
    .name = "gl-egl",
    .title = "OpenGL 4.5 with ARB_gl_spirv, through EGL without a window: the device of vulkan (llvmpipe "
             "where there is no GPU)",
    .devices = egl_devices,
    .open = egl_open,
    AOB_GL_SLOTS,
};

#include "viz_window.hpp"
#include "viz_common.hpp"
#include <vtk_glew.h>
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <cstring>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkWindowToImageFilter.h>

namespace aob_viz
{
namespace
{
/* Debian's VTK only makes X windows, and aborts without an X server. This one stands on an EGL context. */
class egl_window : public vtkGenericOpenGLRenderWindow
{
  public:
    static egl_window *New();
    vtkTypeMacro(egl_window, vtkGenericOpenGLRenderWindow);

    void Open();
    bool IsUsable() const
    {
        return this->Initialized && this->GlewInitValid;
    }

    void MakeCurrent() override
    {
        if (Context != EGL_NO_CONTEXT)
            eglMakeCurrent(Display, EGL_NO_SURFACE, EGL_NO_SURFACE, Context);
    }
    bool IsCurrent() override
    {
        return Context != EGL_NO_CONTEXT && eglGetCurrentContext() == Context;
    }
    int SupportsOpenGL() override
    {
        return 1;
    }
    void Frame() override {}
    void OpenGLInitContext() override;

  protected:
    /* No eglTerminate: the display belongs to everyone in the process. */
    ~egl_window() override
    {
        if (Context == EGL_NO_CONTEXT)
            return;
        this->Finalize();
        eglMakeCurrent(Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(Display, Context);
    }

  private:
    void OpenDisplay();

    EGLDisplay Display = EGL_NO_DISPLAY;
    EGLContext Context = EGL_NO_CONTEXT;
};
vtkStandardNewMacro(egl_window);

void need(bool ok, const char *what)
{
    if (!ok)
        throw std::runtime_error(std::string("no OpenGL for this picture: ") + what +
                                 " failed; is libgl1-mesa-dri installed?");
}

void egl_window::OpenDisplay()
{
    auto get =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    need(get != nullptr, "eglGetPlatformDisplayEXT");
    Display = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    EGLint major, minor;
    need(Display != EGL_NO_DISPLAY && eglInitialize(Display, &major, &minor), "eglInitialize");
}

void egl_window::Open()
{
    static const EGLint config_wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_BIT, EGL_NONE};
    static const EGLint context_wish[] = {EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          2,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
    OpenDisplay();
    EGLConfig config;
    EGLint count = 0;
    need(eglBindAPI(EGL_OPENGL_API), "eglBindAPI");
    need(eglChooseConfig(Display, config_wish, &config, 1, &count) && count > 0, "eglChooseConfig");
    Context = eglCreateContext(Display, config, EGL_NO_CONTEXT, context_wish);
    need(Context != EGL_NO_CONTEXT, "eglCreateContext");
    need(eglMakeCurrent(Display, EGL_NO_SURFACE, EGL_NO_SURFACE, Context), "eglMakeCurrent");
    SetMapped(1);
    SetOwnContext(1);
    SetReadyForRendering(true);
    SetSupportsOpenGL(1);
    SetIsDirect(1);
}

/* Debian's GLEW is the GLX one: with no X it has loaded every entry point and then complains, which VTK would
 * take for failure. */
void egl_window::OpenGLInitContext()
{
    this->ContextCreationTime.Modified();
    if (this->Initialized)
        return;
    GLenum result = glewInit();
    this->GlewInitValid = result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY;
    if (!this->GlewInitValid)
        return;
    float widths[2] = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    this->MaximumHardwareLineWidth = widths[1];
    this->Initialized = true;
}

/* VTK goes on after almost any OpenGL trouble and hands over a picture of one colour. */
void check_not_blank(vtkImageData *image)
{
    int size[3];
    image->GetDimensions(size);
    const auto *bytes = static_cast<const unsigned char *>(image->GetScalarPointer());
    size_t count = static_cast<size_t>(size[0]) * size[1] * image->GetNumberOfScalarComponents();
    if (count < 2 || std::memcmp(bytes, bytes + 3, count - 3) == 0)
        throw std::runtime_error("OpenGL drew nothing");
}
} // namespace

void render_png(vtkRenderer *renderer, int width, int height, const std::string &path)
{
    vtkNew<egl_window> window;
    window->Open();
    window->SetDPI(72);
    window->SetSize(width * OVERSAMPLING, height * OVERSAMPLING);
    window->SetMultiSamples(4);
    window->AddRenderer(renderer);
    window->Render();
    need(window->IsUsable(), "glewInit");
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->ReadFrontBufferOff();
    grab->ShouldRerenderOff();
    vtkNew<vtkImageShrink3D> shrink;
    shrink->SetInputConnection(grab->GetOutputPort());
    shrink->SetShrinkFactors(OVERSAMPLING, OVERSAMPLING, 1);
    shrink->AveragingOn();
    shrink->Update();
    check_not_blank(shrink->GetOutput());
    save_png(shrink->GetOutput(), path);
}
} // namespace aob_viz

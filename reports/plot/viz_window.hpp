/* Rendering with OpenGL into memory: no X, no window. */
#ifndef AOB_REPORTS_PLOT_VIZ_WINDOW_HPP
#define AOB_REPORTS_PLOT_VIZ_WINDOW_HPP
#include <string>
#include <vtkRenderer.h>

namespace aob_viz
{
/* Everything is drawn this many times larger and averaged down: scale fonts and pens by it. */
constexpr int OVERSAMPLING = 2;

/* Renders and writes the PNG of width x height. Throws if there is no EGL, or if the picture came out blank.
 */
void render_png(vtkRenderer *renderer, int width, int height, const std::string &path);
} // namespace aob_viz
#endif

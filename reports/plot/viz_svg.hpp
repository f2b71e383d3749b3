/* SVG without OpenGL and without a window. */
#ifndef AOB_REPORTS_PLOT_VIZ_SVG_HPP
#define AOB_REPORTS_PLOT_VIZ_SVG_HPP
#include <string>
#include <vtkContextItem.h>

namespace aob_viz
{
/* The whole document. The item must paint in pixels, without matrices and clips. */
std::string svg_text(vtkContextItem *item, int width, int height);
} // namespace aob_viz
#endif

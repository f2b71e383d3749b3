/* What all figures share: looks, numbers, and the way out of C++. */
#ifndef AOB_REPORTS_PLOT_VIZ_COMMON_HPP
#define AOB_REPORTS_PLOT_VIZ_COMMON_HPP
#include "viz.h"
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

namespace aob_viz
{
using image_ptr = vtkSmartPointer<vtkImageData>;

enum class face { plain, bold };

constexpr unsigned INK = 0x212124, GREY = 0x5a5a60, FRAME = 0x46464c;

struct text_style {
    int size; /* pixels */
    face weight = face::plain;
    unsigned colour = INK;
    int across = VTK_TEXT_LEFT, along = VTK_TEXT_BOTTOM; /* what of the text lies at the given point */
    int degrees = 0;
};
void apply_style(vtkTextProperty *property, const text_style &style);

/* Pixels that a line takes. */
int text_width(const std::string &text, const text_style &style);

/* One line without control characters, cut with an ellipsis to `width` pixels. NULL gives "". */
std::string fit_text(const char *text, const text_style &style, int width);

/* A round step that divides `range` into about `wanted` parts. */
double nice_step(double range, int wanted);

/* With a true minus sign; `sign` puts a plus before positive numbers. */
std::string number_text(double value, int decimals, bool sign);
std::string short_number(double value);
int decimals_of(double step);

/* RGBA of the error's colours, from -1 to +1 (blue, near white, red). */
constexpr int COLOURS = 2048;
const std::vector<unsigned char> &error_colours();
image_ptr error_bar_image();
const unsigned char *error_colour(double value, double limit);

struct tick {
    double value;
    std::string label;
};
/* Ticks of a colour bar from -limit to +limit that is `length` pixels long. */
std::vector<tick> error_ticks(double limit, double length);

/* What the colours of an error say, after what it is of. */
constexpr const char *ERROR_MEANING = " (blue: too dark, red: too bright)";

/* Throws if the sizes or limit cannot be drawn. */
void check_map(const aob_viz_map &map);

/* A single-component float image in VTK's row order. */
image_ptr float_image(int width, int height, const float *pixels, const char *name);
void flip_rows(int width, int height, const float *from, float *to);

void save_png(vtkImageData *image, const std::string &path);
void save_bytes(const std::string &path, const void *bytes, size_t size);

void silence_vtk();

/* Runs `work`; a throw becomes -1 and its text. */
template <class Work> int guarded(char *error, Work work)
{
    try {
        silence_vtk();
        work();
        return 0;
    } catch (const std::exception &e) {
        std::snprintf(error, AOB_VIZ_ERROR_SIZE, "%s", e.what());
    } catch (...) {
        std::snprintf(error, AOB_VIZ_ERROR_SIZE, "unknown failure within VTK");
    }
    return -1;
}
} // namespace aob_viz
#endif

/* Maps, triptychs, splits and .vti: no OpenGL, so that they cannot fail for want of a driver. */
#include "viz_common.hpp"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTextRenderer.h>
#include <vtkXMLImageDataWriter.h>

using namespace aob_viz;

namespace
{
constexpr int MARGIN = 40, BAR_GAP = 26, BAR_WIDTH = 22, BAR_ROOM = 116;
constexpr const char *PART_LABEL = "part of the error", *PART_MEANING = " (blue: darkens, red: brightens)";
const text_style TITLE = {22, face::bold}, SUBTITLE = {15, face::plain, GREY}, HEADING = {15, face::bold},
                 TICK = {15, face::plain, INK, VTK_TEXT_LEFT, VTK_TEXT_CENTERED},
                 LABEL = {15, face::plain, INK, VTK_TEXT_CENTERED, VTK_TEXT_CENTERED, 90};

/* A white sheet of RGB pixels. x, y count from the top left. */
class canvas
{
  public:
    canvas(int width, int height) : Width(width), Height(height), Image(image_ptr::New())
    {
        Image->SetDimensions(width, height, 1);
        Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        std::memset(Image->GetScalarPointer(), 255, static_cast<size_t>(width) * height * 3);
    }

    unsigned char *at(int x, int y)
    {
        return static_cast<unsigned char *>(Image->GetScalarPointer()) +
               3 * (static_cast<size_t>(Height - 1 - y) * Width + x);
    }

    void fill(int x, int y, int width, int height, const unsigned char colour[3])
    {
        for (int j = std::max(y, 0); j < std::min(y + height, Height); j++)
            for (int i = std::max(x, 0); i < std::min(x + width, Width); i++)
                std::memcpy(at(i, j), colour, 3);
    }

    /* A line one pixel wide around the given area. */
    void frame(int x, int y, int width, int height)
    {
        const unsigned char ink[3] = {FRAME >> 16, FRAME >> 8 & 255, FRAME & 255};
        fill(x - 1, y - 1, width + 2, 1, ink);
        fill(x - 1, y + height, width + 2, 1, ink);
        fill(x - 1, y, 1, height, ink);
        fill(x + width, y, 1, height, ink);
    }

    void text(int x, int y, const std::string &text, const text_style &style);

    const int Width, Height;
    const image_ptr Image;

  private:
    void blend(int x, int y, const unsigned char *rgba);
};

void canvas::blend(int x, int y, const unsigned char *rgba)
{
    if (x < 0 || y < 0 || x >= Width || y >= Height)
        return;
    unsigned char *to = at(x, y);
    for (int k = 0; k < 3; k++)
        to[k] = static_cast<unsigned char>((to[k] * (255 - rgba[3]) + rgba[k] * rgba[3] + 127) / 255);
}

void canvas::text(int x, int y, const std::string &text, const text_style &style)
{
    if (text.empty())
        return;
    vtkNew<vtkTextProperty> property;
    apply_style(property, style);
    vtkNew<vtkImageData> glyphs;
    int used[2] = {0, 0}, box[4] = {0, 0, 0, 0}, room[3];
    vtkTextRenderer *renderer = vtkTextRenderer::GetInstance();
    if (!renderer->GetBoundingBox(property, text, box, 72) ||
        !renderer->RenderString(property, text, glyphs, used, 72))
        throw std::runtime_error("VTK cannot draw text");
    glyphs->GetDimensions(room);
    const auto *from = static_cast<const unsigned char *>(glyphs->GetScalarPointer());
    for (int j = 0; j < used[1]; j++)
        for (int i = 0; i < used[0]; i++)
            blend(x + box[0] + i, y - box[2] - j, from + 4 * (static_cast<size_t>(j) * room[0] + i));
}

/* How one image becomes a panel: magnified by a whole number, or averaged down by one. */
struct scale {
    int up = 1, down = 1;
    int of(int size) const
    {
        return std::max(size / down, 1) * up;
    }
};

double sample(const float *pixels, int width, int height, const scale &s, int x, int y)
{
    int x0 = x / s.up * s.down, y0 = y / s.up * s.down, count = 0;
    double sum = 0;
    for (int j = y0; j < std::min(y0 + s.down, height); j++)
        for (int i = x0; i < std::min(x0 + s.down, width); i++, count++)
            sum += pixels[static_cast<size_t>(j) * width + i];
    return sum / count;
}

struct panel {
    aob_viz_picture picture;
    int width, height;
    scale size;
    double limit;        /* of an error; 0: a picture */
    double exposure = 1; /* of one in colour */
};

unsigned char byte_of(double value)
{
    return static_cast<unsigned char>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

double srgb(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/* The colour of a pixel of the panel. */
void paint(const panel &p, int x, int y, unsigned char into[3])
{
    double values[3];
    int count = p.picture.channels[1] ? 3 : 1;
    bool known = true;
    for (int c = 0; c < count; c++) {
        values[c] = sample(p.picture.channels[c], p.width, p.height, p.size, x, y);
        known = known && std::isfinite(values[c]);
    }
    if (p.picture.depth)
        known = known && std::isfinite(sample(p.picture.depth, p.width, p.height, p.size, x, y));
    if (p.limit > 0 || !known)
        std::memcpy(into, error_colour(known ? values[0] : NAN, p.limit), 3);
    else if (count == 1)
        std::memset(into, byte_of(values[0]), 3);
    else
        for (int c = 0; c < 3; c++)
            into[c] = byte_of(srgb(p.exposure * values[c]));
}

void draw_panel(canvas &sheet, const panel &p, int x, int y)
{
    int width = p.size.of(p.width), height = p.size.of(p.height);
    for (int j = 0; j < height; j++)
        for (int i = 0; i < width; i++)
            paint(p, i, j, sheet.at(x + i, y + j));
    sheet.frame(x, y, width, height);
}

/* What the colours mean, from -limit, or of an amount from 0. */
struct legend {
    double low, limit;
    std::string label;
};

void draw_error_bar(canvas &sheet, int x, int y, int height, const legend &of)
{
    const unsigned char ink[3] = {FRAME >> 16, FRAME >> 8 & 255, FRAME & 255};
    const double span = of.limit - of.low;
    for (int j = 0; j < height; j++)
        sheet.fill(x, y + j, BAR_WIDTH, 1,
                   error_colour(of.limit - span * j / std::max(height - 1, 1), of.limit));
    sheet.frame(x, y, BAR_WIDTH, height);
    for (const tick &t : error_ticks(of.limit, height * 2 * of.limit / span)) {
        if (t.value < of.low)
            continue;
        int at = y + static_cast<int>(std::lround((of.limit - t.value) / span * (height - 1)));
        sheet.fill(x + BAR_WIDTH + 1, at, 5, 1, ink);
        bool plus = of.low == 0 && t.label[0] == '+'; /* an amount has no sign */
        sheet.text(x + BAR_WIDTH + 10, at, t.label.substr(plus), TICK);
    }
    sheet.text(x + BAR_WIDTH + 76, y + height / 2, of.label, LABEL);
}

void draw_titles(canvas &sheet, const aob_viz_map &map, int y)
{
    int width = sheet.Width - 2 * MARGIN;
    sheet.text(MARGIN, y + 24, fit_text(map.title, TITLE, width), TITLE);
    sheet.text(MARGIN, y + 53, fit_text(map.subtitle, SUBTITLE, width), SUBTITLE);
}

/* A bar shorter than its label needs gets a shorter one. */
std::string bar_label(int height, const std::string &brief, const char *meaning)
{
    std::string whole = brief + meaning;
    return text_width(whole, LABEL) <= height + 60 ? whole : height >= 120 ? brief : "";
}

std::string error_label(int height, const aob_viz_map &map)
{
    std::string brief = std::string(map.quantity ? map.quantity : "AO") + " minus reference";
    if (text_width(brief, LABEL) > height + 60) /* the heading names the quantity, too */
        brief = "technique minus reference";
    return bar_label(height, brief, ERROR_MEANING);
}

void draw_map(const aob_viz_map &map, const std::string &path)
{
    check_map(map);
    scale size = {std::max(1, std::min(1440 / map.width, 1080 / map.height)), 1};
    int width = size.of(map.width), height = size.of(map.height), top = 96, bar = std::max(height, 60);
    canvas sheet(MARGIN + std::max(width, 420) + BAR_GAP + BAR_WIDTH + BAR_ROOM, top + bar + 36);
    draw_titles(sheet, map, 26);
    draw_panel(sheet, {{{map.error}, nullptr}, map.width, map.height, size, map.limit}, MARGIN, top);
    draw_error_bar(sheet, MARGIN + width + BAR_GAP, top, bar,
                   map.amount ? legend{0, map.limit, map.amount}
                              : legend{-map.limit, map.limit, error_label(bar, map)});
    save_png(sheet.Image, path);
}

scale panel_scale(int width, int height)
{
    int down = std::max((width + 719) / 720, (height + 719) / 720);
    int up = std::max(1, std::min(560 / width, 420 / height));
    return {down > 1 ? 1 : up, down};
}

void draw_alone(const aob_viz_triptych &figure, const std::string &path)
{
    const aob_viz_map &map = figure.map;
    scale size = panel_scale(map.width, map.height);
    int width = size.of(map.width), top = 126;
    canvas sheet(std::max(2 * MARGIN + width, 720), top + size.of(map.height) + 32);
    draw_titles(sheet, map, 20);
    sheet.text(MARGIN, top - 10, fit_text(figure.technique_name, HEADING, width), HEADING);
    draw_panel(sheet, {figure.technique, map.width, map.height, size, 0, figure.exposure}, MARGIN, top);
    save_png(sheet.Image, path);
}

/* Three images side by side; from the `first_error`-th on they are in the error's colours, before that pictures. */
struct row {
    aob_viz_picture images[3];
    const char *names[3];
    int first_error;
    double exposure;
};

void draw_row(const aob_viz_map &map, const row &of, const std::string &path)
{
    for (int i = of.first_error; i < 3; i++) {
        aob_viz_map drawn = map;
        drawn.error = of.images[i].channels[0];
        check_map(drawn);
    }
    scale size = panel_scale(map.width, map.height);
    int width = size.of(map.width), height = size.of(map.height), step = std::max(width, 200) + 20;
    int top = 126, bar = std::max(height, 60), end = MARGIN + 2 * step + width;
    canvas sheet(std::max(end + BAR_GAP + BAR_WIDTH + BAR_ROOM, 720), top + bar + 32);
    draw_titles(sheet, map, 20);
    for (int i = 0; i < 3; i++) {
        int x = MARGIN + i * step;
        sheet.text(x, top - 10, fit_text(of.names[i], HEADING, step - 24), HEADING);
        double limit = i >= of.first_error ? map.limit : 0;
        draw_panel(sheet, {of.images[i], map.width, map.height, size, limit, of.exposure}, x, top);
    }
    std::string label = of.first_error ? error_label(bar, map) : bar_label(bar, PART_LABEL, PART_MEANING);
    draw_error_bar(sheet, end + BAR_GAP, top, bar, {-map.limit, map.limit, label});
    save_png(sheet.Image, path);
}

void draw_triptych(const aob_viz_triptych &figure, const std::string &path)
{
    const aob_viz_map &map = figure.map;
    if (!figure.technique.channels[0] || map.width < 1 || map.height < 1)
        throw std::runtime_error("the image of the technique is missing");
    if (figure.technique.channels[1] && !(figure.exposure > 0))
        throw std::runtime_error("the exposure must be positive");
    if (!figure.reference.channels[0])
        return draw_alone(figure, path);
    draw_row(map,
             {{figure.technique, figure.reference, {{map.error}, nullptr}},
              {figure.technique_name, figure.reference_name, "Error: technique \u2212 reference"},
              2,
              figure.exposure},
             path);
}

void draw_split(const aob_viz_split &figure, const std::string &path)
{
    row of = {{}, {figure.names[0], figure.names[1], figure.names[2]}, 0, 1};
    for (int i = 0; i < 3; i++)
        of.images[i].channels[0] = figure.parts[i];
    draw_row(figure.map, of, path);
}

void write_vti(int width, int height, const aob_viz_field *fields, size_t count, const std::string &path)
{
    if (width < 1 || height < 1 || count < 1)
        throw std::runtime_error("there is no image to write");
    vtkNew<vtkImageData> image;
    image->SetDimensions(width, height, 1);
    for (size_t i = 0; i < count; i++) {
        vtkNew<vtkFloatArray> values;
        values->SetName(fields[i].name);
        values->SetNumberOfValues(static_cast<vtkIdType>(width) * height);
        flip_rows(width, height, fields[i].pixels, values->GetPointer(0));
        image->GetPointData()->AddArray(values);
    }
    image->GetPointData()->SetActiveScalars(fields[count - 1].name);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->WriteToOutputStringOn();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    writer->SetHeaderTypeToUInt64();
    if (!writer->Write())
        throw std::runtime_error("VTK made no image file");
    std::string bytes = writer->GetOutputString();
    save_bytes(path, bytes.data(), bytes.size());
}
} // namespace

int aob_viz_map_png(const aob_viz_map *map, const char *path, char *error)
{
    return guarded(error, [=] { draw_map(*map, path); });
}

int aob_viz_triptych_png(const aob_viz_triptych *figure, const char *path, char *error)
{
    return guarded(error, [=] { draw_triptych(*figure, path); });
}

int aob_viz_split_png(const aob_viz_split *figure, const char *path, char *error)
{
    return guarded(error, [=] { draw_split(*figure, path); });
}

int aob_viz_vti(int width, int height, const aob_viz_field *fields, size_t count, const char *path,
                char *error)
{
    return guarded(error, [=] { write_vti(width, height, fields, count, path); });
}

#include "viz_common.hpp"
#include <cerrno>
#include <cmath>
#include <cstring>
#include <unistd.h>
#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace aob_viz
{
namespace
{
constexpr int DPI = 72; /* at which a font's points are pixels */
const char *const FONTS[] = {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"};

/* Without it a "$" would start a formula. */
vtkTextRenderer *text_renderer()
{
    vtkTextRenderer *renderer = vtkTextRenderer::GetInstance();
    if (!renderer)
        throw std::runtime_error("VTK has no text renderer");
    renderer->SetDefaultBackend(vtkTextRenderer::FreeType);
    return renderer;
}

void drop_last_character(std::string &text)
{
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80)
        text.pop_back();
    if (!text.empty())
        text.pop_back();
}
} // namespace

void silence_vtk()
{
    vtkObject::GlobalWarningDisplayOff();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

void apply_style(vtkTextProperty *property, const text_style &style)
{
    const char *font = FONTS[style.weight == face::bold];
    if (access(font, R_OK) == 0) {
        property->SetFontFamily(VTK_FONT_FILE);
        property->SetFontFile(font);
    } else {
        property->SetFontFamilyToArial();
        property->SetBold(style.weight == face::bold);
    }
    property->SetFontSize(style.size);
    property->SetColor((style.colour >> 16) / 255.0, (style.colour >> 8 & 255) / 255.0,
                       (style.colour & 255) / 255.0);
    property->SetJustification(style.across);
    property->SetVerticalJustification(style.along);
    property->SetOrientation(style.degrees);
}

int text_width(const std::string &text, const text_style &style)
{
    vtkNew<vtkTextProperty> property;
    text_style level = style;
    level.degrees = 0;
    apply_style(property, level);
    int box[4] = {0, 0, 0, 0};
    if (text.empty() || !text_renderer()->GetBoundingBox(property, text, box, DPI))
        return 0;
    return box[1] - box[0] + 1;
}

std::string fit_text(const char *text, const text_style &style, int width)
{
    std::string line = text ? text : "";
    for (char &c : line)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = ' ';
    if (line.size() > 1000)
        line.resize(1000);
    bool whole = text_width(line, style) <= width;
    while (!whole && !line.empty() && text_width(line + "\u2026", style) > width)
        drop_last_character(line);
    return whole ? line : line + "\u2026";
}

double nice_step(double range, int wanted)
{
    double raw = range / wanted, power = std::pow(10, std::floor(std::log10(raw))), first = raw / power;
    return (first < 1.5 ? 1 : first < 3.5 ? 2 : first < 7.5 ? 5 : 10) * power;
}

int decimals_of(double step)
{
    int digits = static_cast<int>(-std::floor(std::log10(step) + 1e-9));
    return digits < 0 ? 0 : digits > 9 ? 9 : digits;
}

static std::string with_minus(const char *digits)
{
    return digits[0] == '-' ? std::string("\u2212") + (digits + 1) : std::string(digits);
}

std::string number_text(double value, int decimals, bool sign)
{
    char digits[64];
    if (std::fabs(value) < 0.5 * std::pow(10, -decimals))
        return "0";
    std::snprintf(digits, sizeof digits, sign ? "%+.*f" : "%.*f", decimals, value);
    return with_minus(digits);
}

std::string short_number(double value)
{
    char digits[64];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return with_minus(digits);
}

/* ColorBrewer's RdBu with eleven steps, between them in Lab. */
static std::vector<unsigned char> make_error_colours()
{
    static const unsigned steps[] = {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7,
                                     0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f};
    vtkNew<vtkColorTransferFunction> function;
    function->SetColorSpaceToLab();
    for (int i = 0; i < 11; i++)
        function->AddRGBPoint(i / 5.0 - 1, (steps[i] >> 16) / 255.0, (steps[i] >> 8 & 255) / 255.0,
                              (steps[i] & 255) / 255.0);
    std::vector<float> table(3 * COLOURS);
    function->GetTable(-1, 1, COLOURS, table.data());
    std::vector<unsigned char> colours(4 * COLOURS, 255);
    for (int i = 0; i < COLOURS; i++)
        for (int k = 0; k < 3; k++)
            colours[4 * i + k] = static_cast<unsigned char>(std::lround(255 * table[3 * i + k]));
    return colours;
}

const std::vector<unsigned char> &error_colours()
{
    static const std::vector<unsigned char> colours = make_error_colours();
    return colours;
}

const unsigned char *error_colour(double value, double limit)
{
    static const unsigned char unknown[] = {0xc4, 0xc4, 0xc8, 0xff};
    if (!std::isfinite(value))
        return unknown;
    double place = std::fmin(std::fmax(value / limit, -1), 1) * 0.5 + 0.5;
    return &error_colours()[4 * static_cast<size_t>(std::lround(place * (COLOURS - 1)))];
}

/* Four wide and RGBA: narrower or RGB images are uploaded with the wrong row alignment. */
image_ptr error_bar_image()
{
    constexpr int width = 4, height = 512;
    image_ptr image = image_ptr::New();
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto *out = static_cast<unsigned char *>(image->GetScalarPointer());
    for (int i = 0; i < width * height; i++)
        std::memcpy(out + 4 * i, error_colour(2.0 * (i / width) / (height - 1) - 1, 1), 4);
    return image;
}

std::vector<tick> error_ticks(double limit, double length)
{
    double step = nice_step(2 * limit, length < 340 ? 5 : 8);
    int count = static_cast<int>(std::floor(limit / step + 1e-6));
    std::vector<tick> ticks;
    for (int i = -count; i <= count; i++)
        ticks.push_back({i * step, number_text(i * step, decimals_of(step), true)});
    return ticks;
}

void check_map(const aob_viz_map &map)
{
    if (map.width < 1 || map.height < 1 || map.width > 16384 || map.height > 16384)
        throw std::runtime_error("an image must have 1 to 16384 pixels each way");
    if (!map.error)
        throw std::runtime_error("there is no error to draw");
    if (!(map.limit > 1e-9 && map.limit < 1e9))
        throw std::runtime_error("the limit of the colours must be positive");
}

void flip_rows(int width, int height, const float *from, float *to)
{
    for (int y = 0; y < height; y++)
        std::memcpy(to + static_cast<size_t>(height - 1 - y) * width, from + static_cast<size_t>(y) * width,
                    static_cast<size_t>(width) * sizeof *to);
}

image_ptr float_image(int width, int height, const float *pixels, const char *name)
{
    image_ptr image = image_ptr::New();
    image->SetDimensions(width, height, 1);
    vtkNew<vtkFloatArray> values;
    values->SetName(name);
    values->SetNumberOfValues(static_cast<vtkIdType>(width) * height);
    flip_rows(width, height, pixels, values->GetPointer(0));
    image->GetPointData()->SetScalars(values);
    return image;
}

void save_bytes(const std::string &path, const void *bytes, size_t size)
{
    std::string part = path + "." + std::to_string(getpid()) + ".part";
    std::FILE *file = std::fopen(part.c_str(), "wb");
    bool ok = file && std::fwrite(bytes, 1, size, file) == size;
    if (file)
        ok = std::fclose(file) == 0 && ok;
    if (ok && std::rename(part.c_str(), path.c_str()) == 0)
        return;
    std::string why = std::strerror(errno);
    unlink(part.c_str());
    throw std::runtime_error("cannot write: " + why);
}

/* By way of memory: the writer leaks when a file cannot be opened, and does not notice a full disk. */
void save_png(vtkImageData *image, const std::string &path)
{
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->SetCompressionLevel(4);
    writer->Write();
    vtkUnsignedCharArray *bytes = writer->GetResult();
    if (!bytes || bytes->GetNumberOfValues() == 0)
        throw std::runtime_error("VTK made no PNG");
    save_bytes(path, bytes->GetPointer(0), static_cast<size_t>(bytes->GetNumberOfValues()));
}
} // namespace aob_viz

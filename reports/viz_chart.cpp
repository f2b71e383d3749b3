/* Charts: one painter in pixel coordinates, without matrices and clips, both of which VTK's SVG device gets wrong. */
#include "viz_common.hpp"
#include "viz_window.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>
#include <vtkAssemblyPath.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkViewport.h>
#include <vtkWindow.h>
#include <vtkXMLDataElement.h>

using namespace aob_viz;

namespace
{
constexpr int WIDTH = 960, HEIGHT = 560, TOP = 92, BOTTOM = 70, LEGEND_LINE = 25, LEGEND_MAX = 290;
constexpr unsigned GRID = 0xebecef, GRID_STRONG = 0xd4d6da, FRONT = 0x9a9aa4;
/* Okabe and Ito's colours, apart for colour-blind eyes too; yellow is too pale for lines on white. */
constexpr unsigned COLOUR[] = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9, 0x7f3c8d, 0x444444};
const text_style TITLE = {20, face::bold}, SUBTITLE = {14, face::plain, GREY}, LEGEND = {14};

struct point {
    double x, y, low, high;
};
struct curve {
    std::string name;
    aob_viz_style style;
    int colour;
    std::vector<point> points;
};

/* One axis: what it spans and where its ticks are. */
class scale
{
public:
    scale(const aob_viz_axis &axis) : Log(axis.logarithmic != 0), Label(axis.label ? axis.label : "")
    {
    }
    bool Takes(double value) const
    {
        return std::isfinite(value) && (!Log || value > 0);
    }
    void Include(double value)
    {
        if (Takes(value)) {
            Low = std::min(Low, To(value));
            High = std::max(High, To(value));
        }
    }
    void Finish();
    /* 0 at the low end, 1 at the high end. */
    double Place(double value) const
    {
        return (To(value) - Low) / (High - Low);
    }
    struct mark {
        double value;
        bool strong;
        std::string label;
    };
    std::vector<mark> Marks(int wanted) const;

    const bool Log;
    std::string Label;

private:
    double To(double value) const
    {
        return Log ? std::log10(value) : value;
    }
    std::vector<mark> Decades() const;

    double Low = HUGE_VAL, High = -HUGE_VAL;
};

void scale::Finish()
{
    double low = Low, high = High, width = high - low;
    if (!(width > 1e-9 * std::max(std::fabs(low), std::fabs(high))))
        width = Log || low == 0 ? .6 : std::fabs(low), low -= width / 2, high += width / 2;
    bool from_zero = !Log && Low >= 0 && Low < .4 * High;
    Low = from_zero ? 0 : low - .04 * width;
    High = high + .04 * width;
}

std::vector<scale::mark> scale::Decades() const
{
    std::vector<mark> marks;
    bool few = High - Low < 3;
    for (int e = static_cast<int>(std::floor(Low)); e <= static_cast<int>(std::ceil(High)); e++)
        for (int digit = 1; digit < 10; digit++) {
            double value = digit * std::pow(10, e);
            if (To(value) < Low || To(value) > High)
                continue;
            bool labelled = digit == 1 || (few && (digit == 2 || digit == 5));
            marks.push_back({value, digit == 1, labelled ? short_number(value) : ""});
        }
    return marks;
}

/* A short logarithmic axis gets round steps, as a linear one does. */
std::vector<scale::mark> scale::Marks(int wanted) const
{
    if (Log && High - Low > 1)
        return Decades();
    double low = Log ? std::pow(10, Low) : Low, high = Log ? std::pow(10, High) : High;
    double step = nice_step(high - low, wanted);
    std::vector<mark> marks;
    for (double i = std::ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++)
        marks.push_back({i * step, false, number_text(i * step, decimals_of(step), false)});
    return marks;
}

class chart_item : public vtkContextItem
{
public:
    static chart_item *New();
    vtkTypeMacro(chart_item, vtkContextItem);
    void Take(const aob_viz_chart &chart);
    bool Paint(vtkContext2D *painter) override;

    float K = 1; /* pixels drawn for each pixel of the figure */

private:
    void TakeSeries(const aob_viz_series &series);
    void Layout(const aob_viz_chart &chart);
    void OrderLegend();

    float X(double value) const
    {
        return (Left + static_cast<float>(AxisX.Place(value)) * Across) * K;
    }
    float Y(double value) const
    {
        return (BOTTOM + static_cast<float>(AxisY.Place(value)) * Up) * K;
    }
    void Pen(unsigned colour, float width);
    void Text(float x, float y, const std::string &text, text_style style);
    void Marker(const curve &c, float x, float y);
    void Axes();
    void ColumnLabels(const std::vector<scale::mark> &marks);
    void Front(const curve &c);
    void Curve(const curve &c);
    void Bars(const curve &c);
    void Legend();

    vtkContext2D *Painter = nullptr; /* while painting */
    scale AxisX{{nullptr, 0}}, AxisY{{nullptr, 0}};
    std::vector<curve> Curves;
    std::vector<const curve *> Order; /* of the legend */
    std::string Title, Subtitle;
    float Left = 0, Across = 0, Up = HEIGHT - TOP - BOTTOM;
};
vtkStandardNewMacro(chart_item);

void chart_item::TakeSeries(const aob_viz_series &s)
{
    curve c = {"", s.style, std::max(s.colour, 0), {}};
    for (size_t i = 0; i < s.count; i++) {
        double low = s.low ? s.low[i] : NAN, high = s.high ? s.high[i] : NAN;
        if (!AxisX.Takes(s.x[i]) || !AxisY.Takes(s.y[i]))
            continue;
        c.points.push_back({s.x[i], s.y[i], low, high});
        AxisX.Include(s.x[i]);
        for (double y : {s.y[i], low, high})
            AxisY.Include(y);
    }
    c.name = fit_text(s.name, LEGEND, LEGEND_MAX - 60);
    if (!c.points.empty())
        Curves.push_back(c);
}

void chart_item::Layout(const aob_viz_chart &chart)
{
    int names = 0, numbers = 0;
    for (const curve &c : Curves)
        names = std::max(names, text_width(c.name, LEGEND));
    for (const scale::mark &m : AxisY.Marks(8))
        numbers = std::max(numbers, text_width(m.label, LEGEND));
    Left = static_cast<float>(52 + numbers);
    Across = static_cast<float>(WIDTH - names - 86) - Left;
    Title = fit_text(chart.title, TITLE, WIDTH - static_cast<int>(Left) - 20);
    Subtitle = fit_text(chart.subtitle, SUBTITLE, WIDTH - static_cast<int>(Left) - 20);
}

/* Curves by their last value, so that the legend reads like the chart; the front last. */
void chart_item::OrderLegend()
{
    for (const curve &c : Curves)
        Order.push_back(&c);
    std::stable_sort(Order.begin(), Order.end(), [](const curve *a, const curve *b) {
        if (a->style != AOB_VIZ_CURVE || b->style != AOB_VIZ_CURVE)
            return a->style < b->style;
        return a->points.back().y > b->points.back().y;
    });
}

void chart_item::Take(const aob_viz_chart &chart)
{
    AxisX.~scale();
    new (&AxisX) scale(chart.x);
    AxisY.~scale();
    new (&AxisY) scale(chart.y);
    for (size_t i = 0; i < chart.series_count; i++)
        TakeSeries(chart.series[i]);
    if (Curves.empty())
        throw std::runtime_error("there is no point to draw");
    AxisX.Finish();
    AxisY.Finish();
    Layout(chart);
    OrderLegend();
}

void chart_item::Pen(unsigned colour, float width)
{
    Painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    Painter->GetPen()->SetColor(colour >> 16, colour >> 8 & 255, colour & 255, 255);
    Painter->GetPen()->SetWidth(width * K);
}

/* At whole pixels: elsewhere the texture's edge shows as a ghost line. */
void chart_item::Text(float x, float y, const std::string &text, text_style style)
{
    if (text.empty())
        return;
    vtkNew<vtkTextProperty> property;
    style.size = static_cast<int>(std::lround(static_cast<float>(style.size) * K));
    apply_style(property, style);
    Painter->ApplyTextProp(property);
    Painter->DrawString(std::round(x), std::round(y), text);
}

/* Circle, square, diamond, triangles, pentagon, hexagon; the shape wanders through all as colours repeat. */
void chart_item::Marker(const curve &c, float x, float y)
{
    static const struct {
        int corners;
        float turn, size;
    } shapes[] = {{28, 0, 4.6f},    {4, 45, 5.5f}, {4, 90, 5.9f}, {3, 90, 5.9f},
                  {3, -90, 5.9f}, {5, 90, 5.6f}, {6, 90, 5.4f}};
    const auto &shape = shapes[(c.colour + c.colour / 8) % 7];
    unsigned colour = COLOUR[c.colour % 8];
    float rim[2 * 29];
    for (int i = 0; i <= shape.corners; i++) {
        float angle = static_cast<float>((shape.turn + 360.0f * i / shape.corners) * M_PI / 180);
        rim[2 * i] = x + shape.size * K * std::cos(angle);
        rim[2 * i + 1] = y + shape.size * K * std::sin(angle);
    }
    Painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    Painter->GetBrush()->SetColor(colour >> 16, colour >> 8 & 255, colour & 255, 255);
    Painter->DrawPolygon(rim, shape.corners);
    Pen(0xffffff, 1);
    Painter->DrawPoly(rim, shape.corners + 1);
}

/* Numbers that would touch their neighbour are left out. */
void chart_item::ColumnLabels(const std::vector<scale::mark> &marks)
{
    float free_from = -1e9f;
    for (const scale::mark &m : marks) {
        float x = X(m.value), half = static_cast<float>(text_width(m.label, LEGEND)) * K / 2;
        if (m.label.empty() || x - half < free_from)
            continue;
        Pen(GREY, 1);
        Painter->DrawLine(std::round(x), BOTTOM * K, std::round(x), (BOTTOM - 5) * K);
        Text(x, (BOTTOM - 9) * K, m.label, {14, face::plain, INK, VTK_TEXT_CENTERED, VTK_TEXT_TOP});
        free_from = x + half + 8 * K;
    }
}

void chart_item::Axes()
{
    float left = Left * K, right = (Left + Across) * K, low = BOTTOM * K, high = (BOTTOM + Up) * K;
    auto columns = AxisX.Marks(8), rows = AxisY.Marks(8);
    for (const scale::mark &m : columns) {
        Pen(m.strong ? GRID_STRONG : GRID, 1);
        Painter->DrawLine(std::round(X(m.value)), low, std::round(X(m.value)), high);
    }
    for (const scale::mark &m : rows) {
        float y = std::round(Y(m.value));
        Pen(m.strong ? GRID_STRONG : GRID, 1);
        Painter->DrawLine(left, y, right, y);
        if (m.label.empty())
            continue;
        Pen(GREY, 1);
        Painter->DrawLine(left, y, left - 5 * K, y);
        Text(left - 9 * K, y, m.label, {14, face::plain, INK, VTK_TEXT_RIGHT, VTK_TEXT_CENTERED});
    }
    ColumnLabels(columns);
    Pen(GREY, 1.2f);
    Painter->DrawLine(left, low, right, low);
    Painter->DrawLine(left, low, left, high);
    Text((left + right) / 2, 16 * K, AxisX.Label, {15, face::plain, INK, VTK_TEXT_CENTERED, VTK_TEXT_BOTTOM});
    Text(20 * K, (low + high) / 2, AxisY.Label,
         {15, face::plain, INK, VTK_TEXT_CENTERED, VTK_TEXT_CENTERED, 90});
}

void chart_item::Front(const curve &c)
{
    std::vector<float> path;
    for (size_t i = 0; i < c.points.size(); i++) {
        if (i > 0)
            path.insert(path.end(), {X(c.points[i].x), Y(c.points[i - 1].y)});
        path.insert(path.end(), {X(c.points[i].x), Y(c.points[i].y)});
    }
    path.insert(path.end(), {(Left + Across) * K, path.back()});
    Pen(FRONT, 1.6f);
    Painter->DrawPoly(path.data(), static_cast<int>(path.size() / 2));
}

void chart_item::Curve(const curve &c)
{
    std::vector<float> path;
    for (const point &p : c.points)
        path.insert(path.end(), {X(p.x), Y(p.y)});
    Pen(COLOUR[c.colour % 8], 2.2f);
    if (c.points.size() > 1)
        Painter->DrawPoly(path.data(), static_cast<int>(c.points.size()));
}

void chart_item::Bars(const curve &c)
{
    Pen(COLOUR[c.colour % 8], 1.3f);
    for (const point &p : c.points) {
        if (!AxisY.Takes(p.low) || !AxisY.Takes(p.high) || p.low > p.high)
            continue;
        float x = X(p.x), low = Y(p.low), high = Y(p.high), cap = 4 * K;
        Painter->DrawLine(x, low, x, high);
        Painter->DrawLine(x - cap, low, x + cap, low);
        Painter->DrawLine(x - cap, high, x + cap, high);
    }
}

void chart_item::Legend()
{
    float x = (Left + Across + 20) * K, y = (BOTTOM + Up - 10) * K, end = BOTTOM * K;
    for (size_t i = 0; i < Order.size(); i++, y -= LEGEND_LINE * K) {
        const curve &c = *Order[i];
        bool no_room = y - LEGEND_LINE * K < end && i + 1 < Order.size();
        if (no_room) {
            Text(x, y, "and " + std::to_string(Order.size() - i) + " more",
                 {14, face::plain, GREY, VTK_TEXT_LEFT, VTK_TEXT_CENTERED});
            return;
        }
        Pen(c.style == AOB_VIZ_FRONT ? FRONT : COLOUR[c.colour % 8], c.style == AOB_VIZ_FRONT ? 1.6f : 2.2f);
        if (c.style != AOB_VIZ_POINTS)
            Painter->DrawLine(x, y, x + 30 * K, y);
        if (c.style != AOB_VIZ_FRONT)
            Marker(c, x + 15 * K, y);
        Text(x + 40 * K, y, c.name, {14, face::plain, INK, VTK_TEXT_LEFT, VTK_TEXT_CENTERED});
    }
}

bool chart_item::Paint(vtkContext2D *painter)
{
    Painter = painter;
    Axes();
    for (const curve &c : Curves)
        if (c.style == AOB_VIZ_FRONT)
            Front(c);
    for (const curve &c : Curves)
        if (c.style == AOB_VIZ_CURVE)
            Curve(c);
    for (const curve &c : Curves)
        if (c.style != AOB_VIZ_FRONT)
            Bars(c);
    for (const curve &c : Curves)
        for (const point &p : c.points)
            if (c.style != AOB_VIZ_FRONT)
                Marker(c, X(p.x), Y(p.y));
    Text(Left * K, (HEIGHT - 46) * K, Title, TITLE);
    Text(Left * K, (HEIGHT - 72) * K, Subtitle, SUBTITLE);
    Legend();
    Painter = nullptr;
    return true;
}

/* The SVG device asks its viewport's window for size and resolution, no more. */
class paper : public vtkWindow
{
public:
    static paper *New();
    vtkTypeMacro(paper, vtkWindow);
    void SetDisplayId(void *) override
    {
    }
    void SetWindowId(void *) override
    {
    }
    void SetParentId(void *) override
    {
    }
    void *GetGenericDisplayId() override
    {
        return nullptr;
    }
    void *GetGenericWindowId() override
    {
        return nullptr;
    }
    void *GetGenericParentId() override
    {
        return nullptr;
    }
    void *GetGenericContext() override
    {
        return nullptr;
    }
    void *GetGenericDrawable() override
    {
        return nullptr;
    }
    void SetWindowInfo(const char *) override
    {
    }
    void SetParentInfo(const char *) override
    {
    }
    void Render() override
    {
    }
    void ReleaseGraphicsResources(vtkWindow *) override
    {
    }
    unsigned char *GetPixelData(int, int, int, int, int, int) override
    {
        return nullptr;
    }
    int GetPixelData(int, int, int, int, int, vtkUnsignedCharArray *, int) override
    {
        return 0;
    }
};
vtkStandardNewMacro(paper);

class paper_view : public vtkViewport
{
public:
    static paper_view *New();
    vtkTypeMacro(paper_view, vtkViewport);
    vtkWindow *GetVTKWindow() override
    {
        return this->VTKWindow;
    }
    void LieOn(vtkWindow *window)
    {
        this->VTKWindow = window;
        this->SetViewport(0, 0, 1, 1);
    }
    vtkAssemblyPath *PickProp(double, double) override
    {
        return nullptr;
    }
    vtkAssemblyPath *PickProp(double, double, double, double) override
    {
        return nullptr;
    }
    double GetPickedZ() override
    {
        return 0;
    }
};
vtkStandardNewMacro(paper_view);

/* Without fill="none" every line would be a black area. */
vtkSmartPointer<vtkXMLDataElement> svg_root()
{
    auto root = vtkSmartPointer<vtkXMLDataElement>::New();
    std::string box = "0 0 " + std::to_string(WIDTH) + " " + std::to_string(HEIGHT);
    root->SetName("svg");
    root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    root->SetAttribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
    root->SetAttribute("version", "1.1");
    root->SetIntAttribute("width", WIDTH);
    root->SetIntAttribute("height", HEIGHT);
    root->SetAttribute("viewBox", box.c_str());
    root->SetAttribute("fill", "none");
    root->SetAttribute("stroke-linejoin", "round");
    return root;
}

vtkXMLDataElement *add_element(vtkXMLDataElement *parent, const char *name)
{
    vtkNew<vtkXMLDataElement> element;
    element->SetName(name);
    parent->AddNestedElement(element);
    return element;
}

void draw_svg(const aob_viz_chart &chart, const std::string &path)
{
    vtkNew<chart_item> item;
    item->Take(chart);
    auto root = svg_root();
    vtkXMLDataElement *definitions = add_element(root, "defs"), *sheet = add_element(root, "rect");
    sheet->SetAttribute("width", "100%");
    sheet->SetAttribute("height", "100%");
    sheet->SetAttribute("fill", "#ffffff");
    vtkNew<paper> window;
    window->SetSize(WIDTH, HEIGHT);
    window->SetDPI(72);
    vtkNew<paper_view> view;
    view->LieOn(window);
    vtkNew<vtkSVGContextDevice2D> device;
    device->SetSVGContext(add_element(root, "g"), definitions);
    vtkNew<vtkContext2D> painter;
    device->Begin(view);
    painter->Begin(device);
    item->Paint(painter);
    painter->End();
    device->GenerateDefinitions();
    std::ostringstream text;
    text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    root->PrintXML(text, vtkIndent());
    save_bytes(path, text.str().data(), text.str().size());
}

void draw_png(const aob_viz_chart &chart, const std::string &path)
{
    vtkNew<chart_item> item;
    item->K = OVERSAMPLING;
    item->Take(chart);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(item);
    renderer->AddActor(actor);
    actor->GetScene()->SetRenderer(renderer);
    render_png(renderer, WIDTH, HEIGHT, path);
}
} // namespace

int aob_viz_chart_svg(const aob_viz_chart *chart, const char *path, char *error)
{
    return guarded(error, [=] { draw_svg(*chart, path); });
}

int aob_viz_chart_png(const aob_viz_chart *chart, const char *path, char *error)
{
    return guarded(error, [=] { draw_png(*chart, path); });
}

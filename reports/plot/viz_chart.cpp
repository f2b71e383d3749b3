/* Charts: one painter in pixel coordinates, without matrices and clips, both of which VTK's SVG device gets
 * wrong. */
#include "viz_common.hpp"
#include "viz_scale.hpp"
#include "viz_svg.hpp"
#include "viz_window.hpp"
#include <algorithm>
#include <cmath>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>

using namespace aob_viz;

namespace
{
constexpr int WIDTH = 960, HEIGHT = 560, TOP = 92, BOTTOM = 70, LEGEND_LINE = 25, LEGEND_MAX = 290;
constexpr unsigned GRID = 0xebecef, GRID_STRONG = 0xd4d6da, FRONT = 0x9a9aa4;
/* Okabe and Ito's colours, apart for colour-blind eyes too; yellow is too pale for lines on white. */
constexpr unsigned COLOUR[] = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7,
                               0xe69f00, 0x56b4e9, 0x7f3c8d, 0x444444};
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
    scale AxisX, AxisY;
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
    AxisX = scale(chart.x);
    AxisY = scale(chart.y);
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
    } shapes[] = {{28, 0, 4.6f},  {4, 45, 5.5f}, {4, 90, 5.9f}, {3, 90, 5.9f},
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

void draw_svg(const aob_viz_chart &chart, const std::string &path)
{
    vtkNew<chart_item> item;
    item->Take(chart);
    std::string text = svg_text(item, WIDTH, HEIGHT);
    save_bytes(path, text.data(), text.size());
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

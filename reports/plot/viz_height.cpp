/* The error as a landscape. */
#include "viz_common.hpp"
#include "viz_window.hpp"
#include <algorithm>
#include <cmath>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkContext2D.h>
#include <vtkContextActor.h>
#include <vtkContextItem.h>
#include <vtkContextScene.h>
#include <vtkCubeAxesActor.h>
#include <vtkBrush.h>
#include <vtkImageDataGeometryFilter.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkWarpScalar.h>

using namespace aob_viz;

namespace
{
constexpr int WIDTH = 1280, HEIGHT = 720, GRID = 256; /* cells across that still read as a surface */
constexpr float K = OVERSAMPLING;

/* Titles and colour bar in front of the landscape. */
class overlay : public vtkContextItem
{
  public:
    static overlay *New();
    vtkTypeMacro(overlay, vtkContextItem);
    bool Paint(vtkContext2D *painter) override;
    void Text(vtkContext2D *painter, float x, float y, const std::string &text, text_style style);

    std::string Title, Subtitle;
    double Limit = 1;
};
vtkStandardNewMacro(overlay);

void overlay::Text(vtkContext2D *painter, float x, float y, const std::string &text, text_style style)
{
    vtkNew<vtkTextProperty> property;
    style.size *= OVERSAMPLING;
    apply_style(property, style);
    painter->ApplyTextProp(property);
    painter->DrawString(std::round(x * K), std::round(y * K), text);
}

bool overlay::Paint(vtkContext2D *painter)
{
    constexpr float x = 1150, y = 130, width = 20, height = 440;
    Text(painter, 40, HEIGHT - 44, Title, {22, face::bold});
    Text(painter, 40, HEIGHT - 74, Subtitle, {15, face::plain, GREY});
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->GetBrush()->SetColorF(1, 1, 1, 1);
    painter->DrawImage(vtkRectf(x * K, y * K, width * K, height * K), error_bar_image());
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->GetPen()->SetColor(FRAME >> 16, FRAME >> 8 & 255, FRAME & 255);
    painter->GetPen()->SetWidth(K);
    float frame[] = {
        x * K, y * K, (x + width) * K, y * K, (x + width) * K, (y + height) * K, x * K, (y + height) * K,
        x * K, y * K};
    painter->DrawPoly(frame, 5);
    for (const tick &t : error_ticks(Limit, height)) {
        float at = y + static_cast<float>((t.value / Limit + 1) / 2) * height;
        painter->DrawLine((x + width) * K, at * K, (x + width + 5) * K, at * K);
        Text(painter, x + width + 10, at, t.label, {14, face::plain, INK, VTK_TEXT_LEFT, VTK_TEXT_CENTERED});
    }
    Text(painter, x + width + 76, y + height / 2, "AO minus reference",
         {14, face::plain, INK, VTK_TEXT_CENTERED, VTK_TEXT_CENTERED, 90});
    return true;
}

vtkSmartPointer<vtkLookupTable> colour_table(double limit)
{
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(COLOURS);
    const auto &colours = error_colours();
    for (int i = 0; i < COLOURS; i++)
        table->SetTableValue(i, colours[4 * i] / 255.0, colours[4 * i + 1] / 255.0,
                             colours[4 * i + 2] / 255.0);
    table->SetTableRange(-limit, limit);
    return table;
}

std::vector<float> without_holes(const aob_viz_map &map)
{
    std::vector<float> values(map.error, map.error + static_cast<size_t>(map.width) * map.height);
    for (float &v : values)
        v = std::isfinite(v) ? std::clamp(v, static_cast<float>(-map.limit), static_cast<float>(map.limit))
                             : 0;
    return values;
}

/* Single pixels are unreadable as a surface: average, then smooth. */
vtkSmartPointer<vtkPolyData> landscape(const aob_viz_map &map, double exaggeration)
{
    int shrink_by =
        std::max(1, static_cast<int>(std::lround(std::max(map.width, map.height) / double(GRID))));
    shrink_by = std::min(shrink_by, std::max(1, std::min(map.width, map.height) / 2));
    vtkNew<vtkImageShrink3D> shrink;
    shrink->SetInputData(float_image(map.width, map.height, without_holes(map).data(), "error"));
    shrink->SetShrinkFactors(shrink_by, shrink_by, 1);
    shrink->AveragingOn();
    vtkNew<vtkImageGaussianSmooth> smooth;
    smooth->SetInputConnection(shrink->GetOutputPort());
    smooth->SetDimensionality(2);
    smooth->SetStandardDeviations(1.2, 1.2, 0);
    smooth->SetRadiusFactors(3, 3, 0);
    vtkNew<vtkImageDataGeometryFilter> surface;
    surface->SetInputConnection(smooth->GetOutputPort());
    vtkNew<vtkWarpScalar> warp;
    warp->SetInputConnection(surface->GetOutputPort());
    warp->SetScaleFactor(exaggeration);
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(warp->GetOutputPort());
    normals->SplittingOff();
    normals->ConsistencyOff();
    normals->Update();
    return normals->GetOutput();
}

void add_surface(vtkRenderer *renderer, vtkPolyData *surface, double limit)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->SetLookupTable(colour_table(limit));
    mapper->SetScalarRange(-limit, limit);
    mapper->InterpolateScalarsBeforeMappingOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToPhong();
    actor->GetProperty()->SetAmbient(.38);
    actor->GetProperty()->SetDiffuse(.62);
    actor->GetProperty()->SetSpecular(0);
    renderer->AddActor(actor);
}

/* A headlight would burn out the pale colours. */
void add_lights(vtkRenderer *renderer)
{
    static const struct {
        double x, y, z, intensity;
    } lights[] = {{-.5, .3, 1, .85}, {.5, -.6, .6, .35}};
    renderer->AutomaticLightCreationOff();
    for (const auto &from : lights) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToSceneLight();
        light->SetPositional(false);
        light->SetPosition(from.x, from.y, from.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(from.intensity);
        renderer->AddLight(light);
    }
}

void style_axis(vtkCubeAxesActor *axes, int i, vtkProperty *line, vtkProperty *grid)
{
    text_style label = {13 * OVERSAMPLING};
    apply_style(axes->GetTitleTextProperty(i), label);
    apply_style(axes->GetLabelTextProperty(i), label);
    line->SetColor(.45, .45, .48);
    grid->SetColor(.85, .86, .88);
    line->SetLineWidth(K);
    grid->SetLineWidth(K);
}

/* Pixels along x and y; the colour bar tells the height. */
void add_axes(vtkRenderer *renderer, const aob_viz_map &map, double top)
{
    vtkNew<vtkCubeAxesActor> axes;
    axes->SetBounds(0, map.width, 0, map.height, -top, top);
    axes->SetCamera(renderer->GetActiveCamera());
    axes->SetFlyModeToOuterEdges();
    axes->SetUse2DMode(1);
    axes->SetLabelScaling(false, 0, 0, 0);
    axes->SetXTitle(" ");
    axes->SetYTitle(" ");
    axes->SetZTitle(" ");
    axes->SetXLabelFormat("%.0f");
    axes->SetYLabelFormat("%.0f");
    axes->ZAxisLabelVisibilityOff();
    axes->ZAxisTickVisibilityOff();
    axes->SetGridLineLocation(vtkCubeAxesActor::VTK_GRID_LINES_FURTHEST);
    axes->DrawXGridlinesOn();
    axes->DrawYGridlinesOn();
    axes->DrawZGridlinesOn();
    axes->XAxisMinorTickVisibilityOff();
    axes->YAxisMinorTickVisibilityOff();
    axes->ZAxisMinorTickVisibilityOff();
    style_axis(axes, 0, axes->GetXAxesLinesProperty(), axes->GetXAxesGridlinesProperty());
    style_axis(axes, 1, axes->GetYAxesLinesProperty(), axes->GetYAxesGridlinesProperty());
    style_axis(axes, 2, axes->GetZAxesLinesProperty(), axes->GetZAxesGridlinesProperty());
    renderer->AddActor(axes);
}

void place_camera(vtkRenderer *renderer, double width, double height)
{
    double size = std::max(width, height * 16 / 9);
    vtkCamera *camera = renderer->GetActiveCamera();
    camera->SetViewAngle(26);
    camera->SetFocalPoint(width / 2, height / 2, 0);
    camera->SetPosition(width / 2 - .30 * size, height / 2 - 1.42 * size, 1.24 * size);
    camera->SetViewUp(0, 0, 1);
    camera->SetWindowCenter(.07, .02);
    renderer->ResetCameraClippingRange();
}

void add_overlay(vtkRenderer *renderer, const aob_viz_map &map)
{
    vtkNew<overlay> item;
    item->Title = fit_text(map.title, {22, face::bold}, WIDTH - 80);
    item->Subtitle = fit_text(map.subtitle, {15}, WIDTH - 80);
    item->Limit = map.limit;
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->AddItem(item);
    renderer->AddActor(actor);
    actor->GetScene()->SetRenderer(renderer);
}

void draw_height(const aob_viz_map &map, const std::string &path)
{
    check_map(map);
    if (map.width < 4 || map.height < 4)
        throw std::runtime_error("a height field needs 4 x 4 pixels");
    double top = .14 * std::max(map.width, map.height);
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    add_surface(renderer, landscape(map, top / map.limit), map.limit);
    add_lights(renderer);
    add_axes(renderer, map, top);
    add_overlay(renderer, map);
    place_camera(renderer, map.width, map.height);
    render_png(renderer, WIDTH, HEIGHT, path);
}
} // namespace

int aob_viz_height_png(const aob_viz_map *map, const char *path, char *error)
{
    return guarded(error, [=] { draw_height(*map, path); });
}

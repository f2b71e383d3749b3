#include "viz_svg.hpp"
#include <sstream>
#include <vtkAssemblyPath.h>
#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkUnsignedCharArray.h>
#include <vtkViewport.h>
#include <vtkWindow.h>
#include <vtkXMLDataElement.h>

namespace aob_viz
{
namespace
{
/* The SVG device asks its viewport's window for size and resolution, no more. */
class paper : public vtkWindow
{
  public:
    static paper *New();
    vtkTypeMacro(paper, vtkWindow);
    void SetDisplayId(void *) override {}
    void SetWindowId(void *) override {}
    void SetParentId(void *) override {}
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
    void SetWindowInfo(const char *) override {}
    void SetParentInfo(const char *) override {}
    void Render() override {}
    void ReleaseGraphicsResources(vtkWindow *) override {}
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
vtkSmartPointer<vtkXMLDataElement> svg_root(int width, int height)
{
    auto root = vtkSmartPointer<vtkXMLDataElement>::New();
    std::string box = "0 0 " + std::to_string(width) + " " + std::to_string(height);
    root->SetName("svg");
    root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    root->SetAttribute("xmlns:xlink", "http://www.w3.org/1999/xlink");
    root->SetAttribute("version", "1.1");
    root->SetIntAttribute("width", width);
    root->SetIntAttribute("height", height);
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
} // namespace

std::string svg_text(vtkContextItem *item, int width, int height)
{
    auto root = svg_root(width, height);
    vtkXMLDataElement *definitions = add_element(root, "defs"), *sheet = add_element(root, "rect");
    sheet->SetAttribute("width", "100%");
    sheet->SetAttribute("height", "100%");
    sheet->SetAttribute("fill", "#ffffff");
    vtkNew<paper> window;
    window->SetSize(width, height);
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
    return text.str();
}
} // namespace aob_viz

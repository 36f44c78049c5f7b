#include "CadFiles.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax2.hxx>

#include <stdexcept>

namespace dipwright::test {
namespace {

Handle(TDocStd_Document) newDocument() {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Controller::Init();
    IGESControl_Controller::Init();
    Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
    Handle(TDocStd_Document) document;
    XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
    return document;
}

void write(const Handle(TDocStd_Document) & document, const QString& path, const char* unit) {
    Interface_Static::SetCVal("write.step.unit", unit);
    Interface_Static::SetCVal("write.iges.unit", unit);
    const QByteArray name = path.toLocal8Bit();
    bool isWritten = false;
    if (path.endsWith(QLatin1String(".igs"))) {
        IGESCAFControl_Writer writer;
        isWritten = writer.Transfer(document) && writer.Write(name.constData());
    } else {
        STEPCAFControl_Writer writer;
        isWritten = writer.Transfer(document) && writer.Write(name.constData()) == IFSelect_RetDone;
    }
    if (!isWritten) {
        throw std::runtime_error("the CAD file was not written");
    }
}

TopoDS_Shape bracket() {
    const TopoDS_Shape plate = BRepPrimAPI_MakeBox(gp_Pnt(-20, 0, -15), gp_Pnt(20, 5, 15)).Shape();
    const TopoDS_Shape upright =
        BRepPrimAPI_MakeBox(gp_Pnt(-20, 5, 10), gp_Pnt(20, 25, 15)).Shape();
    const TopoDS_Shape hole =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 15, 0), gp_Dir(0, 0, 1)), 6, 30).Shape();
    return BRepAlgoAPI_Cut(BRepAlgoAPI_Fuse(plate, upright).Shape(), hole).Shape();
}

// The face whose middle lies lowest.
TopoDS_Face underside(const TopoDS_Shape& shape) {
    TopoDS_Face lowest;
    double least = 1e9;
    for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        GProp_GProps properties;
        BRepGProp::SurfaceProperties(face.Current(), properties);
        if (properties.CentreOfMass().Y() < least) {
            least = properties.CentreOfMass().Y();
            lowest = TopoDS::Face(face.Current());
        }
    }
    return lowest;
}

} // namespace

void writeBracket(const QString& path, const char* unit) {
    const Handle(TDocStd_Document) document = newDocument();
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const auto colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
    const TopoDS_Shape shape = bracket();
    const TDF_Label part = shapes->AddShape(shape, false);
    TDataStd_Name::Set(part, "Bracket");
    colours->SetColor(part, Quantity_Color(0.2, 0.4, 0.6, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    const TDF_Label logo = shapes->AddSubShape(part, underside(shape));
    TDataStd_Name::Set(logo, "Logo");
    colours->SetColor(logo, Quantity_Color(0.8, 0.1, 0.1, Quantity_TOC_sRGB), XCAFDoc_ColorSurf);
    write(document, path, unit);
}

void writeDoubled(const QString& path, int levels) {
    const Handle(TDocStd_Document) document = newDocument();
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    TDF_Label below = shapes->AddShape(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), false);
    for (int level = 0; level < levels; ++level) {
        const TDF_Label above = shapes->NewShape();
        for (const double x : {0.0, 20.0 * (1 << level)}) {
            gp_Trsf place;
            place.SetTranslation(gp_Vec(x, 0, 0));
            shapes->AddComponent(above, below, TopLoc_Location(place));
        }
        below = above;
    }
    shapes->UpdateAssemblies();
    write(document, path, "MM");
}

void writeBoxes(const QString& path, int boxes) {
    const Handle(TDocStd_Document) document = newDocument();
    TopoDS_Compound part;
    const BRep_Builder builder;
    builder.MakeCompound(part);
    for (int box = 0; box < boxes; ++box) {
        builder.Add(part, BRepPrimAPI_MakeBox(gp_Pnt(2 * box, 0, 0), 1, 1, 1).Shape());
    }
    XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(part, false);
    write(document, path, "MM");
}

} // namespace dipwright::test

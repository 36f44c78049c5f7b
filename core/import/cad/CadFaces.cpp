#include "import/cad/CadFaces.h"

#include "base/Budgets.h"
#include "base/OneLine.h"

#include <QCoreApplication>
#include <QHash>
#include <QSet>

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <Bnd_Box.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Quantity_Color.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

constexpr int longestName = 150; // letters of a face's name

// Returns a name that is the same after it was sent and sanitized.
QString cleaned(const QString& name) {
    const QString start = oneLine(name).simplified().left(longestName).trimmed();
    const QString clean = QString::fromUtf8(start.toUtf8()); // it may have halves of letters
    return clean.compare(QLatin1String("none"), Qt::CaseInsensitive) == 0 ? QString() : clean;
}

QString nameOf(const TDF_Label& label) {
    Handle(TDataStd_Name) name;
    if (!label.FindAttribute(TDataStd_Name::GetID(), name)) {
        return {};
    }
    return cleaned(QString::fromUtf16(name->Get().ToExtString(), name->Get().Length()));
}

// Returns the name of an entity of the file.
QString nameOf(const Handle(Standard_Transient) & entity) {
    Handle(TCollection_HAsciiString) name;
    if (const auto step = Handle(StepRepr_RepresentationItem)::DownCast(entity); !step.IsNull()) {
        name = step->Name();
    } else if (const auto iges = Handle(IGESData_IGESEntity)::DownCast(entity);
               !iges.IsNull() && iges->HasName()) {
        name = iges->NameValue();
    }
    return name.IsNull() ? QString() : cleaned(QString::fromUtf8(name->ToCString()));
}

using NamesInFile = QHash<const TopoDS_TShape*, QString>;

// Returns the names of the file's entities from which faces were made, by these faces.
NamesInFile namesInFile(const XSControl_WorkSession& session) {
    NamesInFile names;
    const Handle(Transfer_TransientProcess) process = session.TransferReader()->TransientProcess();
    for (int i = 1; i <= process->NbMapped(); ++i) {
        const Handle(Standard_Transient) entity = process->Mapped(i);
        const QString name = nameOf(entity);
        const TopoDS_Shape shape =
            name.isEmpty() ? TopoDS_Shape() : TransferBRep::ShapeResult(process, entity);
        if (!shape.IsNull() && shape.ShapeType() == TopAbs_FACE &&
            !names.contains(shape.TShape().get())) {
            names.insert(shape.TShape().get(), name);
        }
    }
    return names;
}

class FaceList {
public:
    FaceList(const CadDocument& document, const QString& path)
        : path_(path), namesInFile_(namesInFile(*document.session)),
          shapes_(XCAFDoc_DocumentTool::ShapeTool(document.document->Main())),
          colours_(XCAFDoc_DocumentTool::ColorTool(document.document->Main())) {
        TDF_LabelSequence labels;
        shapes_->GetFreeShapes(labels);
        for (const TDF_Label& label : labels) {
            addLabel(label, {}, {}, 0);
        }
        nameAll();
    }

    CadFaces take() { return std::move(result_); }

private:
    std::optional<QColor> colourOf(const TDF_Label& label) const {
        Quantity_Color colour;
        for (const XCAFDoc_ColorType kind : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
            if (colours_->GetColor(label, kind, colour)) {
                double red = 0, green = 0, blue = 0;
                colour.Values(red, green, blue, Quantity_TOC_sRGB);
                const auto part = [](double value) { return float(std::clamp(value, 0.0, 1.0)); };
                return QColor::fromRgb(QColor::fromRgbF(part(red), part(green), part(blue)).rgb());
            }
        }
        return std::nullopt;
    }

    // Adds the faces of an assembly, of a part in it, or of a part. `inherited` is the colour of
    // what contains it.
    void addLabel(const TDF_Label& label, const TopLoc_Location& place,
                  const std::optional<QColor>& inherited, qint64 depth) {
        requireWithin(Budget::Nesting, depth, path_);
        const std::optional<QColor> own = colourOf(label);
        const std::optional<QColor> colour = own ? own : inherited;
        TDF_Label prototype;
        TDF_LabelSequence components;
        if (XCAFDoc_ShapeTool::GetReferredShape(label, prototype)) {
            addLabel(prototype, place * XCAFDoc_ShapeTool::GetLocation(label), colour, depth + 1);
        } else if (XCAFDoc_ShapeTool::GetComponents(label, components)) {
            for (const TDF_Label& component : components) {
                addLabel(component, place, colour, depth + 1);
            }
        } else {
            addPart(label, place, colour);
        }
    }

    void addPart(const TDF_Label& label, const TopLoc_Location& place,
                 const std::optional<QColor>& colour) {
        const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(label);
        if (part.IsNull()) {
            return;
        }
        if (partsSeen_.Add(part)) {
            result_.parts.push_back(part);
        }
        std::vector<TDF_Label> named; // of shapes in the part
        TopTools_DataMapOfShapeInteger places;
        TDF_LabelSequence subShapes;
        XCAFDoc_ShapeTool::GetSubShapes(label, subShapes);
        for (const TDF_Label& sub : subShapes) {
            places.Bind(XCAFDoc_ShapeTool::GetShape(sub), int(named.size()));
            named.push_back(sub);
        }
        const auto colourAt = [&](const TopoDS_Shape& shape,
                                  const std::optional<QColor>& otherwise) {
            const int* found = places.Seek(shape);
            const std::optional<QColor> own =
                found ? colourOf(named[std::size_t(*found)]) : std::nullopt;
            return own ? own : otherwise;
        };
        const auto add = [&](const TopoDS_Shape& shape, const std::optional<QColor>& otherwise) {
            const TopoDS_Face face = TopoDS::Face(shape);
            const int* found = places.Seek(face);
            const QString name = found ? nameOf(named[std::size_t(*found)]) : QString();
            result_.faces.push_back(
                {face, place, name.isEmpty() ? namesInFile_.value(face.TShape().get()) : name,
                 colourAt(face, otherwise)});
            requireWithin(Budget::Faces, qint64(result_.faces.size()), path_);
        };
        for (TopExp_Explorer solid(part, TopAbs_SOLID); solid.More(); solid.Next()) {
            const std::optional<QColor> ofSolid = colourAt(solid.Current(), colour);
            for (TopExp_Explorer face(solid.Current(), TopAbs_FACE); face.More(); face.Next()) {
                add(face.Current(), ofSolid);
            }
        }
        for (TopExp_Explorer face(part, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next()) {
            add(face.Current(), colour);
        }
    }

    // Names the unnamed faces, and numbers faces of the same name.
    void nameAll() {
        QSet<QString> taken;
        QHash<QString, int> counts;
        for (std::size_t number = 0; number < result_.faces.size(); ++number) {
            QString& name = result_.faces[number].name;
            const QString plain = name.isEmpty() ? QStringLiteral("Face %1").arg(number + 1) : name;
            name = plain;
            while (taken.contains(name)) {
                name = QStringLiteral("%1 (%2)").arg(plain).arg(counts[plain]++ + 2);
            }
            taken.insert(name);
        }
    }

    const QString& path_;
    NamesInFile namesInFile_;
    Handle(XCAFDoc_ShapeTool) shapes_;
    Handle(XCAFDoc_ColorTool) colours_;
    TopTools_MapOfShape partsSeen_;
    CadFaces result_;
};

// Returns the same faces with shared edges, so that their triangles leave no gaps. Places become
// part of the faces.
CadFaces sewn(const CadFaces& faces) {
    constexpr double share = 1e-5; // tolerance relative to the body; as the repair of meshes uses
    Bnd_Box box;
    for (const CadFace& face : faces.faces) {
        BRepBndLib::Add(face.face.Moved(face.place), box);
    }
    BRepBuilderAPI_Sewing sewing(box.IsVoid() ? 1e-6 : share * std::sqrt(box.SquareExtent()));
    CadFaces result = faces;
    for (CadFace& face : result.faces) {
        face.face = TopoDS::Face(face.face.Moved(face.place));
        face.place = {};
        sewing.Add(face.face);
    }
    sewing.Perform();
    for (CadFace& face : result.faces) {
        if (sewing.IsModified(face.face)) {
            const TopoDS_Shape& modified = sewing.Modified(face.face);
            if (modified.ShapeType() == TopAbs_FACE) {
                face.face = TopoDS::Face(modified);
            }
        }
    }
    result.parts = {sewing.SewedShape()};
    return result;
}

} // namespace

CadFaces cadFaces(const CadDocument& document, const QString& path) {
    CadFaces faces = FaceList(document, path).take();
    if (faces.faces.empty()) {
        throwDamagedCad(Text::tr("it has no surfaces"), path);
    }
    return document.isSewn ? faces : sewn(faces);
}

} // namespace dipwright

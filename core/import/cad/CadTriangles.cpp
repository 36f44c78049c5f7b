#include "import/cad/CadTriangles.h"

#include "base/Budgets.h"
#include "base/Error.h"

#include <QCoreApplication>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

constexpr double turn = 0.35;     // largest angle between neighbouring triangles, radians
constexpr double accepted = 1.02; // a tolerance that is exceeded by less is not improved

// Returns the longest edge of the faces' box, mm in the file. It may be more than the true one.
double longestEdge(const CadFaces& faces) {
    Bnd_Box box;
    for (const CadFace& face : faces.faces) {
        BRepBndLib::Add(face.face.Moved(face.place), box);
    }
    if (box.IsVoid() || box.IsOpen()) {
        return 0;
    }
    double x = 0, y = 0, z = 0, right = 0, top = 0, front = 0;
    box.Get(x, y, z, right, top, front);
    return std::max({right - x, top - y, front - z});
}

// Size on the part of a millimetre in a file whose longest edge is `edge`.
double unitOf(const Tessellation& tessellation, double edge) {
    return tessellation.longestEdge > 0 ? tessellation.longestEdge / edge
                                        : tessellation.unitMillimetres;
}

void mesh(const CadFaces& faces, double deflection, const Progress& progress) {
    const QString step = Text::tr("Cutting the surfaces into triangles");
    for (std::size_t number = 0; number < faces.parts.size(); ++number) {
        progress(double(number) / double(faces.parts.size()), step);
        BRepTools::Clean(faces.parts[number]);
        BRepMesh_IncrementalMesh(faces.parts[number], deflection, false, turn, false);
    }
}

void addFace(const CadFace& face, std::uint16_t material, TexturedMesh& model) {
    TopLoc_Location inPart;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face.face, inPart);
    if (triangles.IsNull()) {
        return;
    }
    const gp_Trsf place = (face.place * inPart).Transformation();
    const bool isTurned = (face.face.Orientation() == TopAbs_REVERSED) != place.IsNegative();
    const auto first = std::uint32_t(model.mesh.positions.size()) - 1; // nodes count from 1
    for (int node = 1; node <= triangles->NbNodes(); ++node) {
        const gp_Pnt at = triangles->Node(node).Transformed(place);
        model.mesh.positions.emplace_back(float(at.X()), float(at.Y()), float(at.Z()));
    }
    for (int number = 1; number <= triangles->NbTriangles(); ++number) {
        int a = 0, b = 0, c = 0;
        triangles->Triangle(number).Get(a, b, c);
        if (isTurned) {
            std::swap(b, c);
        }
        model.mesh.triangles.push_back(
            {first + std::uint32_t(a), first + std::uint32_t(b), first + std::uint32_t(c)});
        model.material.push_back(material);
    }
}

TexturedMesh collected(const CadFaces& faces, const QString& path, QStringList& missing) {
    TexturedMesh model;
    for (const CadFace& face : faces.faces) {
        Material material;
        material.name = face.name;
        material.colour = face.colour.value_or(material.colour);
        const std::size_t before = model.mesh.triangles.size();
        addFace(face, std::uint16_t(model.materials.size()), model);
        if (model.mesh.triangles.size() == before) {
            missing.append(face.name);
        } else {
            model.materials.push_back(material);
        }
        requireWithin(Budget::CadTriangles, qint64(model.mesh.triangles.size()), path);
    }
    std::array<Eigen::Vector2f, 3> none;
    none.fill(Eigen::Vector2f::Constant(std::numeric_limits<float>::quiet_NaN()));
    model.textureCoordinates.assign(model.mesh.triangles.size(), none);
    return model;
}

QString missingText(const QStringList& missing) {
    constexpr qsizetype shown = 3;
    return Text::tr("Faces that are missing, because they cannot be cut into triangles: %1 (%2)")
        .arg(missing.size())
        .arg(missing.mid(0, shown).join(QStringLiteral(", ")));
}

} // namespace

TexturedMesh cadTriangles(const CadFaces& faces, const Tessellation& tessellation, double& used,
                          QStringList& warnings, const QString& path, const Progress& progress) {
    const double edge = longestEdge(faces);
    if (!(edge > 0) || !std::isfinite(edge)) {
        throwDamagedCad(Text::tr("its surfaces have no extent"), path);
    }
    double unit = unitOf(tessellation, edge);
    used = tessellation.tolerance > 0
               ? std::clamp(tessellation.tolerance, finestTessellation, coarsestTessellation)
               : usualTessellation(edge * unit);
    mesh(faces, used / unit, progress.part(0, 0.5));
    QStringList missing;
    TexturedMesh model = collected(faces, path, missing);
    if (model.mesh.triangles.empty()) {
        throwDamagedCad(Text::tr("its surfaces cannot be cut into triangles"), path);
    }
    // A larger box than the true one gives too small a unit, and too coarse triangles.
    if (const double exact = unitOf(tessellation, longestEdgeOf(model.mesh));
        exact > accepted * unit) {
        unit = exact;
        mesh(faces, used / unit, progress.part(0.5, 1));
        missing.clear();
        model = collected(faces, path, missing);
    }
    if (!missing.isEmpty()) {
        warnings.append(missingText(missing));
    }
    return model;
}

} // namespace dipwright

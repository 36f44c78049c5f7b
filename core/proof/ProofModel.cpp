#include "proof/ProofModel.h"

#include "geometry/CornerNormals.h"
#include "geometry/SurfaceQuery.h"
#include "proof/GltfFile.h"
#include "proof/PaintedTexture.h"
#include "reduction/ReducedMesh.h"

#include <QBuffer>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <map>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Proof)
};

constexpr double finestTexel = 0.04; // mm; no printer prints finer
constexpr double filledShare = 0.65; // of a picture that charts fill, roughly
constexpr int jpegQuality = 88;

Unwrapping chartsOf(const TriangleMesh& mesh, const Progress& progress) {
    const double texels = double(mostProofTexels) * mostProofTexels;
    const double texel =
        std::max(finestTexel, std::sqrt(surfaceArea(mesh) / (filledShare * texels)));
    return unwrapped(mesh, {}, texel, qint64(texels), progress);
}

// Adds the mesh's vertices, one for each position, normal and place in the picture.
void addVertices(GltfModel& model, const TriangleMesh& mesh, const Unwrapping& charts) {
    const CornerNormals normals = cornerNormals(mesh);
    const Eigen::Vector2f size(float(charts.width), float(charts.height));
    std::map<std::pair<std::uint32_t, std::array<float, 5>>, std::uint32_t> known;
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        auto& corners = model.triangles.emplace_back();
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t position = mesh.triangles[triangle][corner];
            Eigen::Vector3f normal = normals[triangle][corner].normalized();
            if (!normal.allFinite() || normal.isZero()) {
                normal = Eigen::Vector3f::UnitY(); // of a triangle without area
            }
            const Eigen::Vector2f place = charts.corners[triangle][corner].cwiseQuotient(size);
            const auto [entry, isNew] = known.try_emplace(
                {position, {normal.x(), normal.y(), normal.z(), place.x(), place.y()}},
                std::uint32_t(model.vertices.size()));
            if (isNew) {
                model.vertices.push_back({mesh.positions[position], normal, place});
            }
            corners[corner] = entry->second;
        }
    }
}

QByteArray jpegOf(const QImage& picture) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB888).save(&buffer, "JPG", jpegQuality);
    return bytes;
}

} // namespace

ProofModel proofModel(const QString& name, const TriangleMesh& body,
                      const std::vector<ProofLayer>& layers, const Progress& progress) {
    const QString text = Text::tr("Making the proof to share");
    progress(0, text);
    ProofModel result;
    const ReducedMesh reduced = reducedMesh(
        body, mostProofTriangles, proofTolerance * longestEdgeOf(body), progress.cancelToken);
    result.tolerance = reduced.distance;
    progress(0.15, text);
    const Unwrapping charts = chartsOf(reduced.mesh, progress.silent());
    GltfModel model;
    model.name = name;
    model.isClosed = isClosed(reduced.mesh);
    addVertices(model, reduced.mesh, charts);
    const SurfaceQuery query(body);
    const bool isSame = reduced.distance == 0;
    for (const ProofLayer& layer : layers) {
        progress(0.3 + 0.7 * double(model.materials.size()) / double(layers.size()), text);
        const auto colour = [&](const SurfacePoint& place) {
            return layer.colour(
                isSame ? place
                       : query.closestNear(position(reduced.mesh, place), float(reduced.distance))
                             .point);
        };
        model.materials.push_back(
            {layer.key, layer.name,
             jpegOf(paintedTexture(charts, layer.isMap ? mostProofTexels / 2 : mostProofTexels,
                                   colour, progress.cancelToken)),
             layer.isMap});
    }
    result.glb = glb(model);
    return result;
}

} // namespace dipwright

#include "workbench/document/ModelEdits.h"

#include "import/trusted/CadFacts.h"

#include <QCoreApplication>
#include <algorithm>

namespace dipwright {
namespace {

constexpr double mostRadius = 1000; // mm, of a stroke

void scalePlace(std::array<Millimetres, 3>& place, double factor) {
    for (Millimetres& coordinate : place) {
        coordinate = Millimetres(coordinate.value() * factor);
    }
}

template <typename Mark>
void scaleMarks(std::vector<Mark>& marks, double factor) {
    for (Mark& mark : marks) {
        scalePlace(mark.place, factor);
        if constexpr (requires { mark.path; }) {
            for (BrushPoint& point : mark.path) {
                scalePlace(point.place, factor);
            }
            if (!mark.path.empty()) {
                mark.radius = Millimetres(
                    std::clamp(mark.radius.value() * factor, leastMaskRadius, mostRadius));
            }
        }
    }
}

void scaleArtwork(Artwork& artwork, double factor) {
    scaleMarks(artwork.layers, factor);
    for (ArtworkLayer& layer : artwork.layers) {
        for (Millimetres& side : layer.size) {
            side = Millimetres(std::clamp(side.value() * factor, smallestLayer, largestLayer));
        }
        layer.repeat = Millimetres(std::min(layer.repeat.value() * factor, largestLayer));
    }
}

// The triangles grow with the part, and so does their tolerance.
void scaleTessellation(Project& project, double factor) {
    if (!project.cad.name.isEmpty()) {
        Millimetres& tolerance = project.modelOrigin.tessellation;
        tolerance = Millimetres(
            std::clamp(tolerance.value() * factor, finestTessellation, coarsestTessellation));
    }
}

} // namespace

void resizeModel(Document& document, Millimetres longestEdge) {
    const TexturedMesh& model = *document.project().model;
    const double factor =
        std::clamp(longestEdge.value(), leastLongestEdge.value(), mostLongestEdge.value()) /
        longestEdgeOf(model.mesh);
    document.edit(QCoreApplication::translate("ModelEdits", "Change size"),
                  QStringLiteral("model.size"), [&](Project& project) {
                      auto resized = std::make_shared<TexturedMesh>(model);
                      scale(resized->mesh, factor);
                      project.model = std::move(resized);
                      project.modelOrigin.unitMillimetres *= factor;
                      project.modelOrigin.sha256.clear();
                      scaleTessellation(project, factor);
                      scaleMarks(project.share.marks, factor);
                      scaleMarks(project.tolerance.marks, factor);
                      scaleMarks(project.masks, factor);
                      scaleArtwork(project.artwork, factor);
                  });
}

} // namespace dipwright

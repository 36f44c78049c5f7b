#include "pipeline/PrintedBody.h"

#include "results/Portrait.h"

#include <algorithm>

namespace dipwright {

std::vector<FilmAppearance> filmAppearances(const std::vector<ImmersionResult>& immersions,
                                            bool white) {
    std::vector<FilmAppearance> films;
    for (const ImmersionResult& immersion : immersions) {
        films.push_back({immersion.laid, immersion.texture->image});
        films.back().white = white ? immersion.texture->white : QImage();
        const std::vector<ArtworkLayer> spots = immersion.inputs.texture.paint.artwork.spots();
        for (std::size_t spot = 0; spot < immersion.texture->spots.size(); ++spot) {
            films.back().spots.push_back({immersion.texture->spots[spot], spots[spot].spotColour});
        }
    }
    return films;
}

Ground groundOf(const SheetSettings& sheet, const QString& baseColour) {
    Ground ground;
    if (!baseColour.isEmpty()) {
        ground.base = QColor(baseColour);
    }
    ground.whiteOutside = sheet.white == WhiteLayer::First;
    return ground;
}

PaintedBody printedBody(const JobResult& result, std::size_t count, const RefinedMesh& fine,
                        double places) {
    const std::vector<ImmersionResult>& all = result.immersions;
    const SheetInputs& inputs = all.front().inputs;
    return {filmAppearances({all.begin(), all.begin() + std::ptrdiff_t(count)}, true),
            inputs.texture.printedInk(), groundOf(inputs.settings, result.project.baseColour),
            &fine, places};
}

QImage portraitOf(const JobResult& result, QSize size, const CancelToken& cancelToken) {
    constexpr float usual = 0.35f; // share of the oblique view from above in the direction
    const TriangleMesh& mesh = result.project.model->mesh;
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();
    double area = 0;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const double own = triangleArea(mesh, triangle);
        area += own;
        if (std::any_of(
                result.immersions.begin(), result.immersions.end(),
                [&](const ImmersionResult& dip) { return dip.coverage->covered[triangle] != 0; })) {
            outward += own * triangleNormal(mesh, triangle).cast<double>();
        }
    }
    const Eigen::Vector3f painted = (outward / std::max(area, 1e-9)).cast<float>();
    const Eigen::Vector3f oblique = Eigen::Vector3f(0.5f, 0.45f, 0.8f).normalized();
    const SheetInputs& inputs = result.immersions.front().inputs;
    ProofOptions options;
    options.tile = size;
    options.ink = inputs.texture.printedInk();
    options.ground = groundOf(inputs.settings, result.project.baseColour);
    return portraitPicture(*result.proofStage, filmAppearances(result.immersions, true), options,
                           4 * painted + usual * oblique, cancelToken);
}

} // namespace dipwright

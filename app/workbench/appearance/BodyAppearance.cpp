#include "workbench/appearance/BodyAppearance.h"

#include "dip/FilmMarks.h"
#include "results/Results.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(BodyAppearance)
};

} // namespace

std::shared_ptr<const TexturedMesh> plainBody(const RefinedMesh& mesh) {
    return plainBody(mesh.mesh());
}

std::shared_ptr<const TexturedMesh> plainBody(const TriangleMesh& mesh) {
    auto body = std::make_shared<TexturedMesh>();
    body->mesh = mesh;
    body->textureCoordinates.resize(body->mesh.triangles.size());
    body->material.resize(body->mesh.triangles.size());
    body->chart.resize(body->mesh.triangles.size());
    body->materials.resize(1);
    return body;
}

BodyAppearance bareAppearance(std::shared_ptr<const TexturedMesh> model,
                              const std::optional<QColor>& base) {
    const QColor bare = base.value_or(QColor(206, 206, 203)); // as in the proof
    BodyAppearance appearance{std::move(model), {}};
    appearance.colours.assign(appearance.model->mesh.triangles.size(), bare.rgb());
    appearance.legend = {{bare, Text::tr("Not painted")}};
    return appearance;
}

BodyAppearance previewAppearance(std::shared_ptr<const TexturedMesh> body,
                                 const std::vector<std::uint8_t>& covered) {
    const QRgb painted = mapColour(QStringLiteral("balance"), 0.1).rgb();
    const QRgb bare = painterColour(Painter::None).rgb();
    BodyAppearance appearance{std::move(body), {}};
    for (const std::uint8_t isCovered : covered) {
        appearance.colours.push_back(isCovered ? painted : bare);
    }
    appearance.legend = {{painted, Text::tr("Painted (estimated from the shape)")},
                         {bare, Text::tr("Not painted")}};
    return appearance;
}

BodyAppearance coverageAppearance(std::shared_ptr<const TexturedMesh> model,
                                  const Coverage& coverage) {
    const QRgb painted = mapColour(QStringLiteral("balance"), 0.1).rgb();
    const QRgb bare = painterColour(Painter::None).rgb();
    BodyAppearance appearance{std::move(model), {}};
    for (std::size_t triangle = 0; triangle < coverage.covered.size(); ++triangle) {
        const auto mark = mostSeriousMark(coverage.marks[triangle]);
        appearance.colours.push_back(mark                         ? markColour(*mark).rgb()
                                     : coverage.covered[triangle] ? painted
                                                                  : bare);
    }
    appearance.legend = {{painted, Text::tr("Painted")}, {bare, Text::tr("Not painted")}};
    for (const solver::PointMark mark : filmMarks) {
        if (coverage.marked.of(mark) > 0) {
            appearance.legend.push_back({markColour(mark), markText(mark)});
        }
    }
    return appearance;
}

BodyAppearance shareAppearance(std::shared_ptr<const TexturedMesh> body, const JobResult& result) {
    const BodyShare& share = *result.share;
    BodyAppearance appearance{std::move(body), {}};
    for (const Painter painter : share.painters) {
        appearance.colours.push_back(painterColour(painter).rgb());
    }
    for (const ShareLine& line : shareLines(
             share, {result.immersions[0].immersion.name, result.immersions[1].immersion.name})) {
        appearance.legend.push_back({line.colour, line.text});
    }
    for (const auto& ends : share.join) {
        appearance.lines.push_back({ends, appearance.legend.back().colour});
    }
    return appearance;
}

} // namespace dipwright

#include "workbench/compare/StateDifference.h"

#include "results/DifferenceMap.h"
#include "results/Results.h"

#include <QCoreApplication>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(StateDifference)
};

constexpr int mapEdge = 1600; // pixels

QRgb colourOf(float move, const HeatScale& scale) {
    return move == paintedByNeither ? painterColour(Painter::None).rgb()
           : move == paintedByOne   ? paintedOnceColour.rgb()
                                    : scale.colour(double(move));
}

std::vector<ViewLegendEntry> legendOf(const SheetDifference& sheets, const HeatScale& scale,
                                      LengthUnit unit) {
    std::vector<ViewLegendEntry> legend;
    for (const double share : {0.0, 0.5, 1.0}) {
        const double distance = share * scale.high;
        legend.push_back({QColor(scale.colour(distance)), shownLength(distance, unit, 1)});
    }
    if (sheets.change.distance.maximum > scale.high) {
        legend.push_back({QColor(scale.colour(2 * scale.high)), Text::tr("More")});
    }
    legend.push_back({paintedOnceColour, Text::tr("Painted in only one state")});
    legend.push_back({painterColour(Painter::None), Text::tr("Not painted")});
    return legend;
}

BodyAppearance bodyOf(std::shared_ptr<const TexturedMesh> body, const SheetDifference& sheets,
                      const HeatScale& scale, LengthUnit unit) {
    BodyAppearance appearance{std::move(body), {}, legendOf(sheets, scale, unit)};
    for (const float move : sheets.pieces) {
        appearance.colours.push_back(colourOf(move, scale));
    }
    return appearance;
}

} // namespace

QString incomparableSentence(const ComparedResults& results) {
    const auto& [first, second] = results;
    return !first || !second ? Text::tr("The difference needs the dips of both states.")
           : first->project.model != second->project.model
               ? Text::tr("These states have different models, so their sheets cannot be compared.")
           : first->immersions.size() != second->immersions.size()
               ? Text::tr("These states have different numbers of dips, so their sheets cannot be "
                          "compared.")
               : QString();
}

std::vector<DipDifference> stateDifference(const ComparedResults& results, LengthUnit unit,
                                           const Progress& progress) {
    const TriangleMesh& mesh = results[0]->project.model->mesh;
    const auto fine = fineBody(mesh);
    const auto body = plainBody(*fine);
    std::vector<DipDifference> dips;
    const std::size_t count = results[0]->immersions.size();
    for (std::size_t dip = 0; dip < count; ++dip) {
        progress(double(dip) / double(count), Text::tr("Comparing the sheets"));
        const LaidFilm& second = *results[1]->immersions[dip].laid;
        DipDifference one;
        one.sheets = sheetDifference(*results[0]->immersions[dip].laid, second, *fine);
        const double end = differenceScaleEnd(one.sheets.pieces, unit);
        one.scale = {.low = 0, .high = end, .limit = end};
        progress((double(dip) + 0.5) / double(count), Text::tr("Drawing the difference"));
        one.map = differenceMap(second, one.sheets.points, end, mapEdge, unit);
        one.body = bodyOf(body, one.sheets, one.scale, unit);
        one.farthest = one.sheets.farthest.isValid() ? position(mesh, one.sheets.farthest)
                                                     : Eigen::Vector3f::Zero();
        dips.push_back(std::move(one));
    }
    return dips;
}

} // namespace dipwright

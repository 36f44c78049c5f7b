#include "pipeline/JobProof.h"

#include "base/NumberText.h"
#include "base/WideGamut.h"
#include "geometry/RefinedMesh.h"
#include "marks/SurfaceMask.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/PrintedBody.h"
#include "proof/ProofModel.h"
#include "proof/ProofPage.h"
#include "results/DifferenceMap.h"
#include "results/MapScale.h"
#include "results/PaintedBody.h"
#include "texture/ReverseTexture.h"
#include "texture/SurfaceColours.h"
#include "traveller/Traveller.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Proof)
};

constexpr int sheetPixels = 480, fallbackPixels = 1280; // in width
const QColor unpainted(158, 158, 154);                  // in maps

QString percent(double share) {
    return Text::tr("%1 %").arg(numberText(100 * share, 1));
}

QString area(double squareMillimetres) {
    return Text::tr("%1 mm²").arg(numberText(squareMillimetres, 0));
}

// A layer of the model with its legend.
struct Layer {
    ProofLayer layer;
    ProofLegend legend;
};

Layer layerOf(const char* key, const QString& name, const QString& explanation,
              std::function<QRgb(const SurfacePoint&)> colour) {
    const QString word = QString::fromLatin1(key);
    return {{word, name, std::move(colour)}, {word, name, explanation, {}}};
}

// Returns the part as it comes out of the first `count` dips.
Layer printedLayer(const JobResult& result, const std::shared_ptr<const RefinedMesh>& fine,
                   std::size_t count) {
    const std::vector<ImmersionResult>& all = result.immersions;
    const auto body = std::make_shared<const PaintedBody>(printedBody(result, count, *fine));
    const auto colour = [body, fine](const SurfacePoint& place) {
        return encodedPixel(body->colour(fine->onFine(place)));
    };
    if (count == all.size()) {
        return layerOf("printed", Text::tr("Printed"),
                       Text::tr("The part as it is expected to come out"), colour);
    }
    return layerOf("after-1", Text::tr("After dip 1"),
                   Text::tr("The part after %1").arg(all.front().immersion.name), colour);
}

// Returns the part as it was drawn.
Layer wantedLayer(const JobResult& result) {
    const auto look = result.painted;
    const bool wide = std::ranges::any_of(look->textures, isWide);
    const auto colours = std::make_shared<const SurfaceColours>(*look);
    return layerOf("wanted", Text::tr("Artwork"), Text::tr("The picture that was asked for"),
                   [look, wide, colours](const SurfacePoint& place) {
                       const LinearColour light =
                           colours->at(place, Eigen::Matrix<float, 3, 2>::Zero());
                       return encodedPixel(wide ? srgbLight(light) : light);
                   });
}

// What a map shows between film points. An error is not interpolated: it is zero off the body,
// which would hide it at the edge.
enum class Between { Interpolated, Largest };

// One value for each film point of a dip.
struct FilmPointValues {
    std::shared_ptr<const LaidFilm> laid;
    QImage image; // of the film; transparent where this dip does not print
    std::vector<float> values;
    Between between = Between::Interpolated;

    // Returns the value at a place of the body; nothing if this dip does not paint it.
    std::optional<float> at(const SurfacePoint& point) const {
        const std::optional<FilmPlace> place = laid->place(point);
        if (!place || !prints(place->rest)) {
            return std::nullopt;
        }
        const FilmTriangle& corners = laid->triangles()[place->triangle];
        const Eigen::Vector3f ofCorners{values[corners[0]], values[corners[1]], values[corners[2]]};
        if (between == Between::Largest) {
            return ofCorners.maxCoeff<Eigen::PropagateNaN>();
        }
        return laid->weights(*place).dot(ofCorners);
    }

private:
    bool prints(const Eigen::Vector2f& rest) const {
        const solver::FilmGrid& grid = laid->film().grid;
        const auto pixel = [](float share, int count) {
            return std::clamp(int(std::floor((share + 0.5F) * float(count))), 0, count - 1);
        };
        return qAlpha(image.pixel(pixel(rest.x() / float(grid.width), image.width()),
                                  pixel(rest.y() / float(grid.depth), image.height()))) != 0;
    }
};

std::vector<float> paintedValues(const std::vector<FilmPointValues>& dips) {
    std::vector<float> painted;
    for (const FilmPointValues& dip : dips) {
        const std::vector<std::uint8_t>& isPainted = dip.laid->painted().points;
        for (std::size_t point = 0; point < dip.values.size(); ++point) {
            if (isPainted[point] != 0 && !std::isnan(dip.values[point])) {
                painted.push_back(dip.values[point]);
            }
        }
    }
    return painted.empty() ? std::vector<float>{1} : painted;
}

// Tells whether a painted place has no value.
bool hasGaps(const std::vector<FilmPointValues>& dips) {
    return std::ranges::any_of(dips, [](const FilmPointValues& dip) {
        const std::vector<std::uint8_t>& isPainted = dip.laid->painted().points;
        for (std::size_t point = 0; point < dip.values.size(); ++point) {
            if (isPainted[point] != 0 && std::isnan(dip.values[point])) {
                return true;
            }
        }
        return false;
    });
}

std::vector<ProofLegend::Step> legendSteps(const MapScale& scale) {
    std::vector<ProofLegend::Step> steps{{unpainted, Text::tr("bare")}};
    const int count = int(std::lround((scale.high - scale.low) / scale.step));
    for (int step = 0; step <= count; ++step) {
        const double value = scale.low + step * scale.step;
        steps.push_back({scale.colour(scale.share(value)), scale.text(value)});
    }
    if (scale.hasColourAbove) {
        steps.push_back({scale.past(), Text::tr("more")});
    }
    return steps;
}

// Returns a map of values on the part. Of two dips, the later one that paints a place counts.
Layer mapLayer(const char* key, const QString& name, const QString& explanation,
               std::vector<FilmPointValues> dips, const MapScale& scale) {
    const bool isGapped = hasGaps(dips);
    Layer map =
        layerOf(key, name, explanation, [dips = std::move(dips), scale](const SurfacePoint& place) {
            for (auto dip = dips.rbegin(); dip != dips.rend(); ++dip) {
                if (const auto value = dip->at(place)) {
                    return std::isnan(*value) ? paintedOnceColour.rgb()
                           : scale.hasColourAbove && *value > float(scale.high)
                               ? scale.past().rgb()
                               : scale.colour(scale.share(double(*value))).rgb();
                }
            }
            return unpainted.rgb();
        });
    map.layer.isMap = true;
    map.legend.steps = legendSteps(scale);
    if (isGapped) {
        map.legend.steps.push_back({paintedOnceColour, Text::tr("not compared")});
    }
    return map;
}

template <typename Values>
std::vector<FilmPointValues> valuesOf(const JobResult& result, Between between,
                                      const Values& values) {
    std::vector<FilmPointValues> dips;
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& dip = result.immersions[i];
        dips.push_back({dip.laid, dip.texture->image, values(i), between});
    }
    return dips;
}

void addMapLayers(std::vector<Layer>& layers, const JobResult& result) {
    constexpr double leastRange = 0.02; // mm
    const std::vector<FilmPointValues> stretch =
        valuesOf(result, Between::Interpolated,
                 [&](std::size_t i) { return result.immersions[i].laid->painted().pointMeans; });
    layers.push_back(mapLayer("stretch", Text::tr("Stretch"),
                              Text::tr("How many times longer the film becomes on the part"),
                              stretch, stretchScale(paintedValues(stretch))));
    if (std::ranges::all_of(result.immersions, &ImmersionResult::knownError)) {
        const std::vector<FilmPointValues> errors =
            valuesOf(result, Between::Largest,
                     [&](std::size_t i) { return result.immersions[i].knownError()->pointErrors; });
        const double limit = allowedError(Zone::C, result.project.tolerance);
        layers.push_back(
            mapLayer("error", Text::tr("Numerical error"),
                     Text::tr("How far the picture may be off by computing, in mm. Limit: %1 mm")
                         .arg(numberText(limit, 2)),
                     errors, changeScale(paintedValues(errors), limit, leastRange)));
    }
    if (result.tolerances) {
        const std::vector<FilmPointValues> spread =
            valuesOf(result, Between::Largest,
                     [&](std::size_t i) { return result.tolerances->dips[i].filmPoints; });
        const double limit = result.project.tolerance.limits.back().value();
        layers.push_back(mapLayer("tolerance", Text::tr("Tolerance"),
                                  Text::tr("How far handling may move the picture, ± mm"), spread,
                                  changeScale(paintedValues(spread), limit, leastRange)));
    }
}

// Returns the layers; they keep what they need of the result.
std::vector<Layer> layersOf(const JobResult& result) {
    const auto fine = result.fine ? result.fine : fineBody(result.project.model->mesh);
    std::vector<Layer> layers{printedLayer(result, fine, result.immersions.size())};
    if (result.immersions.size() > 1) {
        layers.push_back(printedLayer(result, fine, 1));
    }
    if (result.painted) {
        layers.push_back(wantedLayer(result));
    }
    addMapLayers(layers, result);
    return layers;
}

ProofSection partSection(const JobResult& result) {
    const Eigen::Vector3f size = boundingBox(result.project.model->mesh).sizes();
    ProofSection section{Text::tr("Part"), {}};
    section.figures = {{Text::tr("Size"),
                        Text::tr("%1 × %2 × %3 mm")
                            .arg(numberText(double(size.x()), 1), numberText(double(size.y()), 1),
                                 numberText(double(size.z()), 1))},
                       {Text::tr("Dips"), QLocale().toString(qulonglong(result.immersions.size()))},
                       {Text::tr("Painted by all dips together"), percent(result.coverageTotal)},
                       {Text::tr("Film"), result.immersions.front().sheet.job.film}};
    if (result.mask) {
        section.figures.push_back(
            {Text::tr("Masked, not painted"),
             Text::tr("%1 mm²").arg(numberText(maskedAreas(*result.mask).area, 0))});
    }
    if (result.share) {
        section.figures.push_back(
            {Text::tr("Length of the seam"),
             Text::tr("%1 mm").arg(numberText(result.share->cost.length, 0))});
    }
    return section;
}

ProofSection dipSection(const JobResult& result, std::size_t i) {
    const ImmersionResult& dip = result.immersions[i];
    const Distribution stretch = distribution(dip.laid->painted().constraints);
    ProofSection section{Text::tr("Dip %1: %2").arg(i + 1).arg(dip.immersion.name), {}};
    section.figures = {{Text::tr("Painted"), percent(dip.coverage->share)},
                       {Text::tr("Stretch: mean, 95 % below, largest"),
                        QStringLiteral("%1 · %2 · %3")
                            .arg(numberText(stretch.mean, 3), numberText(stretch.percentile95, 3),
                                 numberText(stretch.maximum, 3))}};
    const auto within = [&](const QString& name, double length) {
        section.figures.push_back({name, millimetres(length)});
    };
    if (const NumericalErrorEstimate* estimate = dip.knownError()) {
        within(Text::tr("Numerical error, 95 % within"), estimate->offBy.percentile95);
    }
    if (dip.readBack) {
        within(Text::tr("Read-back error, 95 % within"), dip.readBack->percentile95);
    }
    if (result.tolerances) {
        within(Text::tr("Tolerance of handling, 95 % within ±"),
               result.tolerances->dips[i].spread.percentile95);
    }
    section.figures.push_back({Text::tr("Trapped air"), area(dip.coverage->trappedAir.area)});
    section.figures.push_back({Text::tr("Job"), dip.sheet.job.hash});
    return section;
}

ProofSheet sheetOf(const ImmersionResult& dip) {
    return {reduced(dip.sheet, sheetPixels), dip.immersion.name,
            Text::tr("%1 × %2 mm, job %3")
                .arg(numberText(dip.sheet.filmWidth.value(), 0),
                     numberText(dip.sheet.filmHeight.value(), 0), dip.sheet.job.hash)};
}

ProofPage pageOf(const JobResult& result, const std::vector<Layer>& layers,
                 const ProofModel& model) {
    ProofPage page;
    page.title = result.project.name;
    page.date = result.project.date;
    page.verdict = Text::tr("Verdict: %1").arg(adviceText(adviceOf(result)));
    page.verdictKey = adviceKey(adviceOf(result));
    for (const JobReason& reason : reasonsOf(result)) {
        page.reasons << reasonText(reason, result, millimetres);
    }
    for (const Layer& layer : layers) {
        page.layers.push_back(layer.legend);
    }
    page.sections.push_back(partSection(result));
    QStringList jobs;
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        page.sections.push_back(dipSection(result, i));
        page.sheets.push_back(sheetOf(result.immersions[i]));
        jobs << result.immersions[i].sheet.job.hash;
    }
    page.job = combinedJobNumber(jobs);
    page.note = model.tolerance > 0
                    ? Text::tr("The surface shown here is within %1 mm of the part.")
                          .arg(numberText(std::ceil(1000 * model.tolerance) / 1000, 3))
                    : Text::tr("The surface shown here has all triangles of the part.");
    page.note += u' ' + Text::tr("Screens show colours differently; the print decides.");
    page.fallback = result.proof.scaledToWidth(fallbackPixels, Qt::SmoothTransformation);
    page.glb = model.glb;
    return page;
}

} // namespace

SharedProof sharedProof(const JobResult& result, const Progress& progress) {
    const std::vector<Layer> layers = layersOf(result);
    std::vector<ProofLayer> ofModel;
    for (const Layer& layer : layers) {
        ofModel.push_back(layer.layer);
    }
    const ProofModel model =
        proofModel(result.project.name, result.project.model->mesh, ofModel, progress);
    return {model.glb, proofHtml(pageOf(result, layers, model))};
}

} // namespace dipwright

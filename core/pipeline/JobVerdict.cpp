#include "pipeline/JobVerdict.h"

#include "accuracy/verdict/BareZones.h"
#include "artwork/EditArtwork.h"
#include "dip/TankFit.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"
#include "pipeline/FilmRefinement.h"
#include "pipeline/ModelNotes.h"
#include "pipeline/PrintedBody.h"
#include "project/Profiles.h"
#include "share/UnpaintedPlaces.h"
#include "texture/ContrastKept.h"
#include "texture/InkAppearance.h"
#include "texture/ReverseTexture.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

using Kind = VerdictReason::Kind;

constexpr double bareSamples = 20'000; // number of points on the body
// Largest share of the surface that two dips may paint twice if they do not share the body. Along
// the ends of two films that meet, less is painted twice.
constexpr double mostPaintedTwice = 0.02;
// The seam's wishes count as unmet below this share of the wanted overlap, and above this share of
// the area that marks give to a dip.
constexpr double leastWantedOverlap = 0.9;
constexpr double mostMisassigned = 0.1;
// A sheet with less ink than this, in mm² of full tint, has none: less than a dot of 0.4 mm.
constexpr double leastInk = 0.1;
// The share of its contrast that a picture should keep on the part's own colour, compared with the
// same ink on white (docs/film-validation.md, "The verdict"). A picture in black and white keeps
// the lightness L* of that colour, in per cent: 54 % on the grey #808080, 20 % on #303030.
constexpr double leastContrastKept = 0.3, contrastLost = 0.15;
constexpr double contrastSamples = 5'000; // number of points on the body

// Adds reasons for marked zones and separate bodies that are not painted. Kind::Unreached judges
// the rest. `zoned`: null if no zones are marked.
void addBarePlaces(ReasonList& found, const JobResult& result, const ZonedBody* zoned) {
    if (!zoned && !result.bodies) {
        return;
    }
    const TriangleMesh& mesh = result.project.model->mesh;
    std::vector<SurfacePoint> places = evenSamples(mesh, surfaceArea(mesh) / bareSamples);
    const PosedBody& body = *result.immersions.front().body;
    std::erase_if(places, [&](const SurfacePoint& place) {
        return (result.mask && result.mask->covers(place)) || body.isBuried(place);
    });
    std::vector<std::uint8_t> isPainted(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        for (const ImmersionResult& dip : result.immersions) {
            isPainted[i] |= dip.laid->place(places[i]).has_value();
        }
    });
    const VerdictSettings& limits = result.project.verdict;
    if (result.bodies) {
        addBareBodyReasons(found, *result.bodies, places, isPainted, limits.leastPainted);
    }
    if (zoned) {
        std::vector<Zone> zones;
        std::ranges::transform(places, std::back_inserter(zones),
                               [&](const SurfacePoint& place) { return zoned->at(place); });
        addBareZoneReasons(found, zones, isPainted, limits.zoneBare);
    }
}

void addHandlingReasons(ReasonList& found, const JobTolerances& tolerances) {
    for (const ZoneVerdict& zone : tolerances.zones) {
        if (zone.area > 0 && !zone.holds()) {
            found.add({Kind::ZoneExceeded,
                       Advice::CheckFirst,
                       zone.together,
                       zone.limit,
                       {},
                       0,
                       zone.zone});
        }
    }
}

double unreached(const JobResult& result) {
    return result.share && !result.mask ? result.share->areas.none / result.share->areas.total()
                                        : 1 - result.coverageTotal;
}

// Returns the share of the surface that both of two dips paint, if the sheets come from the model.
double paintedTwice(const JobResult& result) {
    const auto isReversed = [](const ImmersionResult& dip) {
        return dip.inputs.texture.isReversed();
    };
    if (!std::all_of(result.immersions.begin(), result.immersions.end(), isReversed)) {
        return 0;
    }
    return result.immersions[0].coverage->share + result.immersions[1].coverage->share -
           result.coverageTotal;
}

// Adds a reason if little of the picture can be seen on the part's own colour.
void addContrastReason(ReasonList& found, const JobResult& result) {
    if (result.project.baseColour.isEmpty()) {
        return;
    }
    const TriangleMesh& mesh = result.project.model->mesh;
    const SheetInputs& inputs = result.immersions.front().inputs;
    const InkSettings ink = inputs.texture.printedInk();
    const bool hasWhite =
        std::all_of(result.immersions.begin(), result.immersions.end(),
                    [](const ImmersionResult& dip) { return dip.lostPlates.isEmpty(); });
    const PaintedBody onPart(filmAppearances(result.immersions, hasWhite), ink,
                             groundOf(inputs.settings, result.project.baseColour));
    const PaintedBody onWhite(filmAppearances(result.immersions, false), ink);
    const std::vector<SurfacePoint> places = evenSamples(mesh, surfaceArea(mesh) / contrastSamples);
    std::vector<std::optional<std::array<float, 2>>> lightness(places.size());
    parallelFor(std::size_t(0), places.size(), [&](std::size_t i) {
        if (onPart.marks(places[i])) {
            lightness[i] = {labOf(onWhite.colour(places[i]))[0],
                            labOf(onPart.colour(places[i]))[0]};
        }
    });
    ContrastKept contrast;
    int count = 0;
    for (const auto& pair : lightness) {
        if (pair) {
            contrast.add(double((*pair)[0]), double((*pair)[1]));
            ++count;
        }
    }
    if (std::isnan(contrast.share())) { // the picture is plain: it stands out from the bare part
        constexpr double white = 100;
        const QColor bare(result.project.baseColour);
        contrast.add(white, double(labOf(linearColour(bare))[0]), count);
    }
    const double share = contrast.share();
    if (share < leastContrastKept) {
        found.add({Kind::FaintPicture,
                   share < contrastLost ? Advice::DoNotPrint : Advice::CheckFirst, share,
                   leastContrastKept});
    }
}

// Tells whether the model shows only one colour.
bool isPlain(const Project& project) {
    const std::vector<Material>& materials = project.model->materials;
    return project.artwork.isEmpty() && project.model->textures.empty() &&
           std::all_of(materials.begin(), materials.end(), [&](const Material& material) {
               return material.colour == materials.front().colour;
           });
}

// Tells whether a sheet that should show a picture takes ink. A plain model may be white;
// Kind::NoPicture judges it.
bool takesInk(const ImmersionResult& dip, const Project& project) {
    const double ink =
        std::accumulate(dip.inks.begin(), dip.inks.end(), 0.0,
                        [](double sum, const InkArea& one) { return sum + one.area; });
    return ink >= leastInk || dip.inks.empty() || // drafts do not measure their ink
           (dip.inputs.texture.isReversed() && isPlain(project));
}

// Adds reasons about where the job comes from: no picture, a changed model, a film that was never
// measured. They either hold or not; the settings say which advice each gives.
void addOriginReasons(ReasonList& found, const JobResult& result) {
    const Project& project = result.project;
    const bool isReversed = result.immersions.front().inputs.texture.isReversed();
    if (isReversed && isPlain(project)) {
        found.add({Kind::NoPicture, project.verdict.noPicture});
    }
    if (isReversed && !inkSpaceOf(*project.model).isEmpty() &&
        !project.artwork.inColours().isEmpty()) {
        found.add({Kind::HiddenInks, Advice::Print});
    }
    if (!project.modelOrigin.remarks.isEmpty()) {
        found.add(
            {Kind::ChangedModel, project.verdict.changedModel, 0, 0, project.modelOrigin.remarks});
    }
    if (!result.thinParts.isEmpty()) {
        found.add({Kind::ThinPlaces, Advice::CheckFirst, 0, 0, result.thinParts});
    }
    if (!project.modelOrigin.losses.isEmpty()) {
        found.add({Kind::IncompleteModel, project.verdict.incompleteModel, 0, 0,
                   project.modelOrigin.losses});
    }
    if (!hasMeasuredSwell(project.film, project.profiles)) {
        found.add({Kind::GuessedFilm, project.verdict.guessedFilm});
    }
    if (const QString expiry = expiryWarning(project.profiles.film); !expiry.isEmpty()) {
        found.add({Kind::ExpiredFilm, project.verdict.expiredFilm, 0, 0, expiry});
    }
    const PosedBody& body = *result.immersions.front().body;
    for (const QString& note : misplacedNotes(project, body.query, body.modelToPose)) {
        found.add({Kind::Misplaced, Advice::CheckFirst, 0, 0, note});
    }
    for (const QString& note : missingMaterialNotes(project)) {
        found.add({Kind::UnknownName, Advice::CheckFirst, 0, 0, note});
    }
    for (const QString& note : fontWarnings(project.artwork)) {
        found.add({Kind::UnknownName, Advice::CheckFirst, 0, 0, note});
    }
}

// Adds reasons for settings that do not occur in practice.
void addUnusualReasons(ReasonList& found, const JobResult& result) {
    const Project& project = result.project;
    const auto addSpeed = [&](Kind kind, double speed, const QString& dip) {
        const double usual = std::clamp(speed, leastUsualSpeed, mostUsualSpeed);
        if (speed != usual) {
            found.add({kind, Advice::CheckFirst, speed, usual, dip});
        }
    };
    addSpeed(Kind::UnusualSpeed, project.process.dipSpeed.value(), {});
    for (const Immersion& dip : project.immersions) {
        if (dip.path.isSlowed()) {
            addSpeed(Kind::UnusualSlowSpeed, dip.path.slowSpeed->value(), dip.name);
        }
    }
    for (const ImmersionResult& dip : result.immersions) {
        if (dip.immersion.path.kind == PathKind::Poses) {
            const auto [mean, most] = speedOnPath(dip.body->path);
            addSpeed(Kind::UnusualPathSpeed, most > mostUsualSpeed ? most : mean,
                     dip.immersion.name);
        }
    }
    const FilmSettings& film = project.film;
    for (const double swell : {film.swellX, film.swellY}) {
        const double usualSwell = std::clamp(swell, leastUsualSwell, mostUsualSwell);
        if (swell != usualSwell) {
            found.add({Kind::UnusualSwell, Advice::CheckFirst, swell, usualSwell});
            break;
        }
    }
    if (!grows(film)) {
        return;
    }
    if (film.growthRate > mostUsualGrowthRate) {
        found.add(
            {Kind::UnusualGrowthRate, Advice::CheckFirst, film.growthRate, mostUsualGrowthRate});
    }
    if (film.growthLimit > mostUsualGrowth) {
        found.add({Kind::UnusualGrowth, Advice::CheckFirst, film.growthLimit, mostUsualGrowth});
    }
}

// Adds reasons for a seam that does not turn out as wanted.
void addSeamReasons(ReasonList& found, const BodyShare& share, const Project& project) {
    found.addShare(Kind::Narrow, share.narrow, project.verdict.narrow);
    const double wanted = project.share.overlap.value();
    if (share.cost.length > 0 && share.overlap.middle < leastWantedOverlap * wanted) {
        found.add({Kind::NarrowSeam, Advice::Print, share.overlap.middle, wanted});
    }
    if (share.misassigned > mostMisassigned) {
        found.add({Kind::Misassigned, Advice::Print, share.misassigned});
    }
}

// Adds reasons for how much of the body is painted: too little, or twice.
void addAmountReasons(ReasonList& found, const JobResult& result) {
    const VerdictSettings& limits = result.project.verdict;
    const std::vector<ImmersionResult>& dips = result.immersions;
    const double share = dips.front().coverage->share;
    if (result.project.immersions.size() == 1 && share > 0 && share < limits.leastPainted) {
        found.add({Kind::LittlePainted, Advice::CheckFirst, share, limits.leastPainted});
    }
    if (dips.size() < 2) {
        return;
    }
    found.addShare(Kind::Unreached, unreached(result), limits.unreached);
    if (result.share) {
        addSeamReasons(found, *result.share, result.project);
    } else if (const double twice = paintedTwice(result); twice > mostPaintedTwice) {
        found.add({Kind::PaintedTwice, Advice::CheckFirst, twice, mostPaintedTwice});
    }
}

} // namespace

Verdict dipVerdict(const ImmersionResult& dip, const Project& project,
                   const JudgedSurface& surface) {
    return verdict({*dip.laid, *dip.coverage, dip.numericalError.get(),
                    dip.inkShortfall.value_or(dip.texture->shortfallArea), surface,
                    tankFaults(project.profiles.tank, project.film, project.process, dip.immersion,
                               dip.body->mesh, dip.body->path),
                    project.immersions.size() == 1, takesInk(dip, project),
                    dip.lostPlates.join(QStringLiteral(". ")), dip.inputs.built,
                    dip.unusualCorrection, dip.coveredPicture},
                   project.tolerance, project.verdict);
}

Verdict allDipsVerdict(const JobResult& result, const ZonedBody* zones) {
    ReasonList found;
    addAmountReasons(found, result);
    addBarePlaces(found, result, zones);
    if (result.tolerances) {
        addHandlingReasons(found, *result.tolerances);
    }
    addContrastReason(found, result);
    addOriginReasons(found, result);
    addUnusualReasons(found, result);
    return std::move(found).verdict();
}

std::vector<UnpaintedPlace> unreachedPlaces(const JobResult& result) {
    if (!result.share) {
        return {};
    }
    return result.mask
               ? unpaintedPlaces(*result.share, *result.immersions.front().body, result.mask.get())
               : result.share->unpainted;
}

Advice adviceOf(const JobResult& result) {
    Advice advice = result.verdict.advice;
    for (const ImmersionResult& dip : result.immersions) {
        advice = worst(advice, dip.verdict.advice);
    }
    return advice;
}

std::vector<JobReason> reasonsOf(const JobResult& result) {
    std::vector<JobReason> all;
    for (std::size_t number = 0; number < result.immersions.size(); ++number) {
        for (const VerdictReason& reason : result.immersions[number].verdict.reasons) {
            all.push_back({number, reason});
        }
    }
    for (const VerdictReason& reason : result.verdict.reasons) {
        all.push_back({std::nullopt, reason});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return a.reason.advice > b.reason.advice;
    });
    return all;
}

QString reasonText(const JobReason& reason, const JobResult& result, const LengthText& length) {
    const QString text = reasonText(reason.reason, length);
    return reason.dip ? Text::tr("%1: %2").arg(result.immersions[*reason.dip].immersion.name, text)
                      : text;
}

QStringList warningLines(const JobResult& result, const LengthText& length) {
    QStringList lines{adviceText(adviceOf(result))};
    for (const JobReason& reason : reasonsOf(result)) {
        if (reason.reason.advice != Advice::Print) {
            lines << QStringLiteral("• ") + reasonText(reason, result, length);
        }
    }
    const QStringList remarks = refinementRemarks(result);
    for (const QString& note : result.notes) {
        if (!remarks.contains(note)) {
            lines << QStringLiteral("• ") + note;
        }
    }
    return lines;
}

} // namespace dipwright

#include "accuracy/verdict/Verdict.h"

#include "accuracy/verdict/PlacesToCheck.h"
#include "dip/BodyPath.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

using Kind = VerdictReason::Kind;

const std::vector<float> nothingKnown;

// Returns the reason for a zone whose numerical error is too large. It says whether the steps or
// the cells cause the error. For cells, it proposes the size that would suffice if the error
// shrinks in proportion to the cells.
VerdictReason numericalErrorReason(const ZoneError& error, const NumericalErrorEstimate& estimate,
                                   const solver::FilmGrid& grid) {
    const double allowed = numericalShare * error.limit;
    VerdictReason reason{Kind::OffBy,
                         error.far > 1 - zoneShareWithin ? Advice::DoNotPrint : Advice::CheckFirst,
                         error.percentile95, allowed};
    const double finer = allowed / error.percentile95;
    // Shorter steps do not reduce the least error.
    const bool canStepsSuffice = leastErrorCells * grid.leastSpacing() < allowed;
    if (canStepsSuffice &&
        estimate.halfStep().distance.percentile95 > estimate.halfSpacing().distance.percentile95) {
        reason.kind = Kind::Step;
    } else if (finer < finestCellNamed) {
        reason.kind = Kind::OffByMuch;
    } else if (!grid.columnPlaces.empty()) {
        reason.most = grid.leastSpacing() * std::min(finer, largestCellNamed);
    }
    return reason;
}

// Returns the reasons that follow from the numerical error in a zone.
std::vector<VerdictReason> zoneReasons(const ZoneError& error,
                                       const NumericalErrorEstimate& estimate,
                                       const solver::FilmGrid& grid, bool namesZone) {
    ReasonList found;
    if (error.percentile95 > numericalShare * error.limit) {
        found.add(numericalErrorReason(error, estimate, grid));
    }
    found.addShare(Kind::UnknownError, error.unknown, mostUnknownArea);
    if (error.percentile95 <= error.limit && error.far > mostFarOffArea) {
        found.add({Kind::FarOffPlaces,
                   error.far > doNotPrintFactor * mostFarOffArea ? Advice::DoNotPrint
                                                                 : Advice::CheckFirst,
                   error.far, error.limit});
    }
    std::vector<VerdictReason> reasons = found.reasons();
    for (VerdictReason& reason : reasons) {
        reason.zone = namesZone ? std::optional(error.zone) : std::nullopt;
        reason.body = error.body;
    }
    return reasons;
}

// Returns for each separate body in the zone its worst reason, if that is worse than `known`.
std::vector<VerdictReason> bodyReasons(const std::vector<ZoneError>& bodies, Zone zone,
                                       Advice known, const NumericalErrorEstimate& estimate,
                                       const solver::FilmGrid& grid, bool namesZone) {
    std::vector<VerdictReason> worse;
    for (const ZoneError& body : bodies) {
        if (body.zone != zone) {
            continue;
        }
        const std::vector<VerdictReason> own = zoneReasons(body, estimate, grid, namesZone);
        const auto worst = std::ranges::max_element(own, {}, &VerdictReason::advice);
        if (worst != own.end() && worst->advice > known) {
            worse.push_back(*worst);
        }
    }
    return worse;
}

void addEstimateReasons(ReasonList& found, const NumericalErrorEstimate& estimate,
                        const PlacesToCheck& checked, const solver::FilmGrid& grid,
                        bool namesZones) {
    const std::vector<ZoneError>& zones = checked.zones;
    if (!estimate.isKnown() || zones.empty()) {
        found.add({Kind::NothingAlike, Advice::DoNotPrint});
        return;
    }
    for (const ZoneError& zone : zones) {
        Advice advice = Advice::Print;
        for (VerdictReason& reason : zoneReasons(zone, estimate, grid, namesZones)) {
            advice = worst(advice, reason.advice);
            found.add(std::move(reason));
        }
        // A small body hardly changes the figures of all bodies together.
        found.addOfBodies(
            bodyReasons(checked.zonesOfBodies, zone.zone, advice, estimate, grid, namesZones));
    }
    // The border moves by about one film cell, and the compared films have double cells.
    const double once = halfSpacingShare * std::max(estimate.doubleSpacing.paintedOnce,
                                                    estimate.doubleStep.paintedOnce);
    if (once > mostPaintedOnce) {
        found.add({Kind::Border, once > spoiltPaintedOnce ? Advice::DoNotPrint : Advice::CheckFirst,
                   once, mostPaintedOnce});
    }
    if (found.isEmpty()) {
        const double worst = std::max_element(zones.begin(), zones.end(), [](auto& a, auto& b) {
                                 return a.percentile95 < b.percentile95;
                             })->percentile95;
        found.add({Kind::Certain, Advice::Print, worst});
    }
}

void addBalanceReason(ReasonList& found, const LaidFilm& laid) {
    const solver::EquilibriumAccount& rest = laid.film().equilibrium;
    if (rest.stepsWithout > 0) {
        found.add({Kind::Unbalanced,
                   Advice::CheckFirst,
                   double(rest.stepsWithout),
                   0,
                   {},
                   rest.worstForceLeft});
    }
}

// Adds the reasons about the numerical error. Returns the places to check.
PlacesToCheck addNumericalReasons(ReasonList& found, const LaidFilm& laid,
                                  const NumericalErrorEstimate* estimate,
                                  const JudgedSurface& surface,
                                  const ToleranceSettings& tolerance) {
    PlacesToCheck uncertain =
        placesToCheck(laid, estimate ? estimate->pointErrors : nothingKnown, surface, tolerance);
    if (!estimate) {
        found.add({Kind::NotAsked, Advice::NotJudged});
    } else if (!estimate->failure.isEmpty()) {
        found.add({Kind::NotCompared, Advice::CheckFirst, 0, 0, estimate->failure});
    } else {
        addEstimateReasons(found, *estimate, uncertain, laid.film().grid, surface.zones != nullptr);
    }
    return uncertain;
}

// Returns the distance of the painted film from the edge of the flat film, in mm.
double edgeDistance(const LaidFilm& laid) {
    const Eigen::AlignedBox2f used = usedFilm(laid);
    const solver::FilmGrid& grid = laid.film().grid;
    const Eigen::Vector2f half(float(grid.width) / 2, float(grid.depth) / 2);
    const float least = std::min((used.min() + half).minCoeff(), (half - used.max()).minCoeff());
    return std::max(double(least), 0.0);
}

// Adds a reason that a sentence explains; none if it is empty.
void addSentence(ReasonList& found, Kind kind, const QString& sentence) {
    if (!sentence.isEmpty()) {
        found.add({kind, Advice::CheckFirst, 0, 0, sentence});
    }
}

void addPaintReasons(ReasonList& found, const JudgedDip& dip, const VerdictSettings& limits) {
    const double painted = dip.coverage.paintedArea;
    if (painted <= 0) {
        const bool isMasked = dip.surface.mask && coverage(dip.laid).paintedArea > 0;
        found.add({isMasked ? Kind::AllMasked : Kind::Unpainted, Advice::DoNotPrint});
        return;
    }
    if (!dip.takesInk) {
        found.add({Kind::NoInk, Advice::DoNotPrint});
    }
    addSentence(found, Kind::LostPlates, dip.lostPlates);
    const MarkedArea& marked = dip.coverage.marked;
    found.addShare(Kind::Air, dip.coverage.trappedAir.area / dip.coverage.unburied, limits.air, {},
                   seenVentCells * double(dip.laid.body().air.cell()));
    found.addShare(Kind::Pale, dip.paleArea / painted, limits.pale);
    found.addShare(Kind::Damaged,
                   (marked.of(solver::PointMark::Torn) + marked.of(solver::PointMark::LetGo)) /
                       painted,
                   limits.damaged);
    if (dip.isOnlyDip) {
        found.addTornBare(dip.coverage.tornBareShare());
    }
    if (const auto rises = riseReason(dip.laid.body().path, dip.laid.body().mesh)) {
        found.add(*rises);
    }
    const double edge = edgeDistance(dip.laid);
    if (edge < limits.edge.value()) {
        found.add({Kind::FilmEdge, edgeIsOnBody(dip.laid) ? Advice::DoNotPrint : Advice::CheckFirst,
                   edge, limits.edge.value()});
    }
}

// Adds reasons if measured parts do not or may not belong to this dip.
void addBuiltReasons(ReasonList& found, const BuiltPartCounts& built) {
    const int used = built.alike + built.unknown;
    if (built.otherwise > 0) {
        found.add({Kind::OtherDips, used > 0 ? Advice::Print : Advice::CheckFirst,
                   double(built.otherwise), double(built.otherwise + used)});
    }
    if (built.unknown > 0) {
        found.add({Kind::UnknownDips, Advice::CheckFirst});
    }
}

} // namespace

void ReasonList::add(VerdictReason reason) {
    reasons_.push_back(std::move(reason));
}

void ReasonList::addOfBodies(std::vector<VerdictReason> reasons) {
    std::ranges::stable_sort(reasons, std::greater(), &VerdictReason::advice);
    if (reasons.size() > mostNamedBodies) {
        reasons[mostNamedBodies].body =
            Text::tr("%1 more bodies").arg(reasons.size() - mostNamedBodies);
        reasons.resize(mostNamedBodies + 1);
    }
    std::ranges::move(reasons, std::back_inserter(reasons_));
}

void ReasonList::addShare(Kind kind, double share, double limit, std::optional<Zone> zone,
                          double most) {
    if (share > limit) {
        add({kind,
             share > doNotPrintFactor * limit ? Advice::DoNotPrint : Advice::CheckFirst,
             share,
             limit,
             {},
             most,
             zone});
    }
}

void ReasonList::addTornBare(double share) {
    if (share > mostTornBare) {
        add({Kind::TornBare, share > spoiltTornBare ? Advice::DoNotPrint : Advice::CheckFirst,
             share, mostTornBare});
    }
}

Verdict ReasonList::verdict(bool isOnlyDip) && {
    std::stable_sort(reasons_.begin(), reasons_.end(),
                     [](const auto& a, const auto& b) { return a.advice > b.advice; });
    Verdict verdict{Advice::Print, std::move(reasons_), {}, 0};
    for (VerdictReason& reason : verdict.reasons) {
        verdict.advice = worst(verdict.advice, reason.advice);
        reason.isOnlyDip = isOnlyDip;
    }
    return verdict;
}

Advice worst(Advice one, Advice other) {
    const Advice worse = std::max(one, other);
    return worse > Advice::Print ? worse : std::min(one, other);
}

Verdict verdict(const JudgedDip& dip, const ToleranceSettings& tolerance,
                const VerdictSettings& limits) {
    ReasonList found;
    addBalanceReason(found, dip.laid);
    PlacesToCheck uncertain;
    if (dip.coverage.paintedArea > 0) {
        uncertain =
            addNumericalReasons(found, dip.laid, dip.numericalError, dip.surface, tolerance);
    }
    addPaintReasons(found, dip, limits);
    addBuiltReasons(found, dip.built);
    addSentence(found, Kind::CoveredPicture, dip.coveredPicture);
    addSentence(found, Kind::UnusualCorrection, dip.unusualCorrection);
    for (const TankFault& fault : dip.tankFaults) {
        found.add({Kind::Tank, Advice::DoNotPrint, fault.value, fault.limit, fault.sentence});
    }
    Verdict judged = std::move(found).verdict(dip.isOnlyDip);
    judged.places = uncertain.places;
    judged.areaToCheck = uncertain.area;
    return judged;
}

std::optional<VerdictReason> riseReason(const solver::BodyPath& path, const TriangleMesh& posed) {
    const double rise = riseOnPath(path, posed);
    return rise > mostRise
               ? std::optional(VerdictReason{Kind::Rises, Advice::CheckFirst, rise, mostRise})
               : std::nullopt;
}

Verdict numericalVerdict(const LaidFilm& laid, const NumericalErrorEstimate* estimate,
                         const JudgedSurface& surface, const ToleranceSettings& tolerance) {
    ReasonList found;
    addBalanceReason(found, laid);
    addNumericalReasons(found, laid, estimate, surface, tolerance);
    return std::move(found).verdict();
}

QString adviceKey(Advice advice) {
    switch (advice) {
    case Advice::NotJudged:
        return QStringLiteral("not_judged");
    case Advice::Print:
        return QStringLiteral("print");
    case Advice::CheckFirst:
        return QStringLiteral("look_first");
    case Advice::DoNotPrint:
        return QStringLiteral("do_not_print");
    }
    return {};
}

namespace {

struct KindWords {
    const char* key;
    const char* limit; // the project's field that holds the limit
};

// In the order of VerdictReason::Kind.
constexpr std::array kindWords{KindWords{"not_asked", ""},
                               KindWords{"not_compared", ""},
                               KindWords{"unpainted", ""},
                               KindWords{"all_masked", ""},
                               KindWords{"nothing_alike", ""},
                               KindWords{"certain", "tolerance.limits_mm"},
                               KindWords{"off_by", "tolerance.limits_mm"},
                               KindWords{"off_by_much", "tolerance.limits_mm"},
                               KindWords{"step", "process.contact_travel_cells"},
                               KindWords{"far_off_places", "tolerance.limits_mm"},
                               KindWords{"unknown_error", ""},
                               KindWords{"border", ""},
                               KindWords{"unbalanced", ""},
                               KindWords{"refined", "film.work_million"},
                               KindWords{"air", "verdict.air"},
                               KindWords{"pale", "verdict.pale"},
                               KindWords{"damaged", "verdict.damaged"},
                               KindWords{"torn_bare", ""},
                               KindWords{"film_edge", "verdict.edge_mm"},
                               KindWords{"rises", ""},
                               KindWords{"tank", ""},
                               KindWords{"no_ink", ""},
                               KindWords{"lost_plates", ""},
                               KindWords{"covered_picture", ""},
                               KindWords{"other_dips", "as_built.correct"},
                               KindWords{"unusual_correction", "as_built.correct"},
                               KindWords{"unknown_dips", "as_built.correct"},
                               KindWords{"unreached", "verdict.unreached"},
                               KindWords{"narrow", "verdict.narrow"},
                               KindWords{"narrow_seam", "share.overlap_mm"},
                               KindWords{"misassigned", "share.marks"},
                               KindWords{"zone_bare", "verdict.zone_bare"},
                               KindWords{"body_bare", "verdict.least_painted"},
                               KindWords{"zone_exceeded", "tolerance.limits_mm"},
                               KindWords{"no_picture", "verdict.no_picture"},
                               KindWords{"hidden_inks", ""},
                               KindWords{"changed_model", "verdict.changed_model"},
                               KindWords{"guessed_film", "verdict.guessed_film"},
                               KindWords{"expired_film", "verdict.expired_film"},
                               KindWords{"unknown_name", ""},
                               KindWords{"misplaced", ""},
                               KindWords{"incomplete_model", "verdict.incomplete_model"},
                               KindWords{"painted_twice", "share.enabled"},
                               KindWords{"little_painted", "verdict.least_painted"},
                               KindWords{"faint_picture", ""},
                               KindWords{"thin_places", "body.sdf_resolution"},
                               KindWords{"unusual_speed", "process.dip_speed_mm_s"},
                               KindWords{"unusual_slow_speed", ""}, // each dip has its own field
                               KindWords{"unusual_path_speed", ""},
                               KindWords{"unusual_growth_rate", "film.growth_per_s"},
                               KindWords{"unusual_growth", "film.growth_limit"},
                               KindWords{"unusual_swell", "film.swell"}};
static_assert(kindWords.size() == std::size_t(Kind::UnusualSwell) + 1);

} // namespace

QString reasonKey(Kind kind) {
    return QString::fromLatin1(kindWords[std::size_t(kind)].key);
}

QString limitField(Kind kind) {
    return QString::fromLatin1(kindWords[std::size_t(kind)].limit);
}

} // namespace dipwright

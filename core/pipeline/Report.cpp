#include "pipeline/Report.h"

#include "accuracy/correction/RepeatingError.h"
#include "cost/CostText.h"
#include "pipeline/JobCost.h"
#include "pipeline/SheetNumericalError.h"
#include "project/DipKeys.h"
#include "project/Profiles.h"

#include "pipeline/InkOptions.h"
#include "pipeline/JobTolerances.h"
#include "pipeline/JobVerdict.h"
#include "pipeline/JobWarnings.h"
#include "pipeline/SmallerFilm.h"
#include "texture/ReverseTexture.h"
#include "traveller/TankTasks.h"

#include <QJsonArray>
#include <cmath>

namespace dipwright {
namespace {

QJsonObject toJson(const Distribution& distribution) {
    return {{"min", distribution.minimum},
            {"mean", distribution.mean},
            {"p95", distribution.percentile95},
            {"max", distribution.maximum}};
}

QJsonObject toJson(const ReadBackError& error) {
    return {{"mean", error.mean},
            {"p95", error.percentile95},
            {"max", error.maximum},
            {"samples", qint64(error.samples)}};
}

QJsonObject toJson(const PlaceToCheck& place) {
    return {{"film_mm", QJsonArray{place.rest.x(), place.rest.y()}},
            {"model_mm", QJsonArray{place.place.x(), place.place.y(), place.place.z()}},
            {"area_mm2", place.area},
            {"limit_mm", place.limit},
            {"off_by_mm", place.offBy}};
}

QJsonArray sentencesOf(const Verdict& verdict) {
    QJsonArray sentences;
    for (const VerdictReason& reason : verdict.reasons) {
        sentences.append(reasonText(reason, millimetres));
    }
    return sentences;
}

// Returns the reasons of the whole job, the worst first.
QJsonArray reasonsJson(const JobResult& result) {
    QJsonArray json;
    for (const JobReason& reason : reasonsOf(result)) {
        const VerdictReason& why = reason.reason;
        QJsonObject one{{"kind", reasonKey(why.kind)},
                        {"verdict", adviceKey(why.advice)},
                        {"sentence", reasonText(reason, result, millimetres)},
                        {"dip", reason.dip ? QJsonValue(qint64(*reason.dip) + 1) : QJsonValue()},
                        {"value", why.value},
                        {"limit", why.limit}};
        if (const QString field = limitField(why.kind); !field.isEmpty()) {
            one["field"] = field;
        }
        if (why.zone) {
            one["zone"] = zoneName(*why.zone);
        }
        if (!why.body.isEmpty()) {
            one["body"] = why.body;
        }
        json.append(one);
    }
    return json;
}

// Returns all plates in addition to the four process inks, in the order of printing.
QJsonArray spotsJson(const ImmersionResult& result) {
    QJsonArray spots;
    for (const SheetPlate& plate : result.sheet.plates) {
        spots.append(
            QJsonObject{{"name", plate.name},
                        {"printed", plate.first ? "first" : "last"},
                        {"colour", plate.alternate.isValid() ? QJsonValue(plate.alternate.name())
                                                             : QJsonValue()}});
    }
    return spots;
}

QJsonArray inksJson(const std::vector<InkArea>& inks) {
    QJsonArray json;
    for (const InkArea& ink : inks) {
        json.append(QJsonObject{{"ink", ink.ink}, {"full_tint_mm2", ink.area}});
    }
    return json;
}

QJsonArray costsJson(const JobResult& result, const Project& project) {
    QJsonArray json;
    for (const OrderCost& cost : jobCosts(result, project)) {
        json.append(costJson(cost));
    }
    return json;
}

QJsonObject inkJson(const ImmersionResult& result) {
    QJsonObject json{{"shortfall_area", result.texture->shortfallArea},
                     {"inks", inksJson(result.inks)},
                     {"inks_estimated", areEstimated(result.inks)}};
    if (result.inkShortfall) {
        json["per_ink_shortfall_area"] = *result.inkShortfall;
    }
    return json;
}

QJsonObject numericalErrorJson(const ImmersionResult& result) {
    const Verdict& verdict = result.verdict;
    QJsonArray places;
    for (const PlaceToCheck& place : verdict.places) {
        places.append(toJson(place));
    }
    QJsonObject json{{"verdict", adviceKey(verdict.advice)},
                     {"reasons", sentencesOf(verdict)},
                     {"places", places},
                     {"uncertain_area_mm2", verdict.areaToCheck}};
    if (const NumericalErrorEstimate* estimate = result.knownError()) {
        json["off_by_mm"] = toJson(estimate->offBy);
        json["double_step"] = toJson(estimate->doubleStep);
        json["double_spacing"] = toJson(estimate->doubleSpacing);
    }
    return json;
}

QJsonObject markedJson(const Coverage& coverage) {
    const MarkedArea& marked = coverage.marked;
    const double painted = coverage.paintedArea;
    return {{"area_mm2", marked.any},
            {"share", painted > 0 ? marked.any / painted : 0},
            {"torn_mm2", marked.of(solver::PointMark::Torn)},
            {"unbalanced_mm2", marked.of(solver::PointMark::Unbalanced)},
            {"let_go_mm2", marked.of(solver::PointMark::LetGo)}};
}

QJsonArray lawsJson(const std::vector<LawChange>& laws) {
    QJsonArray json;
    for (const LawChange& law : laws) {
        json.append(QJsonObject{{"setting", law.setting},
                                {"value", law.value},
                                {"less", law.less},
                                {"more", law.more},
                                {"mean_mm", law.distance.mean},
                                {"p95_mm", law.distance.percentile95},
                                {"max_mm", law.distance.maximum},
                                {"moved", law.moved},
                                {"lost", law.lost},
                                {"sentence", lawText(law, millimetres)}});
    }
    return json;
}

QJsonObject toJson(const SeamCost& cost) {
    return {{"length_mm", cost.length}, {"cost_mm", cost.cost}};
}

QJsonArray placeJson(const Eigen::Vector3f& place) {
    return {place.x(), place.y(), place.z()};
}

QJsonObject shareJson(const JobResult& result) {
    const BodyShare& share = *result.share;
    QJsonArray unpainted;
    for (const UnpaintedPlace& place : unreachedPlaces(result)) {
        unpainted.append(
            QJsonObject{{"area_mm2", place.area}, {"model_mm", placeJson(place.place)}});
    }
    return {{"join_stretch", QJsonArray{share.seamStretch[0], share.seamStretch[1]}},
            {"overlap_mm", share.overlap.middle},
            {"overlap_least_mm", share.overlap.least},
            {"overlap_most_mm", share.overlap.most},
            {"overlap_too_narrow", share.narrow},
            {"misassigned", share.misassigned},
            {"first_mm2", share.areas.first},
            {"second_mm2", share.areas.second},
            {"both_mm2", share.areas.both},
            {"none_mm2", share.areas.none},
            {"join", toJson(share.cost)},
            {"equator", toJson(share.equator)},
            {"unpainted", unpainted}};
}

QJsonObject filmJson(const DippedFilm& film) {
    return {{"columns", film.grid.columns},
            {"rows", film.grid.rows},
            {"cell_mm", film.grid.leastSpacing()},
            {"points", qint64(film.grid.pointCount())},
            {"constraints", qint64(constraintCount(film.grid, film.isotropic))}};
}

QJsonObject immersionJson(const ImmersionResult& result) {
    const DippedFilm& film = result.laid->film();
    const FilmContact& contact = result.laid->contact();
    const PaintedStretch& painted = result.laid->painted();
    const Wrinkling& wrinkling = painted.wrinkling;
    qint64 adhered = 0;
    for (std::size_t point = 0; point < film.states.size(); ++point) {
        adhered += film.adhered(point) ? 1 : 0;
    }
    const double seconds = film.wallSeconds;
    QJsonObject json{
        {"name", result.immersion.name},
        {"film", filmJson(film)},
        {"steps", qint64(film.steps)},
        {"wall_seconds", seconds},
        {"steps_per_second", seconds > 0 ? double(film.steps) / seconds : 0},
        {"equilibrium",
         QJsonObject{{"steps_without", qint64(film.equilibrium.stepsWithout)},
                     {"worst_force_left", film.equilibrium.worstForceLeft},
                     {"linear_iterations", qint64(film.equilibrium.linearIterations)}}},
        {"adhered", adhered},
        {"coverage", result.coverage->share},
        {"painted_area_mm2", result.coverage->paintedArea},
        {"trapped_air_area_mm2", result.coverage->trappedAir.area},
        {"stretch", toJson(distribution(painted.constraints))},
        {"area_stretch", toJson(distribution(painted.areas))},
        {"wrinkling", QJsonObject{{"film_area_mm2", wrinkling.area},
                                  {"share", wrinkling.share},
                                  {"least", wrinkling.least}}},
        {"texture", QJsonObject{{"contact", qint64(contact.contactCount)},
                                {"filled", qint64(contact.filledCount)},
                                {"seam_triangles", qint64(result.texture->seamTriangles)}}},
        {"certainty", numericalErrorJson(result)},
        {"marked", markedJson(*result.coverage)},
        {"marked_area_mm2", result.coverage->marked.any}, // as in earlier versions
        {"torn_bare_area_mm2", result.coverage->tornBare},
        {"read_back_mm", toJson(*result.readBack)},
        {"registration_mm",
         toJson(*result.readBack)}, // name of the read-back error in earlier versions
        {"ink", inkJson(result)},
        {"job", result.sheet.job.hash}};
    if (!result.immersion.path.isStraightDown()) {
        json.insert(QStringLiteral("path"), pathToJson(result.immersion));
    }
    if (const QJsonArray spots = spotsJson(result); !spots.isEmpty()) {
        json["spots"] = spots;
    }
    const SheetSettings& sheet = result.sheet.settings;
    if (sheet.white != WhiteLayer::None) {
        json["white"] =
            QJsonObject{{"printed", sheet.white == WhiteLayer::First ? "first" : "last"},
                        {"name", sheet.whiteName},
                        {"density", sheet.whiteDensity},
                        {"choke_mm", sheet.whiteChoke.value()}};
    }
    if (!result.laws.empty()) {
        json["laws"] = lawsJson(result.laws);
    }
    return json;
}

QJsonObject toJson(const Spread& spread) {
    return {{"p50", spread.median}, {"p95", spread.percentile95}, {"max", spread.maximum}};
}

QJsonObject toJson(const WorstPlace& worst) {
    return {{"model_mm", QJsonArray{worst.place.x(), worst.place.y(), worst.place.z()}},
            {"spread_mm", worst.spread},
            {"contributor", contributorKey(worst.contributor)}};
}

QJsonObject tolerancesJson(const DipTolerances& tolerances) {
    QJsonArray contributions, worst;
    for (const Contribution& contribution : tolerances.contributions) {
        contributions.append(QJsonObject{{"contributor", contributorKey(contribution.contributor)},
                                         {"tolerance", contribution.tolerance},
                                         {"unit", contributorUnit(contribution.contributor)},
                                         {"share", contribution.share},
                                         {"spread_mm", toJson(contribution.spread)},
                                         {"lost_mm2", contribution.lost},
                                         {"gained_mm2", contribution.gained}});
    }
    for (const WorstPlace& place : tolerances.worst) {
        worst.append(toJson(place));
    }
    QJsonObject json{{"spread_mm", toJson(tolerances.spread)},
                     {"contributions", contributions},
                     {"worst", worst}};
    if (tolerances.sampled) {
        json["sampled"] = QJsonObject{{"dips", tolerances.sampled->dips},
                                      {"p95_mm", tolerances.sampled->percentile95},
                                      {"linear_p95_mm", tolerances.sampled->linear},
                                      {"agrees", tolerances.sampled->agrees()}};
    }
    return json;
}

QJsonArray zonesJson(const std::vector<ZoneVerdict>& zones) {
    QJsonArray json;
    for (const ZoneVerdict& zone : zones) {
        json.append(QJsonObject{{"zone", zoneName(zone.zone)},
                                {"limit_mm", zone.limit},
                                {"holds", zone.holds()},
                                {"painted_mm2", zone.area},
                                {"unpainted_mm2", zone.unpainted},
                                {"within", zone.within},
                                {"together_p95_mm", zone.together},
                                {"spread_mm", toJson(zone.spread)},
                                {"worst", toJson(zone.worst)},
                                {"contributor", contributorKey(zone.contributor)},
                                {"sentence", zoneText(zone, millimetres)}});
    }
    return json;
}

QJsonObject cradleJson(const Cradle& cradle) {
    QJsonObject json{{"notes", QJsonArray::fromStringList(cradle.notes)}};
    if (!cradle.mesh.triangles.empty()) {
        const CradleCheck& check = cradle.check;
        json["closed"] = check.isClosed && check.parts == 1 && check.volume > 0;
        json["triangles"] = qint64(cradle.mesh.triangles.size());
        json["volume_mm3"] = check.volume;
        json["cell_mm"] = cradle.cell;
        json["gap_mm"] = check.leastGap;
        json["paint_gap_mm"] = check.paintGap;
        json["comes_out"] = check.comesOut;
        json["seat_area_mm2"] = check.seatArea;
        json["padded_area_mm2"] = check.paddedArea;
        json["tilt_deg"] = check.standing.tiltDegrees;
        json["side_hold_deg"] = check.standing.sideHoldDegrees;
    }
    return json;
}

QJsonObject filmJson(const Project& project) {
    const auto word = [](bool measured) { return measured ? "measured" : "guessed"; };
    return {{"swell", word(hasMeasuredSwell(project.film, project.profiles))},
            {"growth", word(hasMeasuredGrowth(project.film, project.profiles))},
            {"relaxation", word(hasMeasuredRelaxation(project.film, project.profiles))},
            {"ink", word(hasMeasuredInk(project.ink, project.profiles))}};
}

// Returns the used share of the film, and a smaller format that would suffice.
QJsonObject filmUseJson(const JobResult& result) {
    QJsonObject json{{"used", filmUsed(result)}};
    if (const std::optional<SmallerFilm> smaller = smallerFilm(result)) {
        json["enough"] = smaller->format;
        json["enough_mm"] = QJsonArray{smaller->width.value(), smaller->height.value()};
    }
    return json;
}

// Returns, for each dip, the repeating error of earlier parts and whether the sheet was corrected
// for it.
QJsonObject asBuiltJson(const JobResult& result) {
    const AsBuilt& built = result.project.asBuilt;
    const QStringList keys = dipKeys(result.project);
    const AsBuilt alike = dippedAlike(built, keys);
    QJsonArray dips;
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const RepeatingError error(alike, int(i) + 1);
        const BuiltPartCounts parts = countParts(built, int(i) + 1, keys);
        dips.append(QJsonObject{{"corrected", result.immersions[i].inputs.correction.has_value()},
                                {"parts", error.parts()},
                                {"parts_of_unknown_dips", parts.unknown},
                                {"parts_of_other_dips", parts.otherwise},
                                {"places", qint64(error.places().size())},
                                {"scatter_mm", error.scatter()},
                                {"part_scatter_mm", error.partScatter()},
                                {"shift_mm", QJsonArray{error.shift().x(), error.shift().y()}},
                                {"repeating_mm", error.repeating()},
                                {"reach_mm", error.reach()}});
    }
    QJsonArray times;
    for (const TankSummary& step : tankSummaries(built.times)) {
        times.append(QJsonObject{
            {"dip", step.dip},
            {"step", tankStepKeys().at(int(step.step))},
            {"runs", step.runs},
            {"planned_s", step.planned ? QJsonValue(step.planned->value()) : QJsonValue()},
            {"mean_s", step.mean.value()},
            {"shortest_s", step.shortest.value()},
            {"longest_s", step.longest.value()}});
    }
    QJsonObject json{{"strength", built.strength}, {"dips", dips}};
    if (!times.isEmpty()) {
        json.insert(QStringLiteral("times"), times);
    }
    return json;
}

QJsonObject reachJson(const InkReach& reach) {
    return {{"too_pale_share", reach.shortShare},
            {"missing_density_p95", reach.missing95},
            {"missing_density_max", reach.mostMissing},
            {"contrast_kept", std::isnan(reach.contrast) ? QJsonValue() : reach.contrast},
            {"colour_error_mean", reach.colourError}};
}

// Returns null if ink suffices.
QJsonValue inkOptionsJson(const JobResult& result) {
    const std::optional<InkOptions> found = inkOptions(result, {});
    if (!found) {
        return {};
    }
    QJsonArray options;
    for (const InkOption& option : found->options) {
        QJsonObject json = option.reach ? reachJson(*option.reach) : QJsonObject();
        json["option"] = remedyKey(option.remedy);
        json["sentence"] = QStringLiteral("%1: %2").arg(remedyText(option), optionText(option));
        if (const QString field = remedyField(option.remedy); !field.isEmpty()) {
            json["field"] = field;
            json["value"] = option.remedy == InkRemedy::WhiteBeneath ? QJsonValue("last")
                                                                     : QJsonValue(option.value);
        } else {
            json["area_stretch"] = option.value;
        }
        options.append(json);
    }
    return QJsonObject{
        {"painted_mm2", found->paintedArea}, {"now", reachJson(found->now)}, {"options", options}};
}

QString warningKey(WarningKind kind) {
    switch (kind) {
    case WarningKind::TrappedAir:
        return QStringLiteral("air");
    case WarningKind::NotReached:
        return QStringLiteral("not_reached");
    case WarningKind::Torn:
        return QStringLiteral("torn");
    case WarningKind::Unbalanced:
        return QStringLiteral("not_converged");
    case WarningKind::TooPale:
        return QStringLiteral("too_pale");
    case WarningKind::Released:
        break;
    }
    return QStringLiteral("released");
}

QJsonArray warningsJson(const JobResult& result) {
    QJsonArray warnings;
    for (const JobWarning& warning : jobWarnings(result)) {
        warnings.append(
            QJsonObject{{"kind", warningKey(warning.kind)},
                        {"dip", warning.dip ? QJsonValue(int(*warning.dip) + 1) : QJsonValue()},
                        {"area_mm2", warning.area},
                        {"model_mm", placeJson(warning.place)}});
    }
    return warnings;
}

} // namespace

QJsonObject report(const Project& project, const JobResult& result) {
    QJsonArray immersions;
    for (const ImmersionResult& immersion : result.immersions) {
        immersions.append(immersionJson(immersion));
    }
    const auto add = [&](std::size_t number, const char* key, const QJsonObject& value) {
        QJsonObject json = immersions.at(qsizetype(number)).toObject();
        json[QLatin1String(key)] = value;
        immersions.replace(qsizetype(number), json);
    };
    for (std::size_t i = 0; i < result.cradles.size(); ++i) {
        add(i, "cradle", cradleJson(result.cradles[i]));
    }
    for (std::size_t i = 0; result.tolerances && i < result.tolerances->dips.size(); ++i) {
        add(i, "tolerances", tolerancesJson(result.tolerances->dips[i]));
    }
    QJsonObject json{{"version", 1},
                     {"project", project.name},
                     {"verdict", adviceKey(adviceOf(result))},
                     {"reasons", reasonsJson(result)},
                     {"solver", QJsonObject{{"id", result.solver.id},
                                            {"device", result.solver.device},
                                            {"version", result.solver.version}}},
                     {"film", filmJson(project)},
                     {"film_use", filmUseJson(result)},
                     {"immersions", immersions},
                     {"coverage_total", result.coverageTotal},
                     {"costs", costsJson(result, project)},
                     {"warnings", warningsJson(result)},
                     {"notes", QJsonArray::fromStringList(result.notes)}};
    if (const QJsonValue options = inkOptionsJson(result); !options.isNull()) {
        json["ink_options"] = options;
    }
    if (result.share) {
        json["share"] = shareJson(result);
    }
    if (result.mask) {
        const MaskedAreas masked = maskedAreas(*result.mask);
        json["masks"] = QJsonObject{{"areas", qint64(masked.count)}, {"area_mm2", masked.area}};
    }
    if (!project.artwork.isEmpty()) {
        json["artwork"] = toJson(project).value(QLatin1String("artwork"));
    }
    if (!project.asBuilt.parts.empty() || !project.asBuilt.times.empty()) {
        json["as_built"] = asBuiltJson(result);
    }
    if (result.tolerances) {
        json["zones"] = zonesJson(result.tolerances->zones);
    }
    return json;
}

} // namespace dipwright

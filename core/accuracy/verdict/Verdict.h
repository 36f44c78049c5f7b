// Decides whether to print a job's sheets, check them first, or not print them, and gives every
// reason (docs/film-validation.md, "The verdict"). Window, command line, report, traveller and
// print dialog all show this verdict.
#pragma once

#include "accuracy/numericalError/NumericalErrorEstimate.h"
#include "accuracy/tolerance/Zones.h"
#include "dip/Coverage.h"
#include "settings/VerdictSettings.h"

#include <functional>

namespace dipwright {

// One reason for a verdict.
struct VerdictReason {
    enum class Kind : std::uint8_t {
        // About one dip. Shares in `value` are 0 … 1.
        NotAsked,     // the job did not ask for an estimate of the numerical error
        NotCompared,  // the numerical error could not be estimated: `text` says why
        Unpainted,    // the film paints nothing of the body
        NothingAlike, // this dip and the coarser dips paint no place in common
        Certain,      // numerical error: 95 % of the painted area is within `value` mm
        OffBy,        // the same, above the limit; `most`: cell to try, mm; 0 if not a graded film
        OffByMuch,    // the same, too large to tell which cell would suffice
        Step,         // the same, and longer steps change more than wider cells
        FarOffPlaces, // the error exceeds `limit` mm on the share `value` of the painted area
        Border,       // only one of the compared dips paints the share `value` of the body
        Unbalanced,   // `value` steps ended without equilibrium; `most`: the largest residual
        Air,          // trapped air keeps the share `value` of the body's surface dry
        Pale,         // the share `value` of the painted area will be too pale
        Damaged,      // film tore or was released on the share `value` of the painted area
        FilmEdge,     // the painted film comes within `value` mm of the film's edge
        // About all dips together.
        Unreached,    // neither dip paints the share `value` of the body's surface
        Narrow,       // the share `value` of the overlap is too narrow
        ZoneBare,     // the share `value` of the zone is not painted
        ZoneExceeded, // handling and numerical error together: 95 % of the zone's painted area is
                      // within `value` mm, which exceeds `limit`
        NoPicture,    // the model has one plain colour
        ChangedModel, // `text`: what the import repaired, or what is missing
        GuessedFilm,  // the film's swell was not measured
    };
    Kind kind;
    Advice advice = Advice::Print; // the verdict if this were the only reason
    double value = 0;
    double limit = 0; // for `value`; 0: none
    QString text = {};
    double most = 0;
    std::optional<Zone> zone = {}; // set if the reason is about one zone
};

// A connected part of the painted film to check: its numerical error exceeds the limit of its zone,
// or a step ended there without equilibrium.
struct PlaceToCheck {
    Eigen::Vector2f rest;  // its worst point on the flat film, mm
    Eigen::Vector3f place; // that point on the body, model coordinates, mm
    double area = 0;       // mm² of the body
    double limit = 0;      // numerical error allowed there, mm
    double offBy = 0;      // numerical error at the worst point, mm
};

// The verdict on one dip, or on all dips together.
struct Verdict {
    Advice advice = Advice::NotJudged;
    std::vector<VerdictReason> reasons; // the worst first
    // The largest first; at most mostPlaces, each of at least leastPlaceArea.
    std::vector<PlaceToCheck> places;
    double areaToCheck = 0; // of all places to check, mm² of the body
};

// The share of a zone's limit that the numerical error may use; handling has the rest. 95 % of the
// zone's painted area must keep this share, and at most mostFarOffArea may exceed the whole limit.
inline constexpr double numericalShare = 1.0 / 3;
inline double allowedError(Zone zone, const ToleranceSettings& tolerance) {
    return numericalShare * tolerance.limits[std::size_t(zone)].value();
}
inline constexpr double mostFarOffArea = 0.01;
inline constexpr double spoiltPaintedOnce = 0.15; // of the body's surface
// The smallest cell that a reason proposes, relative to the film's own. An error so large that it
// needs smaller cells need not shrink in proportion to them.
inline constexpr double finestCellNamed = 0.15;
inline constexpr std::size_t mostPlaces = 12;
inline constexpr double leastPlaceArea = 1; // mm²: smaller places cannot be inspected

// A dip and all that its verdict needs.
struct JudgedDip {
    const LaidFilm& laid;
    const Coverage& coverage;
    const NumericalErrorEstimate* numericalError = nullptr; // null: not asked for
    double paleArea = 0;                                    // mm² of the body with too little ink
    const ZonedBody* zones = nullptr;                       // null: the whole body is in zone C
};

// Judges one dip by `tolerance` and `limits`.
Verdict verdict(const JudgedDip& dip, const ToleranceSettings& tolerance,
                const VerdictSettings& limits);

// Collects reasons; the verdict is the worst of them.
class ReasonList {
public:
    void add(VerdictReason reason);
    // Adds a reason if the share exceeds its limit: check first, or do not print above spoiltTimes
    // the limit.
    void addShare(VerdictReason::Kind kind, double share, double limit,
                  std::optional<Zone> zone = {});
    bool isEmpty() const { return reasons_.empty(); }
    // Sorts the reasons, the worst first and otherwise as added. Without reasons: `Print`.
    Verdict verdict() &&;

private:
    std::vector<VerdictReason> reasons_;
};

// Returns the worse of two; NotJudged if one is not judged and the other says print.
Advice worst(Advice one, Advice other);

// Texts for the user. `length` and `area` format mm and mm².
QString adviceText(Advice advice); // "Print it"
using LengthText = std::function<QString(double)>;
QString millimetres(double length); // "0.12 mm"
QString reasonText(const VerdictReason& reason, const LengthText& length);
QString placeText(const PlaceToCheck& place, const LengthText& length, const LengthText& area);
// The whole verdict in one line: "Top: Print it. 95 % of the sheet is within …".
QString verdictText(const QString& immersion, const Verdict& verdict);
// Keys for files: "print", "look_first", "do_not_print" or "not_judged"; and "air" and so on.
QString adviceKey(Advice advice);
QString reasonKey(VerdictReason::Kind kind);
// The project's field that holds the limit of such a reason, "verdict.air"; empty if none does.
QString limitField(VerdictReason::Kind kind);

} // namespace dipwright

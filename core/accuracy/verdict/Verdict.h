// What is to be done with a job's sheets: print them, look at them first, or not print them, and
// every reason for it (docs/film-validation.md, "The verdict"). The one place that decides so;
// window, command line, report, traveller and print dialog all show what stands here.
#pragma once

#include "accuracy/certainty/CertaintyEstimate.h"
#include "accuracy/tolerance/Zones.h"
#include "dip/Coverage.h"
#include "settings/VerdictSettings.h"

#include <functional>

namespace dipwright {

struct VerdictReason {
    enum class Kind : std::uint8_t {
        // Of one dip.
        NotAsked,     // nothing was compared, as the job wanted it
        NotCompared,  // nothing could be compared: `text` says why
        Unpainted,    // the film paints nothing of the body
        NothingAlike, // nothing is painted alike by this dip and by coarser ones
        Certain,      // 95 % of it may be off by `value` mm at most
        OffBy,        // 95 % of it may be off by `value` mm; `most` the cell over the body to be
                      // tried, mm, of a graded film, 0 of one of evenly spaced points
        OffByMuch,    // the same, too far to tell which cell would do
        Step,         // the same, and longer steps change more than wider cells
        FarOffPlaces, // `value` of the painted area may be off by more than `limit` mm
        Border,       // `value` of the body is painted by one of the dips only
        Unbalanced,   // `value` steps ended without equilibrium, `most` the worst force left in one
        Air,          // `value` of the body's surface is kept dry by trapped air
        Pale,         // `value` of the painted area will look too pale
        Damaged,      // `value` of the painted area wears film that tore or was let go of
        FilmEdge,     // the painted film comes to `value` mm of the film's edge
        // Of all dips together.
        Unreached,    // `value` of the body's surface is painted by neither dip
        Narrow,       // `value` of the overlap is too narrow
        ZoneBare,     // `value` of the zone is not painted
        ZoneExceeded, // what is off in handling and the numerical error together: 95 % of the zone
                      // within `value` mm only
        NoPicture,    // the model has one plain colour
        ChangedModel, // `text`: what was put right, or is missing
        GuessedFilm,  // nobody has measured the film's swell
    };
    Kind kind;
    Advice advice = Advice::Print; // what this reason alone would come to
    double value = 0;
    double limit = 0; // that `value` is held against; 0: none
    QString text = {};
    double most = 0;
    std::optional<Zone> zone = {}; // where only one of several is meant
};

// A connected part of the painted film that may be off by more than the numerical error may be in
// its zone, or lies where a step has ended without equilibrium.
struct UncertainPlace {
    Eigen::Vector2f rest;  // the worst film point of it, on the flat film; mm
    Eigen::Vector3f place; // and where that lies on the body, in model coordinates; mm
    double area = 0;       // mm² of the body, all of which may be off by more than …
    double limit = 0;      // … this, mm
    double offBy = 0;      // at the worst point, mm
};

struct Verdict {
    Advice advice = Advice::NotJudged;
    std::vector<VerdictReason> reasons; // the worst first
    // The largest first, at most mostPlaces, each of leastPlaceArea or more.
    std::vector<UncertainPlace> places;
    double uncertainArea = 0; // of all such places, mm² of the body
};

// The numerical error may take so much of a zone's tolerance, so that handling has the rest: 95 %
// of what is painted of the zone keeps it, and no more than this share of it exceeds the whole.
inline constexpr double numericalShare = 1.0 / 3;
inline double allowedError(Zone zone, const ToleranceSettings& tolerance) {
    return numericalShare * tolerance.limits[std::size_t(zone)].value();
}
inline constexpr double mostFarOffArea = 0.01;
inline constexpr double spoiltPaintedOnce = 0.15; // of the body's surface
// No cell is named that is smaller than this, over the film's own: an error that large need not
// fall as the cells do.
inline constexpr double finestCellNamed = 0.15;
inline constexpr std::size_t mostPlaces = 12;
inline constexpr double leastPlaceArea = 1; // mm², that somebody can look at

// A dip and what is known of it.
struct JudgedDip {
    const LaidFilm& laid;
    const Coverage& coverage;
    const CertaintyEstimate* certainty = nullptr; // null: none was asked for
    double paleArea = 0;                          // mm² of the body that are short of ink
    const ZonedBody* zones = nullptr;             // null: all of the body is in zone C
};

// Of one dip, by its `limits`.
Verdict verdict(const JudgedDip& dip, const ToleranceSettings& tolerance,
                const VerdictSettings& limits);

// Collects reasons; the verdict is the worst of them.
class Objections {
public:
    void add(VerdictReason reason);
    // A share above its limit is to be looked at, spoiltTimes above it not to be printed; below it
    // nothing is said.
    void addShare(VerdictReason::Kind kind, double share, double limit,
                  std::optional<Zone> zone = {});
    bool isEmpty() const { return reasons_.empty(); }
    // The worst first, in the order in which they came. Nothing was found wrong: `Print`.
    Verdict verdict() &&;

private:
    std::vector<VerdictReason> reasons_;
};

// Of several together: the worst; not judged where one was not and nothing else is the matter.
Advice worst(Advice one, Advice other);

// For the user: "Print it", and why, in a sentence. `length` words a length given in mm.
QString adviceText(Advice advice);
using LengthText = std::function<QString(double)>;
QString millimetres(double length); // "0.12 mm"
QString reasonText(const VerdictReason& reason, const LengthText& length);
QString placeText(const UncertainPlace& place, const LengthText& length, const LengthText& area);
// All of it in a line: "Top: Print it. 95 % of the sheet is off by …".
QString verdictText(const QString& immersion, const Verdict& verdict);
// "print", "look_first", "do_not_print", "not_judged"; and of a kind of reason: "air".
QString adviceKey(Advice advice);
QString reasonKey(VerdictReason::Kind kind);
// The field of the project that holds the limit of such a reason, "verdict.air"; empty: none does.
QString limitField(VerdictReason::Kind kind);

} // namespace dipwright

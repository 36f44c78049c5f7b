// Decides whether to print a job's sheets, check them first, or not print them, and gives every
// reason (docs/film-validation.md, "The verdict"). Window, command line, report, traveller and
// print dialog all show this verdict.
#pragma once

#include "accuracy/error/NumericalErrorEstimate.h"
#include "accuracy/tolerance/Zones.h"
#include "dip/Coverage.h"
#include "dip/TankFit.h"
#include "model/SeparateBodies.h"
#include "settings/AsBuilt.h"
#include "settings/VerdictSettings.h"

#include <functional>

namespace dipwright {

// One reason for a verdict.
struct VerdictReason {
    enum class Kind : std::uint8_t {
        // Reasons about one dip. Shares in `value` are 0 … 1.
        NotAsked,     // the job did not request an estimate of the numerical error
        NotCompared,  // the numerical error could not be estimated: `text` says why
        Unpainted,    // the film paints nothing of the body
        AllMasked,    // masks cover everything that the film would paint
        NothingAlike, // this dip and the coarser dips paint no place in common
        Certain,      // numerical error: 95 % of the painted area is within `value` mm
        OffBy, // as Certain, but `value` exceeds the limit; `most`: cell to try, mm; 0: film not
               // graded
        OffByMuch,    // as OffBy, but too large to tell which cell would suffice
        Step,         // as OffBy, and longer steps change the sheet more than wider cells do
        FarOffPlaces, // numerical error exceeds `limit` mm on the share `value` of the painted area
        UnknownError, // the numerical error of the share `value` of the painted area is unknown,
                      // because the compared dips leave it bare
        Border,       // only one of the compared dips paints the share `value` of the body
        Unbalanced,   // `value` steps ended without equilibrium; `most`: the largest residual
        Refined,      // search only: the job repeats the dip with cells of `value` mm
        Air,          // trapped air keeps the share `value` of the body's surface dry; `most`: vent
                      // holes narrower than this may not be seen, mm
        Pale,         // the share `value` of the painted area will be too pale
        Damaged,      // film tore or was released on the share `value` of the painted area
        TornBare, // only dip of a job: the share `value` of the surface that it should paint stays
                  // bare because the film tears first
        FilmEdge, // film that paints the body lies only `value` mm from the film's edge
        Rises,    // the path lifts the part again by the share `value` of its depth
        Tank,     // `text`: which limit of the tank or its machine the dip exceeds by `value` mm,
                  // mm/s or °/s
        NoInk,    // the sheet takes no ink
        LostPlates,     // `text`: the plates that the project's printer cannot print
        CoveredPicture, // `text`: marks, ruler or job line cover a part of the picture
        OtherDips, // `value` of `limit` measured parts were dipped otherwise, so the sheet is not
                   // corrected by them
        UnusualCorrection, // `text`: measured parts change the sheet unusually much
        UnknownDips, // measured parts correct the sheet, but nothing says how they were dipped
        // Reasons about all dips together.
        Unreached,    // neither dip paints the share `value` of the body's surface
        Narrow,       // the share `value` of the overlap is too narrow
        NarrowSeam,   // half of the overlap is at most `value` mm wide; the user wants `limit` mm
        Misassigned,  // one dip paints the share `value` of the area that marks give to the other
        ZoneBare,     // the share `value` of the zone is not painted
        BodyBare,     // only the share `value` of the separate body is painted, less than `limit`
        ZoneExceeded, // handling and numerical error together: 95 % of the zone's painted area is
                      // within `value` mm, which exceeds `limit`
        NoPicture,    // the model has one plain colour
        HiddenInks,   // artwork hides the amounts of ink in the model's texture
        ChangedModel, // `text`: what the import repaired or found odd
        GuessedFilm,  // the film's swell was not measured
        ExpiredFilm,  // `text`: which film, and since when
        UnknownName,  // `text`: a face or material that a mark or layer names but the model lacks,
                      // or a font or characters of a text that this computer lacks
        Misplaced,    // `text`: marks off the part, or a layer that does not fit around it
        IncompleteModel, // `text`: what the import left out or cannot show as the file means it
        PaintedTwice,    // both dips print the share `value` of the body's surface at full strength
        LittlePainted,   // the only dip paints the share `value` of the surface, less than `limit`
        FaintPicture,    // on the part's own colour, the picture keeps the share `value` of its
                         // contrast, less than `limit`
        ThinPlaces,      // `text`: places that are too thin for the distance field's cells
        UnusualSpeed,    // the dip speed of `value` mm/s is not usual
        UnusualSlowSpeed,  // the slow speed of `value` mm/s in the dip named `text` is not usual
        UnusualPathSpeed,  // the part moves at `value` mm/s on the path of the dip named `text`
        UnusualGrowthRate, // the film grows by the share `value` per second, more than is usual
        UnusualGrowth,     // the film grows by the share `value` in all, more than is usual
        UnusualSwell,      // the film's swell of `value` is not usual
    };
    Kind kind;
    Advice advice = Advice::Print; // the verdict if this is the only reason
    double value = 0;
    double limit = 0; // limit for `value`; 0: no limit
    QString text = {};
    double most = 0;
    std::optional<Zone> zone = {}; // set if the reason is about one zone
    QString body = {};             // name of the separate body that the reason is about; or empty
    bool isOnlyDip = false;        // the job has no other dip, so a second one is possible
};

// A connected part of the painted film to check: its numerical error exceeds the limit of its zone,
// or a step ended there without equilibrium.
struct PlaceToCheck {
    Eigen::Vector2f rest;  // middle of the part's worst film triangle, on the flat film, mm
    Eigen::Vector3f place; // the same place on the body, model coordinates, mm
    double area = 0;       // mm² of the body
    double limit = 0;      // least allowed numerical error of the part, mm
    // Largest known numerical error of the part, mm. If it is within the limit, the part is listed
    // because its film did not converge.
    double offBy = 0;
};

// The verdict on one dip, or on all dips together.
struct Verdict {
    Advice advice = Advice::NotJudged;
    std::vector<VerdictReason> reasons; // the worst first
    // The places to check, the largest first: at most mostPlaces, each of at least leastPlaceArea.
    std::vector<PlaceToCheck> places;
    double areaToCheck = 0; // total area of all places to check, mm² of the body
};

// The share of a zone's limit that the numerical error may use; the rest is for handling. On 95 %
// of the zone's painted area the error must be within this share. It may exceed the whole limit on
// at most the fraction mostFarOffArea of that area.
inline constexpr double numericalShare = 1.0 / 3;
inline double allowedError(Zone zone, const ToleranceSettings& tolerance) {
    return numericalShare * tolerance.limits[std::size_t(zone)].value();
}
inline constexpr double mostFarOffArea = 0.01;
// The numerical error must be known on all but this share of the painted area.
inline constexpr double mostUnknownArea = 1 - zoneShareWithin;
// Do not print if more than this share of the body's surface is painted by only one of the compared
// dips.
inline constexpr double spoiltPaintedOnce = 0.15;
// Limits for the share of the surface to paint that stays bare because the only film tears
// (Coverage::tornBareShare()): above the first the verdict is *check first*, above the second *do
// not print*. In ordinary dips up to 0.28 is counted where 0.06 is lost.
inline constexpr double mostTornBare = 0.2, spoiltTornBare = 0.4;
// The usual speeds of a dip, in mm/s, and the usual growth and swell of floating film
// (FilmBehaviour). The verdict on other values is *check first* (docs/film-validation.md, "The
// verdict").
inline constexpr double leastUsualSpeed = 0.5, mostUsualSpeed = 100;
inline constexpr double mostUsualGrowthRate = 0.05, mostUsualGrowth = 0.5;
inline constexpr double leastUsualSwell = 0.95, mostUsualSwell = 1.3;
// A vent hole this many cells of the search for trapped air wide is always seen (AirPockets.h).
inline constexpr double seenVentCells = 2;
// Limit for riseOnPath(); above it the verdict is *check first*.
inline constexpr double mostRise = 0.5;
// The smallest cell that a reason proposes, relative to the film's own cell. An error that
// would need even smaller cells does not shrink in proportion to the cells.
inline constexpr double finestCellNamed = 0.15;
// The largest cell that a reason proposes, relative to the film's own cell. It doubles the work; a
// larger one would hardly change the sheet.
inline constexpr double largestCellNamed = 0.7937; // 2^(−1/3)
inline constexpr std::size_t mostPlaces = 12;
inline constexpr std::size_t mostNamedBodies = 3;
inline constexpr double leastPlaceArea = 1; // mm²: smaller places cannot be inspected

// What distinguishes places of the body for its verdict.
struct JudgedSurface {
    const ZonedBody* zones = nullptr;       // null: the whole body is in zone C
    const SurfaceMask* mask = nullptr;      // masked surface is not judged; null: none
    const SeparateBodies* bodies = nullptr; // null: one body
};

// A dip and everything that its verdict needs.
struct JudgedDip {
    const LaidFilm& laid;
    const Coverage& coverage;
    const NumericalErrorEstimate* numericalError = nullptr; // null: not requested
    double paleArea = 0;                                    // mm² of the body with too little ink
    JudgedSurface surface = {};
    std::vector<TankFault> tankFaults = {}; // limits of the tank that the dip exceeds
    bool isOnlyDip = false;                 // the job has no other dip
    bool takesInk = true;                   // the sheet's picture has ink
    QString lostPlates = {}; // sentences on plates that the printer cannot print; empty: none
    // The measured parts by which the project wants to correct the sheet.
    BuiltPartCounts built = {};
    QString unusualCorrection = {}; // sentence on a correction that is unusually large; empty: none
    QString coveredPicture = {};    // sentence on marks that cover the picture; empty: none do
};

// Returns the verdict on one dip by the limits in `tolerance` and `limits`.
Verdict verdict(const JudgedDip& dip, const ToleranceSettings& tolerance,
                const VerdictSettings& limits);

// Returns the reason of a path that lifts the part again (riseOnPath()); nothing if it does not, or
// hardly.
std::optional<VerdictReason> riseReason(const solver::BodyPath& path, const TriangleMesh& posed);

// Returns the part of the verdict that is about the numerical error; without places.
Verdict numericalVerdict(const LaidFilm& laid, const NumericalErrorEstimate* estimate,
                         const JudgedSurface& surface, const ToleranceSettings& tolerance);

// Collects reasons; the verdict is the worst of them.
class ReasonList {
public:
    void add(VerdictReason reason);
    // Adds reasons about separate bodies: the first mostNamedBodies of the worst by name, and the
    // next one for all others together.
    void addOfBodies(std::vector<VerdictReason> reasons);
    // Adds a reason if the share exceeds its limit. The advice is CheckFirst, or DoNotPrint if the
    // share exceeds doNotPrintFactor times the limit.
    void addShare(VerdictReason::Kind kind, double share, double limit,
                  std::optional<Zone> zone = {}, double most = 0);
    // Adds a reason if the only dip of a job leaves too much bare because its film tears. `share`:
    // Coverage::tornBareShare(). Of two dips, the other may paint it, so Kind::Unreached decides.
    void addTornBare(double share);
    bool isEmpty() const { return reasons_.empty(); }
    const std::vector<VerdictReason>& reasons() const { return reasons_; }
    // Returns the verdict. Its reasons are sorted, the worst first; equally bad ones keep the order
    // in which they were added. Without reasons the advice is `Print`.
    // `isOnlyDip`: VerdictReason::isOnlyDip of all reasons.
    Verdict verdict(bool isOnlyDip = false) &&;

private:
    std::vector<VerdictReason> reasons_;
};

// Returns the worse of the two; NotJudged if one is NotJudged and the other is Print.
Advice worst(Advice one, Advice other);

// The next functions return texts for the user. `length` and `area` format mm and mm².
QString adviceText(Advice advice); // "Print it"
using LengthText = std::function<QString(double)>;
QString millimetres(double length); // "0.12 mm"
QString reasonText(const VerdictReason& reason, const LengthText& length);
QString placeText(const PlaceToCheck& place, const LengthText& length, const LengthText& area);
// Returns the whole verdict in one line: "Top: Print it. Numerical error: at most …".
QString verdictText(const QString& immersion, const Verdict& verdict);
// Returns the key for files: "print", "look_first", "do_not_print" or "not_judged".
QString adviceKey(Advice advice);
// Returns the key for files: "air" and so on.
QString reasonKey(VerdictReason::Kind kind);
// Returns the project's field that holds the limit for this kind of reason, such as "verdict.air";
// empty if there is none.
QString limitField(VerdictReason::Kind kind);

} // namespace dipwright

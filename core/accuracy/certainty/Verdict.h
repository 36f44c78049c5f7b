// What is to be done with a sheet, as far as the numerics go: print it, look at some places first,
// or not print it (docs/film-validation.md, "The verdict").
#pragma once

#include "accuracy/certainty/CertaintyEstimate.h"

#include <functional>

namespace dipwright {

enum class Advice { NotJudged, Print, LookFirst, DoNotPrint }; // the later the worse

struct VerdictReason {
    enum class Kind {
        NotAsked,    // nothing was compared, as the job wanted it
        NotCompared, // nothing could be compared: `text` says why
        NothingPaints,
        Certain,      // 95 % of it may be off by `value` mm at most
        OffBy,        // 95 % of it may be off by `value` mm; `most` the cell over the body to be
                      // tried, mm, of a graded film, 0 of one of evenly spaced points
        OffByMuch,    // the same, too far to tell which cell would do
        FarOffPlaces, // `value` of the painted area may be off by more than farOff
        Step,         // 95 % of it is expected to move by `value` mm with half the step
        Border,       // `value` of the body is painted by one of the dips only
        Unbalanced,   // `value` steps ended without equilibrium, `most` the worst force left in one
    };
    Kind kind;
    double value = 0;
    QString text = {};
    double most = 0;
};

// A connected part of the painted film that may be off by more than places of a certain sheet are,
// or lies where a step has ended without equilibrium.
struct UncertainPlace {
    Eigen::Vector2f rest;  // the worst film point of it, on the flat film; mm
    Eigen::Vector3f place; // and where that lies on the body, in model coordinates; mm
    double area = 0;       // mm² of the body
    double offBy = 0;      // there, mm
};

struct Verdict {
    Advice advice = Advice::NotJudged;
    std::vector<VerdictReason> reasons; // the worst first, never empty
    std::vector<UncertainPlace> places; // the largest first, mostPlaces at most
    double uncertainArea = 0;           // of all such places, mm² of the body
};

// A sheet of which 95 % may be off by no more than this can be looked at; one that is farther off
// is no use. A place that is farther off is to be looked at, whatever the rest is like.
inline constexpr double certainOffBy = certainHalfSpacing / halfSpacingShare; // mm, of a place
inline constexpr double farOff = 1;                                           // mm
inline constexpr double mostFarOffArea = 0.01;    // of the painted area, of a certain sheet
inline constexpr double spoiltPaintedOnce = 0.15; // of the body's surface
// No cell is named that is smaller than this, over the film's own: an error that large need not
// fall as the cells do.
inline constexpr double finestCellNamed = 0.15;
inline constexpr std::size_t mostPlaces = 12;

// The one place that tells of steps without equilibrium. `estimate` null: none was asked for.
Verdict verdict(const LaidFilm& own, const CertaintyEstimate* estimate);

// For the user: "Print it", and why, in a sentence. `length` words a length given in mm.
QString adviceText(Advice advice);
using LengthText = std::function<QString(double)>;
QString millimetres(double length); // "0.12 mm"
QString reasonText(const VerdictReason& reason, const LengthText& length);
// All of it in a line: "Top: Print it. 95 % of the sheet is off by …".
QString verdictText(const QString& immersion, const Verdict& verdict);
// "print", "look_first", "do_not_print", "not_judged".
QString adviceKey(Advice advice);

} // namespace dipwright

// What a fit to a dipped part can find out, and what each does to a dip (docs/inspection.md, "The
// fit").
#pragma once

#include "accuracy/tolerance/Contributors.h"

#include <QString>
#include <vector>

namespace dipwright {

struct Project;

enum class FitQuantity : std::uint8_t {
    ShiftX, // of the body against the film, mm
    ShiftZ,
    Turn, // of the body about the vertical through the middle of its bounding box, degrees
    SwellX,
    SwellY,
    Relaxation,      // s
    Growth,          // 1/s
    ContactDistance, // mm
    Depth,           // mm
};
inline constexpr std::size_t fitQuantityCount = 9;

// Placement, swell and relaxation. Contact distance can hardly be told from swell, depth and growth
// are better measured at the tank.
std::vector<FitQuantity> usualQuantities();
// Of a dip, that is; else of the film, and the same in all dips.
bool isOfDip(FitQuantity quantity);
// For the user: "Body along X", "mm".
QString fitQuantityText(FitQuantity quantity);
QString fitQuantityUnit(FitQuantity quantity);
// For files and the command line: "shift_x".
QString fitQuantityKey(FitQuantity quantity);
// Throws Error on another word.
FitQuantity fitQuantityOf(const QString& key);

// A quantity that is looked for, of one dip where it is one's.
struct FitUnknown {
    FitQuantity quantity = FitQuantity::ShiftX;
    int dip = 0;
};

// In a fit an unknown is a number of the order of 1 that is 0 at the start: mm, degrees, per cent
// of the swell, and the logarithm of relaxation and growth over the start's.
struct FitScale {
    double step;    // to either side, for the derivatives
    double most;    // that it goes in one round
    double mostOff; // 95 %: past it, it is not known
    double least;   // that it has to move by for another round
};
FitScale fitScale(FitQuantity quantity);

// The dips of a project, and what becomes of them for unknowns. Keeps references.
class FittedDips {
public:
    // `setups`: of the project's immersions each.
    FittedDips(const Project& project, std::vector<solver::DipSetup> setups);

    const solver::DipSetup& setup(int dip) const { return setups_[std::size_t(dip)]; }
    // Whether it changes a dip at all.
    bool matters(FitQuantity quantity) const;
    // Within what a dip can be.
    double within(FitQuantity quantity, double unknown) const;
    ChangedDip dip(int dip, const std::vector<FitUnknown>& unknowns,
                   const std::vector<double>& values) const;
    // In the quantity's own unit. Shifts are offsets on the water, turns count from the pose that
    // the project has.
    double told(const FitUnknown& unknown, double value) const;
    // As the project has it.
    double before(const FitUnknown& unknown) const;

private:
    double duration() const; // of the first dip, s

    const Project& project_;
    std::vector<solver::DipSetup> setups_;
    double relaxation_ = 0; // at the start, s
};

} // namespace dipwright

// Lists the quantities that a fit to a dipped part can determine, and applies them to a dip
// (docs/inspection.md, "The fit").
#pragma once

#include "accuracy/tolerance/Contributors.h"

#include <QString>
#include <vector>

namespace dipwright {

struct Project;

enum class FitQuantity : std::uint8_t {
    ShiftX, // shift of the body relative to the film along X, mm
    ShiftZ, // the same along Z, mm
    // Rotation of the body about the vertical axis through the centre of its bounding box, degrees.
    Turn,
    SwellX,          // floating length divided by printed length, along X
    SwellY,          // the same along Y
    Relaxation,      // s
    Growth,          // 1/s
    ContactDistance, // mm
    Depth,           // mm
};
inline constexpr std::size_t fitQuantityCount = 9;

// Returns the quantities of placement, swell and relaxation. Contact distance is left out because
// it can hardly be separated from swell; depth and growth are better measured at the tank.
std::vector<FitQuantity> usualQuantities();
// Tells whether a quantity belongs to a single dip. Otherwise it belongs to the film and is the
// same in all dips.
bool isOfDip(FitQuantity quantity);
// Return the name and unit for the user, for example "Position of the part along X" and "mm".
QString fitQuantityText(FitQuantity quantity);
QString fitQuantityUnit(FitQuantity quantity);
// Returns the key for files and the command line, for example "shift_x".
QString fitQuantityKey(FitQuantity quantity);
// Throws Error for an unknown key.
FitQuantity fitQuantityOf(const QString& key);

// A quantity to determine. For a quantity of a single dip, `dip` is the dip's index.
struct FitUnknown {
    FitQuantity quantity = FitQuantity::ShiftX;
    int dip = 0;
};

// The scale of an unknown. In a fit, an unknown is a number of the order of 1 that starts at 0. It
// counts mm, degrees, or per cent of the swell; for relaxation and growth it is the logarithm of
// value divided by start value.
struct FitScale {
    double step;                // change to either side, for the derivatives
    double most;                // largest change in one round of the fit
    double widestKnownInterval; // with a wider 95 % interval, the unknown does not count as known
    double least;               // smallest change that makes another round necessary
};
FitScale fitScale(FitQuantity quantity);

// The dips of a project, and how unknowns change them. Keeps references.
class FittedDips {
public:
    // `setups` has one entry per immersion of the project.
    FittedDips(const Project& project, std::vector<solver::DipSetup> setups);

    const solver::DipSetup& setup(int dip) const { return setups_[std::size_t(dip)]; }
    // Tells whether the quantity has any effect on the dips.
    bool matters(FitQuantity quantity) const;
    // Clamps an unknown to the range that a dip allows.
    double within(FitQuantity quantity, double unknown) const;
    ChangedDip dip(int dip, const std::vector<FitUnknown>& unknowns,
                   const std::vector<double>& values) const;
    // Returns a value in the quantity's own unit. Shifts are offsets on the water; turns count from
    // the project's pose.
    double told(const FitUnknown& unknown, double value) const;
    // Returns the value in the project, in the same unit.
    double before(const FitUnknown& unknown) const;

private:
    double duration() const; // duration of the first dip, s
    // Returns the depth of the lowest point at the end of a dip, mm.
    double depth(const Immersion& immersion) const;
    // Replaces the path by that of the changed immersion, `deeper` mm deeper than the project's.
    void planPath(ChangedDip& dip, double deeper) const;

    const Project& project_;
    std::vector<solver::DipSetup> setups_;
    double relaxation_ = 0; // relaxation time at the start of the fit, s
};

} // namespace dipwright

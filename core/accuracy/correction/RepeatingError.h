// Separates the error that repeats in all parts of a job from the scatter between parts
// (docs/inspection.md, "As built").
#pragma once

#include "settings/AsBuilt.h"

#include <Eigen/Core>

#include <vector>

namespace dipwright {

// A place that was measured on one or more parts. Lengths are mm on the sheet.
struct RepeatedPlace {
    Eigen::Vector2d sheet{0, 0}, mean{0, 0}; // the place, and its mean error over the parts
    double scatter = 0;                      // root mean square along each axis; 0 for one part
    int parts = 0;                           // number of parts on which the place was measured
};

// The repeating error of one dip, as a smooth displacement of the sheet. Immutable; any thread may
// read it.
class RepeatingError {
public:
    // Fits the error to the places of dip `dip`, counted from 1. Without places it isNothing().
    RepeatingError(const AsBuilt& built, int dip);

    bool isNothing() const { return places_.empty(); }
    // Returns the error at a place of the sheet, in mm. Film printed at `sheet` lands where film
    // from sheet + at(sheet) was meant to land.
    Eigen::Vector2d at(const Eigen::Vector2d& sheet) const;

    const std::vector<RepeatedPlace>& places() const { return places_; }
    // Returns the part of the repeating error that is the same everywhere, in mm.
    Eigen::Vector2d shift() const { return mean_; }
    // The next three are standard deviations along each axis, in mm.
    double scatter() const { return scatter_; }         // of single places between parts
    double partScatter() const { return partScatter_; } // of whole parts
    double repeating() const { return repeating_; }     // of the repeating error without shift()
    double reach() const { return reach_; } // correlation length of the repeating error, mm
    int parts() const { return parts_; }    // number of measured parts

private:
    void gather(const AsBuilt& built, int dip);
    void fit();

    std::vector<RepeatedPlace> places_;
    int parts_ = 0;
    double scatter_ = 0, partScatter_ = 0, repeating_ = 0, reach_ = 1;
    Eigen::Vector2d mean_{0, 0};
    Eigen::MatrixX2d weights_; // one row for each place
};

} // namespace dipwright

// What the parts of a job are off again and again, told from what is off in each of them by chance
// (docs/inspection.md, "As built").
#pragma once

#include "settings/AsBuilt.h"

#include <Eigen/Core>

#include <vector>

namespace dipwright {

// A place that was seen on some of the parts. mm on the sheet.
struct RepeatedPlace {
    Eigen::Vector2d sheet{0, 0}, mean{0, 0};
    double scatter = 0; // root mean square, along each axis; 0 of one part
    int parts = 0;
};

// Of one dip: a smooth displacement of the sheet. Immutable; any thread may read.
class RepeatingError {
public:
    // `dip` from 1. Nothing where no part has a place of that dip.
    RepeatingError(const AsBuilt& built, int dip);

    bool isNothing() const { return places_.empty(); }
    // Film that is printed at `sheet` lies where film of at(sheet) farther on is meant to lie; mm.
    Eigen::Vector2d at(const Eigen::Vector2d& sheet) const;

    const std::vector<RepeatedPlace>& places() const { return places_; }
    // Along each axis: of single places from part to part, of parts as a whole, and of what
    // repeats.
    double scatter() const { return scatter_; }
    double partScatter() const { return partScatter_; }
    double repeating() const { return repeating_; }
    double reach() const { return reach_; } // mm over which what repeats is alike
    int parts() const { return parts_; }

private:
    void gather(const AsBuilt& built, int dip);
    void fit();

    std::vector<RepeatedPlace> places_;
    int parts_ = 0;
    double scatter_ = 0, partScatter_ = 0, repeating_ = 0, reach_ = 1;
    Eigen::Vector2d mean_{0, 0};
    Eigen::MatrixX2d weights_; // a place each
};

} // namespace dipwright

// Prices and times of work, as a shop enters them into its profiles. All prices are in one
// currency. They do not affect sheets or job numbers.
#pragma once

#include "base/Units.h"

#include <QString>
#include <array>
#include <optional>

namespace dipwright {

// The inks of a printer. 0: not given.
struct InkCosts {
    // For cyan, magenta, yellow and black: ml of ink per m² of film at full tint; price of a litre.
    std::array<double, 4> laydown{}, price{};
    // The same for white and for the other spot inks.
    std::array<double, 2> spotLaydown{}, spotPrice{};
    bool operator==(const InkCosts&) const = default;
};

enum class FilmPriceUnit { SquareMetre, RollMetre, Sheet };

struct FilmCosts {
    std::optional<double> price; // of one unit
    FilmPriceUnit unit = FilmPriceUnit::SquareMetre;
    bool operator==(const FilmCosts&) const = default;
};

// Work at the tank. None: not given.
struct WorkCosts {
    std::optional<double> labourRate; // price of an hour
    std::optional<double> setUp;      // min for each order
    std::optional<double> handling; // min for each dip, in addition to the timed steps: laying the
                                    // film, mounting, rinsing
    int partsPerRack = 1;           // parts that one dip with one sheet makes
    double scrap = 0;               // share of the dipped racks that cannot be sold
    QString currency;
    bool operator==(const WorkCosts&) const = default;
};

} // namespace dipwright

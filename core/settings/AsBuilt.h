// Parts of a job that were dipped so far, as in the project file's "as_built": measurements from
// photos, and times at the tank.
#pragma once

#include "base/Units.h"
#include "settings/UnknownKeys.h"

#include <QString>
#include <QStringList>
#include <array>
#include <optional>
#include <vector>

namespace dipwright {

struct BuiltPart {
    QString date;        // ISO date of the photos
    QString acceptedBy;  // who accepted its measurements
    QString photos;      // SHA-256 of the photos' files, hexadecimal, separated by spaces
    double residual = 0; // rms error of the places, mm on the sheet
    // dipKeys() of the job when the part was dipped, separated by spaces. Empty: not known, for
    // parts that an earlier version of the program kept.
    QString dips = {};
    UnknownKeys unknown = {};
    bool operator==(const BuiltPart&) const = default;
};

// A measured place on a part's sheet. The image at this place landed where another place of the
// sheet was meant to land. `off` leads to that other place.
struct BuiltPlace {
    int part = 1;                       // index in AsBuilt::parts, from 1
    int dip = 1;                        // index in the project's immersions, from 1
    std::array<Millimetres, 2> sheet{}; // restPosition() (DippedFilm.h) divided by the swell
    // Intended place on the model. Places of several parts are matched by it.
    std::array<Millimetres, 3> model{};
    std::array<Millimetres, 2> off{}; // offset from `sheet` to the other place, on the sheet
    UnknownKeys unknown = {};
    bool operator==(const BuiltPlace&) const = default;
};

// The steps of one dip at the tank, in the order of the traveller.
enum class TankStep { Tape, Lay, Soak, Activator, Dip, Hold, Flash, Dry, RemoveTape, Compare };
// Returns the steps' words in files, in the same order.
inline QStringList tankStepKeys() {
    return {QStringLiteral("tape"),      QStringLiteral("lay"), QStringLiteral("soak"),
            QStringLiteral("activator"), QStringLiteral("dip"), QStringLiteral("hold"),
            QStringLiteral("flash"),     QStringLiteral("dry"), QStringLiteral("remove_tape"),
            QStringLiteral("compare")};
}

// How long a step at the tank took.
struct TankTime {
    int run = 1; // a run goes once through all steps of all dips; counted from 1
    int dip = 1; // index in the project's immersions, from 1
    TankStep step = TankStep::Lay;
    QString began;                  // ISO date and time, of the local clock
    std::optional<Seconds> planned; // none: no time is given
    Seconds took{0};                // without pauses
    UnknownKeys unknown = {};
    bool operator==(const TankTime&) const = default;
};

inline constexpr std::size_t mostTankTimes = 5000;
inline constexpr std::size_t mostBuiltParts = 50;
inline constexpr std::size_t mostBuiltPlaces = 5000;

struct AsBuilt {
    // Whether the sheets are corrected for the error that repeats in all parts.
    bool corrects = false;
    double strength = 1; // share of the correction that is applied
    std::vector<BuiltPart> parts;
    std::vector<BuiltPlace> places;
    std::vector<TankTime> times; // no sheet depends on them
    bool operator==(const AsBuilt&) const = default;
};

// Returns `built` with the times of one more run, which get its number. The times of the oldest
// runs are dropped beyond the limit.
AsBuilt withTankRun(AsBuilt built, std::vector<TankTime> times);

// Tells whether a part's dip, counted from 1, was as `dips` say, the keys of the dips
// (BuiltPart::dips); nothing if that is not known.
std::optional<bool> isDippedAlike(const BuiltPart& part, int dip, const QStringList& dips);
// Returns `built` without the places whose part was dipped otherwise than `dips` say, and without
// those of dips that the job does not have. Keeps the places of parts whose dips are not known.
AsBuilt dippedAlike(AsBuilt built, const QStringList& dips);

// How many parts with measured places on one dip's sheet were dipped in which way.
struct BuiltParts {
    int alike = 0;     // as the keys say
    int unknown = 0;   // the part's dips are not known
    int otherwise = 0; // their errors say nothing about the next sheet
    bool operator==(const BuiltParts&) const = default;
};
// Counts the parts of a dip, counted from 1.
BuiltParts countParts(const AsBuilt& built, int dip, const QStringList& dips);

} // namespace dipwright

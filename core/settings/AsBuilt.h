// The parts of a job that have been dipped: measurements from photos, and times at the tank. As in
// the project file's "as_built".
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
    QString acceptedBy;  // the person who accepted the measurements
    QString photos;      // SHA-256 of the photos' files, hexadecimal, separated by spaces
    double residual = 0; // root mean square error of the places, mm on the sheet
    // dipKeys() of the job when the part was dipped, separated by spaces. Empty: not known, because
    // an earlier version of the program stored the part.
    QString dips = {};
    UnknownKeys unknown = {};
    bool operator==(const BuiltPart&) const = default;
};

// A measured place on a part's sheet. The image of this place landed on the model where another
// place of the sheet should have landed.
struct BuiltPlace {
    int part = 1;                       // index in AsBuilt::parts, from 1
    int dip = 1;                        // index in the project's immersions, from 1
    std::array<Millimetres, 2> sheet{}; // restPosition() (DippedFilm.h) divided by the swell
    // Where the place should have landed on the model. Identifies the same place on several parts.
    std::array<Millimetres, 3> model{};
    std::array<Millimetres, 2> off{}; // from `sheet` to the other place, on the sheet
    UnknownKeys unknown = {};
    bool operator==(const BuiltPlace&) const = default;
};

// Measured places whose coordinates on the model round to the same multiples of this, in mm, count
// as one place.
inline constexpr double sameBuiltPlace = 0.01;

// The steps of one dip at the tank, in the traveller's order.
enum class TankStep { Tape, Lay, Soak, Activator, Dip, Hold, Flash, Dry, RemoveTape, Compare };
// Returns the steps' keys in files, in the same order.
inline QStringList tankStepKeys() {
    return {QStringLiteral("tape"),      QStringLiteral("lay"), QStringLiteral("soak"),
            QStringLiteral("activator"), QStringLiteral("dip"), QStringLiteral("hold"),
            QStringLiteral("flash"),     QStringLiteral("dry"), QStringLiteral("remove_tape"),
            QStringLiteral("compare")};
}

// The time that a step at the tank took.
struct TankTime {
    int run = 1; // from 1; a run is one pass through all steps of all dips
    int dip = 1; // index in the project's immersions, from 1
    TankStep step = TankStep::Lay;
    QString began;                  // local date and time, ISO 8601
    std::optional<Seconds> planned; // none: the step has no planned time
    Seconds took{0};                // without pauses
    UnknownKeys unknown = {};
    bool operator==(const TankTime&) const = default;
};

inline constexpr std::size_t mostTankTimes = 5000;
inline constexpr std::size_t mostBuiltParts = 50;
inline constexpr std::size_t mostBuiltPlaces = 5000;

struct AsBuilt {
    // Whether the next sheets are corrected for the error that repeats in all parts.
    bool corrects = false;
    double strength = 1; // share of this error that is corrected, 0 to 1
    std::vector<BuiltPart> parts;
    std::vector<BuiltPlace> places;
    std::vector<TankTime> times; // the sheets do not depend on them
    bool operator==(const AsBuilt&) const = default;
};

// Returns `built` with the times of one more run. Sets their run number. If there are more than
// mostTankTimes, drops the oldest runs.
AsBuilt withTankRun(AsBuilt built, std::vector<TankTime> times);

// In the next three functions, `dips` holds the present keys of the job's dips (dipKeys()), and a
// dip counts from 1.

// Tells whether the part's dip had the same key as now; nothing if its key is not known.
std::optional<bool> isDippedAlike(const BuiltPart& part, int dip, const QStringList& dips);
// Returns `built` without the places of dips that had another key, or that the job no longer has.
// Keeps the places of parts whose keys are not known.
AsBuilt dippedAlike(AsBuilt built, const QStringList& dips);

// Numbers of parts with measured places on one dip's sheet.
struct BuiltPartCounts {
    int alike = 0;     // the dip had the same key as now
    int unknown = 0;   // the part's keys are not known
    int otherwise = 0; // the dip had another key: its errors say nothing about the next sheet
    bool operator==(const BuiltPartCounts&) const = default;
};
BuiltPartCounts countParts(const AsBuilt& built, int dip, const QStringList& dips);

} // namespace dipwright

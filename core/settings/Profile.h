// What is known of one printer, one film or one tank, measured once and used by every job.
//
// A profile is a value. A project keeps a copy of those it was made with, by name and content, so
// that an old job prints the same when the profile has since changed.
#pragma once

#include "base/Units.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/RenderingIntent.h"

#include <QByteArray>
#include <QString>
#include <array>
#include <optional>
#include <variant>

namespace dipwright {

struct PrinterProfile {
    QString name;
    QString queue;     // the system's name of the printer, or empty
    double scaleX = 1; // printed length over true length, measured across the page …
    double scaleY = 1; // … and along it; a sheet is drawn smaller by these
    // The page's left, top, right and bottom that the printer cannot reach.
    std::array<Millimetres, 4> margins{};
    QByteArray iccProfile; // the ICC file itself; empty: the printer is sent sRGB
    RenderingIntent intent = RenderingIntent::RelativeColorimetric;
    bool blackPoint = true; // compensated: the darkest dark stays distinct
    double inkLimit = 2;    // highest optical density, a channel
    DotsPerInch resolution{300};
    // Of the four inks of a CMYK profile together, full ink of one being 1; none: what it gives.
    std::optional<double> totalInk;
    bool operator==(const PrinterProfile&) const = default;
};

// Which edge of the sheet goes into the printer first: the film swells more along the web.
enum class FeedDirection { ShortEdgeFirst, LongEdgeFirst };

// Where a film's figures come from that photos of it on the water gave (core/inspection).
struct FilmMeasurement {
    QString date;                           // ISO, of the photos; empty: nothing was measured
    std::optional<double> waterTemperature; // °C
    QString photos;                         // their files' SHA-256, hexadecimal, a space between
    double residual = 0;                    // mm on the film, rms
    // What they gave, and how far the swell may be off at 95 %.
    double swellX = 0, swellY = 0;
    double swellOffX = 0, swellOffY = 0;
    std::optional<double> growthRate, growthLimit; // none: the photos did not tell
    std::optional<double> relaxationTime;          // s; photos of a dipped part tell it
    bool operator==(const FilmMeasurement&) const = default;
};

struct FilmProfile : FilmBehaviour {
    QString name;
    Millimetres width{210}, height{297};
    // None: as the project has them.
    std::optional<Degrees> overhang;
    std::optional<double> tearStretch;
    InkLaw ink; // how ink thins on it; tones were measured by a step wedge
    FeedDirection feed = FeedDirection::ShortEdgeFirst;
    Seconds soakTime{60};      // on the water before the activator
    Seconds activatorTime{10}; // from the activator to the dip
    // None: not known.
    std::optional<Seconds> flashTime;  // from the dip to the rinse
    std::optional<Seconds> dryingTime; // before the body is touched, or dipped again
    QString lot;
    QString expiry; // ISO date, or empty
    FilmMeasurement measured;
    bool operator==(const FilmProfile&) const = default;
};

struct TankProfile {
    QString name;
    Millimetres width{400}, length{600}; // of the water, along X and Z
    Millimetres waterLevel{0};           // under the tank's rim
    FilmEdges barriers;                  // sides of the film that barriers hold
    // Between the tank's marks along X and Z, for whoever lays the sheet; nothing is computed from
    // it. 0: none.
    std::array<Millimetres, 2> markDistance{};
    bool operator==(const TankProfile&) const = default;
};

using Profile = std::variant<PrinterProfile, FilmProfile, TankProfile>;
enum class ProfileKind { Printer, Film, Tank }; // in the order of Profile's alternatives

// The profiles that a project was made with.
struct ProjectProfiles {
    std::optional<PrinterProfile> printer;
    std::optional<FilmProfile> film;
    std::optional<TankProfile> tank;
    bool operator==(const ProjectProfiles&) const = default;
};

} // namespace dipwright

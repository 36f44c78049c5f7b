// Profiles of printers, films and tanks: measured once and used by every job.
//
// A profile is a value. A project keeps a copy of its profiles, with name and content. So an old
// job prints the same after a profile has changed.
#pragma once

#include "base/Units.h"
#include "settings/Costs.h"
#include "settings/FilmSettings.h"
#include "settings/InkSettings.h"
#include "settings/PdfTarget.h"
#include "settings/RenderingIntent.h"
#include "settings/UnknownKeys.h"

#include <QByteArray>
#include <QString>
#include <array>
#include <optional>
#include <variant>

namespace dipwright {

struct PrinterProfile {
    QString name;
    QString queue;     // the system's name for the printer, or empty
    double scaleX = 1; // printed length divided by true length, measured across the page
    double scaleY = 1; // the same along the page; sheets are divided by both factors
    // Unprintable margins of the page: left, top, right, bottom.
    std::array<Millimetres, 4> margins{};
    QByteArray iccProfile; // contents of the ICC file; empty: the printer gets sRGB
    RenderingIntent intent = RenderingIntent::RelativeColorimetric;
    bool blackPoint = true; // black point compensation: the darkest tones stay distinct
    KeptInks keptInks = KeptInks::None;
    // Contents of an ICC device link file from RGB (sRGB) or CMYK to the printer's CMYK. It
    // converts pictures of its kind in place of `iccProfile`, which stays the profile of the
    // printer's inks. Empty: none.
    QByteArray deviceLink;
    double inkLimit = 2; // highest optical density per channel
    DotsPerInch resolution{300};
    // Limit of total area coverage: the largest sum of the four inks at one place, with full ink of
    // one plate as 1. Only for a CMYK profile. None: the inks stay as the profile gives them.
    std::optional<double> totalInk;
    PdfTarget pdfTarget = PdfTarget::Ghostscript; // of PDF files in CMYK
    bool squarePixels = false;                    // TIFF files have one resolution in X and Y
    // Gap between sheets that are printed in one series on a roll, with cut marks. None: each sheet
    // is a page of its own.
    std::optional<Millimetres> rollGap;
    // Width of the loaded roll. None: as the printer's queue reports it.
    std::optional<Millimetres> rollWidth;
    InkCosts costs;
    UnknownKeys unknown = {};
    bool operator==(const PrinterProfile&) const = default;
};

// Which edge of the sheet enters the printer first. The film swells more along the web.
enum class FeedDirection { ShortEdgeFirst, LongEdgeFirst };

// A film's measurement, from photos of the floating film (core/inspection).
struct FilmMeasurement {
    QString date;                           // ISO date of the photos; empty: not measured
    std::optional<double> waterTemperature; // °C
    QString photos;      // SHA-256 of the photos' files, hexadecimal, separated by spaces
    double residual = 0; // rms error, mm on the film
    // The measured swell, and the errors of both values (95 %).
    double swellX = 0, swellY = 0;
    double swellErrorX = 0, swellErrorY = 0;
    std::optional<double> growthRate, growthLimit; // none: the photos did not determine them
    std::optional<double> relaxationTime;          // s; measured by photos of a dipped part
    bool operator==(const FilmMeasurement&) const = default;
};

struct FilmProfile : FilmBehaviour {
    QString name;
    Millimetres width{210}, height{297};
    // None: the project's value is used.
    std::optional<Degrees> overhang;
    std::optional<double> tearStretch;
    InkLaw ink; // how ink thins on this film; its tones were measured with a step wedge
    FeedDirection feed = FeedDirection::ShortEdgeFirst;
    Seconds soakTime{60};      // time on the water before the activator
    Seconds activatorTime{10}; // time from the activator to the dip
    // None: unknown.
    std::optional<Seconds> flashTime;  // time from the dip to the rinse
    std::optional<Seconds> dryingTime; // time before the body may be touched or dipped again
    QString lot;
    QString expiry; // ISO date, or empty
    FilmMeasurement measured;
    FilmCosts costs;
    UnknownKeys unknown = {};
    bool operator==(const FilmProfile&) const = default;
};

struct TankProfile {
    QString name;
    Millimetres width{400}, length{600}; // size of the water surface, along X and Z
    Millimetres waterLevel{0};           // depth of the water surface below the tank's rim
    FilmEdges barriers;                  // sides of the film that barriers hold
    // Limits of a dip; none: not known.
    std::optional<Millimetres> waterDepth; // from the water surface to the floor
    std::optional<Millimetres> reach; // how far the machine moves a part sideways from the middle
    std::optional<MillimetresPerSecond> speed; // of the machine's fastest motion
    std::optional<DegreesPerSecond> turnSpeed; // of the machine's fastest turn
    // Distances between the tank's marks along X and Z, for the person who lays the film. Nothing
    // is computed from them. 0: no marks.
    std::array<Millimetres, 2> markDistance{};
    WorkCosts costs;
    UnknownKeys unknown = {};
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

// Returns the profiles without prices, times of work and ways to write and print files, on which no
// sheet depends.
inline ProjectProfiles withoutCosts(ProjectProfiles profiles) {
    if (profiles.printer) {
        PrinterProfile& printer = *profiles.printer;
        printer.costs = {};
        printer.pdfTarget = {};
        printer.squarePixels = false;
        printer.rollGap.reset();
        printer.rollWidth.reset();
    }
    if (profiles.film) {
        profiles.film->costs = {};
    }
    if (profiles.tank) {
        profiles.tank->costs = {};
    }
    return profiles;
}

} // namespace dipwright

// The way of a dip for whoever, or whatever, moves the body.
#pragma once

#include "base/Units.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace dipwright {

// Heights are of the body's lowest point over the water, mm; negative is under it.
struct DipMotion {
    QString project, immersion, job; // names
    Millimetres park{50};            // where it waits, over the film
    Millimetres start{0.5};          // where the dip begins
    Millimetres depth{0};            // how far under water it ends
    MillimetresPerSecond speed{5};   // of the dip, and out
    MillimetresPerSecond approach{20};
    Seconds hold{5}; // under water

    Seconds dipTime() const { return Seconds((start + depth).value() / speed.value()); }
};

// A place of the way: straight lines at even speed join them.
struct MotionPoint {
    Seconds time; // from when it leaves where it waits
    Millimetres height;
    MillimetresPerSecond speed; // of the line that ends here, 0 where it waits
};
std::vector<MotionPoint> motionPoints(const DipMotion& motion);

// time_s, height_mm, speed_mm_s: a line a point, with a heading. Decimal points, LF.
QByteArray motionCsv(const DipMotion& motion);

// A template with its {names} filled in: project, immersion, job, park_mm, start_mm, depth_mm,
// speed_mm_s, speed_mm_min, approach_mm_min, dip_s, hold_s, hold_ms; hold_depth_mm and hold_mm_min:
// the hold as a slow move a little deeper and back, for controllers that are not of one mind about
// the unit of a dwell. Names lose their line ends and control characters, so that none of them can
// become a command. Throws Error for a name that there is not; `where` is what the user knows the
// template by.
QByteArray filledTemplate(const DipMotion& motion, const QString& text, const QString& where);

struct MotionTemplate {
    QString text, where;
};
// Of a file of up to 1 MiB. Throws Error where it cannot be read.
MotionTemplate motionTemplate(const QString& path);
// The user's own, motion.gcode in the folder for the program's data; without it the one that comes
// with the program: G-code for one linear axis. Throws Error where the user's cannot be read.
MotionTemplate motionTemplate();

} // namespace dipwright

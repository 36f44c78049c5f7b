// Returns the motion of one dip as points, as CSV and as a filled-in template, for the person or
// machine that moves the body.
#pragma once

#include "base/Units.h"

#include <QByteArray>
#include <QString>

#include <vector>

namespace dipwright {

// The motion of one dip. A height is the height of the body's lowest point above the water, in mm;
// it is negative below the water.
struct DipMotion {
    QString project, immersion, job; // names and number for the operator
    Millimetres park{50};            // height at which the body waits over the film
    Millimetres start{0.5};          // height at which the dip begins
    Millimetres depth{0};            // how far below the water the dip ends
    MillimetresPerSecond speed{5};   // speed of the dip and of lifting out
    MillimetresPerSecond approach{20};
    Seconds hold{5}; // time that the body stays under water

    Seconds dipTime() const { return Seconds((start + depth).value() / speed.value()); }
};

// One point of the motion. The body moves in straight lines at constant speed from point to point.
struct MotionPoint {
    Seconds time; // since the body left its waiting height
    Millimetres height;
    MillimetresPerSecond speed; // speed on the line that ends at this point; 0 while the body waits
};
// Returns the points of the motion in order of time.
std::vector<MotionPoint> motionPoints(const DipMotion& motion);

// Returns a CSV table: the heading time_s,height_mm,speed_mm_s and one line per point, with decimal
// points and LF line ends.
QByteArray motionCsv(const DipMotion& motion);

// Fills in the {names} of a template: project, immersion, job, park_mm, start_mm, depth_mm,
// speed_mm_s, speed_mm_min, approach_mm_min, dip_s, hold_s, hold_ms, hold_depth_mm and hold_mm_min.
// hold_depth_mm and hold_mm_min describe the hold as a slow move slightly deeper and back, because
// controllers use different units for a dwell. The values of project, immersion and job lose line
// ends and control characters, so that no name can become a command. Throws Error for an unknown
// name; `where` names the template for the user.
QByteArray filledTemplate(const DipMotion& motion, const QString& text, const QString& where);

struct MotionTemplate {
    QString text, where;
};
// Reads a template file of at most 1 MiB. Throws Error if it cannot be read.
MotionTemplate motionTemplate(const QString& path);
// Reads the user's own template, motion.gcode in the program's data folder. If there is none,
// returns the template that comes with the program: G-code for one linear axis. Throws Error if the
// user's file cannot be read.
MotionTemplate motionTemplate();

} // namespace dipwright

// Returns the motion of one dip as points, as CSV and as a filled-in template, for the person or
// machine that moves the body.
#pragma once

#include "base/Units.h"

#include <QByteArray>
#include <QString>

#include <Eigen/Geometry>

#include <vector>

namespace dipwright {

// A pose of a part that does not go straight down. The frame is that of a machine: X to the right,
// Y to the film's upper edge, Z up, from the film's centre on the water.
struct MotionPose {
    Seconds time;                        // since the dip began
    Eigen::Vector3d place{0, 0, 0};      // of the part's pivot (dip/BodyPath.h), mm
    Eigen::Quaterniond turn{1, 0, 0, 0}; // relative to the rotation at the end of the dip
};

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
    // The poses of the dip, the first at time 0; empty if the body goes straight down.
    std::vector<MotionPose> path = {};

    Seconds dipTime() const {
        return path.empty() ? Seconds((start + depth).value() / speed.value()) : path.back().time;
    }
};

// One point of the motion. The body moves in straight lines at constant speed from point to point.
struct MotionPoint {
    Seconds time; // since the body left its waiting height
    Millimetres height;
    MillimetresPerSecond speed; // speed on the line that ends at this point; 0 while the body waits
};
// Returns the points of the motion in order of time.
std::vector<MotionPoint> motionPoints(const DipMotion& motion);

// Returns the poses of a motion with a path in order of time, from the waiting height over the film
// to the same height after the dip. Times begin there.
std::vector<MotionPose> motionPoses(const DipMotion& motion);
// Returns the angles of each pose about fixed axes X, then Y, then Z, in degrees. From pose to pose
// they change as little as they can; without a turn at the end they end at 0.
std::vector<Eigen::Vector3d> motionAngles(const std::vector<MotionPose>& poses);

// Returns a CSV table with decimal points and LF line ends: the heading time_s,height_mm,speed_mm_s
// and one line per point; on a path, time_s,x_mm,y_mm,z_mm,a_deg,b_deg,c_deg and one line per pose,
// with the angles of motionAngles().
QByteArray motionCsv(const DipMotion& motion);

// Fills in the {names} of a template: project, immersion, job, park_mm, start_mm, depth_mm,
// speed_mm_s, speed_mm_min, approach_mm_min, dip_s, hold_s, hold_ms, hold_depth_mm, hold_mm_min,
// moves and moves_per_minute. hold_depth_mm and hold_mm_min describe the hold as a slow move
// slightly deeper and back, because controllers use different units for a dwell. The last two are
// the whole motion with a path as G1 lines for the axes X, Y, Z, A, B and C that move, with the
// feed in inverse time (G93) or per minute (G94). The values of project, immersion and job lose
// line ends and control characters, so that no name can become a command. Throws Error for an
// unknown name, and for a motion with a path if the template has neither of the last two names;
// `where` names the template for the user.
QByteArray filledTemplate(const DipMotion& motion, const QString& text, const QString& where);

struct MotionTemplate {
    QString text, where;
};
// Returns the template for paths of a controller, "linuxcnc", "grbl" or "marlin", or else reads a
// template file of at most 1 MiB. Throws Error if it cannot be read.
MotionTemplate motionTemplate(const QString& nameOrPath);
// Reads the user's own template, motion.gcode in the program's data folder. If there is none,
// returns the template that comes with the program: G-code for one linear axis or, for motions with
// a path, for LinuxCNC. Throws Error if the user's file cannot be read.
MotionTemplate standardMotionTemplate(const DipMotion& motion);

} // namespace dipwright

// The plate over a seat, as seen from above: its outline, holes and engraving. Pose frame, x and z.
#pragma once

#include "cradle/Cradle.h"

#include <QPainterPath>
#include <optional>

namespace dipwright {

using Outline = Eigen::AlignedBox2d;

struct PlateHole {
    Eigen::Vector2d centre;
    double radius = 0;
};

struct CradlePlate {
    Outline outline;
    double bottom = 0, top = 0;      // y
    std::vector<PlateHole> pinHoles; // through the plate
    std::optional<PlateHole> bore;   // through plate and seat
    // Cut into its top: an arrow to the film's upper edge, the sign of a way that leads down into
    // the plane, the immersion's number and the job. Empty: no room, or not wanted.
    QPainterPath engraving;

    double outside(const Eigen::Vector2d& place) const; // mm from the outline, negative within it
};

// For a seat that is seen from above within `footprint`, with a bore at `bore` where one is wanted.
CradlePlate cradlePlate(const HeldDip& dip, const CradleSettings& settings,
                        const Outline& footprint, const Eigen::Vector2d& bore);

// The distance to a path's outline, positive inside: asked often.
class EngravedArea {
public:
    explicit EngravedArea(const QPainterPath& path);
    // mm; anything below −1 is −1.
    double inside(const Eigen::Vector2d& place) const;

private:
    struct Line {
        Eigen::Vector2d from, to;
    };
    std::vector<Line> lines_;
    Outline box_;
};

} // namespace dipwright

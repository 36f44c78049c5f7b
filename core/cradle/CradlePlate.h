// Lays out the plate over a seat, seen from above: outline, holes and engraving. Positions are
// x and z in the pose frame, mm.
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
    // Engraved into the top: an arrow to the film's upper edge, the number of the dip and the job.
    // The symbol for an arrow that points into the plane shows the direction of the dip. Empty if
    // there is no room, or if engraving is switched off.
    QPainterPath engraving;

    // Returns the distance from the outline, mm; negative inside.
    double outside(const Eigen::Vector2d& place) const;
};

// Lays out the plate for a seat that lies within `footprint` seen from above. `bore` is the
// position of the bore, if the settings ask for one. Returns none if the part tilts so far on its
// path that no plate of reasonable height stays above the water.
std::optional<CradlePlate> cradlePlate(const HeldDip& dip, const CradleSettings& settings,
                                       const Outline& footprint, const Eigen::Vector2d& bore);

// Computes distances to the outline of a path, fast enough for many queries.
class EngravedArea {
public:
    explicit EngravedArea(const QPainterPath& path);
    // Returns the distance from the path's outline, mm: positive inside, negative outside, but
    // never below −1.
    double inside(const Eigen::Vector2d& place) const;

private:
    struct Line {
        Eigen::Vector2d from, to;
    };
    std::vector<Line> lines_;
    Outline box_;
};

} // namespace dipwright

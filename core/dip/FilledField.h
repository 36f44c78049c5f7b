// Makes the distance field for a solver. The field covers the body together with its air pockets,
// since both keep film away.
#pragma once

#include "dip/Pose.h"
#include "geometry/DistanceField.h"

namespace dipwright {

// A body's distance field in which every sample in an air pocket counts as inside. Film floats on
// the water under a pocket, at the pocket's level; the filled body has a flat face there. Only
// samples in the pockets, in the walls round them and below their levels differ from the body's own
// field. Outside the filled body, such samples are exact near the surface. In walls and air pockets
// they are first-order accurate in the cell size. A body without pockets keeps its own field.
class FilledField {
public:
    // `own` is the body's field in body coordinates. It must outlive this object if the body has
    // no pockets. Uses all cores; deterministic.
    FilledField(const PosedBody& body, const DistanceField& own);
    FilledField(const PosedBody& body, DistanceField&& own) = delete;

    const DistanceField& field() const { return filled_ ? *filled_ : own_; }

private:
    const DistanceField& own_;
    std::shared_ptr<const DistanceField> filled_; // null if there are no pockets
};

} // namespace dipwright

// The distance field that a solver is given: of the body and the air that it takes under water,
// which hold film off alike.
#pragma once

#include "dip/Pose.h"
#include "geometry/DistanceField.h"

namespace dipwright {

// The field of a body in whose air pockets every sample counts as inside. Film floats on the water
// under a pocket, at its level: there the filled body has a flat face. The samples are those of the
// body's own field but for those in the pockets, in the walls round them and below their levels;
// near the surface they are exact outside of the filled body and, in the walls and the air, of
// first order in the field's cells. A body without pockets keeps its own field.
class FilledField {
public:
    // `own`: of the body, in model coordinates; it must outlive this where there is no pocket. All
    // cores, deterministic.
    FilledField(const PosedBody& body, const DistanceField& own);
    FilledField(const PosedBody& body, DistanceField&& own) = delete;

    const DistanceField& field() const { return filled_ ? *filled_ : own_; }

private:
    const DistanceField& own_;
    std::shared_ptr<const DistanceField> filled_; // null where there is no pocket
};

} // namespace dipwright

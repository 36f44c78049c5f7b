// Which part of the body is in which zone, and whether it keeps its limit.
#pragma once

#include "accuracy/tolerance/Tolerances.h"
#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// A body with zones marked on it.
class ZonedBody {
public:
    explicit ZonedBody(std::shared_ptr<const TexturedMesh> model);

    // Only what is new is computed where the marks begin as those before do.
    void setMarks(const std::vector<ZoneMark>& marks);

    const RefinedMesh& mesh() const { return fine_; }         // toleranceMesh()
    const std::vector<Zone>& zones() const { return zones_; } // a triangle of it each
    Zone at(const SurfacePoint& place) const;                 // of the model

private:
    void obey(const ZoneMark& mark);
    void set(const std::vector<std::uint32_t>& triangles, Zone zone);

    std::shared_ptr<const TexturedMesh> model_;
    RefinedMesh fine_;
    SurfaceQuery query_; // of the fine mesh
    std::vector<ZoneMark> marks_;
    std::vector<Zone> zones_;
};

// A zone keeps its limit where this share of its painted area does.
inline constexpr double zoneShareWithin = 0.95;

struct ZoneVerdict {
    Zone zone = Zone::C;
    double limit = 0;     // mm
    double area = 0;      // mm² that are painted …
    double unpainted = 0; // … and that are not
    double within = 0;    // share of what is painted that keeps the limit, both together
    Spread spread;
    double together = 0; // mm that 95 % keep to of the spread and the numerical error, added up
    WorstPlace worst;
    Contributor contributor = Contributor::PositionX; // with the largest part in the zone
    bool holds() const { return within >= zoneShareWithin; }
};

// Of the zones that there are, A first. `dips`: of one body, each told at tolerancePlaces(); where
// several paint one, the worst counts. `numericalErrors`: of each dip at the same places, mm; empty
// where a dip's is not known.
std::vector<ZoneVerdict> zoneVerdicts(std::shared_ptr<const TexturedMesh> model,
                                      const std::vector<const DipTolerances*>& dips,
                                      const std::vector<std::vector<float>>& numericalErrors,
                                      const ToleranceSettings& settings);

// "A"
QString zoneName(Zone zone);
// For the user: "Zone A keeps its limit: …". `length` words a length given in mm.
QString zoneText(const ZoneVerdict& verdict, const std::function<QString(double)>& length);

} // namespace dipwright

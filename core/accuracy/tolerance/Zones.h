// Assigns the body's surface to zones A, B and C and tells whether each zone is within its limit.
#pragma once

#include "accuracy/tolerance/Tolerances.h"
#include "geometry/RefinedMesh.h"
#include "geometry/SurfaceQuery.h"
#include "marks/SurfaceMask.h"
#include "model/TexturedMesh.h"

namespace dipwright {

// A body with zones marked on it.
class ZonedBody {
public:
    explicit ZonedBody(std::shared_ptr<const TexturedMesh> model);

    // Replaces the marks. If the list begins with the old marks, only the added marks are computed.
    void setMarks(const std::vector<ZoneMark>& marks);

    const RefinedMesh& mesh() const { return fine_; }         // toleranceMesh()
    const std::vector<Zone>& zones() const { return zones_; } // zone of each triangle of mesh()
    Zone at(const SurfacePoint& place) const;                 // zone of a place of the model

private:
    void obey(const ZoneMark& mark);
    void set(const std::vector<std::uint32_t>& triangles, Zone zone);

    std::shared_ptr<const TexturedMesh> model_;
    RefinedMesh fine_;
    SurfaceQuery query_; // query of the fine mesh
    std::vector<ZoneMark> marks_;
    std::vector<Zone> zones_;
};

// Returns the body with these marks; null if there are none.
std::shared_ptr<const ZonedBody> markedZones(std::shared_ptr<const TexturedMesh> model,
                                             const std::vector<ZoneMark>& marks);

// A zone keeps its limit if at least this share of its painted area is within the limit.
inline constexpr double zoneShareWithin = 0.95;

// How well a zone keeps its limit.
struct ZoneVerdict {
    Zone zone = Zone::C;
    double limit = 0;     // mm
    double area = 0;      // painted area, mm²
    double unpainted = 0; // unpainted area, mm²
    double within = 0;   // share of painted area whose spread + numerical error is within the limit
    Spread spread;       // spread that handling causes, without the numerical error
    double together = 0; // mm: 95th percentile of spread + numerical error on the painted area
    WorstPlace worst;
    Contributor contributor = Contributor::PositionX; // the largest contributor in the zone
    bool holds() const { return within >= zoneShareWithin; }
};

// Returns the verdict on each existing zone, A first. `dips` are the tolerances of one body's dips;
// where several dips paint a place, the worst dip counts. `numericalErrors` holds each dip's
// numerical error at tolerancePlaces(), mm; empty for a dip whose error is not known. Buried
// places, and places under `mask`, which may be null, do not count.
std::vector<ZoneVerdict> zoneVerdicts(std::shared_ptr<const TexturedMesh> model,
                                      const std::vector<const DipTolerances*>& dips,
                                      const std::vector<std::vector<float>>& numericalErrors,
                                      const ToleranceSettings& settings,
                                      const SurfaceMask* mask = nullptr);

// Returns "A", "B" or "C".
QString zoneName(Zone zone);
// Returns a sentence for the user: "Zone A keeps its limit …". `length` formats mm.
QString zoneText(const ZoneVerdict& verdict, const std::function<QString(double)>& length);

} // namespace dipwright

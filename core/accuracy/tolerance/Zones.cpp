#include "accuracy/tolerance/Zones.h"

#include "base/NumberText.h"
#include "geometry/BuriedSurface.h"
#include "geometry/SurfaceSpot.h"
#include "marks/StrokeArea.h"
#include "model/NamedMaterials.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Tolerance)
};

QString percent(double share) {
    return numberText(100 * share, 1);
}

// Returns the dip with the largest spread at a place; none if no dip paints the place.
std::optional<std::size_t> worstDip(const std::vector<const DipTolerances*>& dips,
                                    std::size_t place) {
    std::optional<std::size_t> worst;
    float most = unpaintedPlace;
    for (std::size_t dip = 0; dip < dips.size(); ++dip) {
        if (dips[dip]->places[place] > most) {
            most = dips[dip]->places[place];
            worst = dip;
        }
    }
    return worst;
}

// Collects the errors at the places of a zone.
struct ZoneSum {
    std::vector<float> spread, together;
    std::size_t unpainted = 0, within = 0;
    std::array<double, contributorCount> shares{};
    WorstPlace worst;
    float most = unpaintedPlace;

    void add(const DipTolerances& dip, std::size_t place, float numericalError,
             const Eigen::Vector3f& at, double limit) {
        const float here = dip.places[place];
        spread.push_back(here);
        together.push_back(here + numericalError);
        within += double(together.back()) <= limit ? 1 : 0;
        for (std::size_t number = 0; here > 0 && number < dip.contributions.size(); ++number) {
            shares[std::size_t(dip.contributions[number].contributor)] +=
                double(dip.squares[number][place] / (here * here));
        }
        if (here > most) {
            most = here;
            worst = worstAt(dip, place, at);
        }
    }
};

} // namespace

ZonedBody::ZonedBody(std::shared_ptr<const TexturedMesh> model)
    : model_(std::move(model)), fine_(toleranceMesh(*model_)), query_(fine_.mesh()),
      zones_(fine_.mesh().triangles.size(), Zone::C) {}

void ZonedBody::setMarks(const std::vector<ZoneMark>& marks) {
    if (marks.size() < marks_.size() || !std::equal(marks_.begin(), marks_.end(), marks.begin())) {
        zones_.assign(zones_.size(), Zone::C);
        marks_.clear();
    }
    for (std::size_t number = marks_.size(); number < marks.size(); ++number) {
        obey(marks[number]);
    }
    marks_ = marks;
}

std::shared_ptr<const ZonedBody> markedZones(std::shared_ptr<const TexturedMesh> model,
                                             const std::vector<ZoneMark>& marks) {
    if (marks.empty()) {
        return nullptr;
    }
    auto zones = std::make_shared<ZonedBody>(std::move(model));
    zones->setMarks(marks);
    return zones;
}

void ZonedBody::obey(const ZoneMark& mark) {
    if (mark.extent == MarkExtent::Stroke) {
        set(trianglesOf(fine_.mesh(), StrokeArea(mark.path, mark.radius)), mark.zone);
        return;
    }
    const auto material = [&](std::uint32_t piece) {
        return model_->material[fine_.middle(piece).triangle];
    };
    const auto setMaterial = [&](std::size_t marked) {
        for (std::uint32_t piece = 0; piece < zones_.size(); ++piece) {
            zones_[piece] = material(piece) == marked ? mark.zone : zones_[piece];
        }
    };
    if (!mark.material.isEmpty()) {
        for (const std::size_t marked : materialsNamed(*model_, mark.material)) {
            setMaterial(marked);
        }
        return;
    }
    const SurfacePoint middle = query_.closest(modelPlace(mark.place)).point;
    if (!middle.isValid()) {
        return;
    }
    switch (mark.extent) {
    case MarkExtent::Spot:
        set(trianglesWithin(fine_.mesh(), middle, float(mark.radius.value())), mark.zone);
        break;
    case MarkExtent::Face:
        set(faceAround(fine_.mesh(), middle.triangle), mark.zone);
        break;
    case MarkExtent::Material:
        setMaterial(material(middle.triangle));
        break;
    case MarkExtent::Stroke:
        break; // see above
    }
}

void ZonedBody::set(const std::vector<std::uint32_t>& triangles, Zone zone) {
    for (const std::uint32_t triangle : triangles) {
        zones_[triangle] = zone;
    }
}

Zone ZonedBody::at(const SurfacePoint& place) const {
    return zones_[fine_.onFine(place).triangle];
}

std::vector<ZoneVerdict> zoneVerdicts(std::shared_ptr<const TexturedMesh> model,
                                      const std::vector<const DipTolerances*>& dips,
                                      const std::vector<std::vector<float>>& numericalErrors,
                                      const ToleranceSettings& settings, const SurfaceMask* mask) {
    const TriangleMesh& mesh = model->mesh;
    const std::vector<SurfacePoint> places = tolerancePlaces(*model);
    const std::vector<std::uint8_t> buried = buriedPlaces(mesh, places);
    ZonedBody zones(model);
    zones.setMarks(settings.marks);
    std::array<ZoneSum, zoneCount> sums;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (buried[place] != 0 || (mask && mask->covers(places[place]))) {
            continue;
        }
        const auto zone = std::size_t(zones.at(places[place]));
        if (const std::optional<std::size_t> dip = worstDip(dips, place)) {
            const std::vector<float>& errors = numericalErrors[*dip];
            sums[zone].add(*dips[*dip], place, errors.empty() ? 0 : errors[place],
                           position(mesh, places[place]), settings.limits[zone].value());
        } else {
            ++sums[zone].unpainted;
        }
    }
    const double area = surfaceArea(mesh) / double(std::max<std::size_t>(places.size(), 1));
    std::vector<ZoneVerdict> verdicts;
    for (std::size_t zone = 0; zone < zoneCount; ++zone) {
        ZoneSum& sum = sums[zone];
        const std::size_t painted = sum.spread.size();
        if (painted + sum.unpainted == 0) {
            continue;
        }
        ZoneVerdict verdict;
        verdict.zone = Zone(zone);
        verdict.limit = settings.limits[zone].value();
        verdict.area = area * double(painted);
        verdict.unpainted = area * double(sum.unpainted);
        verdict.within = painted > 0 ? double(sum.within) / double(painted) : 0;
        verdict.spread = spreadOf(std::move(sum.spread));
        verdict.together = spreadOf(std::move(sum.together)).percentile95;
        verdict.worst = sum.worst;
        const auto largest = std::max_element(sum.shares.begin(), sum.shares.end());
        verdict.contributor = contributorAt(std::size_t(largest - sum.shares.begin()));
        verdicts.push_back(verdict);
    }
    return verdicts;
}

QString zoneName(Zone zone) {
    return QString(QChar(u'A' + ushort(zone)));
}

QString zoneText(const ZoneVerdict& verdict, const std::function<QString(double)>& length) {
    if (verdict.area == 0) {
        return Text::tr("Zone %1 is not painted.").arg(zoneName(verdict.zone));
    }
    const QString text =
        verdict.holds() ? Text::tr("Zone %1 keeps its limit of ±%3: on %2 % of the painted area, "
                                   "the image is displaced by less than this limit, and on 95 % by "
                                   "±%4 or less. Largest contributor: %5.")
                        : Text::tr("Zone %1 exceeds its limit of ±%3: on only %2 % of the painted "
                                   "area, the image is displaced by less than this limit, and on "
                                   "95 % by ±%4 or less. Largest contributor: %5.");
    return text.arg(zoneName(verdict.zone), percent(verdict.within), length(verdict.limit),
                    length(verdict.together), contributorText(verdict.contributor));
}

} // namespace dipwright

#include "cradle/CradlePlate.h"

#include "dip/LaidFilm.h"
#include "dip/Pose.h"
#include "sheet/page/SheetLayout.h"

#include <QTransform>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {
namespace {

constexpr double outlineRadius = 6;   // radius of the plate's corners, mm
constexpr double engravingRim = 2;    // distance of the engraving from holes and edges, mm
constexpr double stroke = 1.6;        // width of engraved lines, mm
constexpr double jobHeight = 7;       // height of the job's letters, mm
constexpr double numberHeight = 13;   // height of the dip's number, mm
constexpr double farthestPlate = 200; // largest height of the plate above the body, on a path, mm

// Returns the outline of a text, centred at (0, 0).
QPainterPath lettering(const QString& text, double height) {
    QFont font = sheetFont(height);
    font.setBold(true);
    QPainterPath path;
    path.addText(0, 0, font, text);
    path = QTransform::fromScale(typeUnit, typeUnit).map(path);
    const QPointF middle = path.boundingRect().center();
    return path.translated(-middle).simplified();
}

// Returns an arrow to a bar that stands for the film's upper edge, which is at low z.
QPainterPath arrowToEdge() {
    QPainterPath path;
    path.addRect(QRectF(-7, -8, 14, stroke));
    path.addPolygon(
        QPolygonF({{0, -5}, {5, 2}, {1.2, 2}, {1.2, 8}, {-1.2, 8}, {-1.2, 2}, {-5, 2}, {0, -5}}));
    return path;
}

// Returns the symbol of an arrow that points away from the viewer: the direction of the dip.
QPainterPath signOfDip() {
    QPainterPath ring, hole, cross;
    ring.addEllipse(QPointF(0, 0), 7, 7);
    hole.addEllipse(QPointF(0, 0), 7 - stroke, 7 - stroke);
    cross.addRect(QRectF(-6.5, -stroke / 2, 13, stroke));
    cross = QTransform().rotate(45).map(cross).united(QTransform().rotate(-45).map(cross));
    return ring.subtracted(hole).united(cross);
}

QPainterPath engravingOf(const HeldDip& dip) {
    QPainterPath path;
    path.addPath(lettering(QString::number(dip.number), numberHeight).translated(-20, 0));
    path.addPath(arrowToEdge());
    path.addPath(signOfDip().translated(20, 0));
    path.addPath(lettering(dip.jobHash, jobHeight).translated(0, 15));
    return path.translated(-path.boundingRect().center());
}

bool isFree(const CradlePlate& plate, const QRectF& box) {
    const QRectF wide = box.adjusted(-engravingRim, -engravingRim, engravingRim, engravingRim);
    const Eigen::AlignedBox2d area(Eigen::Vector2d(wide.left(), wide.top()),
                                   Eigen::Vector2d(wide.right(), wide.bottom()));
    const auto isFarFrom = [&](const PlateHole& hole) {
        return area.exteriorDistance(hole.centre) > hole.radius;
    };
    return plate.outline.contains(area) &&
           std::all_of(plate.pinHoles.begin(), plate.pinHoles.end(), isFarFrom) &&
           (!plate.bore || isFarFrom(*plate.bore));
}

// Returns places spread over the plate, starting from the middle.
std::vector<Eigen::Vector2d> placesOn(const Outline& outline) {
    constexpr int steps = 16;
    std::vector<Eigen::Vector2d> places;
    for (int row = 0; row <= steps; ++row) {
        for (int column = 0; column <= steps; ++column) {
            const Eigen::Array2d share(double(column) / steps, double(row) / steps);
            places.push_back(outline.min() + (share * outline.sizes().array()).matrix());
        }
    }
    std::stable_sort(places.begin(), places.end(), [&](const auto& a, const auto& b) {
        return (a - outline.center()).squaredNorm() < (b - outline.center()).squaredNorm();
    });
    return places;
}

QPainterPath placed(const CradlePlate& plate, const QPainterPath& engraving) {
    const std::vector<Eigen::Vector2d> places = placesOn(plate.outline);
    for (const double scale : {1.0, 0.85, 0.7}) {
        const QPainterPath path = QTransform::fromScale(scale, scale).map(engraving);
        for (const Eigen::Vector2d& place : places) {
            if (isFree(plate, path.boundingRect().translated(place.x(), place.y()))) {
                return path.translated(place.x(), place.y());
            }
        }
    }
    return {};
}

// Returns the y at which the lower side of the plate stays `standoff` above the water in all
// moments of the dip; none if the plate would have to be more than farthestPlate above the body.
std::optional<double> bottomOverWater(const PosedBody& body, const ProcessSettings& process,
                                      const Outline& outline, double standoff) {
    if (body.path.isStraightDown()) {
        return dipDepth(process, body) + standoff;
    }
    double bottom = -std::numeric_limits<double>::infinity();
    for (const PathMoment& moment : momentsOf(body.path, shadowStep(body.mesh))) {
        const Eigen::RowVector3d up = moment.poseToWorld.linear().row(1);
        if (up.y() <= 0) {
            return std::nullopt; // the plate hangs upside down
        }
        for (const double x : {outline.min().x(), outline.max().x()}) {
            for (const double z : {outline.min().y(), outline.max().y()}) {
                const double rest =
                    standoff - moment.poseToWorld.translation().y() - up.x() * x - up.z() * z;
                bottom = std::max(bottom, rest / up.y());
            }
        }
    }
    return bottom > body.height + farthestPlate ? std::nullopt : std::optional(bottom);
}

} // namespace

double CradlePlate::outside(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d beyond = (place - outline.center()).cwiseAbs() - outline.sizes() / 2 +
                                   Eigen::Vector2d::Constant(outlineRadius);
    return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0) - outlineRadius;
}

std::optional<CradlePlate> cradlePlate(const HeldDip& dip, const CradleSettings& settings,
                                       const Outline& footprint, const Eigen::Vector2d& bore) {
    CradlePlate plate;
    const double radius = settings.pinDiameter.value() / 2 + settings.pinClearance.value();
    const double rim = radius + 2 * settings.wall.value();
    plate.outline = {footprint.min() - Eigen::Vector2d::Constant(settings.wall.value()),
                     footprint.max() + Eigen::Vector2d::Constant(settings.wall.value())};
    const Eigen::Vector2d offset(dip.immersion.offset[0].value(), dip.immersion.offset[1].value());
    for (const Eigen::Vector2d& pin : dip.pins.pins) {
        const Eigen::Vector2d centre = pin - offset;
        plate.pinHoles.push_back({centre, radius});
        plate.outline.extend(centre - Eigen::Vector2d::Constant(rim));
        plate.outline.extend(centre + Eigen::Vector2d::Constant(rim));
    }
    const PosedBody& body = dip.film.body();
    const double standoff = settings.standoff.value();
    const auto overWater = bottomOverWater(body, dip.process, plate.outline, standoff);
    if (!overWater) {
        return std::nullopt;
    }
    plate.bottom = std::max(body.height + settings.wall.value() + standoff, *overWater);
    plate.top = plate.bottom + settings.plateThickness.value();
    if (settings.bore.value() > 0) {
        plate.bore = PlateHole{bore, settings.bore.value() / 2};
    }
    if (settings.engravingDepth.value() > 0) {
        plate.engraving = placed(plate, engravingOf(dip));
    }
    return plate;
}

EngravedArea::EngravedArea(const QPainterPath& path) {
    // Map to a larger scale first, because Qt cuts curves into lines at the scale of the result.
    constexpr double scale = 20;
    for (const QPolygonF& polygon : path.toSubpathPolygons(QTransform::fromScale(scale, scale))) {
        for (qsizetype i = 0; i < polygon.size(); ++i) {
            const QPointF a = polygon[i] / scale, b = polygon[(i + 1) % polygon.size()] / scale;
            if (a != b) {
                lines_.push_back({{a.x(), a.y()}, {b.x(), b.y()}});
                box_.extend(lines_.back().from);
            }
        }
    }
}

double EngravedArea::inside(const Eigen::Vector2d& place) const {
    if (lines_.empty() || box_.exteriorDistance(place) >= 1) {
        return -1;
    }
    double nearest = 1; // squared distance to the nearest line
    bool isInside = false;
    for (const Line& line : lines_) {
        const Eigen::Vector2d along = line.to - line.from, there = place - line.from;
        const double share = std::clamp(there.dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (there - share * along).squaredNorm());
        if ((line.from.y() > place.y()) != (line.to.y() > place.y()) &&
            there.x() < along.x() * there.y() / along.y()) {
            isInside = !isInside;
        }
    }
    return isInside ? std::sqrt(nearest) : -std::sqrt(nearest);
}

} // namespace dipwright

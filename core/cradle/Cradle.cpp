#include "cradle/Cradle.h"

#include "base/NumberText.h"
#include "cradle/CradleForm.h"
#include "cradle/FormSurface.h"
#include "cradle/ReducedSurface.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

constexpr double steadyTilt = 5;     // degrees of plate tilt that the body must withstand
constexpr double steadySlope = 20;   // degrees; a side hold this steep stops the body from sliding
constexpr double reachGrowth = 1.25; // factor on the reach from one trial to the next
constexpr double pieceEdgeInCells = 2; // longest edge of a surface piece, in cells
// Largest number of samples of the form's grid; above it, the grid is made coarser.
constexpr double mostSamples = 24e6;
// How far the surface may move when its triangles are reduced, mm. A 3D printer is less exact.
constexpr double mostMoved = 0.02;

std::vector<SeatPiece> above(const std::vector<SeatPiece>& seat, double lowest) {
    std::vector<SeatPiece> result;
    std::copy_if(seat.begin(), seat.end(), std::back_inserter(result),
                 [&](const SeatPiece& piece) { return piece.place.y() >= lowest; });
    return result;
}

// Returns the y down to which the cradle reaches, which is only as far as needed to hold the body.
double lowestOf(const std::vector<SeatPiece>& seat, const PosedBody& body, double reach) {
    const Eigen::Vector3d centre = centreOfVolume(body.mesh);
    double best = body.height - reach, bestTilt = -180;
    bool isSteady = false;
    for (; reach < reachGrowth * body.height; reach *= reachGrowth) {
        const double lowest = body.height - reach;
        const CradleStability standing = standingOn(above(seat, lowest), centre);
        if (standing.tiltDegrees >= steadyTilt && standing.sideHoldDegrees >= steadySlope) {
            return lowest;
        }
        if (!isSteady && standing.tiltDegrees > bestTilt) {
            best = lowest;
            bestTilt = standing.tiltDegrees;
            isSteady = standing.tiltDegrees >= steadyTilt;
        }
    }
    return best;
}

CradleDistances distancesOf(const CradleSettings& settings) {
    CradleDistances result;
    result.body = settings.clearance.value();
    const double padding = settings.onPaint ? settings.padding.value() : 0;
    result.outer = result.body + padding + settings.wall.value();
    result.film = std::max(settings.paintDistance.value(), result.outer);
    result.earlierPaint = settings.onPaint ? result.body + padding : result.film;
    return result;
}

Outline footprintOf(const std::vector<SeatPiece>& seat, double outer) {
    Outline result;
    for (const SeatPiece& piece : seat) {
        result.extend(Eigen::Vector2d(piece.place.x(), piece.place.z()));
    }
    return {result.min() - Eigen::Vector2d::Constant(outer),
            result.max() + Eigen::Vector2d::Constant(outer)};
}

// Returns the place of the seat that is nearest to the body's centre, seen from above.
Eigen::Vector2d boreOf(const std::vector<SeatPiece>& seat, const Eigen::Vector3d& centre) {
    const auto aside = [&](const SeatPiece& piece) {
        return std::hypot(piece.place.x() - centre.x(), piece.place.z() - centre.z());
    };
    const auto nearest =
        std::min_element(seat.begin(), seat.end(), [&](const SeatPiece& a, const SeatPiece& b) {
            return aside(a) < aside(b);
        });
    return {nearest->place.x(), nearest->place.z()};
}

Eigen::Isometry3d toPrinter(const CradlePlate& plate) {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    result.translation() =
        Eigen::Vector3d(-plate.outline.min().x(), -plate.outline.min().y(), plate.top);
    return result;
}

// Returns how many parts of the body surely do not touch each other: the boxes round them do not
// meet. Parts on a jig have separate boxes in the model's frame.
std::size_t looseParts(const PosedBody& body) {
    const TriangleMesh mesh = transformed(body.mesh, body.modelToPose.inverse());
    const auto opposite = oppositeEdges(mesh);
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    std::vector<BoundingBox> boxes;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        BoundingBox box;
        for (const std::uint32_t triangle : connectedTriangles(
                 opposite, start, [](std::uint32_t) { return true; }, seen)) {
            for (const Eigen::Vector3f& corner : cornersOf(mesh, triangle)) {
                box.extend(corner);
            }
        }
        const auto meets = [&](const BoundingBox& other) { return other.intersects(box); };
        for (auto met = boxes.begin();
             (met = std::find_if(boxes.begin(), boxes.end(), meets)) != boxes.end();) {
            box.extend(*met);
            boxes.erase(met);
        }
        if (!box.isEmpty()) {
            boxes.push_back(box);
        }
    }
    return boxes.size();
}

QStringList notesOn(const Cradle& cradle, const HeldDip& dip, const CradleSettings& settings,
                    const CradlePlate& plate) {
    QStringList notes;
    const CradleCheck& check = cradle.check;
    const QString& name = dip.immersion.name;
    if (const std::size_t parts = looseParts(dip.film.body()); parts > 1) {
        notes << Text::tr("%1: the model has %2 separate parts, but the cradle has one bore, which "
                          "can fasten only one of them; give each part its own holder")
                     .arg(name)
                     .arg(parts);
    }
    if (check.standing.tiltDegrees < steadyTilt) {
        notes << Text::tr("%1: the part tips out of its cradle unless it is fastened, because the "
                          "cradle cannot hold it on all sides of its centre of mass. Fasten the "
                          "part through the bore in the cradle, or turn the part")
                     .arg(name);
    }
    if (check.standing.sideHoldDegrees < steadySlope) {
        notes << Text::tr("%1: the part can slide sideways in its cradle, because its dry surface "
                          "is too flat; mark its position and fix it there")
                     .arg(name);
    }
    if (check.paddedArea > 0) {
        notes << Text::tr("%1: the cradle touches %2 mm² of paint from an earlier dip; line the "
                          "cradle there with %3 mm of soft felt or foam")
                     .arg(name, numberText(check.paddedArea, 0),
                          numberText(settings.padding.value(), 1));
    }
    if (plate.engraving.isEmpty() && settings.engravingDepth.value() > 0) {
        notes << Text::tr("%1: the cradle's plate has no room for the engraving; write the arrow, "
                          "the dip number and the job on it")
                     .arg(name);
    }
    return notes;
}

Cradle nothingToHold(const HeldDip& dip, const CradleSettings& settings, const FilmSide& side) {
    Cradle result;
    const bool byPaint = !side.earlierPaint.triangles.empty() && !settings.onPaint;
    result.notes << (byPaint
                         ? Text::tr("%1: no cradle is possible, because an earlier dip has painted "
                                    "every place that could hold the part; allow padded contact "
                                    "with paint (cradle.on_paint), or turn the part")
                               .arg(dip.immersion.name)
                         : Text::tr(
                               "%1: no cradle is possible, because the film reaches every place "
                               "that could hold the part; dip it less deep, or turn the part")
                               .arg(dip.immersion.name));
    return result;
}

Cradle boredAway(const HeldDip& dip) {
    Cradle result;
    result.notes << Text::tr("%1: no cradle is possible, because the bore is wider than the place "
                             "where the part rests; choose a smaller bore (cradle.bore_mm)")
                        .arg(dip.immersion.name);
    return result;
}

Cradle touchesWater(const HeldDip& dip) {
    Cradle result;
    result.notes << Text::tr("%1: no cradle is possible, because on this path it would touch the "
                             "film on the water; tilt or roll the part less, dip it less deep, or "
                             "hold it by hand")
                        .arg(dip.immersion.name);
    return result;
}

} // namespace

Cradle makeCradle(const HeldDip& dip, const CradleSettings& settings, const Progress& progress) {
    const PosedBody& body = dip.film.body();
    const Eigen::Vector3d centre = centreOfVolume(body.mesh);
    CradleDistances distances = distancesOf(settings);
    const auto paintDistance =
        settings.onPaint ? std::nullopt : std::optional<double>(distances.earlierPaint);
    const FilmSide side = filmSide(dip.film, dip.earlier, dip.mask, dip.process,
                                   pieceEdgeInCells * settings.cell.value(), distances.film,
                                   paintDistance, progress.part(0, 0.15));
    if (side.seat.empty()) {
        return nothingToHold(dip, settings, side);
    }
    distances.lowest = lowestOf(side.seat, body, settings.reach.value());
    const std::vector<SeatPiece> seat = above(side.seat, distances.lowest);
    if (seat.empty()) {
        return nothingToHold(dip, settings, side);
    }
    const std::optional<CradlePlate> laidOut =
        cradlePlate(dip, settings, footprintOf(seat, distances.outer), boreOf(seat, centre));
    if (!laidOut) {
        return touchesWater(dip);
    }
    const CradlePlate& plate = *laidOut;

    Cradle result;
    result.clearance = distances.body;
    const double samples = formSamples(plate, distances.lowest, settings.cell.value());
    result.cell = settings.cell.value() * std::max(1.0, std::cbrt(samples / mostSamples));
    const DistanceField form =
        cradleForm(dip, settings, side, plate, distances, result.cell, progress.part(0.15, 0.6));
    progress(0.6, Text::tr("Forming the cradle"));
    const TriangleMesh surface = formSurface(form);
    if (!body.path.isStraightDown() &&
        touchesFilmOnPath(surface, body.mesh, body.query, body.path)) {
        return touchesWater(dip);
    }
    result.mesh = reducedSurface(surface, mostMoved, result.cell, progress.part(0.65, 0.8)).mesh;
    result.poseToPrinter = toPrinter(plate);
    TriangleMesh untouched = side.film;
    if (!settings.onPaint) {
        const auto first = std::uint32_t(untouched.positions.size());
        untouched.positions.insert(untouched.positions.end(), side.earlierPaint.positions.begin(),
                                   side.earlierPaint.positions.end());
        for (const auto& [a, b, c] : side.earlierPaint.triangles) {
            untouched.triangles.push_back({a + first, b + first, c + first});
        }
    }
    const std::optional<SurfaceQuery> painted =
        untouched.triangles.empty() ? std::nullopt : std::optional<SurfaceQuery>(untouched);
    result.check =
        checkCradle(result.mesh, body.mesh, body.query, painted ? &*painted : nullptr, seat,
                    distances.body + result.cell, settings.padding.value(), progress.part(0.8, 1));
    if (result.check.seatArea <= 0) {
        return boredAway(dip);
    }
    result.notes = notesOn(result, dip, settings, plate);
    return result;
}

} // namespace dipwright

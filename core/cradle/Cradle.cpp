#include "cradle/Cradle.h"

#include "cradle/CradleForm.h"
#include "cradle/FormSurface.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

constexpr double steadyTilt = 5;     // degrees that a plate can be tilted without the body falling
constexpr double steadySlope = 20;   // degrees, of a side hold that a body does not slide over
constexpr double reachGrowth = 1.25; // from one trial to the next
constexpr double piecesPerCell = 2;  // cells that a piece of the surface is long
constexpr double mostSamples = 24e6; // of the form; a coarser grid past them

std::vector<SeatPiece> above(const std::vector<SeatPiece>& seat, double lowest) {
    std::vector<SeatPiece> result;
    std::copy_if(seat.begin(), seat.end(), std::back_inserter(result),
                 [&](const SeatPiece& piece) { return piece.place.y() >= lowest; });
    return result;
}

// How far down a cradle reaches: as little as it can and hold the body.
double lowestOf(const std::vector<SeatPiece>& seat, const PosedBody& body, double reach) {
    const Eigen::Vector3d centre = centreOfVolume(body.mesh);
    double best = body.height - reach, bestTilt = -180;
    bool isSteady = false;
    for (; reach < reachGrowth * body.height; reach *= reachGrowth) {
        const double lowest = body.height - reach;
        const Standing standing = standingOn(above(seat, lowest), centre);
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

// Of the seat, the place that is nearest to under the body's middle.
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

QString number(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

QStringList notesOn(const Cradle& cradle, const HeldDip& dip, const CradleSettings& settings,
                    const CradlePlate& plate) {
    QStringList notes;
    const CradleCheck& check = cradle.check;
    const QString& name = dip.immersion.name;
    if (check.standing.tiltDegrees < steadyTilt) {
        notes << Text::tr(
                     "%1: the body tips out of its cradle where it is not fixed; what stays dry "
                     "does not lie on all sides of its middle. Fix it through the bore, or turn "
                     "the pose")
                     .arg(name);
    }
    if (check.standing.sideHoldDegrees < steadySlope) {
        notes << Text::tr(
                     "%1: nothing keeps the body from sliding sideways in its cradle, for what "
                     "stays dry is flat; mark its place and fix it there")
                     .arg(name);
    }
    if (check.paddedArea > 0) {
        notes << Text::tr("%1: the cradle lies on %2 mm² of paint of an earlier dip; line it there "
                          "with %3 mm of soft felt or foam")
                     .arg(name, number(check.paddedArea, 0), number(settings.padding.value(), 1));
    }
    if (plate.engraving.isEmpty() && settings.engravingDepth.value() > 0) {
        notes << Text::tr("%1: the cradle's plate has no room for arrow and job; write them on it")
                     .arg(name);
    }
    return notes;
}

Cradle nothingToHold(const HeldDip& dip, const CradleSettings& settings, const FilmSide& side) {
    Cradle result;
    const bool byPaint = !side.earlierPaint.triangles.empty() && !settings.onPaint;
    result.notes << (byPaint
                         ? Text::tr("%1: there is no cradle, for all that could hold the body is "
                                    "painted by an earlier dip; allow it with cradle.on_paint, "
                                    "through padding, or turn the pose")
                               .arg(dip.immersion.name)
                         : Text::tr("%1: there is no cradle, for the film reaches all that could "
                                    "hold the body; dip it less deep or turn the pose")
                               .arg(dip.immersion.name));
    return result;
}

} // namespace

Cradle makeCradle(const HeldDip& dip, const CradleSettings& settings, const Progress& progress) {
    const PosedBody& body = dip.film.body();
    const Eigen::Vector3d centre = centreOfVolume(body.mesh);
    CradleDistances distances = distancesOf(settings);
    const auto paintDistance =
        settings.onPaint ? std::nullopt : std::optional<double>(distances.earlierPaint);
    const FilmSide side =
        filmSide(dip.film, dip.earlier, dip.process, piecesPerCell * settings.cell.value(),
                 distances.film, paintDistance, progress.part(0, 0.15));
    if (side.seat.empty()) {
        return nothingToHold(dip, settings, side);
    }
    distances.lowest = lowestOf(side.seat, body, settings.reach.value());
    const std::vector<SeatPiece> seat = above(side.seat, distances.lowest);
    if (seat.empty()) {
        return nothingToHold(dip, settings, side);
    }
    const CradlePlate plate =
        cradlePlate(dip, settings, footprintOf(seat, distances.outer), boreOf(seat, centre));

    Cradle result;
    result.clearance = distances.body;
    const double samples = formSamples(plate, distances.lowest, settings.cell.value());
    result.cell = settings.cell.value() * std::max(1.0, std::cbrt(samples / mostSamples));
    const DistanceField form =
        cradleForm(dip, settings, side, plate, distances, result.cell, progress.part(0.15, 0.6));
    progress(0.6, Text::tr("Forming the cradle"));
    result.mesh = formSurface(form);
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
                    distances.body + result.cell, settings.padding.value(), progress.part(0.7, 1));
    result.notes = notesOn(result, dip, settings, plate);
    return result;
}

} // namespace dipwright

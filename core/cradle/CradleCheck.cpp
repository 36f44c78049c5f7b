#include "cradle/CradleCheck.h"

#include "base/Units.h"
#include "dip/BodyPath.h"
#include "geometry/SurfaceSamples.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

constexpr double leastSupport = 0.5; // smallest y of the normal of a place that carries the body
constexpr int directions = 24;       // horizontal directions in which sliding is checked
constexpr double samplesOfBody = 100'000;
constexpr double samplesOfCradle = 300'000;
constexpr std::size_t cradleCorners = 20'000; // number of corners checked on a path

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d level(const Eigen::Vector3d& place) {
    return {place.x(), place.z()};
}

// Returns the convex hull of places seen from above, in order (Andrew's monotone chain).
std::vector<Eigen::Vector3d> hullFromAbove(std::vector<Eigen::Vector3d> places) {
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) {
        return std::pair(a.x(), a.z()) < std::pair(b.x(), b.z());
    });
    std::vector<Eigen::Vector3d> hull;
    const auto add = [&](const Eigen::Vector3d& place, std::size_t least) {
        while (hull.size() >= least + 2 &&
               cross(level(hull.back() - hull[hull.size() - 2]), level(place - hull.back())) <= 0) {
            hull.pop_back();
        }
        hull.push_back(place);
    };
    for (const Eigen::Vector3d& place : places) {
        add(place, 0);
    }
    const std::size_t lower = hull.size() - 1;
    for (auto place = places.rbegin() + 1; place < places.rend(); ++place) {
        add(*place, lower);
    }
    hull.pop_back();
    return hull;
}

double tiltDegrees(const std::vector<SeatPiece>& seat, const Eigen::Vector3d& centre) {
    std::vector<Eigen::Vector3d> supports;
    for (const SeatPiece& piece : seat) {
        if (piece.normal.y() >= leastSupport) {
            supports.push_back(piece.place);
        }
    }
    if (supports.size() < 3) {
        return -90;
    }
    const std::vector<Eigen::Vector3d> hull = hullFromAbove(std::move(supports));
    double least = 180;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Eigen::Vector3d& from = hull[i];
        const Eigen::Vector3d& to = hull[(i + 1) % hull.size()];
        const Eigen::Vector2d along = level(to - from);
        const double inside = cross(along, level(centre - from)) / along.norm();
        // The cradle stands upside down on a table. There the body's centre is as far above this
        // edge as it is below the edge in the pose frame.
        const double height = (from.y() + to.y()) / 2 - centre.y();
        least = std::min(least, std::atan2(inside, std::abs(height)) * 180 / pi);
    }
    return hull.size() < 3 ? -90 : least;
}

double sideHoldDegrees(const std::vector<SeatPiece>& seat) {
    double least = 90;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * pi * i / directions;
        const Eigen::Vector2d aside(std::cos(angle), std::sin(angle));
        double steepest = 0;
        for (const SeatPiece& piece : seat) {
            const double slope =
                std::atan2(level(piece.normal).dot(aside), std::max(piece.normal.y(), 0.0));
            steepest = std::max(steepest, slope * 180 / pi);
        }
        least = std::min(least, steepest);
    }
    return least;
}

// Whether the triangles round each position form one ring.
bool hasOneRingRoundEach(const TriangleMesh& mesh, const std::vector<std::uint32_t>& opposite) {
    std::vector<std::uint32_t> corners(mesh.positions.size(), 0);
    std::vector<std::uint32_t> first(mesh.positions.size(), noEdge);
    for (std::uint32_t edge = 0; edge < opposite.size(); ++edge) {
        const std::uint32_t at = mesh.triangles[edge / 3][edge % 3];
        ++corners[at];
        first[at] = edge;
    }
    for (std::size_t at = 0; at < corners.size(); ++at) {
        if (corners[at] == 0) {
            continue;
        }
        std::uint32_t count = 0, edge = first[at];
        do { // cross the edge that leads to the position, to the next triangle
            ++count;
            edge = opposite[edge - edge % 3 + (edge + 2) % 3];
        } while (edge != first[at] && count <= corners[at]);
        if (count != corners[at]) {
            return false;
        }
    }
    return true;
}

int partsOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& opposite) {
    std::vector<std::uint8_t> seen(mesh.triangles.size());
    int parts = 0;
    for (std::uint32_t start = 0; start < seen.size(); ++start) {
        if (seen[start] == 0) {
            ++parts;
            connectedTriangles(
                opposite, start, [](std::uint32_t) { return true; }, seen);
        }
    }
    return parts;
}

// Returns the smallest one(i) for 0 ≤ i < count.
template <typename One>
double leastOf(std::size_t count, const One& one) {
    std::vector<double> values(count, std::numeric_limits<double>::infinity());
    parallelFor(std::size_t(0), count, [&](std::size_t i) { values[i] = one(i); });
    return count == 0 ? std::numeric_limits<double>::infinity()
                      : *std::min_element(values.begin(), values.end());
}

// Returns the corners of a surface, and about `count` points spread evenly over it.
std::vector<Eigen::Vector3f> samplesOf(const TriangleMesh& surface, double count) {
    std::vector<Eigen::Vector3f> places = surface.positions;
    for (const SurfacePoint& sample : evenSamples(surface, surfaceArea(surface) / count)) {
        places.push_back(position(surface, sample));
    }
    return places;
}

double signedDistance(const SurfaceQuery& query, const Eigen::Vector3f& place, double within) {
    const double distance = query.closest(place).distance;
    return distance < within && query.isInside(place) ? -distance : distance;
}

bool meetsNothing(const SurfaceQuery& query, const std::vector<Eigen::Vector3f>& places,
                  const Eigen::Vector3f& direction) {
    return leastOf(places.size(), [&](std::size_t i) {
               return query.hit(places[i], direction).point.isValid() ? -1.0 : 1.0;
           }) > 0;
}

// Returns the pieces of the seat that lie on the cradle.
std::vector<SeatPiece> lyingOn(const SurfaceQuery& cradle, const std::vector<SeatPiece>& seat,
                               double nearest, double padding) {
    std::vector<char> lies(seat.size(), 0);
    parallelFor(std::size_t(0), seat.size(), [&](std::size_t i) {
        const double within = nearest + (seat[i].isPadded ? padding : 0);
        lies[i] = cradle.closest(seat[i].place.cast<float>(), float(within)).point.isValid();
    });
    std::vector<SeatPiece> result;
    for (std::size_t i = 0; i < seat.size(); ++i) {
        if (lies[i]) {
            result.push_back(seat[i]);
        }
    }
    return result;
}

} // namespace

bool isClosedSurface(const TriangleMesh& mesh) {
    return isClosed(mesh) && hasOneRingRoundEach(mesh, oppositeEdges(mesh));
}

Eigen::Vector3d centreOfVolume(const TriangleMesh& body) {
    const Eigen::Vector3d origin = boundingBox(body).center().cast<double>();
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double sixfold = 0;
    for (const auto& triangle : body.triangles) {
        const Eigen::Vector3d a = body.positions[triangle[0]].cast<double>() - origin,
                              b = body.positions[triangle[1]].cast<double>() - origin,
                              c = body.positions[triangle[2]].cast<double>() - origin;
        const double part = a.dot(b.cross(c));
        sixfold += part;
        sum += part * (a + b + c) / 4;
    }
    return sixfold == 0 ? origin : (origin + sum / sixfold).eval();
}

CradleStability standingOn(const std::vector<SeatPiece>& seat, const Eigen::Vector3d& centre) {
    return {tiltDegrees(seat, centre), sideHoldDegrees(seat)};
}

bool touchesFilmOnPath(const TriangleMesh& cradle, const TriangleMesh& body,
                       const SurfaceQuery& bodyQuery, const solver::BodyPath& path) {
    const std::vector<PathMoment> moments = momentsOf(path, shadowStep(body));
    const std::size_t step = std::max<std::size_t>(cradle.positions.size() / cradleCorners, 1);
    const std::size_t count = (cradle.positions.size() + step - 1) / step;
    return leastOf(count, [&](std::size_t i) {
               const Eigen::Vector3f& corner = cradle.positions[i * step];
               for (const PathMoment& moment : moments) {
                   const Eigen::Vector3f down =
                       -moment.poseToWorld.linear().row(1).transpose().cast<float>();
                   if ((moment.poseToWorld * corner.cast<double>()).y() <= 0 &&
                       !bodyQuery.hit(corner, down).point.isValid()) {
                       return -1.0;
                   }
               }
               return 1.0;
           }) < 0;
}

CradleCheck checkCradle(const TriangleMesh& cradle, const TriangleMesh& body,
                        const SurfaceQuery& bodyQuery, const SurfaceQuery* painted,
                        const std::vector<SeatPiece>& seat, double nearest, double padding,
                        const Progress& progress) {
    progress(0, Text::tr("Checking the cradle"));
    const SurfaceQuery cradleQuery(cradle);
    const std::vector<std::uint32_t> opposite = oppositeEdges(cradle);
    CradleCheck check;
    check.isClosed = isClosedSurface(cradle);
    check.parts = partsOf(cradle, opposite);
    check.volume = volume(cradle);

    const std::vector<Eigen::Vector3f> samples = samplesOf(body, samplesOfBody),
                                       places = samplesOf(cradle, samplesOfCradle);
    progress(0.3, Text::tr("Checking the cradle"));
    const double fromCradle = leastOf(places.size(), [&](std::size_t i) {
        return signedDistance(bodyQuery, places[i], 2 * nearest);
    });
    const double fromBody = leastOf(samples.size(), [&](std::size_t i) {
        return signedDistance(cradleQuery, samples[i], 2 * nearest);
    });
    check.leastGap = std::min(fromCradle, fromBody);
    check.paintGap =
        painted
            ? leastOf(places.size(),
                      [&](std::size_t i) { return double(painted->closest(places[i]).distance); })
            : std::numeric_limits<double>::infinity();
    progress(0.7, Text::tr("Checking the cradle"));
    check.comesOut = meetsNothing(bodyQuery, places, Eigen::Vector3f::UnitY()) &&
                     meetsNothing(cradleQuery, samples, -Eigen::Vector3f::UnitY());
    const std::vector<SeatPiece> lying = lyingOn(cradleQuery, seat, nearest, padding);
    for (const SeatPiece& piece : lying) {
        check.seatArea += piece.area;
        check.paddedArea += piece.isPadded ? piece.area : 0;
    }
    check.standing = standingOn(lying, centreOfVolume(body));
    return check;
}

} // namespace dipwright

#include "cradle/FilmSide.h"

#include "dip/BodyPath.h"
#include "parallel/ParallelFor.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Cradle)
};

enum class Side : std::uint8_t { Dry, Film, EarlierPaint };

// A piece of a body triangle, with the triangle's shape. Its corners are barycentric weights in the
// triangle.
struct Piece {
    std::uint32_t triangle = 0;
    std::array<Eigen::Vector3f, 3> corners;
    Side side = Side::Dry;

    SurfacePoint middle() const {
        return {triangle, ((corners[0] + corners[1] + corners[2]) / 3).eval()};
    }
};

// Cuts each triangle evenly so that no side of a piece is longer than `edge`.
std::vector<Piece> piecesOf(const TriangleMesh& mesh, double edge) {
    std::vector<Piece> pieces;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& corner = mesh.triangles[t];
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3f side =
                mesh.positions[corner[(i + 1) % 3]] - mesh.positions[corner[i]];
            longest = std::max(longest, double(side.norm()));
        }
        const int cuts = std::max(1, int(std::ceil(longest / edge)));
        const auto at = [&](int row, int place) {
            const auto n = float(cuts);
            return Eigen::Vector3f(1 - float(row) / n, float(row - place) / n, float(place) / n);
        };
        for (int row = 0; row < cuts; ++row) {
            for (int place = 0; place <= row; ++place) {
                pieces.push_back(
                    {t, {at(row, place), at(row + 1, place), at(row + 1, place + 1)}, Side::Dry});
                if (place < row) {
                    pieces.push_back({t,
                                      {at(row, place), at(row + 1, place + 1), at(row, place + 1)},
                                      Side::Dry});
                }
            }
        }
    }
    return pieces;
}

TriangleMesh meshOf(const std::vector<Piece>& pieces, const TriangleMesh& body, Side side) {
    TriangleMesh mesh;
    for (const Piece& piece : pieces) {
        if (piece.side == side) {
            const auto first = std::uint32_t(mesh.positions.size());
            for (const Eigen::Vector3f& weights : piece.corners) {
                mesh.positions.push_back(position(body, {piece.triangle, weights}));
            }
            mesh.triangles.push_back({first, first + 1, first + 2});
        }
    }
    return mesh;
}

class Sorting {
public:
    Sorting(const LaidFilm& film, const std::vector<const LaidFilm*>& earlier,
            const SurfaceMask* mask, const ProcessSettings& process)
        : film_(film), earlier_(earlier), mask_(mask), upward_(std::sin(radians(process.overhang))),
          waterline_(dipDepth(process, film.body())) {
        const PosedBody& body = film.body();
        if (!body.path.isStraightDown()) {
            moments_ = momentsOf(body.path, shadowStep(body.mesh));
        }
    }

    Side sideOf(const Piece& piece) const {
        const TriangleMesh& mesh = film_.body().mesh;
        const SurfacePoint middle = piece.middle();
        if (mask_ && mask_->covers(middle)) {
            return Side::Dry;
        }
        if (mayTakeFilm(position(mesh, middle).cast<double>(),
                        triangleNormal(mesh, piece.triangle).cast<double>()) ||
            film_.place(middle)) {
            return Side::Film;
        }
        const bool wasPainted =
            std::any_of(earlier_.begin(), earlier_.end(),
                        [&](const LaidFilm* laid) { return laid->place(middle).has_value(); });
        return wasPainted ? Side::EarlierPaint : Side::Dry;
    }

private:
    // Whether a place goes under water while it turns up by no more than the overhang.
    bool mayTakeFilm(const Eigen::Vector3d& place, const Eigen::Vector3d& normal) const {
        if (moments_.empty()) {
            return place.y() < waterline_ && normal.y() <= upward_;
        }
        bool isUnderWater = false;
        for (const PathMoment& moment : moments_) {
            const bool wasUnderWater = isUnderWater;
            isUnderWater = (moment.poseToWorld * place).y() <= 0;
            if (isUnderWater && !wasUnderWater &&
                moment.poseToWorld.linear().row(1).dot(normal) <= upward_) {
                return true;
            }
        }
        return false;
    }

    const LaidFilm& film_;
    const std::vector<const LaidFilm*>& earlier_;
    const SurfaceMask* mask_; // may be null
    double upward_, waterline_;
    std::vector<PathMoment> moments_; // of the path; empty if the body goes straight down
};

// Whether `place` is at least `distance` away from a mesh; true if there is no mesh.
bool isAway(const std::optional<SurfaceQuery>& from, const Eigen::Vector3f& place,
            double distance) {
    return !from || !from->closest(place, float(distance)).point.isValid();
}

std::optional<SurfaceQuery> queryOf(const TriangleMesh& mesh) {
    return mesh.triangles.empty() ? std::nullopt : std::optional<SurfaceQuery>(mesh);
}

} // namespace

FilmSide filmSide(const LaidFilm& film, const std::vector<const LaidFilm*>& earlier,
                  const SurfaceMask* mask, const ProcessSettings& process, double edge,
                  double filmDistance, std::optional<double> earlierDistance,
                  const Progress& progress) {
    progress(0, Text::tr("Finding the surface that stays dry"));
    const PosedBody& body = film.body();
    const TriangleMesh& mesh = body.mesh;
    std::vector<Piece> pieces = piecesOf(mesh, edge);
    const Sorting sorting(film, earlier, mask, process);
    parallelFor(std::size_t(0), pieces.size(),
                [&](std::size_t i) { pieces[i].side = sorting.sideOf(pieces[i]); });
    progress(0.5, Text::tr("Finding the surface that stays dry"));

    FilmSide result{meshOf(pieces, mesh, Side::Film), meshOf(pieces, mesh, Side::EarlierPaint), {}};
    const auto filmQuery = queryOf(result.film);
    const auto paintQuery = queryOf(earlierDistance ? result.earlierPaint : TriangleMesh());
    std::vector<SeatPiece> seats(pieces.size());
    parallelFor(std::size_t(0), pieces.size(), [&](std::size_t i) {
        const Piece& piece = pieces[i];
        const Eigen::Vector3f place = position(mesh, piece.middle());
        const Eigen::Vector3f normal = triangleNormal(mesh, piece.triangle);
        if (piece.side == Side::Film || !isAway(filmQuery, place, filmDistance) ||
            !isAway(paintQuery, place, earlierDistance.value_or(0)) ||
            body.query.hit(place + normal * 1e-3F * float(edge), Eigen::Vector3f::UnitY())
                .point.isValid()) {
            return;
        }
        const Eigen::Vector3f a = position(mesh, {piece.triangle, piece.corners[0]}),
                              b = position(mesh, {piece.triangle, piece.corners[1]}),
                              c = position(mesh, {piece.triangle, piece.corners[2]});
        seats[i] = {place.cast<double>(), normal.cast<double>(),
                    double((b - a).cross(c - a).norm()) / 2, piece.side == Side::EarlierPaint};
    });
    std::copy_if(seats.begin(), seats.end(), std::back_inserter(result.seat),
                 [](const SeatPiece& seat) { return seat.area > 0; });
    return result;
}

} // namespace dipwright

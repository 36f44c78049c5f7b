// The dip of the production film (film-physics §2), whatever solves its equilibrium.
//
// The film is a plane problem: every point has a place in the water plane. A free point is where
// the equilibrium puts it. A point that has adhered is held; the triangles that cross the contact
// line see it where its piece of the body's surface lies when that is unfolded about the line
// (ContactPath.h). One step lowers the body by so much that the contact line travels a fraction of
// a cell along the surface, lets the film find its equilibrium, and lets every point that met the
// surface on the way adhere when and where it met it.
#pragma once

#include "pbd/ContactPath.h"
#include "pbd/CrossingTriangle.h"

#include <dipwright/FilmSolver.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dipwright::pbd {

// `Equilibrium` has a type Vector (two arrays x, z of its Real, a film point each) and
//   Equilibrium(grid), setFree(vector<float>), setCrossing(vector<CrossingTriangle<Real>>),
//   solve(Vector& displacement, double residual) and relax(const Vector& displacement, double
//   keep).
template <typename Equilibrium>
class QuasiStaticDip {
public:
    using Vector = typename Equilibrium::Vector;
    using Real = typename Vector::Real;

    explicit QuasiStaticDip(const solver::DipSetup& setup)
        : grid_(setup.film), field_(fieldGrid<Real>(setup.field)), motion_(setup.motion),
          settings_(setup.settings), equilibrium_(setup.film), displacement_(grid_.pointCount()),
          before_(grid_.pointCount()), states_(grid_.pointCount(), solver::PointState::Free),
          attached_(grid_.pointCount()), free_(grid_.pointCount(), 1.f),
          clearance_(grid_.pointCount(), Real(0)), holding_(trianglesPerPoint(grid_)),
          released_(2 * std::size_t(grid_.columns - 1) * std::size_t(grid_.rows - 1), 0) {
        for (std::size_t point = 0; point < setup.pinned.size(); ++point) {
            free_[point] = setup.pinned[point] ? 0.f : 1.f;
        }
        equilibrium_.setFree(free_);
    }

    solver::Progress advance(int maximumSteps) {
        for (int i = 0; i < maximumSteps && !finished(); ++i) {
            step();
        }
        return {steps_, descent_, finished()};
    }

    // World position of a point.
    Vector3<Real> position(std::size_t point) const {
        return states_[point] != solver::PointState::Free
                   ? bodyFrame<Real>(motion_, descent_).toWorld(attached_[point])
                   : planePosition(displacement_, point);
    }
    solver::PointState state(std::size_t point) const { return states_[point]; }
    const Equilibrium& equilibrium() const { return equilibrium_; }

private:
    // Grid columns and rows of a triangle's corners: the two ends of its horizontal edge, and the
    // third corner, which shares its vertical edge with one of them.
    struct TriangleCorners {
        std::size_t left, right, third;
        bool thirdOnRight, thirdAbove; // above: in the next row
    };

    bool finished() const { return descent_ >= motion_.travel; }
    Real cell() const { return Real(std::min(grid_.spacingX(), grid_.spacingZ())); }

    Vector3<Real> rest(std::size_t point) const {
        const std::size_t columns = std::size_t(grid_.columns);
        return {Real(-grid_.width / 2 + double(point % columns) * grid_.spacingX()), Real(0),
                Real(-grid_.depth / 2 + double(point / columns) * grid_.spacingZ())};
    }
    Vector3<Real> planePosition(const Vector& displacement, std::size_t point) const {
        return rest(point) + Vector3<Real>{displacement.x[point], Real(0), displacement.z[point]};
    }

    void step() {
        const double increment = std::min(nextIncrement(), motion_.travel - descent_);
        const BodyFrame<Real> frame = bodyFrame<Real>(motion_, descent_ + increment);
        predict(increment);
        if (anyAdhered_) {
            const std::vector<CrossingTriangle<Real>> crossing = crossingTriangles(frame);
            equilibrium_.moveCrossing(crossing);
            equilibrium_.solve(displacement_, settings_.residual);
            for (const std::size_t torn :
                 equilibrium_.tornCrossing(displacement_, settings_.tearStretch)) {
                release(crossing[torn].cell, crossing[torn].second);
            }
            equilibrium_.relax(displacement_, keptStress(increment));
        }
        const std::vector<std::size_t> touching = touchingPoints(increment, frame);
        for (const std::size_t point : touching) {
            adhere(point, increment);
        }
        if (!touching.empty() || freeChanged_) {
            anyAdhered_ = true;
            freeChanged_ = false;
            equilibrium_.setFree(free_);
        }
        if (anyAdhered_) {
            equilibrium_.setCrossing(crossingTriangles(frame), displacement_);
        }
        descent_ += increment;
        increment_ = increment;
        ++steps_;
    }

    // The share of its stress that the film keeps over a step.
    double keptStress(double increment) const {
        const double time = increment / motion_.speed;
        return settings_.relaxationTime > 0 ? std::exp(-time / settings_.relaxationTime) : 0.0;
    }

    // Descent in which the contact line travels settings.contactTravel cells along the surface.
    double nextIncrement() const {
        const double travel = settings_.contactTravel * double(cell());
        if (!anyAdhered_) { // nothing has touched: as far as the nearest point is away
            return std::max(nearestClearance(), 0.1 * travel);
        }
        return travel * double(std::max(steepness_, Real(0.15)));
    }

    double nearestClearance() const {
        const BodyFrame<Real> frame = bodyFrame<Real>(motion_, descent_);
        Real nearest = cell();
        for (std::size_t point = 0; point < states_.size(); ++point) {
            const Real distance =
                sampleField(field_, frame.toBody(planePosition(displacement_, point))).distance;
            nearest = std::min(nearest, distance - Real(settings_.contactDistance));
        }
        return double(nearest);
    }

    Real limited(Real way) const { return std::clamp(way, -cell(), cell()); }

    // Free points go on as in the step before: the warm start of the equilibrium.
    void predict(double increment) {
        const Real factor = increment_ > 0 && driven_ ? Real(increment / increment_) : Real(0);
        for (std::size_t point = 0; point < states_.size(); ++point) {
            const Real x = displacement_.x[point], z = displacement_.z[point];
            if (free_[point] > 0) {
                displacement_.x[point] += limited(factor * (x - before_.x[point]));
                displacement_.z[point] += limited(factor * (z - before_.z[point]));
            }
            before_.x[point] = x;
            before_.z[point] = z;
        }
    }

    TriangleCorners corners(int column, int row, bool second) const {
        return corners(grid_, column, row, second);
    }
    static TriangleCorners corners(const solver::FilmGrid& grid, int column, int row, bool second) {
        const bool even = (column + row) % 2 == 0;
        const bool onRight = even != second;
        const std::size_t columns = std::size_t(grid.columns);
        const std::size_t lower = std::size_t(row) * columns + std::size_t(column);
        const std::size_t base = second ? lower + columns : lower;
        const std::size_t other = (second ? lower : lower + columns) + (onRight ? 1 : 0);
        return {base, base + 1, other, onRight, !second};
    }

    // Takes a triangle out of the film for good. A free point that no triangle holds any more stays
    // where it is: nothing says where it should go.
    void release(std::uint32_t cellIndex, bool second) {
        std::uint8_t& released = released_[2 * std::size_t(cellIndex) + second];
        if (released) {
            return;
        }
        released = 1;
        const int cells = grid_.columns - 1;
        const TriangleCorners c = corners(int(cellIndex) % cells, int(cellIndex) / cells, second);
        for (const std::size_t point : {c.left, c.right, c.third}) {
            if (--holding_[point] == 0 && free_[point] > 0) {
                free_[point] = 0.f;
                freeChanged_ = true;
            }
        }
    }

    // How many triangles meet in each point.
    static std::vector<std::uint8_t> trianglesPerPoint(const solver::FilmGrid& grid) {
        std::vector<std::uint8_t> counts(grid.pointCount(), 0);
        for (int row = 0; row + 1 < grid.rows; ++row) {
            for (int column = 0; column + 1 < grid.columns; ++column) {
                for (const bool second : {false, true}) {
                    const TriangleCorners c = corners(grid, column, row, second);
                    for (const std::size_t point : {c.left, c.right, c.third}) {
                        ++counts[point];
                    }
                }
            }
        }
        return counts;
    }

    // Unfolds the surface under every triangle that crosses the contact line. Where there is no
    // contact line near (a flat face, a body that has gone under) its corners stay where they are.
    std::vector<CrossingTriangle<Real>> crossingTriangles(const BodyFrame<Real>& frame) {
        std::vector<CrossingTriangle<Real>> crossing;
        steepness_ = Real(1);
        driven_ = false;
        const auto isAdhered = [&](std::size_t point) {
            return states_[point] != solver::PointState::Free;
        };
        for (int row = 0; row + 1 < grid_.rows; ++row) {
            for (int column = 0; column + 1 < grid_.columns; ++column) {
                const std::size_t p =
                    std::size_t(row) * std::size_t(grid_.columns) + std::size_t(column);
                const int adhered = isAdhered(p) + isAdhered(p + 1) +
                                    isAdhered(p + std::size_t(grid_.columns)) +
                                    isAdhered(p + std::size_t(grid_.columns) + 1);
                if (adhered == 0 || adhered == 4) {
                    continue;
                }
                for (const bool second : {false, true}) {
                    unfoldTriangle(column, row, second, frame, crossing);
                }
            }
        }
        return crossing;
    }

    void unfoldTriangle(int column, int row, bool second, const BodyFrame<Real>& frame,
                        std::vector<CrossingTriangle<Real>>& crossing) {
        const TriangleCorners c = corners(column, row, second);
        const std::size_t points[3] = {c.left, c.right, c.third};
        Vector3<Real> adhered, free;
        int adheredCount = 0;
        bool released = false;
        for (const std::size_t point : points) {
            released = released || states_[point] == solver::PointState::Trapped;
            if (states_[point] != solver::PointState::Free) {
                adhered = adhered + frame.toWorld(attached_[point]);
                ++adheredCount;
            } else {
                free = free + planePosition(displacement_, point);
            }
        }
        if (adheredCount == 0 || adheredCount == 3) {
            return;
        }
        const std::uint32_t cellIndex =
            std::uint32_t(row) * std::uint32_t(grid_.columns - 1) + std::uint32_t(column);
        const Real contactDistance = Real(settings_.contactDistance);
        const ContactLine<Real> line = contactLine(field_, frame, contactDistance, cell(),
                                                   adhered * (Real(1) / Real(adheredCount)),
                                                   free * (Real(1) / Real(3 - adheredCount)));
        const bool turnsUp = released || line.upwards > Real(std::sin(settings_.overhang));
        released = turnsUp || released_[2 * std::size_t(cellIndex) + second] != 0;
        if (turnsUp) { // the softened film stays on the water where it is
            release(cellIndex, second);
            for (const std::size_t point : points) {
                freeChanged_ = freeChanged_ || free_[point] > 0;
                free_[point] = 0.f;
            }
        }
        if (!released) {
            steepness_ = std::min(steepness_, line.steepness);
            driven_ = true;
        }
        Vector3<Real> offset[3];
        Real distance[3]; // from the contact line: along the surface, or across the water
        for (int k = 0; k < 3; ++k) {
            const Vector3<Real> plane = planePosition(displacement_, points[k]);
            distance[k] = Real(0);
            if (!line.found) {
                continue;
            }
            if (states_[points[k]] != solver::PointState::Free) {
                const Unfolded<Real> place = unfolded(field_, frame, contactDistance, cell(), line,
                                                      frame.toWorld(attached_[points[k]]));
                offset[k] = place.position - plane;
                distance[k] = place.path;
            } else {
                distance[k] = std::max(dot(plane - line.place, line.outwards), Real(0));
            }
        }
        const int shared = c.thirdOnRight ? 1 : 0, end = 1 - shared;
        const auto isFree = [&](int k) { return states_[points[k]] == solver::PointState::Free; };
        const auto share = [&](int k, int l) {
            if (isFree(k) == isFree(l)) {
                return isFree(k) ? Real(1) : Real(0);
            }
            const Real floating = isFree(k) ? distance[k] : distance[l];
            const Real all = distance[k] + distance[l];
            return all > Real(1e-6) * cell() ? floating / all : Real(1);
        };
        const Vector3<Real> horizontal = offset[1] - offset[0];
        const Vector3<Real> vertical =
            c.thirdAbove ? offset[2] - offset[shared] : offset[shared] - offset[2];
        CrossingTriangle<Real> triangle;
        triangle.cell = cellIndex;
        triangle.second = second;
        triangle.thirdOnRight = c.thirdOnRight;
        triangle.released = released;
        triangle.hx = horizontal.x;
        triangle.hz = horizontal.z;
        triangle.vx = vertical.x;
        triangle.vz = vertical.z;
        triangle.horizontalShare = share(shared, end);
        triangle.verticalShare = share(shared, 2);
        triangle.diagonalShare = share(end, 2);
        triangle.sharedFree = isFree(shared);
        triangle.horizontalFree = isFree(end);
        triangle.verticalFree = isFree(2);
        triangle.normalX = line.outwards.x;
        triangle.normalZ = line.outwards.z;
        Real floating(0), laid(0);
        for (int k = 0; k < 3; ++k) {
            isFree(k) ? floating += distance[k] / Real(3 - adheredCount)
                      : laid += distance[k] / Real(adheredCount);
        }
        triangle.floating =
            floating + laid > Real(1e-6) * cell() ? floating / (floating + laid) : Real(1);
        crossing.push_back(triangle);
    }

    // Free points within the contact distance at the end of the step. A point far from the body is
    // not looked at again before it or the body can have come so far.
    std::vector<std::size_t> touchingPoints(double increment, const BodyFrame<Real>& frame) {
        std::vector<std::size_t> touching;
        for (std::size_t point = 0; point < states_.size(); ++point) {
            if (states_[point] != solver::PointState::Free) {
                continue;
            }
            const Real dx = displacement_.x[point] - before_.x[point];
            const Real dz = displacement_.z[point] - before_.z[point];
            clearance_[point] -= Real(increment) + std::sqrt(dx * dx + dz * dz);
            if (clearance_[point] > Real(0)) {
                continue;
            }
            const Real distance =
                sampleField(field_, frame.toBody(planePosition(displacement_, point))).distance -
                Real(settings_.contactDistance);
            if (distance <= Real(0)) {
                touching.push_back(point);
            } else {
                clearance_[point] =
                    distance / Real(3); // a third: safe outside the field's grid too
            }
        }
        return touching;
    }

    // The point sticks at the moment in the step, and at the place, at which it met the surface.
    void adhere(std::size_t point, double increment) {
        const Vector3<Real> start = planePosition(before_, point);
        const Vector3<Real> way = planePosition(displacement_, point) - start;
        Real early(0), late(1);
        const auto attachment = [&](Real share) {
            return bodyFrame<Real>(motion_, descent_ + increment * double(share))
                .toBody(start + way * share);
        };
        for (int iteration = 0; iteration < 24; ++iteration) {
            const Real middle = (early + late) / Real(2);
            const Real distance = sampleField(field_, attachment(middle)).distance;
            (distance > Real(settings_.contactDistance) ? early : late) = middle;
        }
        attached_[point] = attachment(late);
        const Vector3<Real> gradient =
            bodyFrame<Real>(motion_, 0)
                .directionToWorld(sampleField(field_, attached_[point]).gradient);
        states_[point] = gradient.y > Real(std::sin(settings_.overhang)) * length(gradient)
                             ? solver::PointState::Trapped
                             : solver::PointState::Adhered;
        free_[point] = 0.f;
    }

    solver::FilmGrid grid_;
    FieldGrid<Real> field_;
    solver::BodyMotion motion_;
    solver::Settings settings_;
    Equilibrium equilibrium_;
    Vector displacement_, before_; // from rest, now and a step ago
    std::vector<solver::PointState> states_;
    std::vector<Vector3<Real>> attached_; // where an adhered point sits, body coordinates
    std::vector<float> free_;             // 1: the equilibrium moves it
    std::vector<Real> clearance_;         // how far from contact a free point is at least
    std::vector<std::uint8_t> holding_;   // triangles of a point that have not come off
    std::vector<std::uint8_t> released_; // two triangles a cell: 1 once the film has come off there
    Real steepness_ = Real(1);           // the least of all contact-line places
    double descent_ = 0, increment_ = 0;
    std::int64_t steps_ = 0;
    bool anyAdhered_ = false;
    bool driven_ = false;      // the contact line still pulls at the film
    bool freeChanged_ = false; // free_ is newer than what the equilibrium knows
};

// FilmSolver::read for such a dip.
template <typename Equilibrium>
void readFilm(const QuasiStaticDip<Equilibrium>& dip, std::size_t points,
              std::span<float> positions, std::span<solver::PointState> states) {
    for (std::size_t point = 0; point < points; ++point) {
        const auto p = dip.position(point);
        positions[3 * point] = float(p.x);
        positions[3 * point + 1] = float(p.y);
        positions[3 * point + 2] = float(p.z);
    }
    for (std::size_t point = 0; point < states.size(); ++point) {
        states[point] = dip.state(point);
    }
}

} // namespace dipwright::pbd

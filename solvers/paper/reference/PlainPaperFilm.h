// The paper's step exactly as in docs/film-model.md, "The paper's model", in double precision.
// Computes one point, one constraint and one sweep after the other. Slow; the reference for the
// film on the CPU.
#pragma once

#include "common/BodyFrame.h"
#include "common/FieldSampling.h"

#include <vector>

namespace dipwright::reference {

class PlainPaperFilm {
public:
    explicit PlainPaperFilm(const solver::DipSetup& setup)
        : setup_(setup), field_(numerics::fieldGrid<double>(setup.field)) {
        const solver::FilmGrid& grid = setup.film;
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                points_.push_back({{grid.restX(column), 0, grid.restZ(row)}});
                connect(column, row, column + 1, row, 1);
                connect(column, row, column, row + 1, 1);
                if (setup.settings.lattice == solver::Lattice::Isotropic) {
                    connect(column, row, column + 1, row + 1, 0.5);
                    connect(column + 1, row, column, row + 1, 0.5);
                }
            }
        }
    }

    void dip() {
        const double step = setup_.motion.speed * setup_.settings.timeStep;
        for (int steps = 1; descent_ < setup_.motion.travel; ++steps) {
            descent_ = std::min(setup_.motion.travel, steps * step);
            advance();
        }
    }

    numerics::Vector3<double> position(std::size_t point) const { return points_[point].x; }
    bool isAdhered(std::size_t point) const { return points_[point].isAdhered; }

private:
    using Vector = numerics::Vector3<double>;
    struct Point {
        Vector x, p{}, v{}, onBody{};
        bool isAdhered = false;
        double weight() const { return isAdhered ? 0 : 1; }
    };
    struct Constraint {
        std::size_t first, second;
        double length, stiffness;
    };

    void connect(int columnA, int rowA, int columnB, int rowB, double stiffness) {
        const solver::FilmGrid& grid = setup_.film;
        if (std::max(columnA, columnB) >= grid.columns || std::max(rowA, rowB) >= grid.rows) {
            return;
        }
        const bool isOnBorder =
            (rowA == rowB && (rowA == 0 || rowA == grid.rows - 1)) ||
            (columnA == columnB && (columnA == 0 || columnA == grid.columns - 1));
        const bool isIsotropic = setup_.settings.lattice == solver::Lattice::Isotropic;
        constraints_.push_back(
            {std::size_t(rowA * grid.columns + columnA), std::size_t(rowB * grid.columns + columnB),
             std::hypot((columnB - columnA) * grid.spacingX(0), (rowB - rowA) * grid.spacingZ(0)),
             isIsotropic && isOnBorder ? 0.5 : stiffness});
    }

    void advance() {
        const double time = setup_.settings.timeStep;
        const auto frame = numerics::bodyFrame<double>(setup_.motion, descent_);
        for (Point& point : points_) {
            point.p = point.x + point.v * time;
            if (!point.isAdhered) {
                touch(point, frame);
            }
            if (point.isAdhered) {
                point.p = frame.toWorld(point.onBody);
            }
        }
        for (int sweep = 0; sweep < setup_.settings.iterations; ++sweep) {
            relax();
        }
        for (Point& point : points_) {
            point.v = (point.p - point.x) * (1 / time);
            point.x = point.p;
        }
    }

    void touch(Point& point, const numerics::BodyFrame<double>& frame) {
        const Vector place = frame.toBody(point.p);
        if (numerics::sampleField(field_, place).distance <= setup_.settings.contactDistance) {
            point.isAdhered = true;
            point.onBody = numerics::onLevel(field_, place, setup_.settings.contactDistance);
        }
    }

    void relax() {
        std::vector<Vector> sums(points_.size());
        std::vector<double> counts(points_.size());
        for (const Constraint& constraint : constraints_) {
            const Point &a = points_[constraint.first], &b = points_[constraint.second];
            counts[constraint.first] += constraint.stiffness;
            counts[constraint.second] += constraint.stiffness;
            if (a.isAdhered && b.isAdhered) {
                continue;
            }
            const Vector apart = a.p - b.p;
            const double distance = length(apart);
            const Vector n = apart * (1 / distance);
            const double lambda = (distance - constraint.length) / (a.weight() + b.weight());
            sums[constraint.first] =
                sums[constraint.first] - n * (a.weight() * lambda * constraint.stiffness);
            sums[constraint.second] =
                sums[constraint.second] + n * (b.weight() * lambda * constraint.stiffness);
        }
        for (std::size_t i = 0; i < points_.size(); ++i) {
            points_[i].p = points_[i].p + sums[i] * (1 / counts[i]);
        }
    }

    solver::DipSetup setup_;
    numerics::FieldGrid<double> field_;
    std::vector<Point> points_;
    std::vector<Constraint> constraints_;
    double descent_ = 0;
};

} // namespace dipwright::reference

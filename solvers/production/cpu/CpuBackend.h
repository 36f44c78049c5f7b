// Runs the production film on the CPU's cores, row by row (FilmBackend.h). Solves linear systems by
// GMRES with a multigrid cycle as preconditioner. The result has the same bits for any number of
// threads, and on the GPU (docs/speed.md).
#pragma once

#include "common/cpu/FlushDenormals.h"
#include "parallel/ParallelFor.h"
#include "production/cpu/PlaneFilm.h"
#include "production/cpu/StiffnessMultigrid.h"
#include "production/formulas/HostFilm.h"

#include <algorithm>
#include <array>

namespace dipwright::cpu {

class CpuBackend : public numerics::HostFilm<PlaneVector> {
public:
    explicit CpuBackend(const solver::DipSetup& setup);

    numerics::Matrix2<float> shape(int triangle) const { return film_.shape(triangle); }
    void setShape(int triangle, const numerics::Matrix2<float>& shape) {
        film_.setShape(triangle, shape);
    }
    numerics::EdgePair<float> edges(int triangle) const {
        return film_.edges(triangle, displacement_);
    }
    bool triangleMoves(int triangle) const { return film_.moves(triangle); }

    template <typename Crosses, typename Unfold>
    numerics::LineState<float> findCrossing(const Crosses& crosses, const Unfold& unfold);
    template <typename Work>
    void forCrossing(const Work& work) {
        film_.forCrossing(work);
    }
    template <typename OnLine, typename Floating>
    void forTriangles(const OnLine& onLine, const Floating& floating) {
        film_.forTriangles(onLine, floating);
    }
    template <typename OnLine, typename Floating>
    void forStretched(float limit, const OnLine& onLine, const Floating& floating) {
        film_.forStretched(displacement_, limit, onLine, floating);
    }

    static constexpr numerics::NewtonLimits newtonLimits() { return {}; }
    void setFree();
    numerics::FilmForce force(float drag);
    numerics::FilmForce forceAlong(float length, float drag);
    numerics::Vector2<float> forceOn(int point) const {
        return {gradient_.x[std::size_t(point)], gradient_.z[std::size_t(point)]};
    }
    void prepareLinear(float drag) { multigrid_.prepare(film_, masked_, areas_, drag); }
    void solveLinear(float drag, numerics::Tangent tangent, double start, double tolerance);
    double startOfStep();
    void keepBest() { best_ = displacement_; }
    void takeBest() { displacement_ = best_; }

    template <typename Work>
    double inSmallProblem(const Work& work) {
        return work(leastResiduals_);
    }
    void startLinear();
    void startBasis(float factor);
    void extendBasis(int count, float drag, numerics::Tangent tangent);
    void addToStep(int count);
    double linearResidual(float drag, numerics::Tangent tangent);

private:
    // Triangles that one thread unfolds at a time.
    static constexpr std::size_t trianglesAtOnce = 32;

    // Returns the triangles that satisfy `crosses`. Tests only cells with both held and free
    // corners.
    template <typename Crosses>
    std::vector<int> crossingTriangles(const Crosses& crosses) const;
    RowOfPairs rowOf(const PlaneVector& v, int row) const;
    double norm(const PlaneVector& v) const;
    void maskHeld(PlaneVector& v) const;
    // Computes out = H v, including the drag.
    void multiply(const PlaneVector& v, float drag, numerics::Tangent tangent, PlaneVector& out);

    PlaneFilm film_;
    StiffnessMultigrid multigrid_;
    std::vector<float> masked_; // per point: 0 if it was held at the last setFree()
    std::vector<float> areas_;  // per point: film area relative to the finest cell
    PlaneVector gradient_, step_, start_, best_;
    // The basis vectors, which must be multiplied by their factors.
    std::vector<PlaneVector> basis_;
    std::array<float, std::size_t(numerics::mostBasisVectors) + 1> factors_{};
    std::vector<PlaneVector> smoothed_;
    numerics::GmresProblem leastResiduals_;
};

template <typename Crosses>
std::vector<int> CpuBackend::crossingTriangles(const Crosses& crosses) const {
    std::vector<int> triangles;
    const int columns = model().columns, cellsPerRow = columns - 1;
    const auto isHeld = [&](int point) { return pointState(point) != solver::PointState::Free; };
    for (int row = 0; row + 1 < model().rows; ++row) {
        for (int column = 0; column < cellsPerRow; ++column) {
            const int lower = row * columns + column, upper = lower + columns;
            const int held = isHeld(lower) + isHeld(lower + 1) + isHeld(upper) + isHeld(upper + 1);
            for (int second = 0; held > 0 && held < 4 && second < 2; ++second) {
                if (crosses(numerics::triangleCorners(columns, column, row, second != 0))) {
                    triangles.push_back(2 * (row * cellsPerRow + column) + second);
                }
            }
        }
    }
    return triangles;
}

template <typename Crosses, typename Unfold>
numerics::LineState<float> CpuBackend::findCrossing(const Crosses& crosses, const Unfold& unfold) {
    const std::vector<int> triangles = crossingTriangles(crosses);
    std::vector<PlaneFilm::Crossing> crossing(triangles.size());
    std::vector<float> steepness(triangles.size());
    parallelForPieces(
        std::size_t(0), triangles.size(), trianglesAtOnce, [&](std::size_t begin, std::size_t end) {
            const FlushDenormals flush;
            for (std::size_t i = begin; i < end; ++i) {
                const auto unfolded =
                    unfold(triangles[i],
                           numerics::triangleCorners(model().columns, std::size_t(triangles[i])));
                crossing[i] = unfolded.crossing;
                steepness[i] = unfolded.steepness;
            }
        });
    film_.setCrossing(std::move(crossing));
    numerics::LineState<float> line{1, !triangles.empty()};
    for (const float least : steepness) {
        line.steepness = std::min(line.steepness, least);
    }
    return line;
}

} // namespace dipwright::cpu

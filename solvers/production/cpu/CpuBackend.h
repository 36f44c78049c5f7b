// Runs the production film on the CPU's cores, row by row (FilmBackend.h). Solves linear systems by
// GMRES with a multigrid cycle as preconditioner. The result has the same bits for any number of
// threads, and on the GPU (docs/speed.md).
#pragma once

#include "common/cpu/RowParallel.h"
#include "parallel/ParallelFor.h"
#include "production/cpu/PlaneFilm.h"
#include "production/cpu/StiffnessMultigrid.h"
#include "production/formulas/HostFilm.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>
#include <vector>

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

    template <typename Work>
    void forPoints(const Work& work) const;
    template <typename Ask>
    bool anyPoint(const Ask& ask) const;
    template <typename Fold>
    float leastOver(float value, const Fold& fold) const;

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
    template <typename OnLine>
    void relaxTriangles(const OnLine& onLine, float keep) {
        film_.forCrossing(onLine);
        film_.relaxFloating(displacement_, keep);
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
    void keepBest();
    void takeBest();

    template <typename Work>
    double inSmallProblem(const Work& work) {
        return work(leastResiduals_);
    }
    void startBasis(float factor);
    void extendBasis(int count, float drag, numerics::Tangent tangent);
    void setStep(int count);

private:
    // Triangles that one thread unfolds at a time.
    static constexpr std::size_t trianglesAtOnce = 32;

    // Returns the triangles that satisfy `crosses`. Tests only cells with both held and free
    // corners.
    template <typename Crosses>
    std::vector<int> crossingTriangles(const Crosses& crosses) const;
    RowOfPairs rowOf(const PlaneVector& v, int row) const;
    // Calls work(first, last) for the points of each band of rows.
    template <typename Work>
    void forBands(const Work& work) const;
    bool isHeld(int point) const { return pointState(point) != solver::PointState::Free; }
    // Returns whether any and whether all of the points in a row are on the body.
    std::pair<bool, bool> heldInRow(int row) const;
    // Adds the drag on a row of a Hessian product, and clears it at held points.
    void addDrag(int row, float drag, const PlaneVector& v, PlaneVector& product) const;

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

template <typename Work>
void CpuBackend::forBands(const Work& work) const {
    const int columns = model().columns;
    forRowBands(model().rows, columns,
                [&](int begin, int end) { work(begin * columns, end * columns); });
}

template <typename Work>
void CpuBackend::forPoints(const Work& work) const {
    forBands([&](int first, int last) {
        for (int point = first; point < last; ++point) {
            work(point);
        }
    });
}

template <typename Ask>
bool CpuBackend::anyPoint(const Ask& ask) const {
    std::atomic<bool> any = false;
    forBands([&](int first, int last) {
        bool ofBand = false;
        for (int point = first; point < last; ++point) {
            ofBand = ask(point) || ofBand;
        }
        if (ofBand) {
            any = true;
        }
    });
    return any;
}

template <typename Fold>
float CpuBackend::leastOver(float value, const Fold& fold) const {
    const int columns = model().columns;
    std::vector<float> least(std::size_t(model().rows), value); // the first row of a band counts
    forBands([&](int first, int last) {
        float ofBand = value;
        for (int point = first; point < last; ++point) {
            ofBand = fold(point, ofBand);
        }
        least[std::size_t(first / columns)] = ofBand;
    });
    return *std::min_element(least.begin(), least.end());
}

template <typename Crosses>
std::vector<int> CpuBackend::crossingTriangles(const Crosses& crosses) const {
    const int columns = model().columns, rows = model().rows - 1, cells = columns - 1;
    std::vector<std::vector<int>> ofRow(static_cast<std::size_t>(rows));
    forRows(rows, columns, [&](int row) {
        const auto [anyBelow, allBelow] = heldInRow(row);
        const auto [anyAbove, allAbove] = heldInRow(row + 1);
        if (!(anyBelow || anyAbove) || (allBelow && allAbove)) {
            return;
        }
        for (int column = 0; column < cells; ++column) {
            const int lower = row * columns + column, upper = lower + columns;
            const int held = isHeld(lower) + isHeld(lower + 1) + isHeld(upper) + isHeld(upper + 1);
            for (int second = 0; held > 0 && held < 4 && second < 2; ++second) {
                if (crosses(numerics::triangleCorners(columns, column, row, second != 0))) {
                    ofRow[std::size_t(row)].push_back(2 * (row * cells + column) + second);
                }
            }
        }
    });
    std::vector<int> triangles;
    for (const std::vector<int>& found : ofRow) {
        triangles.insert(triangles.end(), found.begin(), found.end());
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
    numerics::LineState<float> line;
    line.driven = !triangles.empty();
    for (const PlaneFilm::Crossing& triangle : crossing) {
        line.upwards = std::fmax(line.upwards, triangle.upwards);
    }
    film_.setCrossing(std::move(crossing));
    for (const float least : steepness) {
        line.steepness = std::min(line.steepness, least);
    }
    return line;
}

} // namespace dipwright::cpu

// The production film on the GPU (FilmBackend.h). One kernel runs all steps of a launch. The blocks
// of a film synchronize at barriers, so the host is not involved until the steps are done.
#pragma once

#include "production/cuda/PlaneForces.cuh"
#include "production/formulas/FilmStep.h"

#include <dipwright/FilmSolver.h>

namespace dipwright::cuda {

// One film, as seen by its team (FilmBackend.h). All threads of the team call all members. Large
// members that several places call are not inlined: a step runs most of its code only a few times,
// so fetching the code takes longer than running it.
class CudaBackend {
public:
    using Real = float;

    __device__ CudaBackend() : state_(*thisBlock.block.dip.state) {}

    __device__ const numerics::FilmModel<float>& model() const { return thisBlock.block.model; }
    __device__ const numerics::ContactBody<float>& body() const { return thisBlock.block.dip.body; }
    __device__ numerics::StepState<float>& state() { return state_; }

    __device__ numerics::Vector2<float> displacement(int point) const {
        return plain(thisBlock.block.dip.displacement[point]);
    }
    __device__ numerics::Vector2<float> before(int point) const {
        return plain(thisBlock.block.dip.before[point]);
    }
    __device__ void setDisplacement(int point, numerics::Vector2<float> way) const {
        thisBlock.block.dip.displacement[point] = {way.x, way.z};
    }
    __device__ void setBefore(int point, numerics::Vector2<float> way) const {
        thisBlock.block.dip.before[point] = {way.x, way.z};
    }
    __device__ solver::PointState pointState(int point) const {
        return solver::PointState(thisBlock.block.dip.states[point]);
    }
    __device__ numerics::Vector3<float> attached(int point) const {
        const float3 place = thisBlock.block.dip.attached[point];
        return {place.x, place.y, place.z};
    }
    __device__ void attach(int point, numerics::Vector3<float> place,
                           solver::PointState state) const {
        thisBlock.block.dip.attached[point] = {place.x, place.y, place.z};
        thisBlock.block.dip.states[point] = std::uint8_t(state);
    }
    __device__ void mark(int point, solver::PointMark why) const {
        atomicOr(thisBlock.block.dip.marks + point, unsigned(why));
    }
    __device__ bool moves(int point) const { return thisBlock.block.dip.free[point] > 0; }
    __device__ void hold(int point) const { thisBlock.block.dip.free[point] = 0; }
    __device__ float clearance(int point) const { return thisBlock.block.dip.clearance[point]; }
    __device__ void setClearance(int point, float clearance) const {
        thisBlock.block.dip.clearance[point] = clearance;
    }

    __device__ numerics::Matrix2<float> shape(int triangle) const {
        return shapeOf(thisBlock.block.dip, triangle);
    }
    __device__ void setShape(int triangle, const numerics::Matrix2<float>& inverse) const {
        thisBlock.block.dip.inverseShape[triangle] = {inverse.a, inverse.b, inverse.c, inverse.d};
    }
    __device__ numerics::EdgePair<float> edges(int triangle) const {
        const numerics::TriangleSize<float> size = triangleSize(thisBlock.block.model, triangle);
        return triangleEdges(corners(triangle), size.x, size.z, [&](std::uint32_t point) {
            return thisBlock.block.dip.displacement[point];
        });
    }
    __device__ bool triangleMoves(int triangle) const {
        bool moves = false;
        for (const std::uint32_t point : corners(triangle).points) {
            moves = moves || thisBlock.block.dip.masked[point] > 0;
        }
        return moves;
    }
    __device__ numerics::LaidCorners<float>& laid(int triangle) const {
        return thisBlock.block.dip.laid[triangle];
    }

    __device__ void barrier() const { thisBlock.block.team.barrier(); }
    __device__ float least(float value) const { return float(-largest(-double(value))); }
    __device__ bool anyOf(bool flag) const { return largest(flag ? 1.0 : 0.0) > 0; }

    template <typename Ask>
    __device__ bool anyPoint(const Ask& ask) const {
        bool any = false;
        forPoints([&](int point) { any = ask(point) || any; });
        return any;
    }
    template <typename Fold>
    __device__ float leastOver(float value, const Fold& fold) {
        forPoints([&](int point) { value = fold(point, value); });
        return least(value);
    }
    template <typename Work>
    __device__ void forPoints(const Work& work) const {
        const int count = numerics::pointCount(thisBlock.block.model);
        for (int point = thisBlock.block.team.thread(); point < count;
             point += thisBlock.block.team.threadCount()) {
            work(point);
        }
    }
    template <typename Crosses, typename Unfold>
    __device__ numerics::LineState<float> findCrossing(const Crosses& crosses,
                                                       const Unfold& unfold) const {
        numerics::LineState<float> line;
        const auto cross = [&](int triangle) {
            const numerics::UnfoldedTriangle<float> unfolded = unfold(triangle, corners(triangle));
            if (numerics::Lanes::index() == 0 && numerics::Lanes::side() == 0) {
                thisBlock.block.dip.crossing[triangle] = unfolded.crossing;
            }
            line = {fminf(line.steepness, unfolded.steepness), true,
                    fmaxf(line.upwards, unfolded.crossing.upwards)};
        };
        forListed(
            [&](int triangle) {
                const bool onLine = crosses(corners(triangle));
                thisBlock.block.dip.crosses[triangle] = onLine ? 1 : 0;
                return onLine;
            },
            cross);
        double found[3] = {-double(line.steepness), line.driven ? 1.0 : 0.0, double(line.upwards)};
        thisBlock.block.team.largest(found);
        return {float(-found[0]), found[1] > 0, float(found[2])};
    }
    template <typename Work>
    __device__ void forCrossing(const Work& work) const {
        forAllTriangles([&](int triangle) {
            if (thisBlock.block.dip.crosses[triangle]) {
                work(triangle, thisBlock.block.dip.crossing[triangle],
                     thisBlock.block.dip.anchors[triangle]);
            }
        });
    }
    template <typename OnLine, typename Floating>
    __device__ void forTriangles(const OnLine& onLine, const Floating& floating) const {
        forAllTriangles([&](int triangle) {
            if (thisBlock.block.dip.crosses[triangle]) {
                onLine(triangle, thisBlock.block.dip.crossing[triangle],
                       thisBlock.block.dip.anchors[triangle]);
            } else {
                floating(triangle);
            }
        });
    }
    template <typename OnLine, typename Floating>
    __device__ void forStretched(float, const OnLine& onLine, const Floating& floating) const {
        forTriangles(onLine, floating);
    }

    __host__ __device__ static constexpr numerics::NewtonLimits newtonLimits() { return {}; }
    __device__ void setFree() const {
        forPoints([&](int point) {
            thisBlock.block.dip.masked[point] = thisBlock.block.dip.free[point];
        });
    }
    __device__ numerics::FilmForce force(float drag) const { return forceOf(drag, false, 0); }
    __device__ numerics::FilmForce forceAlong(float length, float drag) const {
        return forceOf(drag, true, length);
    }
    __device__ numerics::Vector2<float> forceOn(int point) const {
        return plain(thisBlock.block.dip.forces[point]);
    }
    __device__ __noinline__ void prepareLinear(float drag) const {
        prepareCycle(thisBlock.block.model, thisBlock.block.dip, drag, thisBlock.block.team);
    }
    __device__ __noinline__ void solveLinear(float drag, numerics::Tangent tangent, double start,
                                             double tolerance) {
        numerics::solveGmres(*this, drag, tangent, start, tolerance);
    }
    __device__ double startOfStep() const {
        double longest = 0;
        forPoints([&](int point) {
            const float2 step = thisBlock.block.dip.newtonStep[point];
            thisBlock.block.dip.start[point] = thisBlock.block.dip.displacement[point];
            longest = fmax(longest, double(fmaxf(fabsf(step.x), fabsf(step.y))));
        });
        return largest(longest);
    }
    __device__ void keepBest() const {
        copy(thisBlock.block.dip.displacement, thisBlock.block.dip.best);
    }
    __device__ void takeBest() const {
        copy(thisBlock.block.dip.best, thisBlock.block.dip.displacement);
        thisBlock.block.team.barrier();
    }

    // Each block has its own problem, and one of its threads works on it.
    template <typename Work>
    __device__ double inSmallProblem(const Work& work) const {
        if (threadIdx.x == 0) {
            thisBlock.block.small.answer = work(thisBlock.block.small.problem);
        }
        __syncthreads();
        const double answer = thisBlock.block.small.answer;
        __syncthreads();
        return answer;
    }
    // The first basis vector already holds the forces.
    __device__ void startBasis(float factor) const {
        if (threadIdx.x == 0) {
            thisBlock.block.small.factors[0] = factor;
        }
        __syncthreads();
    }
    __device__ void extendBasis(int count, float drag, numerics::Tangent tangent) const {
        float2* next = thisBlock.block.dip.basis[count + 1];
        smoothBasis(count);
        std::int64_t products[numerics::mostBasisVectors] = {};
        multiply(thisBlock.block.model, thisBlock.block.dip, drag, tangent,
                 thisBlock.block.dip.smoothed[count], thisBlock.block.team,
                 [&](int point, float2 product) {
                     next[point] = product;
#pragma unroll
                     for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                         if (i <= count) {
                             const float2 earlier = thisBlock.block.dip.basis[i][point];
                             products[i] += numerics::ProductSum::multiple(
                                 double(product.x * earlier.x + product.y * earlier.y) *
                                 double(thisBlock.block.small.factors[i]));
                         }
                     }
                 });
        thisBlock.block.team.sum(products, count + 1);
        float weights[numerics::mostBasisVectors];
#pragma unroll
        for (int i = 0; i < numerics::mostBasisVectors; ++i) {
            if (i <= count) {
                weights[i] = float(numerics::ProductSum::value(products[i]) *
                                   double(thisBlock.block.small.factors[i]));
            }
        }
        numerics::SquareSum squares;
        forPoints([&](int point) {
            float2 left = next[point];
#pragma unroll
            for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                if (i <= count) {
                    left = left - thisBlock.block.dip.basis[i][point] * weights[i];
                }
            }
            next[point] = left;
            squares.add(double(left.x * left.x + left.y * left.y));
        });
        const double length = rootOf(squares);
        inSmallProblem([&](numerics::GmresProblem& problem) {
            double* column = problem.matrix[count];
#pragma unroll
            for (int i = 0; i < numerics::mostBasisVectors; ++i) {
                if (i <= count) {
                    column[i] = numerics::ProductSum::value(products[i]);
                }
            }
            column[count + 1] = length;
            thisBlock.block.small.factors[count + 1] = numerics::inverseLength(length);
            return 0.0;
        });
    }
    __device__ void setStep(int count) const {
        forPoints([&](int point) {
            float2 step{0, 0};
            for (int i = 0; i < count; ++i) {
                step = step - thisBlock.block.dip.smoothed[i][point] *
                                  float(thisBlock.block.small.problem.weights[i]);
            }
            thisBlock.block.dip.newtonStep[point] = step;
        });
    }

private:
    __device__ __noinline__ static void smoothBasis(int count) {
        multigridCycle(thisBlock.block.model, thisBlock.block.dip,
                       {thisBlock.block.dip.basis[count], thisBlock.block.small.factors[count],
                        thisBlock.block.model.columns},
                       thisBlock.block.dip.smoothed[count], thisBlock.block.team);
    }
    __device__ __noinline__ static double largest(double value) {
        double values[1] = {value};
        thisBlock.block.team.largest(values);
        return values[0];
    }
    __device__ __noinline__ static numerics::FilmForce forceOf(float drag, bool isAlong,
                                                               float length) {
        return cuda::force(thisBlock.block.model, thisBlock.block.dip, drag, isAlong, length,
                           thisBlock.block.team);
    }
    // Returns the root of the sum of all threads' squares.
    __device__ __noinline__ static double rootOf(numerics::SquareSum squares) {
        std::int64_t sums[2] = {squares.coarse, squares.rest};
        thisBlock.block.team.sum(sums);
        return numerics::SquareSum{sums[0], sums[1]}.root();
    }
    __device__ static numerics::Vector2<float> plain(float2 value) {
        return {value.x, value.y};
    }
    __device__ numerics::TriangleCorners corners(int triangle) const {
        return numerics::triangleCorners(thisBlock.block.model.columns, std::size_t(triangle));
    }
    template <typename Work>
    __device__ void forAllTriangles(const Work& work) const {
        const int count = numerics::triangleCount(thisBlock.block.model);
        for (int triangle = thisBlock.block.team.thread(); triangle < count;
             triangle += thisBlock.block.team.threadCount()) {
            work(triangle);
        }
    }
    // Calls work(triangle) for all triangles for which isMeant(triangle), each by the lanes of a
    // triangle. The warps of a block share these triangles evenly.
    template <typename IsMeant, typename Work>
    __device__ void forListed(const IsMeant& isMeant, const Work& work) const {
        constexpr int lanes = numerics::Lanes::count * numerics::Lanes::sides;
        constexpr int groups = Team::threads / lanes;
        constexpr int rounds = 8; // a list of 8 triangles per thread fits into the memory for tiles
        const int group = int(threadIdx.x) % 32 / lanes * Team::warps + int(threadIdx.x) / 32;
        const int all = numerics::triangleCount(thisBlock.block.model);
        const int threads = thisBlock.block.team.threadCount();
        int* list = reinterpret_cast<int*>(tileMemory);
        for (int begin = 0; begin < all; begin += rounds * threads) {
            if (threadIdx.x == 0) {
                thisBlock.block.listed = 0;
            }
            __syncthreads();
#pragma unroll 1
            for (int round = 0; round < rounds; ++round) {
                const int triangle = begin + round * threads + thisBlock.block.team.thread();
                if (triangle < all && isMeant(triangle)) {
                    list[atomicAdd(&thisBlock.block.listed, 1)] = triangle;
                }
            }
            __syncthreads();
            for (int i = group; i < thisBlock.block.listed; i += groups) {
                work(list[i]);
            }
            __syncthreads();
        }
    }
    __device__ void copy(const float2* from, float2* to) const {
        forPoints([&](int point) { to[point] = from[point]; });
    }

    numerics::StepState<float> state_;
};

static_assert(numerics::FilmBackend<CudaBackend> && numerics::GmresBackend<CudaBackend>);

// Runs at most `maximumSteps` steps of each film, with `blocksPerFilm` blocks per film. `teams`
// holds the memory of each film's team.
__global__ void __launch_bounds__(Team::threads, 1)
    productionSteps(const ProductionFilm* films, TeamMemory* teams, int blocksPerFilm,
                    int maximumSteps) {
    const int number = int(blockIdx.x) / blocksPerFilm;
    if (threadIdx.x == 0) {
        static_cast<ProductionFilm&>(thisBlock.block) = films[number];
    }
    __syncthreads();
    thisBlock.block.team.begin(teams + number, blocksPerFilm, int(blockIdx.x) % blocksPerFilm);
    CudaBackend film;
    for (int step = 0; step < maximumSteps && !numerics::isFinished(film); ++step) {
        numerics::step(film);
    }
    thisBlock.block.team.barrier(); // all threads have read the state
    if (thisBlock.block.team.block() == 0 && threadIdx.x == 0) {
        *thisBlock.block.dip.state = film.state();
    }
}

} // namespace dipwright::cuda

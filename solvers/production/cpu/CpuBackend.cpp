#include "production/cpu/CpuBackend.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <cmath>

namespace dipwright::cpu {

namespace {

// Adds factor · a to `count` points of `out` from the point `first` on.
void add(float factor, const PlaneVector& a, PlaneVector& out, std::size_t first,
         std::size_t count) {
    addScaled(count, factor, a.x.data() + first, out.x.data() + first);
    addScaled(count, factor, a.z.data() + first, out.z.data() + first);
}

// Sums of the rows, which are added up in the same order for any number of threads.
class RowSums {
public:
    RowSums(int rows, std::size_t sums) : sums_(sums), values_(std::size_t(rows) * sums) {}
    double& at(std::size_t row, std::size_t sum) { return values_[row * sums_ + sum]; }
    double total(std::size_t sum) const {
        double all = 0;
        for (std::size_t i = sum; i < values_.size(); i += sums_) {
            all += values_[i];
        }
        return all;
    }

private:
    std::size_t sums_;
    std::vector<double> values_;
};

} // namespace

static_assert(numerics::FilmBackend<CpuBackend> && numerics::GmresBackend<CpuBackend>);

CpuBackend::CpuBackend(const solver::DipSetup& setup)
    : HostFilm(setup), film_(model()), multigrid_(setup.film), areas_(setup.film.pointCount()),
      gradient_(setup.film.pointCount()), step_(setup.film.pointCount()),
      start_(setup.film.pointCount()), best_(setup.film.pointCount()),
      basis_(std::size_t(numerics::mostBasisVectors) + 1, PlaneVector(setup.film.pointCount())),
      smoothed_(std::size_t(numerics::mostBasisVectors), PlaneVector(setup.film.pointCount())),
      factors_(std::size_t(numerics::mostBasisVectors) + 1) {
    forPoints([&](int point) { areas_[std::size_t(point)] = pointArea(model(), point); });
    setFree();
}

void CpuBackend::setFree() {
    masked_ = free_;
    film_.setFree(masked_);
}

template <typename Work>
void CpuBackend::forRows(const Work& work) const {
    forRowBands(film_.rows(), film_.columns(), [&](int begin, int end) {
        for (int row = begin; row < end; ++row) {
            work(std::size_t(row) * std::size_t(film_.columns()));
        }
    });
}

double CpuBackend::rowDot(const PlaneVector& a, const PlaneVector& b, std::size_t first) const {
    const std::size_t width = std::size_t(film_.columns());
    return cpu::rowDot(a.x.data() + first, b.x.data() + first, width) +
           cpu::rowDot(a.z.data() + first, b.z.data() + first, width);
}

void CpuBackend::maskHeld(PlaneVector& v, std::size_t first) const {
    const std::size_t width = std::size_t(film_.columns());
    multiplyBy(width, masked_.data() + first, v.x.data() + first);
    multiplyBy(width, masked_.data() + first, v.z.data() + first);
}

numerics::FilmForce CpuBackend::force(float drag) {
    const FlushDenormals flush;
    const std::size_t width = std::size_t(film_.columns());
    RowSums squares(film_.rows(), 1);
    const double elastic = film_.gradient(displacement_, gradient_, [&](int row) {
        const std::size_t first = std::size_t(row) * width;
        const auto addDrag = [&](const std::vector<float>& now, const std::vector<float>& before,
                                 std::vector<float>& force) {
            addDifference(width, drag, areas_.data() + first, now.data() + first,
                          before.data() + first, force.data() + first);
        };
        addDrag(displacement_.x, before_.x, gradient_.x);
        addDrag(displacement_.z, before_.z, gradient_.z);
        maskHeld(gradient_, first);
        squares.at(std::size_t(row), 0) = rowDot(gradient_, gradient_, first);
    });
    return {std::sqrt(squares.total(0)), elastic};
}

numerics::FilmForce CpuBackend::forceAlong(float length, float drag) {
    const FlushDenormals flush;
    const std::size_t width = std::size_t(film_.columns());
    forRows([&](std::size_t first) {
        std::copy_n(start_.x.data() + first, width, displacement_.x.data() + first);
        std::copy_n(start_.z.data() + first, width, displacement_.z.data() + first);
        add(length, step_, displacement_, first, width);
    });
    return force(drag);
}

double CpuBackend::startOfStep() {
    start_ = displacement_;
    float longest = 0;
    for (std::size_t point = 0; point < step_.size(); ++point) {
        longest = std::max({longest, std::abs(step_.x[point]), std::abs(step_.z[point])});
    }
    return double(longest);
}

void CpuBackend::solveLinear(float drag, numerics::Tangent tangent, double start,
                             double tolerance) {
    const FlushDenormals flush;
    numerics::solveGmres(*this, drag, tangent, start, tolerance);
}

void CpuBackend::startLinear() {
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    basis_.front() = gradient_;
}

void CpuBackend::startBasis(float factor) {
    factors_.front() = double(factor);
}

template <typename WhenDone>
void CpuBackend::multiply(const PlaneVector& v, float drag, numerics::Tangent tangent,
                          PlaneVector& out, const WhenDone& whenDone) {
    const std::size_t width = std::size_t(film_.columns());
    film_.hessian(v, tangent, out, [&](int row) {
        const std::size_t first = std::size_t(row) * width;
        addWeighted(width, drag, areas_.data() + first, v.x.data() + first, out.x.data() + first);
        addWeighted(width, drag, areas_.data() + first, v.z.data() + first, out.z.data() + first);
        maskHeld(out, first);
        whenDone(std::size_t(row), first);
    });
}

// The new vector is made orthogonal to all others at once (classical Gram–Schmidt): one meeting of
// the threads, and the vectors are read once.
void CpuBackend::extendBasis(int count, float drag, numerics::Tangent tangent) {
    const std::size_t newest = std::size_t(count), width = std::size_t(film_.columns());
    multigrid_.apply(basis_[newest], float(factors_[newest]), smoothed_[newest]);
    PlaneVector& next = basis_[newest + 1];
    RowSums products(film_.rows(), newest + 1), squares(film_.rows(), 1);
    multiply(smoothed_[newest], drag, tangent, next, [&](std::size_t row, std::size_t first) {
        // The preconditioned system is nearly the identity. Without its main part, rounding errors
        // are smaller, and the basis stays orthogonal.
        add(-float(factors_[newest]), basis_[newest], next, first, width);
        for (std::size_t i = 0; i <= newest; ++i) {
            products.at(row, i) = rowDot(next, basis_[i], first);
        }
    });
    double* column = leastResiduals_.matrix[count];
    for (std::size_t i = 0; i <= newest; ++i) {
        column[i] = products.total(i) * factors_[i];
    }
    forRows([&](std::size_t first) {
        for (std::size_t i = 0; i <= newest; ++i) {
            add(-float(column[i] * factors_[i]), basis_[i], next, first, width);
        }
        squares.at(first / width, 0) = rowDot(next, next, first);
    });
    column[newest] += 1;
    const double size = std::sqrt(squares.total(0));
    column[newest + 1] = size;
    factors_[newest + 1] = size > 0 ? 1 / size : 0;
}

void CpuBackend::addToStep(int count) {
    forRows([&](std::size_t first) {
        for (int i = 0; i < count; ++i) {
            add(-float(leastResiduals_.weights[i]), smoothed_[std::size_t(i)], step_, first,
                std::size_t(film_.columns()));
        }
    });
}

double CpuBackend::linearResidual(float drag, numerics::Tangent tangent) {
    RowSums squares(film_.rows(), 1);
    PlaneVector& residual = basis_.front();
    multiply(step_, drag, tangent, residual, [&](std::size_t row, std::size_t first) {
        add(1, gradient_, residual, first, std::size_t(film_.columns()));
        squares.at(row, 0) = rowDot(residual, residual, first);
    });
    return std::sqrt(squares.total(0));
}

} // namespace dipwright::cpu

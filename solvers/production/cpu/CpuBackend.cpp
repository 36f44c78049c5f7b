#include "production/cpu/CpuBackend.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <array>
#include <cstdint>

namespace dipwright::cpu {

namespace {

void add(float factor, const PlaneVector& a, PlaneVector& out) {
    addScaled(out.size(), factor, a.x.data(), out.x.data());
    addScaled(out.size(), factor, a.z.data(), out.z.data());
}
// The products of a vector with the first basis vectors, in multiples (OrderlessSum.h).
struct BasisProducts {
    std::array<std::int64_t, std::size_t(numerics::mostBasisVectors)> multiples{};

    void add(const BasisProducts& other) {
        for (std::size_t i = 0; i < multiples.size(); ++i) {
            multiples[i] += other.multiples[i];
        }
    }
};

} // namespace

static_assert(numerics::FilmBackend<CpuBackend> && numerics::GmresBackend<CpuBackend>);

CpuBackend::CpuBackend(const solver::DipSetup& setup)
    : HostFilm(setup), film_(model()), multigrid_(setup.film), areas_(setup.film.pointCount()),
      gradient_(setup.film.pointCount()), step_(setup.film.pointCount()),
      start_(setup.film.pointCount()), best_(setup.film.pointCount()),
      basis_(std::size_t(numerics::mostBasisVectors) + 1, PlaneVector(setup.film.pointCount())),
      smoothed_(std::size_t(numerics::mostBasisVectors), PlaneVector(setup.film.pointCount())) {
    forPoints([&](int point) { areas_[std::size_t(point)] = pointArea(model(), point); });
    setFree();
}

void CpuBackend::setFree() {
    masked_ = free_;
    film_.setFree(masked_);
}

RowOfPairs CpuBackend::rowOf(const PlaneVector& v, int row) const {
    const std::size_t first = std::size_t(row) * std::size_t(film_.columns());
    return {v.x.data() + first, v.z.data() + first};
}

double CpuBackend::norm(const PlaneVector& v) const {
    const std::size_t width = std::size_t(film_.columns());
    return sumOverRows<numerics::SquareSum>(
               film_.rows(), film_.columns(),
               [&](int row) { return rowSquares(rowOf(v, row), width); })
        .root();
}

void CpuBackend::maskHeld(PlaneVector& v) const {
    multiplyBy(v.size(), masked_.data(), v.x.data());
    multiplyBy(v.size(), masked_.data(), v.z.data());
}

numerics::FilmForce CpuBackend::force(float drag) {
    const double elastic = film_.gradient(displacement_, gradient_);
    addDifference(gradient_.size(), drag, areas_.data(), displacement_.x.data(), before_.x.data(),
                  gradient_.x.data());
    addDifference(gradient_.size(), drag, areas_.data(), displacement_.z.data(), before_.z.data(),
                  gradient_.z.data());
    maskHeld(gradient_);
    return {norm(gradient_), elastic};
}

numerics::FilmForce CpuBackend::forceAlong(float length, float drag) {
    displacement_ = start_;
    add(length, step_, displacement_);
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
    numerics::solveGmres(*this, drag, tangent, start, tolerance);
}

void CpuBackend::startLinear() {
    std::fill(step_.x.begin(), step_.x.end(), 0.f);
    std::fill(step_.z.begin(), step_.z.end(), 0.f);
    basis_.front() = gradient_;
}

void CpuBackend::startBasis(float factor) {
    factors_.front() = factor;
}

void CpuBackend::multiply(const PlaneVector& v, float drag, numerics::Tangent tangent,
                          PlaneVector& out) {
    film_.hessian(v, tangent, out);
    addWeighted(out.size(), drag, areas_.data(), v.x.data(), out.x.data());
    addWeighted(out.size(), drag, areas_.data(), v.z.data(), out.z.data());
    maskHeld(out);
}

// Classical Gram–Schmidt: all products first.
void CpuBackend::extendBasis(int count, float drag, numerics::Tangent tangent) {
    const std::size_t newest = std::size_t(count);
    multigrid_.apply(basis_[newest], factors_[newest], smoothed_[newest]);
    PlaneVector& next = basis_[newest + 1];
    multiply(smoothed_[newest], drag, tangent, next);
    const int rows = film_.rows(), columns = film_.columns();
    const std::size_t width = std::size_t(columns);
    const auto products = sumOverRows<BasisProducts>(rows, columns, [&](int row) {
        BasisProducts ofRow;
        for (std::size_t i = 0; i <= newest; ++i) {
            ofRow.multiples[i] =
                rowProducts(rowOf(next, row), rowOf(basis_[i], row), factors_[i], width);
        }
        return ofRow;
    });
    double* column = leastResiduals_.matrix[count];
    for (std::size_t i = 0; i <= newest; ++i) {
        column[i] = numerics::ProductSum::value(products.multiples[i]);
    }
    const auto squares = sumOverRows<numerics::SquareSum>(rows, columns, [&](int row) {
        const std::size_t first = std::size_t(row) * width;
        for (std::size_t i = 0; i <= newest; ++i) {
            const float factor = -float(column[i] * double(factors_[i]));
            addScaled(width, factor, basis_[i].x.data() + first, next.x.data() + first);
            addScaled(width, factor, basis_[i].z.data() + first, next.z.data() + first);
        }
        return rowSquares(rowOf(next, row), width);
    });
    column[newest + 1] = squares.root();
    factors_[newest + 1] = numerics::inverseLength(column[newest + 1]);
}

void CpuBackend::addToStep(int count) {
    for (int i = 0; i < count; ++i) {
        add(-float(leastResiduals_.weights[i]), smoothed_[std::size_t(i)], step_);
    }
}

double CpuBackend::linearResidual(float drag, numerics::Tangent tangent) {
    PlaneVector& residual = basis_.front();
    multiply(step_, drag, tangent, residual);
    add(1, gradient_, residual);
    return norm(residual);
}

} // namespace dipwright::cpu

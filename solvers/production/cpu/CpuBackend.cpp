#include "production/cpu/CpuBackend.h"

#include "common/cpu/RowParallel.h"
#include "production/cpu/RowKernels.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace dipwright::cpu {

namespace {

// Computes out += factor·a at some points.
void add(float factor, const PlaneVector& a, PlaneVector& out, int first, int last) {
    const std::size_t from = std::size_t(first), count = std::size_t(last - first);
    addScaled(count, factor, a.x.data() + from, out.x.data() + from);
    addScaled(count, factor, a.z.data() + from, out.z.data() + from);
}
void copy(const PlaneVector& a, PlaneVector& out, int first, int last) {
    std::copy(a.x.begin() + first, a.x.begin() + last, out.x.begin() + first);
    std::copy(a.z.begin() + first, a.z.begin() + last, out.z.begin() + first);
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
    : HostFilm(setup), film_(model()), multigrid_(setup.film), masked_(setup.film.pointCount()),
      areas_(setup.film.pointCount()), gradient_(setup.film.pointCount()),
      step_(setup.film.pointCount()), start_(setup.film.pointCount()),
      best_(setup.film.pointCount()),
      basis_(std::size_t(numerics::mostBasisVectors) + 1, PlaneVector(setup.film.pointCount())),
      smoothed_(std::size_t(numerics::mostBasisVectors), PlaneVector(setup.film.pointCount())) {
    forPoints([&](int point) { areas_[std::size_t(point)] = pointArea(model(), point); });
    setFree();
}

void CpuBackend::setFree() {
    forBands([&](int first, int last) {
        std::copy(free_.begin() + first, free_.begin() + last, masked_.begin() + first);
    });
    film_.setFree(masked_);
}

RowOfPairs CpuBackend::rowOf(const PlaneVector& v, int row) const {
    const std::size_t first = std::size_t(row) * std::size_t(film_.columns());
    return {v.x.data() + first, v.z.data() + first};
}

std::pair<bool, bool> CpuBackend::heldInRow(int row) const {
    const int first = row * film_.columns();
    int held = 0;
    for (int point = first; point < first + film_.columns(); ++point) {
        held += isHeld(point);
    }
    return {held > 0, held == film_.columns()};
}

numerics::FilmForce CpuBackend::force(float drag) {
    const std::size_t width = std::size_t(film_.columns());
    const auto addDrag = [&](int row, const AlignedVector<float>& now,
                             const AlignedVector<float>& before, AlignedVector<float>& forces) {
        const std::size_t first = std::size_t(row) * width;
        addDifference(width, drag, areas_.data() + first, now.data() + first, before.data() + first,
                      forces.data() + first);
        multiplyBy(width, masked_.data() + first, forces.data() + first);
    };
    std::vector<numerics::SquareSum> squares(static_cast<std::size_t>(film_.rows()));
    const double elastic = film_.gradient(displacement_, gradient_, [&](int row) {
        addDrag(row, displacement_.x, before_.x, gradient_.x);
        addDrag(row, displacement_.z, before_.z, gradient_.z);
        squares[std::size_t(row)] = rowSquares(rowOf(gradient_, row), width);
    });
    return {sumOf(squares).root(), elastic};
}

numerics::FilmForce CpuBackend::forceAlong(float length, float drag) {
    forBands([&](int first, int last) {
        copy(start_, displacement_, first, last);
        add(length, step_, displacement_, first, last);
    });
    return force(drag);
}

double CpuBackend::startOfStep() {
    const std::size_t width = std::size_t(film_.columns());
    std::vector<float> longest(static_cast<std::size_t>(film_.rows()));
    forRows(film_.rows(), film_.columns(), [&](int row) {
        const int first = row * film_.columns();
        copy(displacement_, start_, first, first + film_.columns());
        longest[std::size_t(row)] = std::max(rowLargest(step_.x.data() + first, width),
                                             rowLargest(step_.z.data() + first, width));
    });
    return double(*std::max_element(longest.begin(), longest.end()));
}

void CpuBackend::keepBest() {
    forBands([&](int first, int last) { copy(displacement_, best_, first, last); });
}
void CpuBackend::takeBest() {
    forBands([&](int first, int last) { copy(best_, displacement_, first, last); });
}

void CpuBackend::solveLinear(float drag, numerics::Tangent tangent, double start,
                             double tolerance) {
    numerics::solveGmres(*this, drag, tangent, start, tolerance);
}

void CpuBackend::startBasis(float factor) {
    forBands([&](int first, int last) { copy(gradient_, basis_.front(), first, last); });
    factors_.front() = factor;
}

void CpuBackend::addDrag(int row, float drag, const PlaneVector& v, PlaneVector& product) const {
    const std::size_t width = std::size_t(film_.columns()), first = std::size_t(row) * width;
    const auto finish = [&](const AlignedVector<float>& from, AlignedVector<float>& out) {
        addWeighted(width, drag, areas_.data() + first, from.data() + first, out.data() + first);
        multiplyBy(width, masked_.data() + first, out.data() + first);
    };
    finish(v.x, product.x);
    finish(v.z, product.z);
}

// Classical Gram–Schmidt: all products first.
void CpuBackend::extendBasis(int count, float drag, numerics::Tangent tangent) {
    const std::size_t newest = std::size_t(count);
    multigrid_.apply(basis_[newest], factors_[newest], smoothed_[newest]);
    PlaneVector& next = basis_[newest + 1];
    const int rows = film_.rows(), columns = film_.columns();
    const std::size_t width = std::size_t(columns);
    std::vector<BasisProducts> ofRows(static_cast<std::size_t>(rows));
    film_.hessian(smoothed_[newest], tangent, next, [&](int row) {
        addDrag(row, drag, smoothed_[newest], next);
        for (std::size_t i = 0; i <= newest; ++i) {
            ofRows[std::size_t(row)].multiples[i] =
                rowProducts(rowOf(next, row), rowOf(basis_[i], row), factors_[i], width);
        }
    });
    const BasisProducts products = sumOf(ofRows);
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

void CpuBackend::setStep(int count) {
    forBands([&](int first, int last) {
        std::fill(step_.x.begin() + first, step_.x.begin() + last, 0.f);
        std::fill(step_.z.begin() + first, step_.z.begin() + last, 0.f);
        for (int i = 0; i < count; ++i) {
            add(-float(leastResiduals_.weights[i]), smoothed_[std::size_t(i)], step_, first, last);
        }
    });
}

} // namespace dipwright::cpu

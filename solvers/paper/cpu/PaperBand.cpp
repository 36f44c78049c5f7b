#include "paper/cpu/PaperBand.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright::cpu {

namespace {

constexpr int arraysPerWorkingRow = 4;
// A point that is farther than this from rest, in mm, wakes the film beside it. The motion is so
// sensitive that ignoring a millionth of a millimetre would change the result. With 0, sleeping
// film does not change a bit of the result.
constexpr float wakeDistance = 0;
constexpr float infinity = std::numeric_limits<float>::infinity();

WorkingRow workingRow(float* values, int stride) {
    return {values, values + stride, values + 2 * stride, values + 3 * stride};
}

WorkingRow advanced(WorkingRow row, int columns) {
    return {row.x + columns, row.y + columns, row.z + columns, row.weight + columns};
}

} // namespace

int rowsPerSweep(solver::Relaxation relaxation) {
    return relaxation == solver::Relaxation::Jacobi ? 1 : 2;
}

PaperBand::PaperBand(const PaperModel& model, SharedFilm& shared, int first, int last, int sweeps)
    : model_(model), shared_(shared), first_(first), last_(last),
      reach_(sweeps * rowsPerSweep(model.settings.relaxation)),
      firstLoaded_(std::max(0, first - reach_)),
      lastLoaded_(std::min(model.grid.rows, last + reach_)),
      ringRows_((sweeps + 2) * rowsPerSweep(model.settings.relaxation)) {
    const auto stride = std::size_t(model.stride);
    // One more cache line of padding keeps the rows' arrays from mapping to the same lines of the
    // cache.
    ring_.resize(std::size_t(ringRows_) * (arraysPerWorkingRow * stride + chunkColumns));
    noRow_.resize(arraysPerWorkingRow * stride);
    fromAbove_.resize(3 * stride * std::size_t(sweeps));
    approaches_.resize(std::size_t(lastLoaded_ - firstLoaded_) * std::size_t(model.chunks));
    motion_.resize(std::size_t(model.chunks));
    isNeeded_.resize(std::size_t(model.chunks));
    if (splitsColumns()) {
        unsplit_.resize(arraysPerWorkingRow * stride);
        allExist_.assign(stride, 1.0f);
        evenHasRight_.resize(stride / 2);
        oddHasRight_.resize(stride / 2);
        model.kernels.split(model.hasRight.data(), allExist_.data(), int(stride / 2));
        std::copy_n(allExist_.data(), stride / 2, evenHasRight_.data());
        std::copy_n(allExist_.data() + stride / 2, stride / 2, oddHasRight_.data());
        std::fill(allExist_.begin(), allExist_.end(), 1.0f);
    }
}

void PaperBand::run(const PaperPass& pass) {
    pass_ = pass;
    if (splitsColumns()) {
        runGaussSeidel();
    } else {
        runJacobi();
    }
}

// Processes the rows in order. Each row is loaded, and each sweep follows one row behind the
// previous sweep, so the rows in use stay in the cache. Near the end of the pass, the sweeps leave
// out the neighbours' rows, whose values are no longer known.
void PaperBand::runJacobi() {
    const int rows = model_.grid.rows, sweeps = pass_.sweeps;
    const int firstLoaded = std::max(0, first_ - sweeps);
    const int lastLoaded = std::min(rows, last_ + sweeps);
    for (int front = firstLoaded; front < lastLoaded + sweeps; ++front) {
        if (front < lastLoaded) {
            load(front);
        }
        for (int sweep = 1; sweep <= sweeps; ++sweep) {
            const int row = front - sweep, left = sweeps - sweep;
            if (row >= std::max(0, first_ - left) && row < std::min(rows, last_ + left)) {
                jacobi(row, sweep);
            }
        }
        if (isOwn(front - sweeps)) {
            store(front - sweeps);
        }
    }
}

void PaperBand::jacobi(int row, int sweep) {
    const bool isFirst = row == std::max(0, first_ - (pass_.sweeps - sweep));
    if (isFirst && row == 0) {
        const auto size = std::ptrdiff_t(3) * model_.stride;
        std::fill_n(fromAbove_.begin() + (sweep - 1) * size, size, 0.0f);
    } else if (isFirst) {
        jacobi(row - 1, sweep, shared_.activity.nothing());
    }
    jacobi(row, sweep, shared_.activity.isBusy(row));
}

void PaperBand::jacobi(int row, int sweep, const std::uint8_t* isBusy) {
    const int stride = model_.stride;
    const bool hasBelow = row < model_.grid.rows - 1;
    float* fromAbove = fromAbove_.data() + std::ptrdiff_t(3) * stride * (sweep - 1);
    JacobiTask task;
    task.row = working(row);
    task.below = hasBelow ? working(row + 1) : workingRow(noRow_.data(), stride);
    task.fromAbove = {fromAbove, fromAbove + stride, fromAbove + 2 * stride};
    task.share = (model_.isBorderRow(row) ? model_.borderShare : model_.innerShare).data();
    task.hasRight = model_.hasRight.data();
    task.columnStiffness = model_.columnStiffness.data();
    task.hasBelow = hasBelow ? 1.0f : 0.0f;
    task.rowStiffness = model_.isBorderRow(row) ? 0.5f : 1.0f;
    task.vertical = model_.vertical;
    task.rest = model_.rest;
    task.chunks = model_.chunks;
    task.isBusy = isBusy;
    task.isBusyBelow = hasBelow ? shared_.activity.isBusy(row + 1) : shared_.activity.nothing();
    if (model_.hasDiagonals) {
        model_.kernels.jacobiWithDiagonals(task);
    } else {
        model_.kernels.jacobi(task);
    }
}

// Processes the rows in pairs, 2·pair and 2·pair + 1. A sweep first solves the constraints along
// the pair's rows, then those between its two rows, and last those to the pair above. The next
// sweep follows one pair behind.
void PaperBand::runGaussSeidel() {
    const int rows = model_.grid.rows, sweeps = pass_.sweeps;
    const int first = first_ / 2, last = (last_ + 1) / 2, allPairs = (rows + 1) / 2;
    const int firstLoaded = std::max(0, first - sweeps);
    const int lastLoaded = std::min(allPairs, last + sweeps);
    for (int front = firstLoaded; front <= lastLoaded + sweeps; ++front) {
        for (int row = 2 * front; front < lastLoaded && row < std::min(rows, 2 * front + 2);
             ++row) {
            load(row);
        }
        for (int sweep = 1; sweep <= sweeps; ++sweep) {
            const int pair = front - sweep, beside = sweeps - sweep + 1;
            const int firstPair = std::max(0, first - beside);
            if (pair >= firstPair && pair < std::min(allPairs, last + beside)) {
                gaussSeidel(pair, pair > firstPair);
            }
        }
        const int finished = 2 * (front - sweeps);
        for (const int row : {finished - 1, finished}) {
            if (isOwn(row)) {
                store(row);
            }
        }
    }
}

void PaperBand::gaussSeidel(int pair, bool hasPairAbove) {
    const int row = 2 * pair;
    const bool isWhole = row + 1 < model_.grid.rows;
    solveAlongRow(row);
    if (isWhole) {
        solveAlongRow(row + 1);
        solveBetweenRows(row);
    }
    if (hasPairAbove) {
        solveBetweenRows(row - 1);
    }
}

void PaperBand::solve(const WorkingRow& first, const WorkingRow& second, std::array<float, 2> rest,
                      float length, float stiffness, const AlignedVector<float>& exists) const {
    PairTask task{first, second, rest, length, stiffness, model_.vertical, exists.data(), 0};
    const bool isWholeRow = &exists == &allExist_;
    const int pairs = (model_.grid.columns + 1) / 2;
    task.count =
        isWholeRow ? model_.stride : (pairs + chunkColumns - 1) / chunkColumns * chunkColumns;
    model_.kernels.pairs(task);
}

void PaperBand::solveAlongRow(int row) {
    const WorkingRow even = working(row), odd = advanced(even, model_.stride / 2);
    const std::array<float, 2> rest{model_.rest[0], 0};
    solve(even, odd, rest, model_.rest[0], 1, evenHasRight_);
    solve(odd, advanced(even, 1), rest, model_.rest[0], 1, oddHasRight_);
}

// Solves the constraints between a row and the row below it.
void PaperBand::solveBetweenRows(int row) {
    const WorkingRow even = working(row), odd = advanced(even, model_.stride / 2);
    const WorkingRow evenBelow = working(row + 1),
                     oddBelow = advanced(evenBelow, model_.stride / 2);
    const auto [x, z, diagonal] = model_.rest;
    solve(even, evenBelow, {0, z}, z, 1, allExist_);
    if (model_.hasDiagonals) {
        solve(even, oddBelow, {x, z}, diagonal, 0.5f, evenHasRight_);
        solve(odd, advanced(evenBelow, 1), {x, z}, diagonal, 0.5f, oddHasRight_);
        solve(evenBelow, odd, {x, -z}, diagonal, 0.5f, evenHasRight_);
        solve(oddBelow, advanced(even, 1), {x, -z}, diagonal, 0.5f, oddHasRight_);
    }
}

void PaperBand::load(int row) {
    const auto chunks = std::size_t(model_.chunks);
    const std::uint8_t* isPresent = shared_.activity.isPresent(row);
    const auto bodyStep = float(model_.stepLength());
    const auto margin = float(model_.clearanceMargin);
    Approach* approach = approaches(row);
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        approach[chunk].travelled += pass_.predicts ? bodyStep : 0.0f;
        const bool isNear = pass_.predicts && approach[chunk].isNear(margin);
        isNeeded_[chunk] = isPresent[chunk] || isNear || splitsColumns();
    }

    LoadTask task;
    task.from = isOwn(row) ? shared_.film.row(row) : shared_.published[shared_.read].row(row);
    task.to = splitsColumns() ? workingRow(unsplit_.data(), model_.stride) : working(row);
    task.chunks = model_.chunks;
    task.isNeeded = isNeeded_.data();
    task.descent = float(pass_.descent);
    task.inertia = pass_.predicts ? 1.0f : 0.0f;
    task.keepsPrevious = pass_.predicts && isOwn(row);
    task.motion = motion_.data();
    model_.kernels.load(task);

    for (std::size_t chunk = 0; pass_.predicts && chunk < chunks; ++chunk) {
        // The points moved by `motion_` in the last step. They may move as far again until the end
        // of this step.
        approach[chunk].travelled += motion_[chunk];
        if (approach[chunk].isNear(margin + motion_[chunk])) {
            findContacts(row, int(chunk));
            if (isOwn(row) && approach[chunk].isNear(margin)) {
                shared_.activity.hasMoved(row)[chunk] =
                    1; // film near the body must be awake before it makes contact
            }
        }
    }
    if (splitsColumns()) {
        const WorkingRow to = working(row);
        const int half = model_.stride / 2;
        model_.kernels.split(task.to.x, to.x, half);
        model_.kernels.split(task.to.y, to.y, half);
        model_.kernels.split(task.to.z, to.z, half);
        model_.kernels.split(task.to.weight, to.weight, half);
    }
}

void PaperBand::store(int row) {
    StoreTask task;
    task.from = working(row);
    if (splitsColumns()) {
        const int half = model_.stride / 2;
        const WorkingRow merged = workingRow(unsplit_.data(), model_.stride);
        model_.kernels.merge(task.from.x, merged.x, half);
        model_.kernels.merge(task.from.y, merged.y, half);
        model_.kernels.merge(task.from.z, merged.z, half);
        model_.kernels.merge(task.from.weight, merged.weight, half);
        task.from = merged;
    }
    task.to = shared_.film.row(row);
    task.chunks = model_.chunks;
    task.isBusy = shared_.activity.isBusy(row);
    task.wakeDistance = wakeDistance;
    task.hasMoved = shared_.activity.hasMoved(row);
    model_.kernels.store(task);
    if (isReadByNeighbour(row)) {
        shared_.published[1 - shared_.read].copyRow(row, shared_.film);
    }
}

// Tests the points of the chunk whose predicted positions may touch the body.
void PaperBand::findContacts(int row, int chunk) {
    WorkingRow points = splitsColumns() ? workingRow(unsplit_.data(), model_.stride) : working(row);
    Approach& approach = approaches(row)[chunk];
    const float motion = motion_[std::size_t(chunk)];
    const float reached = approach.travelled + motion + float(model_.clearanceMargin);
    approach.nearest = infinity;
    for (int lane = 0; lane < chunkColumns; ++lane) {
        const int i = chunk * chunkColumns + lane;
        if (points.weight[i] == 0) {
            continue;
        }
        float& untouchedUntil = approach.points[std::size_t(lane)];
        if (untouchedUntil <= reached) {
            const numerics::Vector3<double> world{model_.grid.restX(i) + double(points.x[i]),
                                                  points.y[i],
                                                  model_.grid.restZ(row) + double(points.z[i])};
            const numerics::Vector3<double> place = pass_.frame.toBody(world);
            const auto sample = numerics::sampleField(model_.field, place);
            if (sample.distance <= model_.settings.contactDistance) {
                adhere(row, i, place);
                continue;
            }
            untouchedUntil = approach.travelled + float(numerics::clearance(sample)) - motion;
        }
        approach.nearest = std::min(approach.nearest, untouchedUntil);
    }
}

// Makes the point adhere at the contact distance, where ∇φ leads from `place`.
void PaperBand::adhere(int row, int column, numerics::Vector3<double> place) {
    place = numerics::onLevel(model_.field, place, model_.settings.contactDistance);
    const numerics::Vector3<double> anchor = model_.frameAtStart.toWorld(place);
    const auto x = float(anchor.x - model_.grid.restX(column));
    const auto y = float(anchor.y);
    const auto z = float(anchor.z - model_.grid.restZ(row));
    WorkingRow points = splitsColumns() ? workingRow(unsplit_.data(), model_.stride) : working(row);
    points.x[column] = x;
    points.y[column] = y - float(pass_.descent);
    points.z[column] = z;
    points.weight[column] = 0;
    if (isOwn(row)) {
        const StoredRow stored = shared_.film.row(row);
        stored.x[column] = stored.previousX[column] = x;
        stored.y[column] = stored.previousY[column] = y;
        stored.z[column] = stored.previousZ[column] = z;
        stored.weight[column] = 0;
        stored.sinking[column] = 1;
        shared_.activity.hasMoved(row)[column / chunkColumns] = 1;
        --shared_.activity.freePoints(row)[column / chunkColumns];
    }
}

bool PaperBand::isReadByNeighbour(int row) const {
    return (first_ > 0 && row < first_ + reach_) ||
           (last_ < model_.grid.rows && row >= last_ - reach_);
}

WorkingRow PaperBand::working(int row) {
    const std::ptrdiff_t size = std::ptrdiff_t(arraysPerWorkingRow) * model_.stride + chunkColumns;
    return workingRow(ring_.data() + (row % ringRows_) * size, model_.stride);
}

PaperBand::Approach* PaperBand::approaches(int row) {
    return approaches_.data() + std::ptrdiff_t(row - firstLoaded_) * model_.chunks;
}

} // namespace dipwright::cpu

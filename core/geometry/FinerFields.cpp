#include "geometry/FinerFields.h"

#include "geometry/SurfaceQuery.h"
#include "parallel/Tasks.h"

namespace dipwright {

FinerFields::FinerFields(TriangleMesh body, const FieldGrid& usual) : body_(std::move(body)) {
    double spacing = usual.spacing / 2;
    for (FieldGrid grid = boxGrid(body_, spacing); grid.sampleCount() <= mostFinerSamples;
         grid = boxGrid(body_, spacing)) {
        levels_.push_back({grid, nullptr});
        spacing /= 2;
    }
}

const DistanceField& FinerFields::level(int level, const Progress& progress) const {
    const std::lock_guard lock(building_);
    Level& wanted = levels_[std::size_t(level - 1)];
    if (!wanted.field) {
        // Without runIsolated(), the loops here could start a task that waits for this lock.
        runIsolated([&] {
            wanted.field = std::make_unique<const DistanceField>(
                buildDistanceField(body_, SurfaceQuery(body_), wanted.grid, progress));
        });
    }
    return *wanted.field;
}

int fieldLevel(const DistanceField& usual, double filmCell) {
    const int count = usual.finer ? usual.finer->count() : 0;
    const double most = mostFieldCell * filmCell;
    int level = usual.spacing <= most || count == 0 ? 0 : 1;
    while (level > 0 && level < count && usual.finer->spacing(level) > most) {
        ++level;
    }
    return level;
}

const DistanceField& fieldAtLevel(const DistanceField& usual, int level, const Progress& progress) {
    return level > 0 ? usual.finer->level(level, progress) : usual;
}

} // namespace dipwright

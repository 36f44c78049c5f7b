#include "geometry/FinerFields.h"

#include "geometry/FieldCache.h"
#include "geometry/SurfaceQuery.h"
#include "parallel/Tasks.h"

#include <algorithm>
#include <mutex>

namespace dipwright {

struct FinerFields::Level {
    FieldGrid grid;
    std::mutex building;
    std::shared_ptr<const DistanceField> field; // null until it is needed
};

FinerFields::FinerFields(TriangleMesh body, const FieldGrid& usual, const QString& name)
    : body_(std::move(body)), name_(name) {
    double spacing = usual.spacing / 2;
    for (FieldGrid grid = boxGrid(body_, spacing); grid.sampleCount() <= mostFinerSamples;
         grid = boxGrid(body_, spacing)) {
        levels_.push_back(std::make_unique<Level>());
        levels_.back()->grid = grid;
        spacing /= 2;
    }
}

FinerFields::~FinerFields() = default;

double FinerFields::spacing(int level) const {
    return levels_[std::size_t(level - 1)]->grid.spacing;
}

const DistanceField& FinerFields::level(int level, const Progress& progress) const {
    Level& wanted = *levels_[std::size_t(level - 1)];
    const std::lock_guard lock(wanted.building);
    if (!wanted.field) {
        // Without runIsolated(), the loops here could start a task that waits for this lock.
        runIsolated([&] {
            wanted.field = fieldFromCache(QStringLiteral("%1-%2").arg(name_).arg(level), [&] {
                return buildDistanceField(body_, SurfaceQuery(body_), wanted.grid, progress);
            });
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

int coarserFieldLevel(const DistanceField& usual, double filmCell) {
    return std::max(fieldLevel(usual, filmCell) - 1, 0);
}

const DistanceField& fieldAtLevel(const DistanceField& usual, int level, const Progress& progress) {
    return level > 0 ? usual.finer->level(level, progress) : usual;
}

} // namespace dipwright

// Distance fields of one body with smaller cells than its usual field. Film with small cells needs
// them, because a field rounds edges and valleys by about one of its cells (docs/film-model.md,
// "The distance field's cells").
#pragma once

#include "geometry/DistanceField.h"

#include <vector>

namespace dipwright {

// The cells of level L (1, 2, …) are 2^L times smaller than the usual ones. A level is built when
// it is first needed, and kept. Any thread.
class FinerFields {
public:
    // `usual` is the grid of the body's usual field. `name` is that field's name in the cache on
    // disk, which also keeps the levels.
    FinerFields(TriangleMesh body, const FieldGrid& usual, const QString& name);
    ~FinerFields();

    // Returns the number of levels: those with at most mostFinerSamples.
    int count() const { return int(levels_.size()); }
    double spacing(int level) const;
    // Uses all cores. Throws Cancelled.
    const DistanceField& level(int level, const Progress& progress) const;

private:
    struct Level;

    TriangleMesh body_;
    QString name_;
    std::vector<std::unique_ptr<Level>> levels_;
};

// The largest number of samples of a level; they take 512 MiB.
inline constexpr std::size_t mostFinerSamples = std::size_t(1) << 27;
// The largest cell of the field for a film, relative to the film's smallest cell.
inline constexpr double mostFieldCell = 1.0 / 2;

// Returns the level for a film whose smallest cells are `filmCell` mm wide: the first one with
// cells of at most mostFieldCell of that, or the last one. 0 stands for `usual` itself, also if it
// has no finer fields.
int fieldLevel(const DistanceField& usual, double filmCell);
// Returns the level for the coarser films of a dip whose own film has cells of `filmCell` mm: the
// one below fieldLevel(), so that the films also differ by the error of the field.
int coarserFieldLevel(const DistanceField& usual, double filmCell);
// Returns the field of a level. `usual` must outlive the result.
const DistanceField& fieldAtLevel(const DistanceField& usual, int level, const Progress& progress);

} // namespace dipwright

// Encodes and decodes one dip for the project's dip cache. Private to this folder.
#pragma once

#include "accuracy/error/NumericalErrorEstimate.h"
#include "base/Error.h"
#include "film/DippedFilm.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <memory>

namespace dipwright {

// A dip as the cache holds it.
struct CachedDip {
    DippedFilm film;
    double refinement = 1;                                        // ImmersionResult::refinement
    std::shared_ptr<const NumericalErrorEstimate> numericalError; // null: not estimated
};

// Encodes a dip.
QByteArray cachedDip(const CachedDip& dip);
// Decodes a dip. `gridOf` returns the film's grid for a refinement. Checks every value against its
// range and never reads beyond the bytes. Throws Error if the bytes are not a dip of such a film.
using GridOfRefinement = std::function<solver::FilmGrid(double refinement)>;
CachedDip readCachedDip(const QByteArray& bytes, const GridOfRefinement& gridOf, bool isotropic,
                        const QString& where);
// Returns the error for a damaged cache file `where`.
Error damagedDips(const QString& where);

} // namespace dipwright

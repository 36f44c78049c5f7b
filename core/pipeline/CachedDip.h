// Encodes and decodes one dip for the project's dip cache. Private to this folder.
#pragma once

#include "accuracy/error/NumericalErrorEstimate.h"
#include "base/Error.h"
#include "film/DippedFilm.h"

#include <QByteArray>
#include <QString>
#include <memory>

namespace dipwright {

// A dip as the cache holds it.
struct CachedDip {
    DippedFilm film;
    std::shared_ptr<const NumericalErrorEstimate> numericalError; // null: not estimated
};

// Encodes a dip.
QByteArray cachedDip(const CachedDip& dip);
// Decodes a dip with the film points of `grid`. Checks every value against its range and never
// reads beyond the bytes. Throws Error if the bytes are not a dip of such a film.
CachedDip readCachedDip(const QByteArray& bytes, const solver::FilmGrid& grid, bool isotropic,
                        const QString& where);
// Returns the error for a damaged cache file `where`.
Error damagedDips(const QString& where);

} // namespace dipwright

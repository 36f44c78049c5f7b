// One dip as the file of kept dips holds it. Private to this folder.
#pragma once

#include "accuracy/certainty/CertaintyEstimate.h"
#include "base/Error.h"
#include "film/DippedFilm.h"

#include <QByteArray>
#include <QString>
#include <memory>

namespace dipwright {

struct CachedDip {
    DippedFilm film;
    std::shared_ptr<const CertaintyEstimate> certainty; // null: none was made
};

QByteArray cachedDip(const CachedDip& dip);
// Of the points of `grid`. Throws Error where the bytes are not those of a dip of such a film:
// every value is held against what it may be, and no more is taken than there is.
CachedDip readCachedDip(const QByteArray& bytes, const solver::FilmGrid& grid, bool isotropic,
                        const QString& where);
// What is wrong with a file of kept dips, in which `where` is.
Error damagedDips(const QString& where);

} // namespace dipwright

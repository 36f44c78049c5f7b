// Pairs of places come in a table, and what follows from them goes out as numbers, a table and
// pictures (docs/files-and-commands.md, "Part files").
#pragma once

#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"

#include <QDateTime>
#include <QImage>
#include <QStringList>
#include <optional>

namespace dipwright {

// Of the bytes of a table with the columns photo (from 1), x_px, y_px, x_mm, y_mm, z_mm under these
// names. Throws Error, naming `where` and the line, for anything else.
std::vector<PlacePair> readPairs(const QByteArray& table, int photos, const QString& where);

// Of the bytes of part-places.csv, or of a table like it. Throws Error as readPairs() does.
std::vector<PrintedPlace> readPlaces(const QByteArray& table, int photos, const QString& where);

struct PartPhoto {
    QString where, sha256;
    QImage picture;
    std::optional<QDateTime> taken = std::nullopt;
};

// Photos of one part are all held at once, 4 bytes a pixel.
inline constexpr qint64 mostPartPixels = 400'000'000;

// One more photo of a part. Throws Error where it is of another size than the others, or where they
// have more than mostPartPixels together; `photos` is then as it was.
void addPartPhoto(std::vector<PartPhoto>& photos, PartPhoto photo);

// The photo, with a line from where each of its places is expected to where it is seen, as in the
// paper's Figure 8, `times` as long as it is.
QImage pairsPicture(const PartPhoto& photo, int index, const std::vector<PlacePair>& pairs,
                    const PartView& view, double times);

// Replaces part-view.json, part-figures.csv, part-pairs.csv and part-photo-N.png in `folder`
// together, and part-places.csv, of places that were found, where there are any: `pairs` are then
// theirs. Needs a QGuiApplication. Throws Error.
void writePartView(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& pairs,
                   const PartView& view, const std::vector<PrintedPlace>& places,
                   const QString& folder);

} // namespace dipwright

// Reads pairs of places from a table and writes the camera's results as numbers, tables and
// pictures (docs/files-and-commands.md, "Part files").
#pragma once

#include "inspection/PartCamera.h"
#include "inspection/PrintedPlace.h"

#include <QDateTime>
#include <QImage>
#include <QStringList>
#include <optional>

namespace dipwright {

// Reads a table with the columns photo (from 1), x_px, y_px, x_mm, y_mm and z_mm, under these
// names. Throws Error, naming `where` and the line, if the table is different.
std::vector<PlacePair> readPairs(const QByteArray& table, int photos, const QString& where);
// Throws Error, naming the line of the table, if a place is outside its photo.
void requireInPhotos(const std::vector<PlacePair>& pairs, QSize picture, const QString& where);

// Reads part-places.csv, or a table like it. Throws Error as readPairs() does.
std::vector<PrintedPlace> readPlaces(const QByteArray& table, int photos, const QString& where);

struct PartPhoto {
    QString where, sha256;
    QImage picture;
    std::optional<QDateTime> taken = std::nullopt;
};

// Limit for the pixels of all photos of one part. They are in memory together, with 4 bytes per
// pixel.
inline constexpr qint64 mostPartPixels = 400'000'000;

// Adds a photo of the part. Throws Error, without changing `photos`, if it is the same as another,
// if its size differs from the others', or if all together exceed mostPartPixels.
void addPartPhoto(std::vector<PartPhoto>& photos, PartPhoto photo);

// Returns the photo with a line from each expected place towards the seen place, as in the paper's
// Figure 8. The lines are `times` as long as the distances.
QImage pairsPicture(const PartPhoto& photo, int index, const std::vector<PlacePair>& pairs,
                    const PartView& view, double times);

// Replaces part-view.json, part-figures.csv, part-pairs.csv and part-photo-N.png in `folder`, all
// or none. If `places` is not empty, also writes part-places.csv; `pairs` must then be the same
// places. Needs a QGuiApplication. Throws Error.
void writePartView(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& pairs,
                   const PartView& view, const std::vector<PrintedPlace>& places,
                   const QString& folder);

} // namespace dipwright

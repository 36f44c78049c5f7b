#include "inspection/PartViewFiles.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/Png.h"
#include "disk/FolderTransaction.h"
#include "inspection/SamePhoto.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QTextStream>
#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::PartCamera)
};

constexpr int mostPhotos = 50;
constexpr qsizetype mostPairs = 10'000;
constexpr double mostPixel = 100'000, mostMillimetres = 100'000;
const QByteArray columns = "photo,x_px,y_px,x_mm,y_mm,z_mm";
const QByteArray placeColumns = "photo,x_px,y_px,dip,sheet_x_mm,sheet_y_mm,x_mm,y_mm,z_mm";

QString photoName(std::size_t index) {
    return QStringLiteral("part-photo-%1.png").arg(index + 1);
}

struct TableLine {
    int number = 1; // in the file, from 1
    std::vector<double> values;
};

// Returns the numbers in each line of a table. A line has a whole number from 1 to `photos`, two
// numbers in pixels, and numbers in millimetres. `kind` describes a line in error messages.
std::vector<TableLine> numbersOf(const QByteArray& table, const QByteArray& header, int photos,
                                 const QString& kind, const QString& where) {
    const QByteArray mark = "\xef\xbb\xbf"; // byte order mark that some spreadsheets write
    const QList<QByteArray> lines =
        (table.startsWith(mark) ? table.mid(mark.size()) : table).split('\n');
    if (lines.first().trimmed() != header) {
        throw Error(
            Text::tr("The first line of the pairs must be %1").arg(QString::fromLatin1(header)),
            where);
    }
    const auto count = header.count(',') + 1;
    std::vector<TableLine> all;
    for (qsizetype i = 1; i < lines.size(); ++i) {
        if (lines[i].trimmed().isEmpty()) {
            continue;
        }
        const QList<QByteArray> cells = lines[i].split(',');
        bool isGood = cells.size() == count;
        std::vector<double> values;
        for (qsizetype cell = 0; isGood && cell < count; ++cell) {
            values.push_back(cells[cell].trimmed().toDouble(&isGood));
            const double most = cell == 0 ? photos : cell < 3 ? mostPixel : mostMillimetres;
            isGood = isGood && std::abs(values.back()) <= most;
        }
        if (!isGood || values[0] < 1 || values[0] != std::floor(values[0])) {
            throw Error(Text::tr("Line %1 of the pairs must contain %2").arg(i + 1).arg(kind),
                        where);
        }
        all.push_back({int(i) + 1, std::move(values)});
        if (qsizetype(all.size()) > mostPairs) {
            throw Error(Text::tr("There are more than %1 pairs; give fewer").arg(mostPairs), where);
        }
    }
    return all;
}

QJsonObject toJson(const PartFigures& figures) {
    return {{"count", figures.count},
            {"mean_px", figures.meanPixels},
            {"deviation_px", figures.deviationPixels},
            {"share_of_diagonal", figures.shareOfDiagonal},
            {"p95_mm", figures.percentile95},
            {"worst_mm", figures.worst},
            {"worst_pair", qint64(figures.worstPair) + 1}};
}

QJsonArray rows(const Eigen::Matrix3d& matrix) {
    QJsonArray all;
    for (int row = 0; row < 3; ++row) {
        all.append(QJsonArray{matrix(row, 0), matrix(row, 1), matrix(row, 2)});
    }
    return all;
}

QByteArray jsonOf(const std::vector<PartPhoto>& photos, const PartView& view) {
    QJsonArray list;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const PartPose& pose = view.photos[i];
        list.append(
            QJsonObject{{"file", QFileInfo(photos[i].where).fileName()},
                        {"sha256", photos[i].sha256},
                        {"turn", rows(pose.turn)},
                        {"shift_mm", QJsonArray{pose.shift.x(), pose.shift.y(), pose.shift.z()}}});
    }
    return QJsonDocument(QJsonObject{{"version", 1},
                                     {"focal_length",
                                      QJsonArray{view.focalLength.value, view.focalLength.off}},
                                     {"k1", view.lens.k1},
                                     {"figures", toJson(view.figures)},
                                     {"photos", list}})
        .toJson();
}

QByteArray tableOf(const std::vector<PlacePair>& pairs, const PartView& view) {
    QByteArray table;
    QTextStream out(&table);
    out << columns << ",off_x_px,off_y_px,off_mm\n";
    const auto number = [](double value) { return QString::number(value, 'f', 4); };
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PlacePair& pair = pairs[i];
        out << pair.photo + 1;
        for (const double value :
             {pair.pixel.x(), pair.pixel.y(), pair.model.x(), pair.model.y(), pair.model.z(),
              view.off[i].pixels.x(), view.off[i].pixels.y(), view.off[i].millimetres}) {
            out << ',' << number(value);
        }
        out << '\n';
    }
    out.flush();
    return table;
}

// Returns a table like the paper's Table II, with one line per photo and one for all.
QByteArray figuresTable(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& pairs,
                        const PartView& view) {
    QByteArray table;
    QTextStream out(&table);
    out << "photo,count,mean_px,deviation_px,percent_of_diagonal,p95_mm,worst_mm\n";
    const auto line = [&](const QString& name, const PartFigures& figures) {
        out << name << ',' << figures.count;
        for (const double value :
             {figures.meanPixels, figures.deviationPixels, 100 * figures.shareOfDiagonal,
              figures.percentile95, figures.worst}) {
            out << ',' << QString::number(value, 'f', 4);
        }
        out << '\n';
    };
    for (std::size_t i = 0; i < photos.size(); ++i) {
        line(QString::number(i + 1), figuresOfPhoto(view, pairs, int(i), photos[i].picture.size()));
    }
    line(QStringLiteral("all"), view.figures);
    out.flush();
    return table;
}

QByteArray placesTable(const std::vector<PrintedPlace>& places) {
    QByteArray table;
    QTextStream out(&table);
    out << placeColumns << "\n";
    const auto number = [](double value) { return QString::number(value, 'f', 4); };
    for (const PrintedPlace& place : places) {
        out << place.photo + 1 << ',' << number(place.pixel.x()) << ',' << number(place.pixel.y())
            << ',' << place.dip + 1;
        for (const double value : {place.sheet.x(), place.sheet.y(), place.model.x(),
                                   place.model.y(), place.model.z()}) {
            out << ',' << number(value);
        }
        out << '\n';
    }
    out.flush();
    return table;
}

// Returns the enlargement with which the longest line is at most a twentieth of the picture.
double enlargement(const PartView& view, QSize picture) {
    double longest = 1e-3;
    for (const PairDistance& off : view.off) {
        longest = std::max(longest, off.pixels.norm());
    }
    const double times = std::max(picture.width(), picture.height()) / 20.0 / longest;
    return std::max(1.0, std::pow(10, std::floor(std::log10(times))));
}

} // namespace

std::vector<PlacePair> readPairs(const QByteArray& table, int photos, const QString& where) {
    std::vector<PlacePair> pairs;
    for (const auto& [line, v] :
         numbersOf(table, columns, photos,
                   Text::tr("a photo number, two coordinates in pixels and three in millimetres, "
                            "separated by commas"),
                   where)) {
        pairs.push_back({int(v[0]) - 1, {v[1], v[2]}, {v[3], v[4], v[5]}, line});
    }
    return pairs;
}

void requireInPhotos(const std::vector<PlacePair>& pairs, QSize picture, const QString& where) {
    for (const PlacePair& pair : pairs) {
        const bool isInside = pair.pixel.x() >= 0 && pair.pixel.x() <= picture.width() &&
                              pair.pixel.y() >= 0 && pair.pixel.y() <= picture.height();
        if (!isInside) {
            throw Error(Text::tr("Line %1 of the pairs names a place outside the photo, which has "
                                 "%2 × %3 pixels; correct the place")
                            .arg(pair.line)
                            .arg(picture.width())
                            .arg(picture.height()),
                        where);
        }
    }
}

std::vector<PrintedPlace> readPlaces(const QByteArray& table, int photos, const QString& where) {
    const QString kind =
        Text::tr("a photo number, two coordinates in pixels, a dip number, two sheet coordinates "
                 "and three model coordinates in millimetres, separated by commas");
    std::vector<PrintedPlace> places;
    for (const auto& [line, v] : numbersOf(table, placeColumns, photos, kind, where)) {
        if (v[3] != 1 && v[3] != 2) {
            throw Error(Text::tr("Line %1 of the pairs must contain %2").arg(line).arg(kind),
                        where);
        }
        places.push_back(
            {int(v[0]) - 1, {v[1], v[2]}, int(v[3]) - 1, {v[4], v[5]}, {v[6], v[7], v[8]}});
    }
    return places;
}

void addPartPhoto(std::vector<PartPhoto>& photos, PartPhoto photo) {
    requireNewPhoto(photos, photo);
    const QSize size = photo.picture.size();
    if (!photos.empty() && photos.front().picture.size() != size) {
        throw Error(
            Text::tr(
                "The photos have different sizes; use photos of one camera, held the same way"),
            photo.where);
    }
    const qint64 pixels = qint64(size.width()) * size.height() * qint64(photos.size() + 1);
    if (pixels > mostPartPixels) {
        throw Error(Text::tr("With this photo, the part's photos have %1 million pixels in total, "
                             "but the limit is %2 million; use fewer or smaller photos")
                        .arg(pixels / 1'000'000)
                        .arg(mostPartPixels / 1'000'000),
                    photo.where);
    }
    photos.push_back(std::move(photo));
}

QImage pairsPicture(const PartPhoto& photo, int index, const std::vector<PlacePair>& pairs,
                    const PartView& view, double times) {
    QImage picture = photo.picture.convertToFormat(QImage::Format_RGB32);
    const double unit = std::max(picture.width(), picture.height()) / 500.0; // pixels
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (pairs[i].photo != index) {
            continue;
        }
        const Eigen::Vector2d expected = pairs[i].pixel - view.off[i].pixels;
        const Eigen::Vector2d end = expected + times * view.off[i].pixels;
        const QPointF from(expected.x(), expected.y());
        for (const auto& [colour, width] :
             {std::pair(QColor(Qt::white), 1.6), std::pair(QColor(200, 30, 60), 0.8)}) {
            painter.setPen(QPen(colour, width * unit, Qt::SolidLine, Qt::RoundCap));
            painter.drawEllipse(from, 2 * unit, 2 * unit);
            painter.drawLine(from, QPointF(end.x(), end.y()));
        }
    }
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(std::max(8, int(9 * unit)));
    painter.setFont(font);
    const QString words =
        Text::tr("Rings: expected places · lines: deviations of the seen places, scale %1:1")
            .arg(roundedText(times, 3));
    const QRectF band(0, 0, picture.width(), 14 * unit);
    painter.fillRect(band, QColor(255, 255, 255, 210));
    painter.setPen(Qt::black);
    painter.drawText(band.adjusted(4 * unit, 0, 0, 0), Qt::AlignVCenter, words);
    return picture;
}

void writePartView(const std::vector<PartPhoto>& photos, const std::vector<PlacePair>& pairs,
                   const PartView& view, const std::vector<PrintedPlace>& places,
                   const QString& folder) {
    const QString json = QStringLiteral("part-view.json");
    const QString figures = QStringLiteral("part-figures.csv");
    const QString table = QStringLiteral("part-pairs.csv");
    const QString found = QStringLiteral("part-places.csv");
    QStringList names{json, figures, table, found};
    for (std::size_t i = 0; i < std::size_t(mostPhotos); ++i) {
        names << photoName(i); // removes the pictures of an earlier run with more photos
    }
    FolderTransaction files(folder, names);
    files.write(json, jsonOf(photos, view));
    files.write(figures, figuresTable(photos, pairs, view));
    files.write(table, tableOf(pairs, view));
    if (!places.empty()) {
        files.write(found, placesTable(places));
    }
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const double times = enlargement(view, photos[i].picture.size());
        files.write(photoName(i),
                    pngBytes(pairsPicture(photos[i], int(i), pairs, view, times), photoName(i)));
    }
    files.commit();
}

} // namespace dipwright

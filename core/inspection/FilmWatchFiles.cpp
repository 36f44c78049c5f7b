#include "inspection/FilmWatchFiles.h"

#include "base/NumberText.h"
#include "base/Png.h"
#include "disk/FolderTransaction.h"
#include "results/Results.h"
#include "sheet/page/CodedBoard.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPainter>
#include <QTextStream>
#include <algorithm>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmWatch)
};

const QString jsonName = QStringLiteral("film-watch.json");
const QString tableName = QStringLiteral("unevenness.csv");
const QString mapName = QStringLiteral("unevenness.png");

QJsonArray pair(double x, double y) {
    return {x, y};
}

QJsonObject toJson(const WatchedPhoto& photo) {
    const FlatFilm& film = photo.film;
    return {{"file", QFileInfo(photo.where).fileName()},
            {"sha256", photo.sha256},
            {"seconds", photo.seconds ? QJsonValue(*photo.seconds) : QJsonValue()},
            {"size_px", QJsonArray{photo.size.width(), photo.size.height()}},
            {"film_corners", qint64(film.corners.size())},
            {"card_corners", qint64(film.cardCorners.size())},
            {"swell", pair(film.swellX.value, film.swellY.value)},
            {"swell_off", pair(film.swellX.off, film.swellY.off)},
            {"shear_deg", film.shearDegrees},
            {"residual_px", film.residualPixels},
            {"uneven_p95_mm", film.unevennessMillimetres},
            {"lens", pair(film.lens.k1, film.lens.k2)}};
}

QString wordOf(GrowthKnowledge known) {
    switch (known) {
    case GrowthKnowledge::No:
        return QStringLiteral("not_measured");
    case GrowthKnowledge::None:
        return QStringLiteral("none");
    case GrowthKnowledge::RateOnly:
        return QStringLiteral("rate_only");
    case GrowthKnowledge::Both:
        return QStringLiteral("measured");
    }
    return {};
}

QJsonObject toJson(const FilmWatch& watch, const WatchNotes& notes) {
    const GrowthFit& growth = watch.growth;
    QJsonArray photos;
    for (const WatchedPhoto& photo : watch.photos) {
        photos.append(toJson(photo));
    }
    return {{"version", 1},
            {"date", notes.date},
            {"lot", notes.lot},
            {"water_temperature_c",
             notes.waterTemperature ? QJsonValue(*notes.waterTemperature) : QJsonValue()},
            {"dip_begins_s", watch.begin},
            {"ruler_error_mm", watch.rulerError},
            {"swell", pair(growth.swellX.value, growth.swellY.value)},
            {"swell_off", pair(growth.swellX.off, growth.swellY.off)},
            {"growth", wordOf(growth.known)},
            {"growth_per_s", pair(growth.rate.value, growth.rate.off)},
            {"growth_limit", pair(growth.limit.value, growth.limit.off)},
            {"photos", photos}};
}

QByteArray tableOf(const FilmWatch& watch) {
    QByteArray table;
    QTextStream out(&table);
    out << "photo,column,row,printed_x_mm,printed_y_mm,lies_x_mm,lies_y_mm,off_x_mm,off_y_mm,"
           "swell\n";
    const auto number = [](double value, int decimals) {
        return QString::number(value, 'f', decimals);
    };
    for (std::size_t i = 0; i < watch.photos.size(); ++i) {
        for (const FilmCorner& corner : watch.photos[i].film.corners) {
            out << i + 1 << ',' << corner.column << ',' << corner.row;
            for (const Eigen::Vector2d& place : {corner.printed, corner.lies, corner.off}) {
                out << ',' << number(place.x(), 4) << ',' << number(place.y(), 4);
            }
            out << ',' << (corner.swell ? number(*corner.swell, 5) : QString()) << '\n';
        }
    }
    out.flush();
    return table;
}

// Draws the film's corners as a map.
class Map {
public:
    Map(const WatchedPhoto& photo, int height) : film_(photo.film), unit_(height / 100.0) {
        for (const FilmCorner& corner : film_.corners) {
            const QPointF place(corner.printed.x(), corner.printed.y());
            box_ = box_.isNull() ? QRectF(place, QSizeF(1e-6, 1e-6))
                                 : box_.united(QRectF(place, QSizeF(1e-6, 1e-6)));
        }
        const double margin = boardSquare(BoardKind::Film);
        box_.adjust(-margin, -margin, margin, margin);
        scale_ = 78 / box_.height();
        mean_ = std::sqrt(film_.swellX.value * film_.swellY.value);
        for (const FilmCorner& corner : film_.corners) {
            if (corner.swell) {
                most_ = std::max(most_, std::abs(*corner.swell / mean_ - 1));
            }
            farthest_ = std::max(farthest_, corner.off.norm());
        }
    }

    QImage draw() const {
        QImage picture(QSizeF((box_.width() * scale_ + 30) * unit_, 100 * unit_).toSize(),
                       QImage::Format_RGB32);
        picture.fill(Qt::white);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(unit_, unit_);
        letter(painter, {4, 6}, 2.6, Text::tr("Unevenness of the film"));
        letter(painter, {4, 9.5}, 1.6,
               Text::tr("Colour: growth relative to the mean swell %1 · arrows: displacement, "
                        "scale %2:1")
                   .arg(numberText(mean_, 4))
                   .arg(numberText(enlarged(), 0)));
        for (const FilmCorner& corner : film_.corners) {
            drawSwell(painter, corner);
        }
        for (const FilmCorner& corner : film_.corners) {
            drawArrow(painter, corner);
        }
        drawScale(painter);
        letter(painter, {4, 96}, 1.6,
               Text::tr("95 % of the corners lie within %1 mm of an evenly swollen film")
                   .arg(numberText(film_.unevennessMillimetres, 3)));
        return picture;
    }

private:
    static void letter(QPainter& painter, QPointF at, double height, const QString& text) {
        constexpr double unit = 0.05; // a QFont has no sizes below a whole unit
        painter.save();
        painter.translate(at);
        painter.scale(unit, unit);
        QFont font(QStringLiteral("DejaVu Sans"));
        font.setPixelSize(int(height / unit));
        painter.setFont(font);
        painter.setPen(QColor(40, 44, 50));
        painter.drawText(QPointF(), text);
        painter.restore();
    }

    // Returns the arrows' enlargement: no arrow is longer than one square, and noise stays small.
    double enlarged() const {
        constexpr double least = 0.17; // mm
        const double times = boardSquare(BoardKind::Film) / std::max(farthest_, least);
        return std::pow(10, std::floor(std::log10(times)));
    }

    QPointF placed(double x, double y) const {
        return {4 + (x - box_.left()) * scale_, 12 + (y - box_.top()) * scale_};
    }

    void drawSwell(QPainter& painter, const FilmCorner& corner) const {
        const double side = boardSquare(BoardKind::Film) * scale_;
        const QPointF at = placed(corner.printed.x(), corner.printed.y());
        if (corner.swell) {
            const double share = (*corner.swell / mean_ - 1) / (2 * most_) + 0.5;
            painter.fillRect(QRectF(at - QPointF(side, side) / 2, QSizeF(side, side)),
                             mapColour(QStringLiteral("balance"), share));
        }
    }

    void drawArrow(QPainter& painter, const FilmCorner& corner) const {
        const QPointF at = placed(corner.printed.x(), corner.printed.y());
        const Eigen::Vector2d moved = corner.printed + enlarged() * corner.off;
        painter.setPen(QPen(QColor(40, 44, 50), 0.2));
        painter.drawLine(at, placed(moved.x(), moved.y()));
        painter.setBrush(QColor(40, 44, 50));
        painter.drawEllipse(at, 0.25, 0.25);
    }

    void drawScale(QPainter& painter) const {
        const QRectF bar(4 + box_.width() * scale_ + 4, 16, 3, 60);
        constexpr int steps = 60;
        for (int i = 0; i < steps; ++i) {
            painter.fillRect(QRectF(bar.left(), bar.bottom() - (i + 1.0) * bar.height() / steps,
                                    bar.width(), bar.height() / steps + 0.05),
                             mapColour(QStringLiteral("balance"), (i + 0.5) / steps));
        }
        for (const int end : {-1, 0, 1}) {
            const QString text = numberText(100 * end * most_, 2);
            letter(painter, {bar.right() + 1, bar.center().y() - end * bar.height() / 2 + 0.6}, 1.6,
                   (end > 0 ? QStringLiteral("+") : QString()) + text + QStringLiteral(" %"));
        }
    }

    const FlatFilm& film_;
    double unit_; // pixels in 1 % of the picture's height
    QRectF box_;  // mm on the sheet
    double scale_ = 1, mean_ = 1, farthest_ = 0;
    double most_ = 0.001; // half the range of the colours; the least value keeps noise invisible
};

} // namespace

QStringList filmWatchFiles() {
    return {jsonName, tableName, mapName};
}

QImage boardsPicture(const QImage& photo, const FlatFilm& film, int longest) {
    const QSize size = photo.size().scaled(longest, longest, Qt::KeepAspectRatio);
    const bool shrinks = size.width() < photo.width();
    QImage picture =
        (shrinks ? photo.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation) : photo)
            .convertToFormat(QImage::Format_RGB32);
    const double scale = double(picture.width()) / photo.width();
    const double reach = longest / 250.0;
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(QColor(0x12, 0x8c, 0xe8), reach / 3));
    for (const FilmCorner& corner : film.corners) {
        painter.drawEllipse(QPointF(corner.seen.x(), corner.seen.y()) * scale, reach, reach);
    }
    painter.setPen(QPen(QColor(0xe0, 0x50, 0x20), reach / 3));
    for (const Eigen::Vector2d& corner : film.cardCorners) {
        painter.drawRect(
            QRectF(corner.x() * scale - reach, corner.y() * scale - reach, 2 * reach, 2 * reach));
    }
    return picture;
}

QImage unevennessMap(const WatchedPhoto& photo, int height) {
    return Map(photo, height).draw();
}

void writeFilmWatch(const FilmWatch& watch, const WatchNotes& notes, const QString& folder) {
    constexpr int height = 1400; // pixels
    FolderTransaction files(folder, filmWatchFiles());
    files.write(jsonName, QJsonDocument(toJson(watch, notes)).toJson());
    files.write(tableName, tableOf(watch));
    files.write(mapName, pngBytes(unevennessMap(watch.photos.back(), height), mapName));
    files.commit();
}

} // namespace dipwright

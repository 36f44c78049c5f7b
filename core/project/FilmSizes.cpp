#include "project/FilmSizes.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Project)
};

struct NamedSize {
    const char* name;
    double width, height; // mm, upright
};
constexpr std::array<NamedSize, 7> namedSizes{{{"A5", 148, 210},
                                               {"A4", 210, 297},
                                               {"A3", 297, 420},
                                               {"A2", 420, 594},
                                               {"Letter", 215.9, 279.4},
                                               {"Legal", 215.9, 355.6},
                                               {"Tabloid", 279.4, 431.8}}};

QString sizeName(double width, double height) {
    for (const NamedSize& size : namedSizes) {
        if (std::minmax(width, height) == std::minmax(size.width, size.height)) {
            return QString::fromLatin1(size.name);
        }
    }
    return QStringLiteral("custom");
}

int pointsAlong(double length, double spacing) {
    return std::clamp(int(std::lround(length / spacing)) + 1, minimumFilmPoints, maximumFilmPoints);
}

} // namespace

QStringList filmSizeNames() {
    QStringList names;
    for (const NamedSize& size : namedSizes) {
        names.append(QString::fromLatin1(size.name));
    }
    return names;
}

QSizeF filmSize(const QString& name) {
    for (const NamedSize& size : namedSizes) {
        if (name == QLatin1String(size.name)) {
            return {size.width, size.height};
        }
    }
    throw Error(Text::tr("There is no film size of this name; use one of %1")
                    .arg(filmSizeNames().join(QStringLiteral(", "))),
                name);
}

bool mayHavePoints(int columns, int rows) {
    return std::max(columns, rows) <= maximumFilmPoints && columns * rows <= maximumFilmGrid;
}

void resizeFilm(FilmSettings& film, Millimetres width, Millimetres height) {
    if (film.width == width && film.height == height) {
        return;
    }
    const double w = width.value();
    const double h = height.value();
    double spacing =
        std::min(film.width.value() / (film.columns - 1), film.height.value() / (film.rows - 1));
    // Keep the limits: the most points in all, and the fewest across the shorter side.
    spacing = std::max({spacing, w / (maximumFilmPoints - 2), h / (maximumFilmPoints - 2),
                        std::sqrt(1.01 * w * h / maximumFilmGrid)});
    spacing = std::min({spacing, w / (minimumFilmPoints - 1), h / (minimumFilmPoints - 1)});
    film.columns = pointsAlong(w, spacing);
    film.rows = pointsAlong(h, w / (film.columns - 1));
    film.width = width;
    film.height = height;
    film.preset = sizeName(w, h);
}

} // namespace dipwright

#include "jobs/FilmTable.h"

#include "base/Bytes.h"
#include "base/Error.h"

#include <QCoreApplication>
#include <QTextStream>

namespace dipwright {

namespace {

void write(const FilmReading& reading, QTextStream& table) {
    table
        << "column,row,rest_x_mm,rest_z_mm,x_mm,y_mm,z_mm,adhered,stretch,area,largest,smallest\n";
    const DippedFilm& film = reading.film();
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        const Eigen::Vector2f rest = restPosition(film.grid, point);
        const Eigen::Vector3f& place = film.positions[point];
        table << point % std::size_t(film.grid.columns) << ','
              << point / std::size_t(film.grid.columns) << ',' << rest.x() << ',' << rest.y() << ','
              << place.x() << ',' << place.y() << ',' << place.z() << ',' << film.adhered(point)
              << ',' << reading.values(FilmQuantity::Length)[point] << ','
              << reading.values(FilmQuantity::Area)[point] << ','
              << reading.values(FilmQuantity::Larger)[point] << ','
              << reading.values(FilmQuantity::Smaller)[point] << '\n';
    }
}

} // namespace

void writeFilmTable(const FilmReading& reading, const QString& path) {
    const QByteArray bytes = bytesOf([&](QIODevice& device) {
        QTextStream table(&device);
        write(reading, table);
    });
    const QString failure = replaceFile(path, bytes);
    if (!failure.isEmpty()) {
        throw Error(QCoreApplication::translate("FilmTable", "The table cannot be written: %1")
                        .arg(failure),
                    path);
    }
}

} // namespace dipwright

#include "workbench/dip/FilmTable.h"

#include "disk/AtomicFile.h"

#include <QTextStream>

namespace dipwright {

namespace {

void write(const FilmReadout& reading, QTextStream& table) {
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

void writeFilmTable(const FilmReadout& reading, const QString& path) {
    writeAtomically(path, [&](QIODevice& device) {
        QTextStream table(&device);
        write(reading, table);
    });
}

} // namespace dipwright

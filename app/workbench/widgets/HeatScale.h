// How numbers become colours: a named map over a range, and a mark for what is over a limit.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QString>
#include <optional>
#include <vector>

namespace dipwright {

struct HeatScale {
    QString map = QStringLiteral("lagoon");
    double low = 1, high = 2;
    std::optional<double> limit = {}; // values over it are shown in the warning colour

    QRgb colour(double value) const;
    bool operator==(const HeatScale&) const = default;
};

// From the first to the 99th percentile, rounded outwards to steps of 0.01.
HeatScale automaticScale(const HeatScale& scale, const std::vector<float>& values);

// A value a film point as a picture of the film of `pixels`, interpolated between the points.
QImage heatPicture(const std::vector<float>& values, const solver::FilmGrid& film, QSize pixels,
                   const HeatScale& scale);

// Lines of equal value at multiples of `step`, by marching squares; mm from the film's upper left
// corner.
QList<QLineF> isolines(const std::vector<float>& values, const solver::FilmGrid& film, double step);

} // namespace dipwright

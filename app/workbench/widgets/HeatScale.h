// Maps numbers to colours: a named colour map over a range, with a warning colour above a limit.
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
    std::optional<double> limit = {}; // values above it have the warning colour

    QRgb colour(double value) const;
    bool operator==(const HeatScale&) const = default;
};

// Returns `scale` with its range fitted to the first and 99th percentile of `values`, rounded
// outwards to steps of 0.01.
HeatScale automaticScale(const HeatScale& scale, const std::vector<float>& values);

// Draws `values`, one for each film point, as a picture of the size `pixels`. Interpolates between
// the points.
QImage heatPicture(const std::vector<float>& values, const solver::FilmGrid& film, QSize pixels,
                   const HeatScale& scale);

// Returns lines of equal value at multiples of `step`, by marching squares. Their coordinates are
// in mm from the film's upper left corner.
QList<QLineF> isolines(const std::vector<float>& values, const solver::FilmGrid& film, double step);

} // namespace dipwright

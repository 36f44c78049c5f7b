// The scale of a map of values: its range, its steps and its colours.
#pragma once

#include <QColor>
#include <QString>
#include <vector>

namespace dipwright {

struct MapScale {
    double low = 1;
    double high = 1;
    double step = 0.1;
    QString map;                 // of colourMaps() in Results.h
    bool lowerHalf = false;      // use only the lower half of the map
    bool hasColourAbove = false; // whether values above `high` have a colour of their own

    // Returns the place of a value on the scale, 0 … 1. Values outside the scale are clamped.
    double share(double value) const;
    // Returns the colour at a place of the scale, 0 … 1.
    QColor colour(double place) const;
    // Returns the colour of a value above the scale.
    QColor past() const;
    // Returns a value in the user's language, with enough decimals to tell the steps apart.
    QString text(double value) const;
};

// Returns the smallest of 1, 2 and 5 times a power of ten that is not less than `least`.
double roundedUp(double least);
// Returns a rounded step that divides a span into about six parts.
double niceStep(double span);
// Returns the value that nearly all of `values` (at least one) are below.
double highestOf(std::vector<float> values);

// Returns a scale from 1 (unstretched) upwards, or symmetric about 1 if film is also compressed. A
// few outliers, such as torn film, lie outside the scale. `values`: at least one.
MapScale stretchScale(std::vector<float> values);
// Returns a scale that starts at 0 and includes nearly all values, up to a few times `limit`.
// Outliers lie above the scale. `least` is the smallest range of the scale; it keeps noise from
// filling the picture. `values`: at least one.
MapScale changeScale(const std::vector<float>& values, double limit, double least);

} // namespace dipwright

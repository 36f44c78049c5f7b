// Reads a number as people type it: in any of the units of its field's quantity, with the decimal
// signs and the groups of digits of the languages of the window.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace dipwright {

// What a typed text can mean. `values` are in the field's own unit: usually one; none where the
// text is no number or its unit none of the quantity's; two where a sign that is not the language's
// decimal sign may be one or stand between groups of digits, as in the English "1,234": the decimal
// reading first.
struct TypedNumber {
    std::vector<double> values;
    QString unknownUnit; // as it was typed; empty: none, or one that is known
};

// `unit`: of the field, without spaces, such as "mm". Lengths are read in mm, cm, m, µm, in and ft,
// speeds in these by s or min, times in ms, s, min and h; other quantities in their field's unit
// alone. A number without a unit is in the field's.
TypedNumber typedNumber(const QString& text, const QString& unit, const QLocale& locale);

} // namespace dipwright

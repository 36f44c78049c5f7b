// Reads a number as typed by the user: in any unit of the field's quantity, with the decimal signs
// and digit groups of the window's languages.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace dipwright {

// The possible meanings of a typed text. `values` are in the field's unit. Usually there is one
// value. There is no value if the text is not a number or its unit does not fit the quantity. There
// are two values, the decimal reading first, if a sign may be either the decimal sign or the
// separator of digit groups, as in the English "1,234".
struct TypedNumber {
    std::vector<double> values;
    QString unknownUnit; // as typed; empty: no unit, or a known one
};

// `unit`: the field's unit without spaces, such as "mm". Lengths are read in mm, cm, m, µm, in and
// ft; speeds in these units per s or min; times in ms, s, min and h. Other quantities are read only
// in the field's unit. A number without a unit is in the field's unit.
TypedNumber typedNumber(const QString& text, const QString& unit, const QLocale& locale);

} // namespace dipwright

// Reads a number as typed by the user: a calculation such as "3*12" or "2in + 1/8in", in any unit
// of the field's quantity, with the decimal signs and digit groups of the window's languages.
#pragma once

#include <QLocale>
#include <QString>
#include <vector>

namespace dipwright {

// The possible meanings of a typed text. `values` are in the field's unit. Usually there is one
// value. There are two values, the decimal reading first, if a sign may be either the decimal sign
// or the separator of digit groups, as in the English "1,234". There is no value if the text has a
// fault.
struct TypedNumber {
    enum class Fault {
        None,
        NotANumber,   // not a calculation with a finite result
        TooLarge,     // a number beyond 1.8e308
        UnknownUnit,  // of `unit`
        OtherQuantity // the units do not fit each other or the field
    };

    std::vector<double> values;
    Fault fault = Fault::None;
    QString unit = {};
};

// `unit`: the field's unit, such as "mm" or "°/s"; empty if it has none.
//
// Numbers, such as 12.5 and 2e-3, + − * / and brackets. Units: mm, cm, m, µm, in, ft; ms, s, min,
// h; °, deg, rad, turn; %, ‰; dpi; rpm; quotients and powers of them, such as cm/min and mm/s².
// Other units, such as "cells", are read only in fields of that unit. A number without a unit is in
// the field's unit: alone, as the whole result, or as the term of a sum. In products and quotients
// it is a plain factor. A fraction before a unit is one number: 1/2in is half an inch.
TypedNumber typedNumber(const QString& text, const QString& unit, const QLocale& locale);

} // namespace dipwright

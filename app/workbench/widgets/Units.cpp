#include "workbench/widgets/Units.h"

#include "base/NumberText.h"

#include "base/Units.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Units)
};

bool isShare(Unit unit) {
    return unit == Unit::Share || unit == Unit::ShareRate;
}

bool isLength(Unit unit) {
    return unit == Unit::Length || unit == Unit::Speed || unit == Unit::Acceleration;
}

} // namespace

double shownPerStored(Unit unit, LengthUnit length) {
    return isShare(unit)                                  ? 100
           : isLength(unit) && length == LengthUnit::Inch ? 1 / millimetresPerInch
                                                          : 1;
}

QString unitSuffix(Unit unit, LengthUnit length) {
    const bool inch = length == LengthUnit::Inch;
    switch (unit) {
    case Unit::Length:
        return inch ? Text::tr(" in") : Text::tr(" mm");
    case Unit::Speed:
        return inch ? Text::tr(" in/s") : Text::tr(" mm/s");
    case Unit::Acceleration:
        return inch ? Text::tr(" in/s²") : Text::tr(" mm/s²");
    case Unit::Time:
        return Text::tr(" s");
    case Unit::Angle:
        return Text::tr("°");
    case Unit::AngularSpeed:
        return Text::tr("°/s");
    case Unit::Resolution:
        return Text::tr(" dpi");
    case Unit::Cells:
        return Text::tr(" cells");
    case Unit::Density:
        return Text::tr(" D");
    case Unit::Ratio:
        return QStringLiteral(" ×");
    case Unit::Share:
        return Text::tr(" %");
    case Unit::ShareRate:
        return Text::tr(" %/s");
    case Unit::Million:
        return Text::tr(" million");
    case Unit::None:
        break;
    }
    return {};
}

int unitDecimals(Unit unit, LengthUnit length) {
    const int more = isLength(unit) && length == LengthUnit::Inch ? 2 : 0;
    switch (unit) {
    case Unit::Length:
    case Unit::Speed:
    case Unit::Acceleration:
        return 2 + more;
    case Unit::Time:
        return 4;
    case Unit::Angle:
    case Unit::AngularSpeed:
        return 1;
    case Unit::Resolution:
    case Unit::Million:
        return 0;
    case Unit::Ratio:
    case Unit::Cells:
    case Unit::ShareRate:
        return 3;
    case Unit::Density:
    case Unit::Share:
        return 2;
    case Unit::None:
        break;
    }
    return 0;
}

QString shownNumber(double value, Unit unit, LengthUnit length, int moreDecimals) {
    return numberText(value * shownPerStored(unit, length),
                      unitDecimals(unit, length) + moreDecimals) +
           unitSuffix(unit, length);
}

QString shownArea(double squareMillimetres, LengthUnit length) {
    const double side = shownPerStored(Unit::Length, length);
    return length == LengthUnit::Inch
               ? Text::tr("%1 in²").arg(numberText(squareMillimetres * side * side, 3))
               : Text::tr("%1 mm²").arg(numberText(squareMillimetres, 0));
}

QString shownPlace(const Eigen::Vector3f& place, LengthUnit length) {
    const int decimals = unitDecimals(Unit::Length, length) - 1;
    const double side = shownPerStored(Unit::Length, length);
    const auto coordinate = [&](float value) { return numberText(double(value) * side, decimals); };
    return QStringLiteral("x %1; y %2; z %3%4")
        .arg(coordinate(place.x()), coordinate(place.y()), coordinate(place.z()),
             unitSuffix(Unit::Length, length));
}

QString shownLength(double millimetres, LengthUnit length, int moreDecimals) {
    return shownNumber(millimetres, Unit::Length, length, moreDecimals);
}

QString withUnitsKept(QString text) {
    static const QRegularExpression betweenNumberAndUnit(QStringLiteral("(?<=\\d) (?=[%mi])"));
    return text.replace(betweenNumberAndUnit, QString(QChar::Nbsp));
}

} // namespace dipwright

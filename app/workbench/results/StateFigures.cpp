#include "workbench/results/StateFigures.h"

#include "base/NumberText.h"

#include <QCoreApplication>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(StateFigures)
};

} // namespace

QString StateFigure::text() const {
    return value ? words(*value) : Text::tr("no result");
}

QString differenceText(const StateFigure& first, const StateFigure& second) {
    if (!first.value || !second.value) {
        return {};
    }
    if (first.text() == second.text()) {
        return Text::tr("the same");
    }
    const double more = *second.value - *first.value;
    const QString number = (more > 0 ? QChar(u'+') : QChar(u'−')) + first.words(std::abs(more));
    return (more > 0) == first.isHigherBetter ? Text::tr("%1 (better)").arg(number)
                                              : Text::tr("%1 (worse)").arg(number);
}

std::vector<StateFigure> stateFigures(const QJsonObject& measures, LengthUnit unit) {
    const auto figure = [&](const QString& name, const char* key, bool isHigherBetter,
                            const std::function<QString(double)>& words) {
        const QJsonValue value = measures.value(QLatin1String(key));
        return StateFigure{name, value.isDouble() ? std::optional(value.toDouble()) : std::nullopt,
                           words, isHigherBetter};
    };
    const auto percent = [](double share) {
        return Text::tr("%1 %").arg(numberText(100 * share, 1));
    };
    const auto ratio = [](double stretch) { return numberText(stretch, 3); };
    const auto area = [unit](double value) { return shownArea(value, unit); };
    const auto length = [unit](double value) { return shownLength(value, unit); };
    return {figure(Text::tr("Total coverage"), "painted", true, percent),
            figure(Text::tr("Stretch of the film on the part, 95th percentile"), "stretch", false,
                   ratio),
            figure(Text::tr("Largest stretch of the film on the part"), "largest_stretch", false,
                   ratio),
            figure(Text::tr("Area with too large a numerical error"), "uncertain_mm2", false, area),
            figure(Text::tr("Numerical error of the sheet, 95th percentile"), "error_mm", false,
                   length),
            figure(Text::tr("Compressed film that may wrinkle"), "wrinkled", false, percent),
            figure(Text::tr("Trapped air"), "air_mm2", false, area),
            figure(Text::tr("Area painted by film that tore, was released or did not converge"),
                   "marked_mm2", false, area),
            figure(Text::tr("Area too pale because of the ink limit"), "pale_mm2", false, area),
            figure(Text::tr("Length of the seam"), "seam_mm", false, length),
            figure(Text::tr("Ink of all plates, as area at full tint"), "ink_mm2", false, area)};
}

} // namespace dipwright

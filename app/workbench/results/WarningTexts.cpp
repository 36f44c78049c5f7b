#include "workbench/results/WarningTexts.h"

#include "dip/FilmMarks.h"
#include "results/Results.h"

#include <QCoreApplication>
#include <QStringList>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ReportPanel)
};

solver::PointMark markOf(WarningKind kind) {
    return kind == WarningKind::Torn         ? solver::PointMark::Torn
           : kind == WarningKind::Unbalanced ? solver::PointMark::Unbalanced
                                             : solver::PointMark::LetGo;
}

QString kindText(WarningKind kind) {
    switch (kind) {
    case WarningKind::TrappedAir:
        return Text::tr("Trapped air");
    case WarningKind::NotReached:
        return Text::tr("Reached by neither dip");
    case WarningKind::TooPale:
        return Text::tr("Too pale: needs more ink than the limit");
    default:
        return markText(markOf(kind));
    }
}

} // namespace

QString warningText(const JobWarning& warning, const JobResult& result, LengthUnit unit) {
    QStringList parts{kindText(warning.kind), shownArea(warning.area, unit)};
    if (warning.dip && result.immersions.size() > 1) {
        parts.append(result.immersions[*warning.dip].immersion.name);
    }
    return parts.join(QStringLiteral(", "));
}

QColor warningColour(WarningKind kind) {
    switch (kind) {
    case WarningKind::TrappedAir:
        return QColor(0x3a, 0x8f, 0xd0); // as on the timeline
    case WarningKind::NotReached:
        return QColor(0x5a, 0x60, 0x68);
    case WarningKind::TooPale:
        return QColor(0xe6, 0xd9, 0xa8);
    default:
        return markColour(markOf(kind));
    }
}

} // namespace dipwright

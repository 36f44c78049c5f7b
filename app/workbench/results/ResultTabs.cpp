#include "workbench/results/ResultTabs.h"

#include "workbench/widgets/Icons.h"

#include <QPainter>

namespace dipwright {

namespace {

// In pixels. The mark fits between the text and the corner of a tab.
constexpr int markSize = 5, markFromRight = 1, markFromTop = 3;

} // namespace

ResultTabs::ResultTabs(QWidget* parent) : QTabBar(parent), mark_(icon(QStringLiteral("mark"))) {}

void ResultTabs::setOutdated(int tab, bool isOutdated) {
    const QString note = QLatin1Char('\n') + tr("Changed since the last run. Run again.");
    const QString help = tabToolTip(tab).remove(note);
    setTabToolTip(tab, isOutdated ? help + note : help);
    setAccessibleTabName(tab, isOutdated ? tr("%1, out of date").arg(tabText(tab)) : QString());
    setTabData(tab, isOutdated);
    update();
}

void ResultTabs::paintEvent(QPaintEvent* event) {
    QTabBar::paintEvent(event);
    QPainter painter(this);
    for (int tab = 0; tab < count(); ++tab) {
        if (tabData(tab).toBool()) {
            QRect place(0, 0, markSize, markSize);
            place.moveTopRight(tabRect(tab).topRight() + QPoint(-markFromRight, markFromTop));
            mark_.paint(&painter, place);
        }
    }
}

} // namespace dipwright

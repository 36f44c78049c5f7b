#include "workbench/widgets/PlainTexts.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QToolTip>

namespace dipwright {

namespace {

void makePlain(QObject* object) {
    auto* label = qobject_cast<QLabel*>(object);
    if (label && label->textFormat() == Qt::AutoText) {
        label->setTextFormat(Qt::PlainText);
    }
}

// Called for every object that a screen reader is told about, perhaps before it is polished.
// Returns nothing, so that Qt then asks its own factories.
QAccessibleInterface* makePlainBeforeItIsRead(const QString& /*className*/, QObject* object) {
    makePlain(object);
    return nullptr;
}

// Returns the tooltip of the item, section or widget at a place; empty if it has none.
QString toolTipAt(const QWidget& widget, const QPoint& place) {
    const auto* view = qobject_cast<const QAbstractItemView*>(widget.parentWidget());
    if (!view || view->viewport() != &widget) {
        return widget.toolTip();
    }
    if (const auto* header = qobject_cast<const QHeaderView*>(view)) {
        const int section = header->logicalIndexAt(place);
        return section < 0 ? QString()
                           : header->model()
                                 ->headerData(section, header->orientation(), Qt::ToolTipRole)
                                 .toString();
    }
    return view->indexAt(place).data(Qt::ToolTipRole).toString();
}

} // namespace

PlainTexts::PlainTexts(QApplication& application) {
    application.installEventFilter(this);
    QAccessible::installFactory(makePlainBeforeItIsRead);
}

PlainTexts::~PlainTexts() {
    QAccessible::removeFactory(makePlainBeforeItIsRead);
}

bool PlainTexts::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish) {
        makePlain(watched);
    }
    auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() == QEvent::ToolTip && widget && !widget->property(hasOwnToolTips).toBool()) {
        const auto& help = static_cast<QHelpEvent&>(*event);
        if (const QString text = toolTipAt(*widget, help.pos()); !text.isEmpty()) {
            QToolTip::showText(help.globalPos(), inLines(text), widget);
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

QString inLines(const QString& text) {
    constexpr qsizetype longest = 70; // letters
    QStringList lines;
    for (const QString& line : text.split(QLatin1Char('\n'))) {
        lines.append(QString());
        for (const QString& word : line.split(QLatin1Char(' '))) {
            if (lines.last().isEmpty()) {
                lines.last() = word;
            } else if (lines.last().size() + word.size() < longest) {
                lines.last() += QLatin1Char(' ') + word;
            } else {
                lines.append(word);
            }
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace dipwright

#include "workbench/widgets/PlainTexts.h"

#include <QAccessible>
#include <QApplication>
#include <QEvent>
#include <QLabel>

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
    return QObject::eventFilter(watched, event);
}

QString inLines(const QString& text) {
    constexpr qsizetype longest = 70; // letters
    QStringList lines;
    for (const QString& word : text.split(QLatin1Char(' '))) {
        const bool fits = !lines.isEmpty() && lines.last().size() + word.size() < longest;
        if (fits) {
            lines.last() += QLatin1Char(' ') + word;
        } else {
            lines.append(word);
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace dipwright

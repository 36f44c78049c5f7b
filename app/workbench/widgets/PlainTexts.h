// Keeps text from other sources from being shown as HTML. Names, paths and sentences that quote
// them may come from untrusted files. By default a label guesses its text format. Rich text can
// name pictures and style sheets, which our process would then read, and can show links. So labels
// must not guess. All other widgets with text are plain by default, or are explicitly set to rich
// text.
#pragma once

#include <QObject>

class QApplication;

namespace dipwright {

// While this object exists, labels without an explicit format are plain. This includes labels in
// Qt's own boxes and dialogs, and tooltips of widgets, items and actions, which are labels too. A
// label becomes plain before its first layout and before a screen reader sees it. Before that
// moment, Qt reads no file that rich text names.
//
// A label with intended rich text sets QLabel::setTextFormat(Qt::RichText) and escapes foreign
// text. Tooltips cannot do that. Qt shows plain ones in one line, up to the width of the screen, so
// this object breaks the lines of the tooltips of widgets, items and header sections.
class PlainTexts : public QObject {
public:
    explicit PlainTexts(QApplication& application);
    ~PlainTexts() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

// The dynamic property of a widget that shows other tooltips than its toolTip(). PlainTexts leaves
// these to the widget.
inline constexpr const char* hasOwnToolTips = "hasOwnToolTips";

// Breaks the text of a long tooltip into readable lines. Keeps the line breaks that it has.
QString inLines(const QString& text);

} // namespace dipwright

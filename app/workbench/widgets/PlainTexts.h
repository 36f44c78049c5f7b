// No text from elsewhere is HTML. Names, paths and sentences that quote them come from files of
// strangers, and a label that guesses what it was given would take them for rich text: it then
// reads any picture or style sheet that they name, within our process, and shows links. So labels
// guess no more. Everything else that the window shows text with is plain by itself, or is told to
// be rich.
#pragma once

#include <QObject>

class QApplication;

namespace dipwright {

// While it lives, every label of the application is plain that has not been told its format: those
// of boxes and dialogs that Qt makes and every tool tip, which is a label too, be it of a widget,
// of an item or of an action. A label becomes so before it is first laid out or told to a screen
// reader, which is when Qt reads what rich text names; until then it only keeps the text.
//
// What is rich on purpose says so, QLabel::setTextFormat(Qt::RichText), and escapes in it whatever
// is not its own. Tool tips cannot; their lines are broken where their text is (inLines()).
class PlainTexts : public QObject {
public:
    explicit PlainTexts(QApplication& application);
    ~PlainTexts() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

// The words of a long tool tip in lines that are easily read.
QString inLines(const QString& text);

} // namespace dipwright

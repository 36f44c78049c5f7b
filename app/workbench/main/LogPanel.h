// What the program has done and what went wrong, with a report to hand on.
#pragma once

#include <QWidget>

class QPlainTextEdit;

namespace dipwright {

class LogPanel : public QWidget {
    Q_OBJECT

public:
    explicit LogPanel(QWidget* parent = nullptr);

    void add(const QString& line); // with the time of day in front
    QString text() const;

signals:
    void reportAsked(); // the user wants it, with the facts about the machine, on the clipboard

private:
    QPlainTextEdit* text_;
};

} // namespace dipwright

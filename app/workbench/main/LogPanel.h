// Shows what the program has done and what went wrong. The user can copy this log, together with
// details of the machine, as a report.
#pragma once

#include <QWidget>

class QPlainTextEdit;

namespace dipwright {

class LogPanel : public QWidget {
    Q_OBJECT

public:
    explicit LogPanel(QWidget* parent = nullptr);

    void add(const QString& line); // puts the time of day in front
    QString text() const;

signals:
    void reportAsked(); // the user wants the log and the machine's details on the clipboard

private:
    QPlainTextEdit* text_;
};

} // namespace dipwright

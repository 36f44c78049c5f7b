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
    // Facts about program and machine that stand above the lines in the report.
    void setFacts(const QStringList& facts) { facts_ = facts; }
    QString report() const;

private:
    QPlainTextEdit* text_;
    QStringList facts_;
};

} // namespace dipwright

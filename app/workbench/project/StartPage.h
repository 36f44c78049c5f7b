// What a window shows without a project: how to begin, the recent projects, and the samples.
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QVBoxLayout;

namespace dipwright {

class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void refresh(); // the recent projects, and all colours

signals:
    void newAsked();
    void openAsked();
    void tourAsked();
    void projectChosen(const QString& path);
    void sampleChosen(const QString& path); // open it as a copy

private:
    QWidget* makeActions();
    QListWidget* makeList(const QString& name, void (StartPage::*chosen)(const QString&));

    QListWidget* recent_;
    QListWidget* samples_;
    QLabel* recentHint_;
    QLabel* samplesTitle_;
};

} // namespace dipwright

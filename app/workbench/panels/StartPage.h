// What a window shows without a project: how to begin, and the projects opened last.
#pragma once

#include <QWidget>

class QListWidget;

namespace dipwright {

class StartPage : public QWidget {
    Q_OBJECT

public:
    explicit StartPage(QWidget* parent = nullptr);

    void refresh(); // the recent projects

signals:
    void newAsked();
    void openAsked();
    void tourAsked();
    void projectChosen(const QString& path);

private:
    QListWidget* recent_;
    QWidget* recentHint_;
};

} // namespace dipwright

// Drives a real main window as a user would, for the tests and for the pictures.
#pragma once

#include "workbench/main/MainWindow.h"
#include "workbench/main/Workbench.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

namespace dipwright {

// The application of a program that drives windows: its settings, caches and recovery copies are in
// a folder of its own, which goes with it. Results are kept only where a test wants it.
class WindowApplication {
public:
    WindowApplication(int& argc, char** argv);
    QString home() const { return home_.path(); }

private:
    QTemporaryDir home_;
    std::unique_ptr<QApplication> application_;
};

// What the program of such a test does.
template <typename Test>
int runWindowTest(int argc, char** argv) {
    const WindowApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

// A film and sheets so coarse that a job is quick.
void makeCoarse(Project& project);

class WindowDriver {
public:
    explicit WindowDriver(MainWindow& window) : window_(window) {}

    // Each waits until it is done and tells whether it was.
    bool open(const QString& path);
    bool create(const QString& model, const QString& texture, double longestEdge,
                const std::function<void(Project&)>& complete);
    bool run();

    void drop(const QString& path) const; // a file on the window
    // The left button pressed at a place of the widget, in shares of its size, and let go of at
    // another.
    static void drag(QWidget& widget, QPointF from, QPointF to);

    QAction* action(const char* name) const;
    void trigger(const char* name) const { action(name)->trigger(); }
    template <typename Widget>
    Widget* find(const char* name) const {
        return window_.findChild<Widget*>(QLatin1String(name));
    }

private:
    MainWindow& window_;
};

} // namespace dipwright

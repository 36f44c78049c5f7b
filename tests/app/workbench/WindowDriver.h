// Drives a real main window as a user would, for tests, benchmarks and the pictures in the
// documentation.
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

// The application object of a program that drives windows.
// Its settings, caches and recovery copies are in its own temporary folder. It does not keep
// results with projects, unless a test changes that.
class WindowApplication {
public:
    WindowApplication(int& argc, char** argv);
    QString home() const { return home_.path(); }

private:
    QTemporaryDir home_;
    std::unique_ptr<QApplication> application_;
};

// Runs all cases of `Test` in a WindowApplication. Returns the exit code.
template <typename Test>
int runWindowTest(int argc, char** argv) {
    const WindowApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

// Makes film, field and sheets so coarse that a job is quick.
void makeCoarse(Project& project);

class WindowDriver {
public:
    explicit WindowDriver(MainWindow& window) : window_(window) {}

    // These wait for the end of the action and return whether it succeeded.
    bool open(const QString& path);
    bool create(const QString& model, const QString& texture, double longestEdge,
                const std::function<void(Project&)>& complete);
    bool run();
    bool save();
    bool saveAs(const QString& path);

    void drop(const QString& path) const; // drops a file on the window
    // Drags with the left button between two places of the widget, as fractions (0 to 1) of its
    // size.
    static void drag(QWidget& widget, QPointF from, QPointF to);

    QAction* action(const char* name) const;
    void trigger(const char* name) const { action(name)->trigger(); }
    template <typename Widget>
    Widget* find(const char* name) const {
        return window_.findChild<Widget*>(QLatin1String(name));
    }

private:
    bool waitForSave();

    MainWindow& window_;
};

} // namespace dipwright

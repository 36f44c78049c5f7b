// Drives a real main window as a user would, for the tests and for the pictures.
#pragma once

#include "main/MainWindow.h"
#include "main/Workbench.h"

#include <QAction>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

namespace dipwright {

// Settings, caches and recovery copies in a folder of their own. To be called before QApplication.
void useOwnHome(const QString& folder);

class WindowDriver {
public:
    explicit WindowDriver(MainWindow& window) : window_(window) {}

    // Each waits until it is done and tells whether it was.
    bool open(const QString& path);
    bool create(const QString& model, const QString& texture, double longestEdge,
                const std::function<void(Project&)>& complete);
    bool run();

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

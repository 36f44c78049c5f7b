// A main window with the inspection's pages in front, for their tests.
#pragma once

#include "WindowDriver.h"

#include <functional>
#include <vector>

namespace dipwright {

class InspectionWindow {
public:
    // Opens a window of 1280 × 800 px that keeps its files in `folder`. Its language is that of
    // DIPWRIGHT_PICTURES_LANGUAGE, for screenshots.
    explicit InspectionWindow(const QString& folder);

    bool open(const Project& project); // saves it in the folder and opens the file
    const Project& project() const { return window_.document()->project(); }
    MainWindow& window() { return window_; }
    WindowDriver& driver() { return driver_; }
    template <typename Widget>
    Widget* find(const char* name) const {
        return driver_.find<Widget>(name);
    }
    template <typename Page>
    Page* page() const {
        return window_.findChild<Page*>();
    }
    void show(QWidget* page); // a page of the inspection

    static void drop(QWidget& page, const QStringList& files);
    // Takes screenshots in both themes and two sizes, if DIPWRIGHT_PICTURES names a folder. Calls
    // `show` with the number of the picture before each. Files: `name`-THEME-WIDTH-NUMBER.png.
    void photograph(const QString& name, int pictures, const std::function<void(int)>& show);

private:
    QString folder_;
    Workbench workbench_;
    MainWindow window_;
    WindowDriver driver_;
};

} // namespace dipwright

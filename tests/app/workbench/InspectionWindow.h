// A main window with the inspection's pages in front, for the tests of these.
#pragma once

#include "WindowDriver.h"

#include <functional>
#include <vector>

namespace dipwright {

class InspectionWindow {
public:
    // 1280 by 800; what it keeps is in `folder`. In the language of DIPWRIGHT_PICTURES_LANGUAGE,
    // for whom wants to look at it.
    explicit InspectionWindow(const QString& folder);

    bool open(const Project& project); // in a file in the folder
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
    void show(QWidget* page); // one of the inspection's

    static void drop(QWidget& page, const QStringList& files);
    // Light and dark, small and large, each after `show` has been called with the number of the
    // picture: `name`-THEME-WIDTH-NUMBER.png in the folder of DIPWRIGHT_PICTURES, if it is set.
    void photograph(const QString& name, int pictures, const std::function<void(int)>& show);

private:
    QString folder_;
    Workbench workbench_;
    MainWindow window_;
    WindowDriver driver_;
};

} // namespace dipwright

// A tab bar that marks tabs with outdated contents. The mark takes no room, so that all tabs fit
// side by side.
#pragma once

#include <QIcon>
#include <QTabBar>

namespace dipwright {

class ResultTabs : public QTabBar {
    Q_OBJECT

public:
    explicit ResultTabs(QWidget* parent = nullptr);

    // Also says it in the tab's tooltip and to screen readers.
    void setOutdated(int tab, bool isOutdated);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QIcon mark_;
};

} // namespace dipwright

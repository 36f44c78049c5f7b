#include "workbench/main/WindowLayout.h"

#include "viewport/DipView.h"
#include "workbench/document/SavedLayouts.h"
#include "workbench/main/LogPanel.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/project/PropertyPanel.h"
#include "workbench/project/StartPage.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/Timeline.h"
#include "workbench/view/LookInsideBar.h"
#include "workbench/widgets/NoticeBar.h"
#include "workbench/widgets/Theme.h"

#include <QDockWidget>
#include <QInputDialog>
#include <QLabel>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QSplitter>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <cstdlib>

namespace dipwright {

namespace {

const QString geometryKey = QStringLiteral("window/geometry");
const QString stateKey = QStringLiteral("window/state");

// Makes the dock's menu entry bring the dock to the front if it lies behind another tab. Qt's own
// entry would close it.
void raiseByToggle(QDockWidget& dock) {
    QAction* toggle = dock.toggleViewAction();
    QObject::disconnect(toggle, &QAction::triggered, &dock, nullptr);
    QObject::connect(toggle, &QAction::triggered, &dock, [&dock, toggle] {
        if (dock.isVisible() && !dock.visibleRegion().isEmpty()) {
            dock.close();
        } else {
            dock.show();
            dock.raise();
        }
        toggle->setChecked(dock.isVisible());
    });
}

} // namespace

WindowLayout::WindowLayout(QMainWindow& window, const SolverRegistry& registry) : window_(window) {
    makeCentre();
    makeDocks(registry);
}

void WindowLayout::makeCentre() {
    parts_.startPage = new StartPage;
    auto* view = new DipView;
    view->setObjectName(QStringLiteral("view"));
    view->setAccessibleName(tr("3D view of the dip"));
    view->setWhatsThis(
        tr("The part above the film. Drag to turn the view, drag with the right button to move it, "
           "use the wheel to zoom. Drag a ring to turn the part."));
    parts_.view = view;
    parts_.inside = new LookInsideBar;
    parts_.timeline = new Timeline;
    auto* banner = new QLabel;
    banner->setObjectName(QStringLiteral("staleBanner"));
    banner->setAlignment(Qt::AlignCenter);
    banner->setAutoFillBackground(true);
    banner->setContentsMargins(8, 4, 8, 4);
    banner->setText(QStringLiteral(" ")); // as high as one line
    QSizePolicy keepsRoom(QSizePolicy::Ignored, QSizePolicy::Fixed);
    keepsRoom.setRetainSizeWhenHidden(true); // else the part would jump under the user's hand
    banner->setSizePolicy(keepsRoom);
    banner->hide();
    parts_.staleBanner = banner;
    parts_.notice = new NoticeBar;
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(parts_.notice);
    layout->addWidget(banner);
    layout->addWidget(view, 1);
    layout->addWidget(parts_.inside);
    layout->addWidget(parts_.timeline);
    pages_ = new QStackedWidget;
    pages_->addWidget(parts_.startPage);
    pages_->addWidget(page);
    window_.setCentralWidget(pages_);
}

void WindowLayout::makeDocks(const SolverRegistry& registry) {
    window_.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks |
                           QMainWindow::AllowTabbedDocks);
    window_.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    window_.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);

    parts_.tree = new ProjectTree;
    parts_.properties = new PropertyPanel(registry);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(parts_.tree);
    splitter->addWidget(parts_.properties);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({190, 500});
    parts_.projectDock = addDock(Qt::LeftDockWidgetArea, "projectDock", tr("Project"), splitter);
    connect(parts_.properties, &PropertyPanel::leastWidthChanging, this,
            &WindowLayout::keepProjectWidth);
    parts_.results = new ResultsPanel;
    parts_.resultsDock =
        addDock(Qt::RightDockWidgetArea, "resultsDock", tr("Results"), parts_.results);
    raiseByToggle(*parts_.resultsDock);
    parts_.log = new LogPanel;
    parts_.logDock = addDock(Qt::BottomDockWidgetArea, "logDock", tr("Log"), parts_.log);
    parts_.logDock->hide();
    window_.resizeDocks({parts_.logDock}, {160}, Qt::Vertical);
}

QDockWidget* WindowLayout::addDock(Qt::DockWidgetArea area, const char* name, const QString& title,
                                   QWidget* widget) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QLatin1String(name)); // identifies the dock in saved layouts
    dock->setWidget(widget);
    window_.addDockWidget(area, dock);
    return dock;
}

QDockWidget* WindowLayout::addPage(const char* name, const QString& title, QWidget* page) {
    QDockWidget* dock = addDock(Qt::RightDockWidgetArea, name, title, page);
    window_.tabifyDockWidget(parts_.resultsDock, dock);
    dock->hide();
    raiseByToggle(*dock);
    parts_.pageDocks.append(dock);
    return dock;
}

QList<QAction*> WindowLayout::dockToggles() const {
    QList<QAction*> toggles{parts_.projectDock->toggleViewAction(),
                            parts_.resultsDock->toggleViewAction()};
    for (const QDockWidget* dock : parts_.pageDocks) {
        toggles << dock->toggleViewAction();
    }
    return toggles << parts_.logDock->toggleViewAction();
}

void WindowLayout::sizeDocks() {
    window_.resizeDocks({parts_.projectDock, parts_.resultsDock},
                        {window_.width() / 5, window_.width() * 3 / 10}, Qt::Horizontal);
}

// A page of properties that is wider than the dock widens it. The next page that is narrow enough
// gives the dock its width back, unless the user has changed the width since.
void WindowLayout::keepProjectWidth(int least) {
    const QDockWidget* dock = parts_.projectDock;
    if (!dock || !dock->isVisible()) {
        return;
    }
    const int frame = dock->width() - parts_.properties->width();
    if (!widened_ && least + frame > dock->width()) {
        widened_ = {dock->width(), least + frame};
    } else if (widened_ && least + frame <= widened_->before) {
        const int before = widened_->before;
        const bool isUntouched = std::abs(dock->width() - widened_->after) <= 4;
        widened_.reset();
        if (isUntouched) {
            QTimer::singleShot(0, this, [this, before] { // once the dock may be narrower
                window_.resizeDocks({parts_.projectDock}, {before}, Qt::Horizontal);
            });
        }
    } else if (widened_) {
        widened_->after = std::max(widened_->before, least + frame);
    }
}

void WindowLayout::restore() {
    window_.resize(1280, 800);
    standard_ = window_.saveState();
    const QSettings settings;
    window_.restoreGeometry(settings.value(geometryKey).toByteArray());
    window_.restoreState(settings.value(stateKey).toByteArray());
}

void WindowLayout::keep() const {
    QSettings settings;
    settings.setValue(geometryKey, window_.saveGeometry());
    settings.setValue(stateKey, window_.saveState());
}

void WindowLayout::showProject(bool shown) {
    pages_->setCurrentIndex(shown ? 1 : 0);
    for (QDockWidget* dock : {parts_.projectDock, parts_.resultsDock}) {
        dock->setVisible(shown);
        dock->toggleViewAction()->setEnabled(shown);
    }
    for (QDockWidget* dock : parts_.pageDocks) {
        dock->toggleViewAction()->setEnabled(shown);
        if (!shown) {
            dock->hide();
        }
    }
    if (shown && !QSettings().contains(stateKey)) {
        sizeDocks();
    }
}

void WindowLayout::reset() {
    window_.restoreState(standard_);
    for (QDockWidget* dock : {parts_.projectDock, parts_.resultsDock}) {
        dock->setVisible(pages_->currentIndex() == 1);
    }
    sizeDocks();
}

void WindowLayout::askName() {
    auto* dialog = new QInputDialog(&window_);
    dialog->setObjectName(QStringLiteral("layoutName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Save layout"));
    dialog->setLabelText(tr("Name of the layout"));
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (!name.trimmed().isEmpty()) {
            saveLayout(name.trimmed(), window_.saveState());
        }
    });
    dialog->open();
}

void WindowLayout::fillMenu(QMenu& menu) {
    menu.clear();
    const QStringList names = savedLayouts();
    if (names.isEmpty()) {
        menu.addAction(tr("No saved layouts"))->setEnabled(false);
        return;
    }
    for (const QString& name : names) {
        connect(menu.addAction(name), &QAction::triggered, this, [this, name] {
            window_.restoreState(savedLayout(name));
            emit layoutChosen(name);
        });
    }
    menu.addSeparator();
    QMenu* removal = menu.addMenu(tr("&Remove"));
    for (const QString& name : names) {
        connect(removal->addAction(name), &QAction::triggered, this,
                [name] { removeLayout(name); });
    }
}

void WindowLayout::colourBanners() {
    QPalette warning = window_.palette();
    warning.setColor(QPalette::Window,
                     isDark() ? QColor(0x5a, 0x43, 0x10) : QColor(0xff, 0xf0, 0xc8));
    warning.setColor(QPalette::WindowText,
                     isDark() ? QColor(0xff, 0xe3, 0xa6) : QColor(0x5a, 0x3c, 0x00));
    parts_.staleBanner->setPalette(warning);
    parts_.notice->setPalette(warning);
}

} // namespace dipwright

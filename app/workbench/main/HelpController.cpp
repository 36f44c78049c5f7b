#include "workbench/main/HelpController.h"

#include "base/ProgramName.h"
#include "solver/SolverRegistry.h"
#include "viewport/DipView.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/help/GuideWindow.h"
#include "workbench/help/Tour.h"
#include "workbench/jobs/Messages.h"
#include "workbench/main/LogPanel.h"
#include "workbench/project/StartPage.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/Timeline.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QGuiApplication>
#include <QIcon>
#include <QMainWindow>
#include <QMessageBox>
#include <QSysInfo>
#include <QToolBar>
#include <QWhatsThis>

namespace dipwright {

HelpController::HelpController(const WindowActions& actions, QMainWindow& window,
                               const WindowParts& parts, const SolverRegistry& registry,
                               Messages& messages)
    : window_(window), parts_(parts), registry_(registry), messages_(messages) {
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    on(actions.tour, &HelpController::showTour);
    on(actions.guide, &HelpController::showGuide);
    on(actions.whatsThis, [] { QWhatsThis::enterWhatsThisMode(); });
    on(actions.about, &HelpController::showAbout);
    connect(parts.log, &LogPanel::reportAsked, this, &HelpController::copyReport);
}

// If a part of the window is hidden, the step about it is shown without pointing at it.
void HelpController::showTour() {
    const bool atStart = parts_.startPage->isVisible();
    QWidget* tools = window_.findChild<QToolBar*>(QStringLiteral("mainToolBar"));
    new Tour(
        {{nullptr, tr("Welcome"),
          tr("Dipwright computes the image to print on a film. When the part is dipped through the "
             "film, every colour lands in its intended place.")},
         {atStart ? static_cast<QWidget*>(parts_.startPage) : parts_.projectDock, tr("The project"),
          tr("Model, film, one or two dips, sheet and ink. Select an entry in the tree and change "
             "its values below. To begin, drop a model on the window.")},
         {parts_.view, tr("The view"),
          tr("The part above the film. Drag to look at it from all sides, turn it with the rings, "
             "then press Run.")},
         {tools, tr("Run"),
          tr("Simulates the dip while you watch. You can cancel at any time. With “Run live”, each "
             "change recomputes the results that depend on it.")},
         {parts_.timeline, tr("The timeline"), tr("Replays the dip or shows any moment of it.")},
         {parts_.resultsDock, tr("The results"),
          tr("The stretch of the film, the image on it, the finished part and the sheet to print. "
             "Move the cursor over one picture to see the same place in the others.")}},
        &window_);
}

void HelpController::showGuide() {
    dipwright::showGuide(QApplication::focusWidget(), window_);
}

void HelpController::showAbout() {
    QMessageBox box(QMessageBox::NoIcon, tr("About Dipwright"),
                    QStringLiteral("<h3>Dipwright %1</h3><p>%2</p><p>Qt %3 · %4</p>")
                        .arg(programVersion(), tr("Computational hydrographic printing."),
                             QLatin1String(qVersion()),
                             parts_.view->graphicsDevice().toHtmlEscaped()),
                    QMessageBox::Ok, &window_);
    box.setTextFormat(Qt::RichText);
    box.setIconPixmap(QApplication::windowIcon().pixmap(64, 64));
    box.exec();
}

void HelpController::copyReport() {
    QStringList lines{
        QStringLiteral("Dipwright %1").arg(programVersion()),
        QStringLiteral("Qt %1").arg(QLatin1String(qVersion())),
        QStringLiteral("%1, %2").arg(QSysInfo::prettyProductName(),
                                     QSysInfo::currentCpuArchitecture()),
        QStringLiteral("OpenGL: %1").arg(parts_.view->graphicsDevice()),
    };
    for (const SolverInfo& solver : registry_.solvers()) {
        lines.append(
            QStringLiteral("%1 %2: %3")
                .arg(solver.id, solver.version, solver.available ? solver.device : solver.reason));
    }
    lines += {QString(), parts_.log->text()};
    QGuiApplication::clipboard()->setText(lines.join(QLatin1Char('\n')));
    messages_.say(tr("The report was copied to the clipboard"), 4000);
}

} // namespace dipwright

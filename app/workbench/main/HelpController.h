// Help for the user: the tour, the guide, the about box, and the facts for an error report.
#pragma once

#include "workbench/main/WindowLayout.h"

class QMainWindow;

namespace dipwright {

class Messages;
class WindowActions;

class HelpController : public QObject {
    Q_OBJECT

public:
    HelpController(const WindowActions& actions, QMainWindow& window, const WindowParts& parts,
                   const SolverRegistry& registry, Messages& messages);

    void showTour();

private:
    void showGuide();
    void showAbout();
    // Copies details of program and machine, then the log, to the clipboard.
    void copyReport();

    QMainWindow& window_;
    const WindowParts& parts_;
    const SolverRegistry& registry_;
    Messages& messages_;
};

} // namespace dipwright

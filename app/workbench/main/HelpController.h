// What helps the user: tour, guide, what the program is, and the facts for a report of what went
// wrong.
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
    // On the clipboard: about program and machine, then the log.
    void copyReport();

    QMainWindow& window_;
    const WindowParts& parts_;
    const SolverRegistry& registry_;
    Messages& messages_;
};

} // namespace dipwright

// Shows, calibrates and applies profiles of printers, films and tanks.
#pragma once

#include "workbench/document/DocumentSession.h"

class QWidget;

namespace dipwright {

class PropertyPanel;
class WindowActions;
class Workbench;

class ProfileController : public QObject {
    Q_OBJECT

public:
    // `properties` is refreshed when profiles change.
    ProfileController(const WindowActions& actions, const DocumentSession& session,
                      Messages& messages, const Workbench& workbench, PropertyPanel& properties,
                      QWidget& window);

private:
    void showProfiles();
    void calibratePrinter();

    const DocumentSession& session_;
    Messages& messages_;
    const Workbench& workbench_;
    PropertyPanel& properties_;
    QWidget& window_;
};

} // namespace dipwright

#include "workbench/main/ProfileController.h"

#include "project/Profiles.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/main/Workbench.h"
#include "workbench/printing/CalibrationDialog.h"
#include "workbench/profiles/ProfilesDialog.h"
#include "workbench/project/PropertyPanel.h"
#include "workbench/widgets/ShippedNames.h"

#include <QAction>

namespace dipwright {

ProfileController::ProfileController(const WindowActions& actions, const DocumentSession& session,
                                     Messages& messages, const Workbench& workbench,
                                     PropertyPanel& properties, QWidget& window)
    : session_(session), messages_(messages), workbench_(workbench), properties_(properties),
      window_(window) {
    connect(actions.profiles, &QAction::triggered, this, &ProfileController::showProfiles);
    connect(actions.calibrate, &QAction::triggered, this, &ProfileController::calibratePrinter);
}

void ProfileController::showProfiles() {
    auto* dialog = new ProfilesDialog(ProfileLibrary(), workbench_.preferences().unit, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->allowUse(session_.document() != nullptr);
    connect(dialog, &ProfilesDialog::useAsked, this, [this](const Profile& profile) {
        session_.document()->edit(tr("Use profile %1").arg(shownName(nameOf(profile))), {},
                                  [&](Project& project) { applyProfile(project, profile); });
    });
    connect(dialog, &QDialog::finished, &properties_, &PropertyPanel::refresh);
    dialog->open();
}

void ProfileController::calibratePrinter() {
    auto* dialog = new CalibrationDialog(ProfileLibrary(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CalibrationDialog::calibrated, this, [this](const PrinterProfile& profile) {
        properties_.refresh();
        messages_.log(tr("Calibrated %1").arg(shownName(profile.name)));
    });
    dialog->open();
}

} // namespace dipwright

#include "workbench/inspection/ProfileName.h"

#include "base/Error.h"
#include "project/ProfileLibrary.h"

#include <QCoreApplication>
#include <QInputDialog>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(InspectionProfile)
};

} // namespace

void askProfileName(QWidget& window, const std::function<void(const QString& name)>& chosen) {
    auto* dialog = new QInputDialog(&window);
    dialog->setObjectName(QStringLiteral("filmProfileName"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(Text::tr("Save to profile"));
    dialog->setLabelText(Text::tr("Name of a new or existing film profile"));
    QStringList names;
    for (const ProfileEntry& entry : ProfileLibrary().profiles(ProfileKind::Film)) {
        names << entry.name;
    }
    dialog->setComboBoxItems(names);
    dialog->setComboBoxEditable(true);
    QObject::connect(dialog, &QInputDialog::textValueSelected, &window,
                     [chosen](const QString& text) {
                         const QString name = text.trimmed();
                         if (!name.isEmpty()) {
                             chosen(name);
                         }
                     });
    dialog->open();
}

void saveToProfile(Messages& messages, const QString& name, const FilmProfile& fresh,
                   const std::function<FilmProfile(const FilmProfile&)>& change) {
    try {
        const auto known = ProfileLibrary().found(ProfileKind::Film, name);
        FilmProfile profile = known ? std::get<FilmProfile>(*known) : fresh;
        profile.name = name;
        ProfileLibrary().save(change(profile), known);
        messages.logAndSay(Text::tr("Saved the measurement in the film profile %1").arg(name));
    } catch (const Error&) {
        messages.fail(Text::tr("Save to profile"), std::current_exception());
    }
}

} // namespace dipwright

// The profiles of printers, films and tanks: looked at, changed, made, imported and exported.
// Changes are kept at once; a profile of the program's own is kept as one of the user's.
#pragma once

#include "project/ProfileLibrary.h"
#include "workbench/document/Preferences.h"

#include <QDialog>

class QFormLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QTreeWidget;
class QTreeWidgetItem;

namespace dipwright {

class ProfilesDialog : public QDialog {
    Q_OBJECT

public:
    ProfilesDialog(const ProfileLibrary& library, LengthUnit unit, QWidget* parent = nullptr);

    void allowUse(bool allowed); // whether there is a project to use a profile in
    void choose(ProfileKind kind, const QString& name);
    const std::optional<Profile>& chosen() const { return chosen_; }

    // What the buttons do once a file or a name is there. Throw Error.
    void importFile(const QString& path);
    void exportFile(const QString& path) const;
    void setIccFile(const QString& path);
    void copyAs(const QString& name);

signals:
    void useAsked(const Profile& profile); // in the project

private:
    QWidget* makeList();
    QWidget* makeButtons();
    void fillList();
    void showChosen();
    void addIccRow(QFormLayout& form);
    void edit(const QString& path, const QJsonValue& value);
    bool keep(); // what was changed; false: refused, and said why
    // Under its name, where `known` stands. Else the user is asked; false: the other's stays.
    bool store(const std::optional<Profile>& known);
    void removeChosen();
    void tell(const QString& sentence);
    void attempt(const std::function<void()>& action);
    void askImport();
    void askExport();
    void askCopy();
    void askIcc();

    ProfileLibrary library_;
    LengthUnit unit_;
    std::optional<Profile> chosen_;
    std::optional<Profile> known_; // the chosen one as it was read
    QString storedName_;           // under which the chosen one stands in the library
    bool changed_ = false;
    QTreeWidget* list_;
    QScrollArea* editor_;
    QLabel* message_;
    QPushButton *copy_, *remove_, *export_, *use_;
};

} // namespace dipwright

// Lists the profiles of printers, films and tanks: view, edit, copy, import and export. Changes are
// saved at once. A change to a shipped profile is saved as the user's own copy.
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

    void allowUse(bool allowed); // `allowed`: whether a project is open
    void choose(ProfileKind kind, const QString& name);
    const std::optional<Profile>& chosen() const { return chosen_; }

    // The actions of the buttons, after the user has chosen a file or a name. Each throws Error.
    void importFile(const QString& path);
    void exportFile(const QString& path) const;
    void setIccFile(const QString& path, QByteArray PrinterProfile::*file);
    void copyAs(const QString& name);

signals:
    void useAsked(const Profile& profile); // in the project

private:
    QWidget* makeList();
    QWidget* makeButtons();
    void fillList();
    void showChosen();
    // A row for a file of the printer profile: what it is, and buttons that choose and remove it.
    struct IccRow;
    void addIccRow(QFormLayout& form, const IccRow& icc);
    void addIccRows(QFormLayout& form);
    void edit(const QString& path, const QJsonValue& value);
    bool keep(); // saves the changes; false: refused, with a message
    // Saves the chosen profile under its name if the file still equals `known`. Otherwise asks the
    // user. Returns false if the version in the file stays.
    bool store(const std::optional<Profile>& known);
    void removeChosen();
    void tell(const QString& sentence);
    void attempt(const std::function<void()>& action);
    void askImport();
    void askExport();
    void askCopy();
    void askIcc(QByteArray PrinterProfile::*file);

    ProfileLibrary library_;
    LengthUnit unit_;
    std::optional<Profile> chosen_;
    std::optional<Profile> known_; // the chosen profile as it was read
    QString storedName_;           // the chosen profile's name in the library
    bool changed_ = false;
    QTreeWidget* list_;
    QScrollArea* editor_;
    QLabel* message_;
    QPushButton *copy_, *remove_, *export_, *use_;
};

} // namespace dipwright

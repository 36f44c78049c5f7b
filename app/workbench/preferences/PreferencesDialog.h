// Edits the user's preferences: general settings and shortcuts. Also lists the solvers.
#pragma once

#include "solver/SolverRegistry.h"
#include "workbench/document/Preferences.h"

#include <QDialog>

class QAction;
class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;
class QTabWidget;
class QTreeWidget;

namespace dipwright {

class NumberBox;

class PreferencesDialog : public QDialog {
    Q_OBJECT

public:
    // `actions`: the actions whose shortcuts can be edited.
    PreferencesDialog(const Preferences& preferences, const SolverRegistry& registry,
                      const QList<QAction*>& actions, QWidget* parent = nullptr);

    Preferences preferences() const;

private:
    QWidget* makeGeneralPage();
    void fillLists();
    void explainFields();
    QWidget* makeShortcutPage(const QList<QAction*>& actions);
    void checkShortcuts(); // warns if two commands have the same key, which then works for neither

    Preferences preferences_;
    QComboBox* language_;
    QComboBox* unit_;
    QComboBox* theme_;
    QComboBox* navigation_;
    QComboBox* film_; // the size
    QComboBox* filmProfile_;
    QComboBox* printer_;
    NumberBox* autosave_;
    QCheckBox *live_, *keeps_;
    QTreeWidget* shortcuts_;
    QLabel* clash_;
    QDialogButtonBox* buttons_;
};

} // namespace dipwright

#include "workbench/preferences/PreferencesDialog.h"

#include "project/FilmSizes.h"
#include "project/ProfileLibrary.h"
#include "workbench/preferences/SolverPage.h"
#include "workbench/project/FilmMeasured.h"
#include "workbench/widgets/Languages.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/ShippedNames.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace dipwright {

PreferencesDialog::PreferencesDialog(const Preferences& preferences, const SolverRegistry& registry,
                                     const QList<QAction*>& actions, QWidget* parent)
    : QDialog(parent), preferences_(preferences), language_(new QComboBox), unit_(new QComboBox),
      theme_(new QComboBox), navigation_(new QComboBox), film_(new QComboBox),
      filmProfile_(new QComboBox), printer_(new QComboBox), autosave_(new NumberBox),
      live_(new QCheckBox(tr("Run again after each change"))),
      keeps_(new QCheckBox(tr("Keep results next to the project file"))),
      shortcuts_(new QTreeWidget), clash_(new QLabel),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
    setWindowTitle(tr("Preferences"));
    setObjectName(QStringLiteral("preferencesDialog"));
    auto* tabs = new QTabWidget;
    tabs->addTab(makeGeneralPage(), tr("General"));
    tabs->addTab(makeShortcutPage(actions), tr("Shortcuts"));
    tabs->addTab(new SolverPage(registry), tr("Solvers"));
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(tabs);
    layout->addWidget(buttons_);
    resize(660, 520);
}

// Fills the lists and selects the current preferences.
void PreferencesDialog::fillLists() {
    language_->addItem(tr("Same as the system"), QString());
    for (const Language& language : languages()) {
        language_->addItem(language.name, language.code);
    }
    language_->setCurrentIndex(std::max(0, language_->findData(preferences_.language)));
    unit_->addItems({tr("Millimetres"), tr("Inches")});
    unit_->setCurrentIndex(int(preferences_.unit));
    theme_->addItems({tr("Same as the system"), tr("Light"), tr("Dark")});
    theme_->setCurrentIndex(int(preferences_.theme));
    navigation_->addItems({tr("Turntable: up stays up"), tr("Trackball: turns freely")});
    navigation_->setCurrentIndex(int(preferences_.navigation));
    film_->addItems(filmSizeNames());
    film_->setCurrentText(preferences_.filmPreset);
    addFilmProfiles(*filmProfile_, preferences_.filmProfile);
    printer_->addItem(tr("None"), QString());
    for (const ProfileEntry& entry : ProfileLibrary().profiles(ProfileKind::Printer)) {
        printer_->addItem(shownName(entry.name), entry.name);
    }
    printer_->setCurrentIndex(std::max(0, printer_->findData(preferences_.printerProfile)));
}

void PreferencesDialog::explainFields() {
    film_->setToolTip(tr("The film size proposed for new projects."));
    filmProfile_->setToolTip(tr("The film profile proposed for new projects."));
    printer_->setToolTip(tr("The printer profile of new projects. You can change it under Sheet."));
    language_->setToolTip(tr("The language of menus, panels and messages."));
    unit_->setToolTip(tr("The unit in which lengths and speeds are shown and typed."));
    theme_->setToolTip(tr("Light or dark colours."));
    navigation_->setToolTip(tr("How dragging turns the view."));
    autosave_->setToolTip(tr("Longest time between a change and the recovery copy. After a crash, "
                             "your work is restored from this copy."));
    live_->setToolTip(
        tr("After the first run, each change recomputes the results that depend on it."));
    keeps_->setToolTip(
        tr("Saves the dips of a project in the file NAME.dips next to the project file, up to 64 "
           "MB. When you open the project again, its results are shown at once."));
}

QWidget* PreferencesDialog::makeGeneralPage() {
    fillLists();
    explainFields();
    filmProfile_->setObjectName(QStringLiteral("defaultFilm"));
    printer_->setObjectName(QStringLiteral("defaultPrinter"));
    keeps_->setObjectName(QStringLiteral("keepResults"));
    autosave_->setDecimals(0);
    autosave_->setRange(1, 3600);
    autosave_->setSuffix(tr(" s"));
    autosave_->setValue(preferences_.autosaveSeconds);
    live_->setChecked(preferences_.liveUpdate);
    keeps_->setChecked(preferences_.keepsResults);
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(16, 16, 16, 16);
    form->setVerticalSpacing(10);
    form->addRow(tr("&Language"), language_);
    auto* hint = new QLabel(tr("A new language takes effect when you restart the program."));
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);
    form->addRow(QString(), hint);
    form->addRow(tr("L&ength unit"), unit_);
    form->addRow(tr("T&heme"), theme_);
    form->addRow(tr("&Navigation"), navigation_);
    form->addRow(tr("&Film of new projects"), film_);
    form->addRow(tr("Film pr&ofile of new projects"), filmProfile_);
    form->addRow(tr("&Printer of new projects"), printer_);
    form->addRow(tr("&Recovery copy after"), autosave_);
    form->addRow(QString(), live_);
    form->addRow(QString(), keeps_);
    return page;
}

QWidget* PreferencesDialog::makeShortcutPage(const QList<QAction*>& actions) {
    shortcuts_->setHeaderLabels({tr("Command"), tr("Keys")});
    shortcuts_->setRootIsDecorated(false);
    shortcuts_->setAlternatingRowColors(true);
    shortcuts_->setAccessibleName(tr("Shortcuts"));
    shortcuts_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    shortcuts_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    shortcuts_->header()->setStretchLastSection(false);
    shortcuts_->header()->resizeSection(1, 200);
    QPixmap blank(shortcuts_->iconSize().expandedTo({16, 16})); // aligns names without an icon
    blank.fill(Qt::transparent);
    for (const QAction* action : actions) {
        QString text = action->text();
        text.remove(QLatin1Char('&'));
        auto* item = new QTreeWidgetItem(shortcuts_, {text});
        item->setIcon(0, action->icon().isNull() ? QIcon(blank) : action->icon());
        auto* keys = new QKeySequenceEdit(action->shortcut());
        keys->setAccessibleName(text);
        const auto standard = action->property("defaultShortcut").value<QKeySequence>();
        connect(keys, &QKeySequenceEdit::keySequenceChanged, this,
                [this, name = action->objectName(), standard](const QKeySequence& sequence) {
                    if (sequence == standard) {
                        preferences_.shortcuts.remove(name);
                    } else {
                        preferences_.shortcuts[name] = sequence;
                    }
                    checkShortcuts();
                });
        shortcuts_->setItemWidget(item, 1, keys);
    }
    auto* reset = new QPushButton(tr("Reset all"));
    connect(reset, &QPushButton::clicked, this, [this, actions] {
        for (int row = 0; row < shortcuts_->topLevelItemCount(); ++row) {
            auto* keys = qobject_cast<QKeySequenceEdit*>(
                shortcuts_->itemWidget(shortcuts_->topLevelItem(row), 1));
            keys->setKeySequence(actions[row]->property("defaultShortcut").value<QKeySequence>());
        }
    });
    clash_->setObjectName(QStringLiteral("shortcutClash"));
    clash_->setWordWrap(true);
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->addWidget(shortcuts_);
    layout->addWidget(clash_);
    layout->addWidget(reset, 0, Qt::AlignLeft);
    checkShortcuts();
    return page;
}

void PreferencesDialog::checkShortcuts() {
    QMap<QString, QString> commands; // names by keys
    QString clash;
    for (int row = 0; row < shortcuts_->topLevelItemCount(); ++row) {
        const QTreeWidgetItem* item = shortcuts_->topLevelItem(row);
        const auto* edit = qobject_cast<QKeySequenceEdit*>(
            shortcuts_->itemWidget(shortcuts_->topLevelItem(row), 1));
        const QString keys = edit->keySequence().toString(QKeySequence::NativeText);
        if (!keys.isEmpty() && commands.contains(keys)) {
            clash = tr("%1 is assigned to both “%2” and “%3”. Change one of them.")
                        .arg(keys, commands[keys], item->text(0));
        }
        commands[keys] = item->text(0);
    }
    clash_->setText(clash);
    clash_->setVisible(!clash.isEmpty());
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(clash.isEmpty());
}

Preferences PreferencesDialog::preferences() const {
    Preferences chosen = preferences_;
    chosen.language = language_->currentData().toString();
    chosen.unit = LengthUnit(unit_->currentIndex());
    chosen.theme = ThemeChoice(theme_->currentIndex());
    chosen.navigation = NavigationChoice(navigation_->currentIndex());
    chosen.filmPreset = film_->currentText();
    chosen.filmProfile = filmProfile_->currentData().toString();
    chosen.printerProfile = printer_->currentData().toString();
    chosen.autosaveSeconds = autosave_->wholeValue();
    chosen.liveUpdate = live_->isChecked();
    chosen.keepsResults = keeps_->isChecked();
    return chosen;
}

} // namespace dipwright

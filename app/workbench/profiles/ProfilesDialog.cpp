#include "workbench/profiles/ProfilesDialog.h"

#include "base/Error.h"
#include "disk/SmallFile.h"
#include "printing/PrintFile.h"
#include "project/ProfileFields.h"
#include "project/Profiles.h"
#include "project/ProjectFile.h"
#include "sheet/prepress/PrinterColour.h"
#include "workbench/profiles/ProfileSpecs.h"
#include "workbench/widgets/Icons.h"
#include "workbench/widgets/ShippedNames.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>

namespace dipwright {

namespace {

enum Role { KindRole = Qt::UserRole, NameRole, OwnRole };

QString profileFilter() {
    return ProfilesDialog::tr("Profiles (%1)").arg(QStringLiteral("*.json"));
}

QLabel* heading(const QString& text) {
    auto* label = new QLabel(text);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    label->setContentsMargins(0, 8, 0, 0);
    return label;
}

QString colourSpace(const PrinterProfile& printer) {
    const std::unique_ptr<PrinterColour> colour = printerColour(printer);
    if (!colour) {
        return ProfilesDialog::tr("None (the printer receives sRGB)");
    }
    return colour->isCmyk() ? ProfilesDialog::tr("%1 (CMYK)").arg(colour->description())
                            : ProfilesDialog::tr("%1 (RGB)").arg(colour->description());
}

QString deviceLinkText(const PrinterProfile& printer) {
    return printer.deviceLink.isEmpty()
               ? ProfilesDialog::tr("None (the ICC profile converts all pictures)")
           : printer.deviceLink.mid(16, 4) == "CMYK" // the input space in the header
               ? ProfilesDialog::tr("For pictures in CMYK")
               : ProfilesDialog::tr("For pictures in RGB");
}

} // namespace

ProfilesDialog::ProfilesDialog(const ProfileLibrary& library, LengthUnit unit, QWidget* parent)
    : QDialog(parent), library_(library), unit_(unit), list_(new QTreeWidget),
      editor_(new QScrollArea), message_(new QLabel),
      copy_(new QPushButton(icon(QStringLiteral("copy")), tr("Copy…"))),
      remove_(new QPushButton(icon(QStringLiteral("remove")), tr("Remove"))),
      export_(new QPushButton(icon(QStringLiteral("export")), tr("Export…"))),
      use_(new QPushButton(tr("&Use in project"))) {
    setWindowTitle(tr("Profiles"));
    setObjectName(QStringLiteral("profilesDialog"));
    editor_->setWidgetResizable(true);
    editor_->setFrameShape(QFrame::NoFrame);
    message_->setWordWrap(true);
    message_->setObjectName(QStringLiteral("message"));
    auto* splitter = new QSplitter;
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(makeList());
    splitter->addWidget(editor_);
    splitter->setStretchFactor(1, 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(use_, QDialogButtonBox::ActionRole);
    use_->setToolTip(tr("Copies the profile and its values into the project. Later changes to the "
                        "profile do not affect the project."));
    connect(use_, &QPushButton::clicked, this, [this] {
        if (keep()) {
            emit useAsked(*chosen_);
        }
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, &ProfilesDialog::keep);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(splitter, 1);
    layout->addWidget(message_);
    layout->addWidget(buttons);
    resize(1000, 620);
    fillList();
    const auto printers = library_.profiles(ProfileKind::Printer);
    if (!printers.empty()) {
        choose(ProfileKind::Printer, printers.front().name);
    }
}

QWidget* ProfilesDialog::makeList() {
    list_->setHeaderHidden(true);
    list_->header()->setStretchLastSection(false);
    list_->setAccessibleName(tr("Profiles"));
    list_->setMinimumWidth(230);
    connect(list_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        if (!item || !item->data(0, NameRole).isValid()) {
            return;
        }
        const auto kind = ProfileKind(item->data(0, KindRole).toInt());
        const QString name = item->data(0, NameRole).toString();
        if (chosen_ && kindOf(*chosen_) == kind && storedName_ == name) {
            return;
        }
        attempt([&] {
            if (chosen_ && !keep()) {
                QMetaObject::invokeMethod(this, &ProfilesDialog::fillList, Qt::QueuedConnection);
                return;
            }
            chosen_ = known_ = library_.profile(kind, name);
            storedName_ = name;
            changed_ = false;
            showChosen();
        });
    });
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(list_, 1);
    layout->addWidget(makeButtons());
    return box;
}

QWidget* ProfilesDialog::makeButtons() {
    auto* import = new QPushButton(icon(QStringLiteral("document-open")), tr("Import…"));
    copy_->setToolTip(tr("Makes your own copy of this profile."));
    connect(copy_, &QPushButton::clicked, this, &ProfilesDialog::askCopy);
    connect(remove_, &QPushButton::clicked, this, [this] { attempt([this] { removeChosen(); }); });
    connect(import, &QPushButton::clicked, this, &ProfilesDialog::askImport);
    connect(export_, &QPushButton::clicked, this, &ProfilesDialog::askExport);
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(copy_, 0, 0);
    grid->addWidget(remove_, 0, 1);
    grid->addWidget(import, 1, 0);
    grid->addWidget(export_, 1, 1);
    for (QPushButton* button : {copy_, remove_, import, export_, use_}) {
        button->setAutoDefault(false); // Return must only end the typing of a value
    }
    return box;
}

void ProfilesDialog::fillList() {
    const QSignalBlocker quiet(list_);
    list_->clear();
    const std::pair<ProfileKind, QString> kinds[] = {{ProfileKind::Printer, tr("Printers")},
                                                     {ProfileKind::Film, tr("Films")},
                                                     {ProfileKind::Tank, tr("Tanks")}};
    for (const auto& [kind, title] : kinds) {
        auto* group = new QTreeWidgetItem(list_, {title});
        group->setFlags(Qt::ItemIsEnabled);
        for (const ProfileEntry& entry : library_.profiles(kind)) {
            auto* item = new QTreeWidgetItem(group, {shownName(entry.name)});
            item->setData(0, KindRole, int(kind));
            item->setData(0, NameRole, entry.name);
            item->setData(0, OwnRole, entry.isUsers());
            item->setToolTip(0, item->text(0) + QLatin1Char('\n') +
                                    (entry.isUsers() ? entry.path : tr("Comes with the program")));
            if (const std::optional<Error> several = severalFiles(entry)) {
                item->setIcon(0, icon(QStringLiteral("warning")));
                item->setToolTip(0, several->message());
                item->setData(0, Qt::AccessibleDescriptionRole, several->message());
            }
            QFont font = item->font(0);
            font.setItalic(!entry.isUsers());
            item->setFont(0, font);
            if (chosen_ && kindOf(*chosen_) == kind && storedName_ == entry.name) {
                list_->setCurrentItem(item);
            }
        }
        group->setExpanded(true);
    }
    list_->resizeColumnToContents(0);
    list_->setMinimumWidth(std::min(400, list_->columnWidth(0) + 24)); // shows names in full
    const QTreeWidgetItem* current = list_->currentItem();
    remove_->setEnabled(current && current->data(0, OwnRole).toBool());
}

void ProfilesDialog::allowUse(bool allowed) {
    use_->setEnabled(allowed);
}

void ProfilesDialog::choose(ProfileKind kind, const QString& name) {
    for (QTreeWidgetItemIterator item(list_); *item; ++item) {
        const QVariant entry = (*item)->data(0, NameRole); // invalid for the heading of a kind
        if (entry.isValid() && entry == name && (*item)->data(0, KindRole).toInt() == int(kind)) {
            list_->setCurrentItem(*item);
        }
    }
}

void ProfilesDialog::showChosen() {
    auto* page = new QWidget;
    auto* form = new QFormLayout(page);
    form->setContentsMargins(12, 4, 12, 4);
    form->setVerticalSpacing(8);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const ProfileKind kind = kindOf(*chosen_);
    const std::vector<PropertySection> sections = profileSections(kind);
    const PropertySection* iccSection = // the printer's colour, after its name and page
        kind == ProfileKind::Printer ? &sections.at(1) : nullptr;
    for (const PropertySection& section : sections) {
        if (!section.title.isEmpty()) {
            form->addRow(heading(section.title));
        }
        if (&section == iccSection) {
            addIccRows(*form);
        }
        for (const PropertySpec& spec : section.specs) {
            PropertyField* field =
                PropertyField::make(spec, profileRule(kind, spec.path), unit_, page);
            field->show(profileValue(*chosen_, spec.path));
            auto* label = new QLabel(spec.label);
            label->setBuddy(field);
            label->setToolTip(spec.help);
            form->addRow(label, field);
            connect(field, &PropertyField::edited, this,
                    [this, spec](const QJsonValue& value) { edit(spec.path, value); });
            connect(field, &PropertyField::left, this, &ProfilesDialog::keep);
        }
    }
    editor_->setWidget(page);
    editor_->setMinimumWidth(page->minimumSizeHint().width() +
                             editor_->verticalScrollBar()->sizeHint().width());
    tell({});
    const QTreeWidgetItem* current = list_->currentItem();
    remove_->setEnabled(current && current->data(0, OwnRole).toBool());
}

struct ProfilesDialog::IccRow {
    QString label, help, content; // content: what the file is
    QString path;                 // of the field
    QByteArray PrinterProfile::*file;
    QString choose, none; // names of the buttons
};

void ProfilesDialog::addIccRows(QFormLayout& form) {
    const auto& printer = std::get<PrinterProfile>(*chosen_);
    addIccRow(form,
              {tr("ICC profile"),
               tr("The printer's output profile, made for its ink and film. Sheets are then "
                  "sent in the printer's own colours."),
               colourSpace(printer), QStringLiteral("icc_profile"), &PrinterProfile::iccProfile,
               tr("Choose an ICC profile"), tr("No ICC profile")});
    addIccRow(form,
              {tr("Device link"),
               tr("An ICC device link from RGB or CMYK to the printer's CMYK. It converts "
                  "pictures of its kind in place of the ICC profile, for example to keep "
                  "black text in black ink. Used only with a CMYK ICC profile."),
               deviceLinkText(printer), QStringLiteral("device_link"), &PrinterProfile::deviceLink,
               tr("Choose a device link"), tr("No device link")});
}

void ProfilesDialog::addIccRow(QFormLayout& form, const IccRow& icc) {
    const auto& printer = std::get<PrinterProfile>(*chosen_);
    auto* space = new QLabel(icc.content);
    space->setObjectName(icc.path + QStringLiteral(".content"));
    space->setWordWrap(true);
    auto* choose = new QPushButton(tr("Choose…"));
    auto* none = new QPushButton(tr("None"));
    none->setEnabled(!(printer.*icc.file).isEmpty());
    for (QPushButton* button : {choose, none}) {
        button->setAutoDefault(false);
    }
    choose->setAccessibleName(icc.choose);
    none->setAccessibleName(icc.none);
    // Queued: the buttons are deleted when the page is rebuilt.
    connect(
        choose, &QPushButton::clicked, this, [this, file = icc.file] { askIcc(file); },
        Qt::QueuedConnection);
    connect(
        none, &QPushButton::clicked, this,
        [this, path = icc.path] {
            edit(path, QString());
            keep();
            showChosen();
        },
        Qt::QueuedConnection);
    auto* row = new QWidget; // in a row that is a layout, Qt cuts off lines of wrapped text
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(space, 1);
    layout->addWidget(choose);
    layout->addWidget(none);
    auto* label = new QLabel(icc.label);
    label->setToolTip(icc.help);
    form.addRow(label, row);
}

void ProfilesDialog::edit(const QString& path, const QJsonValue& value) {
    attempt([&] {
        setProfileValue(*chosen_, path, value);
        changed_ = true;
        tell({});
    });
}

bool ProfilesDialog::keep() {
    if (!chosen_ || !changed_) {
        return chosen_.has_value();
    }
    const ProfileKind kind = kindOf(*chosen_);
    const QString name = nameOf(*chosen_).simplified();
    bool kept = false;
    attempt([&] {
        if (name.isEmpty()) {
            throw Error(tr("A profile needs a name"), storedName_);
        }
        if (name != storedName_ && library_.contains(kind, name)) {
            throw Error(tr("A profile with this name already exists; choose another name"), name);
        }
        std::visit([&](auto& profile) { profile.name = name; }, *chosen_);
        if (!store(name == storedName_ ? known_ : std::nullopt)) {
            return;
        }
        known_ = chosen_;
        const std::vector<ProfileEntry> all = library_.profiles(kind);
        if (name != storedName_ && std::any_of(all.begin(), all.end(), [&](const auto& entry) {
                return entry.name == storedName_ && entry.isUsers();
            })) {
            library_.remove(kind, storedName_);
        }
        storedName_ = name;
        changed_ = false;
        kept = true;
        // Queued: a signal of the list may be in progress.
        QMetaObject::invokeMethod(this, &ProfilesDialog::fillList, Qt::QueuedConnection);
    });
    return kept;
}

bool ProfilesDialog::store(const std::optional<Profile>& known) {
    try {
        library_.save(*chosen_, known);
        return true;
    } catch (const ChangedFile&) {
        QMessageBox question(QMessageBox::Warning, tr("Profile changed by another program"),
                             tr("Another program has changed the profile “%1” in the meantime.")
                                 .arg(shownName(nameOf(*chosen_))),
                             QMessageBox::NoButton, this);
        question.setObjectName(QStringLiteral("changedQuestion"));
        QPushButton* theirs =
            question.addButton(tr("Load the other version"), QMessageBox::AcceptRole);
        QPushButton* mine = question.addButton(tr("Keep &mine"), QMessageBox::DestructiveRole);
        question.setDefaultButton(theirs);
        question.setEscapeButton(theirs);
        question.exec();
        if (question.clickedButton() == mine) {
            library_.replace(*chosen_);
            return true;
        }
    }
    changed_ = false;
    chosen_ = known_ = library_.profile(kindOf(*chosen_), storedName_);
    // Queued: one of the fields to be deleted may be emitting its signal.
    QMetaObject::invokeMethod(this, &ProfilesDialog::showChosen, Qt::QueuedConnection);
    return false;
}

void ProfilesDialog::removeChosen() {
    const ProfileKind kind = kindOf(*chosen_);
    const QString name = storedName_;
    library_.remove(kind, name);
    chosen_.reset();
    changed_ = false;
    storedName_.clear();
    fillList();
    const auto rest = library_.profiles(kind);
    choose(kind, library_.contains(kind, name) || rest.empty() ? name : rest.front().name);
}

void ProfilesDialog::importFile(const QString& path) {
    keep();
    const Profile imported = importProfile(path);
    library_.replace(imported);
    chosen_.reset();
    fillList();
    choose(kindOf(imported), nameOf(imported));
}

void ProfilesDialog::exportFile(const QString& path) const {
    exportProfile(*chosen_, path);
}

void ProfilesDialog::setIccFile(const QString& path, QByteArray PrinterProfile::*file) {
    auto printer = std::get<PrinterProfile>(*chosen_);
    printer.*file = readSmallFile(path, mostProfileBytes);
    if (file == &PrinterProfile::deviceLink && printer.iccProfile.isEmpty()) {
        throw Error(tr("A device link needs the printer's ICC profile, too; choose that first"),
                    path);
    }
    // Throws if the profile cannot be used.
    PrinterColour(printer, path);
    chosen_ = printer;
    changed_ = true;
    keep();
    showChosen();
}

void ProfilesDialog::copyAs(const QString& name) {
    keep();
    Profile copy = *chosen_;
    std::visit([&](auto& profile) { profile.name = name.simplified(); }, copy);
    if (library_.contains(kindOf(copy), nameOf(copy))) {
        throw Error(tr("A profile with this name already exists; choose another name"),
                    nameOf(copy));
    }
    library_.save(copy, std::nullopt);
    fillList();
    choose(kindOf(copy), nameOf(copy));
}

void ProfilesDialog::tell(const QString& sentence) {
    message_->setText(
        sentence.isEmpty()
            ? tr("Changes are saved at once. Profiles in italics come with the program. If you "
                 "change one, your copy is used; “Remove” restores the original.")
            : sentence);
}

void ProfilesDialog::attempt(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        tell(error.sentence());
    }
}

void ProfilesDialog::askImport() {
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Import profile"), {}, profileFilter());
    if (!path.isEmpty()) {
        attempt([&] { importFile(path); });
    }
}

void ProfilesDialog::askExport() {
    QFileDialog dialog(this, tr("Export profile"), {}, profileFilter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    dialog.selectFile(storedName_ + QStringLiteral(".json"));
    if (keep() && dialog.exec() == QDialog::Accepted) {
        attempt([&] { exportFile(dialog.selectedFiles().first()); });
    }
}

void ProfilesDialog::askCopy() {
    const QString name = QInputDialog::getText(this, tr("Copy profile"), tr("Name of the copy:"),
                                               QLineEdit::Normal, tr("%1, copy").arg(storedName_));
    if (!name.simplified().isEmpty()) {
        attempt([&] { copyAs(name); });
    }
}

void ProfilesDialog::askIcc(QByteArray PrinterProfile::*file) {
    const QString path = QFileDialog::getOpenFileName(
        this,
        file == &PrinterProfile::iccProfile ? tr("Choose an ICC profile")
                                            : tr("Choose a device link"),
        {}, tr("ICC profiles (%1)").arg(QStringLiteral("*.icc *.icm *.ICC *.ICM")));
    if (!path.isEmpty()) {
        attempt([&] { setIccFile(path, file); });
    }
}

} // namespace dipwright

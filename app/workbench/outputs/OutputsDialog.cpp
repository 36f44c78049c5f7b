#include "workbench/outputs/OutputsDialog.h"

#include "base/Error.h"
#include "workbench/widgets/NoticeBar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QStandardPaths>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace dipwright {

namespace {

enum Column { NameColumn, StateColumn, FilesColumn };

const char* const lastSetKey = "outputs/set";

// The folder that is proposed for a project's outputs: beside its file.
QString proposedFolder(const Document& document) {
    const QString beside = document.path().isEmpty()
                               ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                               : QFileInfo(document.path()).absolutePath();
    return QDir(beside).filePath(
        QFileInfo(document.title()).completeBaseName().simplified().replace(u'/', u'-') +
        QStringLiteral("-outputs"));
}

} // namespace

OutputsDialog::OutputsDialog(Document& document, std::shared_ptr<const JobResult> result,
                             QWidget* parent)
    : QDialog(parent), document_(document), result_(std::move(result)), notice_(new NoticeBar),
      set_(new QComboBox), list_(new QTreeWidget), folder_(new QLineEdit),
      overwrite_(new QCheckBox(tr("Overwrite files that were not made here"))),
      clip_(new QCheckBox(tr("Clip what lies outside the printable area"))), words_(new QLabel),
      progress_(new QProgressBar), save_(new QPushButton(tr("&Save set"))),
      remove_(new QPushButton(tr("&Remove set"))), choose_(new QPushButton(tr("&Choose…"))),
      make_(nullptr), close_(nullptr) {
    setObjectName(QStringLiteral("outputsDialog"));
    setWindowTitle(tr("Make outputs"));
    list_->setObjectName(QStringLiteral("outputs"));
    list_->setAccessibleName(tr("Outputs"));
    list_->setRootIsDecorated(false);
    list_->setHeaderLabels({tr("Output"), tr("State"), tr("Files")});
    list_->header()->setSectionResizeMode(NameColumn, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(StateColumn, QHeaderView::ResizeToContents);
    for (const Output output : allOutputs) {
        auto* row = new QTreeWidgetItem(list_, {outputText(output)});
        row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        row->setCheckState(NameColumn, Qt::Unchecked);
    }
    words_->setWordWrap(true);
    words_->setObjectName(QStringLiteral("outputsWords"));
    words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    progress_->setRange(0, 1000);
    progress_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(notice_);
    layout->addWidget(makeSets());
    layout->addWidget(list_, 1);
    layout->addWidget(makeFolder());
    layout->addWidget(makeOptions());
    layout->addWidget(words_);
    layout->addWidget(progress_);
    layout->addWidget(makeButtons());
    if (!document_.isFresh()) {
        notice_->say(tr("These results were made before the last changes to the project. Run the "
                        "dip again for outputs of the current state."));
    }
    connect(list_, &QTreeWidget::itemChanged, this, &OutputsDialog::enable);
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * 1000));
        if (making_ && !text.isEmpty()) {
            words_->setText(text);
        }
    });
    connect(&jobs_, &JobRunner::idle, this, [this] {
        if (making_) { // cancelled: neither done nor failed
            setBusy(false, tr("Cancelled. Outputs that were finished before stay."));
            showStates();
        }
    });
    resize(760, 560);
    showSets(QSettings().value(QLatin1String(lastSetKey)).toString());
    folder_->setText(QDir::toNativeSeparators(proposedFolder(document_)));
    showStates();
}

QWidget* OutputsDialog::makeSets() {
    set_->setObjectName(QStringLiteral("outputSet"));
    set_->setAccessibleName(tr("Output set"));
    set_->setEditable(true);
    set_->setInsertPolicy(QComboBox::NoInsert);
    set_->setToolTip(
        tr("A named list of outputs. To make an own set, tick its outputs, type a name "
           "and save it. It is kept with the project; the command line makes the same "
           "files with run --outputs NAME."));
    set_->lineEdit()->setMaxLength(longestOutputSetName);
    save_->setObjectName(QStringLiteral("saveOutputSet"));
    save_->setToolTip(tr("Keeps the ticked outputs under this name in the project. This can be "
                         "undone."));
    remove_->setObjectName(QStringLiteral("removeOutputSet"));
    remove_->setToolTip(tr("Removes this set from the project. This can be undone."));
    connect(set_, &QComboBox::activated, this, &OutputsDialog::tickSet);
    connect(set_, &QComboBox::editTextChanged, this, &OutputsDialog::enable);
    connect(save_, &QPushButton::clicked, this, &OutputsDialog::saveSet);
    connect(remove_, &QPushButton::clicked, this, &OutputsDialog::removeSet);
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("S&et"));
    label->setBuddy(set_);
    row->addWidget(label);
    row->addWidget(set_, 1);
    row->addWidget(save_);
    row->addWidget(remove_);
    return box;
}

QWidget* OutputsDialog::makeFolder() {
    folder_->setObjectName(QStringLiteral("outputsFolder"));
    folder_->setToolTip(tr("The folder that the files are written to. It is made if it does not "
                           "exist."));
    connect(choose_, &QPushButton::clicked, this, &OutputsDialog::chooseFolder);
    connect(folder_, &QLineEdit::editingFinished, this, &OutputsDialog::showStates);
    auto* box = new QWidget;
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(tr("&Folder"));
    label->setBuddy(folder_);
    row->addWidget(label);
    row->addWidget(folder_, 1);
    row->addWidget(choose_);
    return box;
}

QWidget* OutputsDialog::makeOptions() {
    overwrite_->setObjectName(QStringLiteral("overwrite"));
    overwrite_->setToolTip(tr("If this is not ticked, an output fails rather than replace a file "
                              "that it has not made, or that was changed since."));
    clip_->setToolTip(tr("For sheets in the printer's colours: if this is not ticked, they fail "
                         "if colour lies where the printer cannot print."));
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(overwrite_);
    column->addWidget(clip_);
    return box;
}

QWidget* OutputsDialog::makeButtons() {
    auto* buttons = new QDialogButtonBox;
    close_ = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    for (QPushButton* other : {save_, remove_, choose_, close_}) {
        other->setAutoDefault(false); // Enter makes the outputs
    }
    make_ = buttons->addButton(tr("&Make outputs"), QDialogButtonBox::ActionRole);
    make_->setObjectName(QStringLiteral("makeOutputsNow"));
    make_->setDefault(true);
    make_->setToolTip(tr("Writes the files of all ticked outputs."));
    connect(make_, &QPushButton::clicked, this, &OutputsDialog::make);
    connect(buttons, &QDialogButtonBox::rejected, this, [this] {
        if (making_) {
            jobs_.cancelAll();
        } else {
            reject();
        }
    });
    return buttons;
}

void OutputsDialog::showSets(const QString& name) {
    {
        const QSignalBlocker quiet(set_);
        set_->clear();
        for (const OutputSet& set : outputSets(document_.project())) {
            set_->addItem(outputSetText(set.name), set.name);
        }
        set_->setCurrentIndex(std::max(set_->findData(name), 0));
    }
    tickSet();
}

void OutputsDialog::tickSet() {
    const std::vector<OutputSet> sets = outputSets(document_.project());
    const OutputSet& set = sets.at(std::size_t(set_->currentIndex()));
    for (std::size_t i = 0; i < allOutputs.size(); ++i) {
        const bool isTicked = std::ranges::count(set.outputs, allOutputs[i]) > 0;
        list_->topLevelItem(int(i))->setCheckState(NameColumn,
                                                   isTicked ? Qt::Checked : Qt::Unchecked);
    }
    QSettings().setValue(QLatin1String(lastSetKey), set.name);
    enable();
}

void OutputsDialog::saveSet() {
    const QString typed = set_->currentText().simplified();
    const int known = set_->findText(typed, Qt::MatchFixedString);
    const OutputSet set{known < 0 ? typed : set_->itemData(known).toString(), ticked()};
    document_.edit(tr("Save output set “%1”").arg(typed), {}, [&set](Project& project) {
        std::vector<OutputSet> own = ownOutputSets(project);
        std::erase_if(own, [&](const OutputSet& one) { return one.name == set.name; });
        own.push_back(set);
        project = withOutputSets(project, own);
    });
    showSets(set.name);
    words_->setText(tr("The set “%1” is kept with the project.").arg(typed));
}

void OutputsDialog::removeSet() {
    const QString name = set_->itemData(set_->findText(set_->currentText())).toString();
    document_.edit(tr("Remove output set “%1”").arg(name), {}, [&name](Project& project) {
        std::vector<OutputSet> own = ownOutputSets(project);
        std::erase_if(own, [&](const OutputSet& one) { return one.name == name; });
        project = withOutputSets(project, own);
    });
    showSets({});
}

void OutputsDialog::chooseFolder() {
    const QString chosen =
        QFileDialog::getExistingDirectory(this, tr("Folder of the outputs"), folder());
    if (!chosen.isEmpty()) {
        folder_->setText(QDir::toNativeSeparators(chosen));
        showStates();
    }
}

QString OutputsDialog::folder() const {
    return QDir::fromNativeSeparators(folder_->text().trimmed());
}

std::vector<Output> OutputsDialog::ticked() const {
    std::vector<Output> outputs;
    for (std::size_t i = 0; i < allOutputs.size(); ++i) {
        if (list_->topLevelItem(int(i))->checkState(NameColumn) == Qt::Checked) {
            outputs.push_back(allOutputs[i]);
        }
    }
    return outputs;
}

void OutputsDialog::showStates() {
    enable();
    const int lookup = ++lookup_;
    jobs_.start(std::make_unique<ValueJob<std::vector<OutputStatus>>>(
        tr("Looking for outputs"),
        [folder = folder(), project = document_.project()](const Progress&) {
            return outputStates(folder, {allOutputs.begin(), allOutputs.end()}, project);
        },
        [this, lookup](const std::vector<OutputStatus>& states) {
            if (lookup == lookup_ && !making_) {
                show(states);
            }
        },
        [this](const std::exception_ptr& failure) { showFailure(failure); }));
}

void OutputsDialog::show(const std::vector<OutputStatus>& states) {
    const auto word = [](OutputState state) {
        switch (state) {
        case OutputState::Done:
            return tr("Done");
        case OutputState::OutOfDate:
            return tr("Out of date");
        case OutputState::Failed:
            return tr("Failed");
        case OutputState::NotMade:
            return tr("Not made");
        }
        return QString();
    };
    const QSignalBlocker quiet(list_);
    for (const OutputStatus& status : states) {
        const auto number =
            std::find(allOutputs.begin(), allOutputs.end(), status.output) - allOutputs.begin();
        QTreeWidgetItem* row = list_->topLevelItem(int(number));
        row->setText(StateColumn, word(status.state));
        row->setText(FilesColumn, status.state == OutputState::Failed
                                      ? status.reason
                                      : status.files.join(QStringLiteral(", ")));
        row->setToolTip(
            FilesColumn,
            (QStringList(row->text(FilesColumn)) + status.notes).join(QStringLiteral("\n")));
    }
}

void OutputsDialog::make() {
    OutputRequest request;
    request.folder = folder();
    request.outputs = ticked();
    request.projectFile = document_.path();
    request.overwrites = overwrite_->isChecked();
    request.acceptsClipping = clip_->isChecked();
    setBusy(true, tr("Making outputs …"));
    jobs_.start(std::make_unique<ValueJob<std::vector<OutputStatus>>>(
        tr("Making outputs"),
        [result = result_, request](const Progress& progress) {
            return makeOutputs(*result, request, progress);
        },
        [this](const std::vector<OutputStatus>& states) { finish(states); },
        [this](const std::exception_ptr& failure) { showFailure(failure); }));
}

void OutputsDialog::finish(const std::vector<OutputStatus>& states) {
    QStringList lines;
    int failed = 0;
    for (const OutputStatus& status : states) {
        if (status.state == OutputState::Failed) {
            ++failed;
            lines << statusText(status);
        }
        for (const QString& note : status.notes) {
            lines << QStringLiteral("%1: %2").arg(outputText(status.output), note);
        }
    }
    const QString sentence =
        failed == 0 ? tr("Made the outputs in %1").arg(QDir::toNativeSeparators(folder()))
                    : tr("Outputs that failed: %1 of %2").arg(failed).arg(states.size());
    setBusy(false, (QStringList(sentence) + lines).join(u'\n'));
    show(states);
    emit made(sentence);
}

void OutputsDialog::setBusy(bool busy, const QString& what) {
    making_ = busy;
    progress_->setVisible(busy);
    progress_->setValue(0);
    words_->setText(what);
    close_->setText(busy ? tr("Cancel") : tr("Close"));
    enable();
}

void OutputsDialog::enable() {
    const std::vector<OutputSet> own = ownOutputSets(document_.project());
    const QString typed = set_->currentText().simplified();
    const bool any = !ticked().empty();
    make_->setEnabled(!making_ && any && !folder().isEmpty());
    save_->setEnabled(!making_ && any && !typed.isEmpty());
    remove_->setEnabled(!making_ && std::ranges::any_of(own, [&](const OutputSet& set) {
        return outputSetText(set.name) == typed;
    }));
    for (QWidget* widget : {static_cast<QWidget*>(set_), static_cast<QWidget*>(list_),
                            static_cast<QWidget*>(folder_), static_cast<QWidget*>(choose_)}) {
        widget->setEnabled(!making_);
    }
}

void OutputsDialog::showFailure(const std::exception_ptr& failure) {
    setBusy(false, {});
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        words_->setText(error.sentence());
    } catch (const std::exception& error) {
        words_->setText(QString::fromUtf8(error.what()));
    }
}

} // namespace dipwright

#include "main/PrintDialog.h"

#include "base/Error.h"
#include "panels/PictureView.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

namespace dipwright {

namespace {

const char* const lastPrinterKey = "lastPrinter";

} // namespace

PrintDialog::PrintDialog(const DipOutcome& outcome, std::size_t immersion, QWidget* parent)
    : QDialog(parent), outcome_(outcome), preview_(new PictureView), printer_(new QComboBox),
      copies_(new QSpinBox), tile_(new QCheckBox(tr("Cut into pieces where the paper is smaller"))),
      grey_(new QCheckBox(tr("Grey, on a printer without colour"))),
      clipped_(new QCheckBox(tr("Without what lies where the printer does not reach"))),
      otherPaper_(new QCheckBox(tr("Though the paper is not loaded as far as is known"))),
      verdict_(new QLabel), progress_(new QProgressBar), print_(nullptr) {
    setWindowTitle(tr("Print Sheets"));
    setObjectName(QStringLiteral("printDialog"));
    for (std::size_t number = 0; number < outcome.result->immersions.size(); ++number) {
        auto* box = new QCheckBox(outcome.result->immersions[number].immersion.name);
        box->setChecked(number == immersion);
        box->setToolTip(tr("Whether this immersion's sheet is printed."));
        connect(box, &QCheckBox::toggled, this, [this, number] {
            preview_->setPicture(outcome_.sheets[number].page, outcome_.sheets[number].size);
            judge();
        });
        immersions_.push_back(box);
    }
    preview_->setAccessibleName(tr("Page"));
    preview_->setMinimumSize(320, 420);
    preview_->setPicture(outcome.sheets[immersion].page, outcome.sheets[immersion].size);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    print_ = buttons->addButton(tr("Print"), QDialogButtonBox::ActionRole);
    print_->setDefault(true);
    connect(print_, &QPushButton::clicked, this, &PrintDialog::print);
    connect(buttons, &QDialogButtonBox::rejected, this, [this] {
        if (printing_) {
            jobs_.cancelAll();
        } else {
            reject();
        }
    });
    auto* left = new QVBoxLayout;
    left->addWidget(makeChoices());
    left->addWidget(makeExceptions());
    left->addWidget(verdict_, 1);
    left->addWidget(progress_);
    left->addWidget(buttons);
    auto* layout = new QHBoxLayout(this);
    layout->addLayout(left, 3);
    layout->addWidget(preview_, 2);
    verdict_->setWordWrap(true);
    verdict_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    verdict_->setMinimumHeight(80);
    progress_->setRange(0, 1000);
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * 1000));
        if (printing_ && !text.isEmpty()) {
            verdict_->setText(text);
        }
    });
    resize(860, 560);
    findPrinters();
}

QWidget* PrintDialog::makeChoices() {
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    printer_->setAccessibleName(tr("Printer"));
    printer_->setToolTip(tr("The printers that are set up on this machine."));
    copies_->setRange(1, 99);
    copies_->setToolTip(tr("How often each sheet is printed."));
    form->addRow(tr("&Printer"), printer_);
    const auto& profile = outcome_.result->project.profiles.printer;
    auto* profileName = new QLabel(
        profile ? profile->name : tr("None: true size and sRGB (choose one under Sheet)"));
    profileName->setWordWrap(true);
    form->addRow(tr("Profile"), profileName);
    form->addRow(tr("&Copies"), copies_);
    auto* sheets = new QVBoxLayout;
    for (QCheckBox* immersion : immersions_) {
        sheets->addWidget(immersion);
    }
    form->addRow(tr("Sheets"), sheets);
    connect(printer_, &QComboBox::currentIndexChanged, this, &PrintDialog::judge);
    connect(copies_, &QSpinBox::valueChanged, this, &PrintDialog::judge);
    return box;
}

QWidget* PrintDialog::makeExceptions() {
    auto* box = new QGroupBox(tr("Print even so"));
    auto* layout = new QVBoxLayout(box);
    for (QCheckBox* exception : {tile_, grey_, clipped_, otherPaper_}) {
        exception->setToolTip(tr("Without this tick such a print is refused, with the reason."));
        layout->addWidget(exception);
        connect(exception, &QCheckBox::toggled, this, &PrintDialog::judge);
    }
    return box;
}

void PrintDialog::findPrinters() {
    setBusy(true, tr("Looking for printers …"));
    jobs_.start(std::make_unique<ValueJob<QStringList>>(
        tr("Looking for printers"), [](const Progress&) { return printSystem()->printers(); },
        [this](const QStringList& printers) { showPrinters(printers); },
        [this](std::exception_ptr failure) { showFailure(failure); }));
}

void PrintDialog::showPrinters(const QStringList& printers) {
    setBusy(false, {});
    {
        const QSignalBlocker quiet(printer_);
        printer_->addItems(printers);
        const auto& profile = outcome_.result->project.profiles.printer;
        for (const QString& wanted : {QSettings().value(QLatin1String(lastPrinterKey)).toString(),
                                      profile ? profile->queue : QString()}) {
            if (printers.contains(wanted)) {
                printer_->setCurrentText(wanted);
            }
        }
    }
    if (printers.isEmpty()) {
        verdict_->setText(
            tr("No printer is set up on this machine. Save the sheet as PDF and print "
               "it elsewhere, at 100 %."));
        print_->setEnabled(false);
    } else {
        judge();
    }
}

PrintRequest PrintDialog::request() const {
    PrintRequest request;
    request.printer = printer_->currentText();
    request.copies = copies_->value();
    request.profile = outcome_.result->project.profiles.printer;
    request.tile = tile_->isChecked();
    request.acceptMonochrome = grey_->isChecked();
    request.acceptClipping = clipped_->isChecked();
    request.acceptOtherPaper = otherPaper_->isChecked();
    return request;
}

std::vector<Sheet> PrintDialog::chosenSheets() const {
    std::vector<Sheet> sheets;
    for (std::size_t number = 0; number < immersions_.size(); ++number) {
        if (immersions_[number]->isChecked()) {
            sheets.push_back(outcome_.result->immersions[number].sheet);
        }
    }
    return sheets;
}

void PrintDialog::judge() {
    const std::vector<Sheet> sheets = chosenSheets();
    if (printing_ || printer_->count() == 0) {
        return;
    }
    if (sheets.empty()) {
        verdict_->setText(tr("Choose at least one sheet."));
        print_->setEnabled(false);
        return;
    }
    setBusy(true, tr("Asking the printer …"));
    const int judgement = ++judgement_;
    jobs_.start(std::make_unique<ValueJob<QStringList>>(
        tr("Asking the printer"),
        [sheets, request = request()](const Progress&) {
            const auto system = printSystem();
            QStringList warnings;
            for (const Sheet& sheet : sheets) {
                warnings.append(planPrint(*system, sheet, request).warnings);
            }
            warnings.removeDuplicates();
            return warnings;
        },
        [this, judgement](const QStringList& warnings) {
            if (judgement == judgement_) {
                setBusy(false, warnings.isEmpty() ? tr("Ready to print at true size.")
                                                  : warnings.join(QStringLiteral("\n\n")));
            }
        },
        [this, judgement](std::exception_ptr failure) {
            if (judgement == judgement_) {
                showFailure(failure);
            }
        }));
}

void PrintDialog::print() {
    printing_ = true;
    setBusy(true, tr("Printing …"));
    QSettings().setValue(QLatin1String(lastPrinterKey), printer_->currentText());
    jobs_.start(std::make_unique<ValueJob<JobState>>(
        tr("Printing"),
        [sheets = chosenSheets(), request = request()](const Progress& progress) {
            const auto system = printSystem();
            JobState state = JobState::Printed;
            for (std::size_t number = 0; number < sheets.size(); ++number) {
                const PrintPlan plan = planPrint(*system, sheets[number], request);
                progress.cancelSwitch.throwIfCancelled();
                const PrintJob job = system->submit(plan.task);
                state = followJob(*system, job,
                                  progress.part(double(number) / double(sheets.size()),
                                                double(number + 1) / double(sheets.size())));
            }
            return state;
        },
        [this](JobState state) {
            emit printed(state == JobState::Printed
                             ? tr("Printed on %1").arg(printer_->currentText())
                             : tr("Handed to the queue of %1").arg(printer_->currentText()));
            accept();
        },
        [this](std::exception_ptr failure) {
            printing_ = false;
            showFailure(failure);
        }));
}

void PrintDialog::setBusy(bool busy, const QString& what) {
    print_->setEnabled(!busy);
    printer_->setEnabled(!printing_);
    progress_->setVisible(printing_);
    verdict_->setText(what);
}

void PrintDialog::showFailure(std::exception_ptr failure) {
    setBusy(false, {});
    print_->setEnabled(false);
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        verdict_->setText(error.sentence());
    } catch (const std::exception& error) {
        verdict_->setText(QString::fromUtf8(error.what()));
    }
}

} // namespace dipwright

#include "workbench/printing/PrintDialog.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "pipeline/JobPacking.h"
#include "pipeline/JobVerdict.h"
#include "printing/PrintFile.h"
#include "project/Profiles.h"
#include "sheet/page/PaperMargins.h"
#include "sheet/page/SheetRows.h"
#include "workbench/printing/PlatesDialog.h"
#include "workbench/widgets/NoticeBar.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"
#include "workbench/widgets/PictureView.h"
#include "workbench/widgets/Units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

namespace dipwright {

namespace {

const char* const lastPrinterKey = "lastPrinter";

struct Judgement {
    QStringList warnings;
    int pages = 0;
};

// Whether the verdict on a job already says that its film has expired.
bool isKnownAsExpired(const JobResult& result) {
    const std::vector<JobReason> reasons = reasonsOf(result);
    return std::any_of(reasons.begin(), reasons.end(), [](const JobReason& reason) {
        return reason.reason.kind == VerdictReason::Kind::ExpiredFilm;
    });
}

} // namespace

PrintDialog::PrintDialog(const DipOutcome& outcome, std::size_t immersion,
                         const QString& projectFile, QWidget* parent,
                         const std::vector<std::shared_ptr<const JobResult>>& judged)
    : QDialog(parent), outcome_(outcome),
      source_(printSource(outcome.result->project, projectFile)), shown_(immersion),
      preview_(new PicturePanel(tr("Page"), {})), printer_(new QComboBox), paper_(new QComboBox),
      orientation_(new QComboBox), proof_(new QComboBox), copies_(new NumberBox),
      tile_(new QCheckBox(tr("Tile the sheet if the paper is too small"))),
      grey_(new QCheckBox(tr("Print in grey on a monochrome printer"))),
      clipped_(new QCheckBox(tr("Clip what lies outside the printable area"))),
      otherPaper_(new QCheckBox(tr("The printer does not report this paper as loaded"))),
      notice_(new NoticeBar), verdict_(new QLabel), gamut_(new QLabel), progress_(new QProgressBar),
      print_(nullptr), save_(nullptr) {
    setWindowTitle(tr("Print sheets"));
    setObjectName(QStringLiteral("printDialog"));
    for (const ImmersionResult& result : outcome.result->immersions) {
        const std::size_t number = sheets_.size();
        sheets_.push_back(result.sheet);
        auto* box = new QCheckBox(result.immersion.name);
        box->setChecked(true); // by default the whole job is printed
        box->setToolTip(tr("Whether the sheet of this dip is printed."));
        connect(box, &QCheckBox::toggled, this, [this, number] {
            showSheet(number);
            judge();
        });
        immersions_.push_back(box);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    print_ = buttons->addButton(tr("Print"), QDialogButtonBox::ActionRole);
    print_->setDefault(true);
    save_ = buttons->addButton(tr("Save as file…"), QDialogButtonBox::ActionRole);
    save_->setToolTip(
        tr("Saves the shown sheet as PDF or TIFF, in the printer's scale and colours."));
    connect(print_, &QPushButton::clicked, this, &PrintDialog::print);
    connect(save_, &QPushButton::clicked, this, &PrintDialog::saveFile);
    connect(buttons, &QDialogButtonBox::rejected, this, [this] {
        if (printing_) {
            jobs_.cancelAll();
        } else {
            reject();
        }
    });
    auto* left = new QVBoxLayout;
    left->addWidget(notice_);
    left->addWidget(makeChoices(!judged.empty()));
    left->addWidget(makeExceptions());
    left->addWidget(verdict_, 1);
    left->addWidget(progress_);
    left->addWidget(buttons);
    auto* layout = new QHBoxLayout(this);
    layout->addLayout(left, 3);
    layout->addWidget(makePreview(), 3);
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
    connect(&jobs_, &JobRunner::idle, this, [this] {
        if (printing_) { // cancelled: neither done nor failed
            printing_ = false;
            setBusy(false,
                    tr("Cancelled. Pages that the printer has already begun may still come out."));
        }
    });
    resize(940, 660);
    showVerdicts(judged.empty() ? std::vector{outcome.result} : judged);
    showSheet(shown_);
    findPrinters();
}

void PrintDialog::warn(const QString& sentence) {
    notice_->say(notice_->isHidden() ? sentence : sentence + u'\n' + notice_->text());
}

void PrintDialog::showVerdicts(const std::vector<std::shared_ptr<const JobResult>>& judged) {
    QStringList lines;
    for (const auto& result : judged) {
        isKnownAsExpired_ |= isKnownAsExpired(*result);
        QStringList found = warningLines(*result, millimetres);
        if (found.size() > 1) {
            if (judged.size() > 1) {
                found.first() = QStringLiteral("%1: %2").arg(result->project.name, found.first());
            }
            lines += found;
        }
    }
    if (!lines.isEmpty()) {
        notice_->say(withUnitsKept(lines.join(u'\n')));
    }
}

QWidget* PrintDialog::makeChoices(bool isOfSeveralJobs) {
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    printer_->setAccessibleName(tr("Printer"));
    printer_->setToolTip(tr("The printers that are set up on this computer."));
    copies_->setDecimals(0);
    copies_->setRange(1, 99);
    copies_->setToolTip(tr("Number of copies of each sheet."));
    printer_->setPlaceholderText(tr("No printer set up"));
    form->addRow(tr("&Printer"), printer_);
    const Project& project = outcome_.result->project;
    const auto& profile = project.profiles.printer;
    auto* profileName = new QLabel(
        profile           ? profile->name
        : isOfSeveralJobs ? tr("None: true size and sRGB (choose a profile in the first project)")
                          : tr("None: true size and sRGB (choose a profile under Sheet)"));
    profileName->setWordWrap(true);
    form->addRow(tr("Profile"), profileName);
    const QLocale locale;
    auto* film = new QLabel(tr("%1 × %2 mm")
                                .arg(locale.toString(project.film.width.value(), 'g', 6),
                                     locale.toString(project.film.height.value(), 'g', 6)));
    if (project.profiles.film) {
        film->setText(project.profiles.film->name + QStringLiteral(", ") + film->text());
    }
    film->setWordWrap(true);
    form->addRow(tr("Film"), film);
    const SheetSettings& settings = sheets_.front().settings;
    paper_->setToolTip(tr("The paper that the sheet is printed on."));
    paper_->addItem(tr("The film itself"), QStringLiteral("film"));
    for (const QString& name :
         {QStringLiteral("A4"), QStringLiteral("A3"), QStringLiteral("Letter")}) {
        paper_->addItem(name, name);
    }
    paper_->addItem(isOfSeveralJobs ? tr("Custom, as set in the first project")
                                    : tr("Custom, as set under Sheet"),
                    QStringLiteral("custom"));
    paper_->setCurrentIndex(paper_->findData(settings.paper));
    orientation_->addItems({tr("Portrait"), tr("Landscape")});
    orientation_->setCurrentIndex(settings.landscape ? 1 : 0);
    form->addRow(tr("P&aper"), paper_);
    form->addRow(tr("&Orientation"), orientation_);
    form->addRow(tr("&Copies"), copies_);
    auto* sheets = new QVBoxLayout;
    for (QCheckBox* immersion : immersions_) {
        sheets->addWidget(immersion);
    }
    form->addRow(tr("Sheets"), sheets);
    connect(printer_, &QComboBox::currentIndexChanged, this, &PrintDialog::judge);
    connect(copies_, &NumberBox::valueChanged, this, &PrintDialog::judge);
    connect(paper_, &QComboBox::currentIndexChanged, this, &PrintDialog::choosePaper);
    connect(orientation_, &QComboBox::currentIndexChanged, this, &PrintDialog::choosePaper);
    return box;
}

QWidget* PrintDialog::makePreview() {
    preview_->view().setMinimumSize(320, 380);
    preview_->offerTrueSize();
    proof_->addItems({tr("As designed"), tr("As printed (soft proof)"),
                      tr("As printed, out-of-gamut colours in magenta")});
    const auto& profile = outcome_.result->project.profiles.printer;
    proof_->setEnabled(profile && !profile->iccProfile.isEmpty());
    proof_->setToolTip(proof_->isEnabled()
                           ? tr("How the page is shown here. The print does not change.")
                           : tr("A soft proof needs a printer profile with an ICC profile."));
    proof_->setObjectName(QStringLiteral("proof"));
    proof_->setAccessibleName(tr("Colours of the page"));
    gamut_->setWordWrap(true);
    connect(proof_, &QComboBox::currentIndexChanged, this, [this] { showSheet(shown_); });
    auto* box = new QWidget;
    auto* layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(preview_, 1);
    auto* plates = new QPushButton(tr("P&lates…"));
    plates->setObjectName(QStringLiteral("showPlates"));
    plates->setAutoDefault(false);
    const bool isTooLong = std::any_of(sheets_.begin(), sheets_.end(),
                                       [](const Sheet& sheet) { return sheet.rows != nullptr; });
    plates->setEnabled(proof_->isEnabled() && !isTooLong);
    plates->setToolTip(
        isTooLong ? tr("This film is too long to show its plates. Look at the "
                       "plates of the single jobs.")
                  : tr("Shows the plates of the sheets, the ink under the cursor, and where "
                       "there is too much ink. Needs a printer profile with an ICC profile in "
                       "CMYK."));
    connect(plates, &QPushButton::clicked, this, [this] {
        auto* dialog = new PlatesDialog(outcome_.result, shown_, LengthUnit::Millimetre, this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->open();
    });
    auto* below = new QHBoxLayout;
    below->addWidget(proof_, 1);
    below->addWidget(plates);
    layout->addLayout(below);
    layout->addWidget(gamut_);
    return box;
}

void PrintDialog::choosePaper() {
    for (Sheet& sheet : sheets_) {
        sheet.settings.paper = paper_->currentData().toString();
        sheet.settings.landscape = orientation_->currentIndex() == 1;
    }
    showSheet(shown_);
    judge();
}

void PrintDialog::showSheet(std::size_t number) {
    shown_ = number;
    const SheetSettings& settings = sheets_[number].settings;
    orientation_->setEnabled(settings.paper != QLatin1String("film") &&
                             settings.paper != QLatin1String("custom"));
    gamut_->clear();
    const int proofing = ++proofing_;
    try {
        const SheetPreview page = sheetPreview(sheets_[number]);
        preview_->setPicture(page.page, page.size);
        if (proof_->currentIndex() > 0) {
            startProof(sheets_[number], page, proofing);
        }
    } catch (const Error&) {
        preview_->clear(); // the verdict says why there is no page
    }
}

void PrintDialog::startProof(const Sheet& sheet, const SheetPreview& page, int proofing) {
    // Use the film image, not the page preview, whose colours are limited to the screen's.
    const double scale = page.page.width() / page.size.width();
    const QSize pixels = (page.film.size() * scale).toSize();
    jobs_.start(std::make_unique<ValueJob<PrintProof>>(
        tr("Computing the soft proof"),
        [sheet, pixels, profile = *outcome_.result->project.profiles.printer,
         marked = proof_->currentIndex() == 2](const Progress&) {
            const Sheet small = scaledSheet(sheet, pixels);
            const auto colour = printerColour(profile);
            PrintProof proof = printProof(small, printCorrection(profile, colour.get()), marked);
            Sheet proofed = small;
            proofed.image = proof.page;
            proof.page = sheetPreview(proofed).page;
            return proof;
        },
        [this, proofing, size = page.size](const PrintProof& proof) {
            if (proofing == proofing_) {
                preview_->setPicture(proof.page, size);
                gamut_->setText(tr("%1 % of the painted area is out of the printer's gamut.")
                                    .arg(numberText(100 * proof.outOfGamut, 1)));
            }
        },
        [this](std::exception_ptr failure) { showFailure(failure); }));
}

void PrintDialog::saveFile() {
    QFileDialog dialog(this, tr("Save sheet"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({QStringLiteral("PDF (*.pdf)"), QStringLiteral("TIFF (*.tiff *.tif)")});
    dialog.setDefaultSuffix(QStringLiteral("pdf"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
        dialog.setDefaultSuffix(filter.section(QLatin1Char(' '), 0, 0).toLower());
    });
    dialog.selectFile(QStringLiteral("%1 %2").arg(
        outcome_.result->project.name, outcome_.result->immersions[shown_].immersion.name));
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const QString path = dialog.selectedFiles().first();
    try {
        PrintFileRequest request;
        request.profile = outcome_.result->project.profiles.printer;
        request.acceptClipping = clipped_->isChecked();
        request.source = source_;
        const QStringList warnings = writePrintFile(sheets_[shown_], request, path, PrintHistory());
        const QString wrote = tr("Wrote %1").arg(QDir::toNativeSeparators(path));
        verdict_->setText((QStringList{wrote} + warnings).join(QStringLiteral("\n")));
    } catch (const Error& error) {
        verdict_->setText(error.sentence());
    }
}

QWidget* PrintDialog::makeExceptions() {
    auto* box = new QGroupBox(tr("Print anyway"));
    auto* layout = new QVBoxLayout(box);
    for (QCheckBox* exception : {tile_, grey_, clipped_, otherPaper_}) {
        exception->setToolTip(tr("If this is not ticked, the program refuses a print with this "
                                 "problem and shows the reason."));
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
        // With blocked signals the box does not select a printer by itself.
        printer_->setCurrentIndex(printers.isEmpty() ? -1 : 0);
        const auto& profile = outcome_.result->project.profiles.printer;
        for (const QString& wanted : {QSettings().value(QLatin1String(lastPrinterKey)).toString(),
                                      profile ? profile->queue : QString()}) {
            if (printers.contains(wanted)) {
                printer_->setCurrentText(wanted);
            }
        }
    }
    if (printers.isEmpty()) {
        verdict_->setText(tr("No printer is set up on this computer. Save the sheet as PDF and "
                             "print it elsewhere, at 100 %."));
        print_->setEnabled(false);
    } else {
        judge();
    }
}

PrintRequest PrintDialog::request() const {
    PrintRequest request;
    request.printer = printer_->currentText();
    request.copies = copies_->wholeValue();
    request.profile = outcome_.result->project.profiles.printer;
    request.tile = tile_->isChecked();
    request.acceptMonochrome = grey_->isChecked();
    request.acceptClipping = clipped_->isChecked();
    request.acceptOtherPaper = otherPaper_->isChecked();
    request.turning = turningOnRoll(outcome_.result->project);
    request.source = source_;
    return request;
}

std::vector<Sheet> PrintDialog::chosenSheets() const {
    std::vector<Sheet> sheets;
    for (std::size_t number = 0; number < immersions_.size(); ++number) {
        if (immersions_[number]->isChecked()) {
            sheets.push_back(sheets_[number]);
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
    setBusy(true, tr("Checking the printer …"));
    const int judgement = ++judgement_;
    jobs_.start(std::make_unique<ValueJob<Judgement>>(
        tr("Checking the printer"),
        [sheets, request = request(),
         expiry = isKnownAsExpired_
                      ? QString()
                      : expiryWarning(outcome_.result->project.profiles.film)](const Progress&) {
            const auto system = printSystem();
            Judgement found;
            if (!expiry.isEmpty()) {
                found.warnings.append(expiry);
            }
            for (const PrintPlan& plan : planPrints(*system, sheets, request)) {
                found.warnings.append(plan.warnings);
                found.pages += plan.task.pages;
            }
            found.warnings.removeDuplicates();
            return found;
        },
        [this, judgement](Judgement found) {
            if (judgement == judgement_) {
                setBusy(false, (found.warnings
                                << tr("Ready to print at true size. Pages: %1.").arg(found.pages))
                                   .join(QStringLiteral("\n\n")));
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
    jobs_.start(std::make_unique<ValueJob<PrintEnd>>(
        tr("Printing"),
        [sheets = chosenSheets(), request = request()](const Progress& progress) {
            const auto system = printSystem();
            return printPlans(*system, planPrints(*system, sheets, request), PrintHistory(),
                              progress);
        },
        [this](const PrintEnd& end) {
            printing_ = false;
            const QString done =
                end.state == JobState::Printed
                    ? tr("Printed on %1").arg(printer_->currentText())
                    : tr("Sent to the print queue of %1").arg(printer_->currentText());
            emit printed(
                end.historyFailure.isEmpty()
                    ? done
                    : QStringLiteral("%1. %2").arg(done, historyErrorText(end.historyFailure)));
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

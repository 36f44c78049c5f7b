#include "workbench/printing/CalibrationDialog.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "disk/AtomicFile.h"
#include "printing/Calibration.h"
#include "project/ProjectFile.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PictureView.h"
#include "workbench/widgets/ShippedNames.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>

namespace dipwright {

namespace {

constexpr double previewPixels = 6; // per millimetre

QImage picture(const CalibrationPage& page) {
    QImage image((page.paper * previewPixels).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(previewPixels, previewPixels);
    paintCalibrationPage(painter, page);
    return image;
}

QDoubleSpinBox* lengthBox(const QString& name) {
    auto* box = new NumberBox;
    box->setRange(1, 5000);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(CalibrationDialog::tr(" mm"));
    box->setAccessibleName(name);
    box->setToolTip(CalibrationDialog::tr("The measured length of the printed ruler, to 0.1 mm."));
    return box;
}

} // namespace

CalibrationDialog::CalibrationDialog(const ProfileLibrary& library, QWidget* parent)
    : QDialog(parent), library_(library), profile_(new QComboBox), printer_(new QComboBox),
      paper_(new QComboBox), measures_(new QRadioButton(tr("Measure (no correction)"))),
      verifies_(new QRadioButton(tr("Verify (corrected by the profile)"))),
      x_(lengthBox(tr("Horizontal ruler"))), y_(lengthBox(tr("Vertical ruler"))),
      xNominal_(new QLabel), yNominal_(new QLabel), scale_(new QLabel), message_(new QLabel),
      progress_(new QProgressBar), print_(new QPushButton(tr("&Print page"))),
      save_(new QPushButton(tr("Save as PDF…"))),
      take_(new QPushButton(tr("&Save scale to profile"))), preview_(new PictureView) {
    setWindowTitle(tr("Calibrate printer"));
    setObjectName(QStringLiteral("calibrationDialog"));
    preview_->setAccessibleName(tr("Page"));
    preview_->setMinimumSize(320, 420);
    message_->setWordWrap(true);
    message_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    message_->setMinimumHeight(60);
    message_->setObjectName(QStringLiteral("message"));
    progress_->setRange(0, 1000);
    progress_->hide();
    connect(&jobs_, &JobRunner::progressed, this, [this](double share, const QString& text) {
        progress_->setValue(int(share * 1000));
        if (printing_ && !text.isEmpty()) {
            tell(text);
        }
    });
    connect(&jobs_, &JobRunner::idle, this, [this] {
        if (printing_) { // cancelled: neither done nor failed
            setPrinting(false);
            tell(tr("Cancelled."));
        }
    });
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this,
            [this] { printing_ ? jobs_.cancelAll() : reject(); });
    auto* left = new QVBoxLayout;
    left->addWidget(makePageChoices());
    left->addWidget(makeMeasurements());
    left->addWidget(message_, 1);
    left->addWidget(progress_);
    left->addWidget(buttons);
    auto* layout = new QHBoxLayout(this);
    layout->addLayout(left, 3);
    layout->addWidget(preview_, 2);
    resize(900, 620);
    showPage();
    findPrinters();
}

QWidget* CalibrationDialog::makePageChoices() {
    for (const ProfileEntry& entry : library_.profiles(ProfileKind::Printer)) {
        profile_->addItem(shownName(entry.name), entry.name);
    }
    for (const QPageSize& paper : calibrationPapers()) {
        paper_->addItem(paper.key(), paper.size(QPageSize::Millimeter));
    }
    measures_->setChecked(true);
    auto* box = new QGroupBox(tr("1. Print the page"));
    auto* form = new QFormLayout(box);
    form->addRow(tr("P&rofile"), profile_);
    printer_->setPlaceholderText(tr("No printer set up"));
    form->addRow(tr("Pr&inter"), printer_);
    form->addRow(tr("P&aper"), paper_);
    form->addRow(tr("Page"), measures_);
    form->addRow(QString(), verifies_);
    auto* row = new QHBoxLayout;
    row->addWidget(print_);
    row->addWidget(save_);
    row->addStretch();
    form->addRow(QString(), row);
    profile_->setToolTip(
        tr("The profile that receives the scale. You can create profiles under “Profiles”."));
    printer_->setToolTip(tr("The printers that are set up on this computer."));
    paper_->setToolTip(tr("The paper in the printer."));
    measures_->setToolTip(tr("Prints rulers without correction, for measuring."));
    verifies_->setToolTip(tr("Prints the same rulers with the correction. Each ruler must now have "
                             "its nominal length."));
    connect(profile_, &QComboBox::currentIndexChanged, this, &CalibrationDialog::showPage);
    connect(paper_, &QComboBox::currentIndexChanged, this, &CalibrationDialog::showPage);
    connect(verifies_, &QRadioButton::toggled, this, &CalibrationDialog::showPage);
    connect(print_, &QPushButton::clicked, this, &CalibrationDialog::print);
    connect(save_, &QPushButton::clicked, this, &CalibrationDialog::saveFile);
    return box;
}

QWidget* CalibrationDialog::makeMeasurements() {
    auto* box = new QGroupBox(tr("2. Measure the rulers"));
    auto* form = new QFormLayout(box);
    const auto addRow = [&](const QString& text, QDoubleSpinBox* length, QLabel* nominal) {
        auto* label = new QLabel(text);
        label->setBuddy(length);
        auto* row = new QHBoxLayout;
        row->addWidget(length);
        row->addWidget(nominal, 1);
        form->addRow(label, row);
        connect(length, &QDoubleSpinBox::valueChanged, this, &CalibrationDialog::showScale);
    };
    addRow(tr("&Horizontal"), x_, xNominal_);
    addRow(tr("&Vertical"), y_, yNominal_);
    form->addRow(tr("Scale"), scale_);
    scale_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(take_);
    row->addStretch();
    form->addRow(QString(), row);
    connect(take_, &QPushButton::clicked, this, &CalibrationDialog::takeOver);
    for (QPushButton* button : {print_, save_, take_}) {
        button->setAutoDefault(false); // Return must only end the typing of a length
    }
    return box;
}

CalibrationPage CalibrationDialog::page() const {
    CalibrationPage result =
        calibrationPage(current_, paper_->currentData().toSizeF(), verifies_->isChecked());
    result.printer = shownName(current_.name);
    return result;
}

void CalibrationDialog::findPrinters() {
    print_->setEnabled(false);
    jobs_.start(std::make_unique<ValueJob<QStringList>>(
        tr("Looking for printers"), [](const Progress&) { return printSystem()->printers(); },
        [this](const QStringList& printers) {
            printer_->addItems(printers);
            chooseQueue();
            print_->setEnabled(!printers.isEmpty());
            if (printers.isEmpty()) {
                tell(tr("No printer is set up on this computer. Save the page as PDF and print it "
                        "elsewhere, at 100 %."));
            }
        },
        [this](std::exception_ptr failure) { showFailure(failure); }));
}

void CalibrationDialog::chooseQueue() {
    const int queue = printer_->findText(current_.queue);
    if (queue >= 0) {
        printer_->setCurrentIndex(queue);
    }
}

void CalibrationDialog::showPage() {
    try {
        current_ = std::get<PrinterProfile>(
            library_.profile(ProfileKind::Printer, profile_->currentData().toString()));
        chooseQueue();
        const CalibrationPage shownPage = page();
        const CalibrationLengths lengths = calibrationLengths(shownPage);
        preview_->setPicture(picture(shownPage), shownPage.paper);
        xNominal_->setText(tr("nominal length: %1 mm").arg(numberText(lengths.x.value(), 0)));
        yNominal_->setText(tr("nominal length: %1 mm").arg(numberText(lengths.y.value(), 0)));
        x_->setValue(lengths.x.value());
        y_->setValue(lengths.y.value());
        tell(tr(
            "Print the page. Measure both rulers from the first to the last line, to 0.1 mm. Type "
            "the lengths and save the scale. Then print the page again to verify the scale."));
        showScale();
    } catch (const Error&) {
        showFailure(std::current_exception());
    }
}

void CalibrationDialog::showScale() {
    try {
        const PrinterProfile result = dipwright::calibrated(
            current_, page(), Millimetres(x_->value()), Millimetres(y_->value()));
        scale_->setText(
            tr("X %1, Y %2").arg(numberText(result.scaleX, 5), numberText(result.scaleY, 5)));
        take_->setEnabled(true);
    } catch (const Error& error) {
        scale_->setText(error.message());
        take_->setEnabled(false);
    }
}

void CalibrationDialog::print() {
    PrintRequest request;
    request.printer = printer_->currentText();
    setPrinting(true);
    jobs_.start(std::make_unique<ValueJob<JobState>>(
        tr("Printing"),
        [page = page(), request](const Progress& progress) {
            const auto system = printSystem();
            const PrintPlan plan = planCalibration(*system, page, request);
            return printPlans(*system, {plan}, PrintHistory(), progress).state;
        },
        [this](JobState state) {
            setPrinting(false);
            tell(state == JobState::Printed
                     ? tr("Printed on %1. Let it dry, then measure.").arg(printer_->currentText())
                     : tr("Sent to the print queue of %1").arg(printer_->currentText()));
        },
        [this](std::exception_ptr failure) {
            setPrinting(false);
            showFailure(failure);
        }));
}

void CalibrationDialog::saveFile() {
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save page"), tr("calibration") + QStringLiteral(".pdf"), QStringLiteral("*.pdf"));
    if (path.isEmpty()) {
        return;
    }
    try {
        writeAtomically(path, [&](QIODevice& device) { writeCalibrationPdf(page(), device); });
        tell(tr("Wrote %1. Print it at 100 %, without “fit to page”.")
                 .arg(QDir::toNativeSeparators(path)));
    } catch (const Error&) {
        showFailure(std::current_exception());
    }
}

void CalibrationDialog::takeOver() {
    try {
        const PrinterProfile result = dipwright::calibrated(
            current_, page(), Millimetres(x_->value()), Millimetres(y_->value()));
        library_.save(result, Profile(current_));
        emit calibrated(result);
        if (verifies_->isChecked()) {
            showPage();
        } else {
            verifies_->setChecked(true);
        }
        tell(tr("%1 now has the scale X %2, Y %3. Print the page again to verify the scale.")
                 .arg(shownName(result.name), numberText(result.scaleX, 5),
                      numberText(result.scaleY, 5)));
    } catch (const ChangedFile&) {
        const std::exception_ptr failure = std::current_exception();
        showPage(); // another program may have changed the profile
        showFailure(failure);
    } catch (const Error&) {
        showFailure(std::current_exception());
    }
}

void CalibrationDialog::setPrinting(bool printing) {
    printing_ = printing;
    progress_->setVisible(printing);
    for (QWidget* widget : {static_cast<QWidget*>(print_), static_cast<QWidget*>(printer_),
                            static_cast<QWidget*>(profile_), static_cast<QWidget*>(paper_)}) {
        widget->setEnabled(!printing);
    }
}

void CalibrationDialog::tell(const QString& sentence) {
    message_->setText(sentence);
}

void CalibrationDialog::showFailure(std::exception_ptr failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const Error& error) {
        tell(error.sentence());
    } catch (const std::exception& error) {
        tell(QString::fromUtf8(error.what()));
    }
}

} // namespace dipwright

// Tests the dialogs for profiles, printing and calibration.
#include "Patience.h"
#include "project/Profiles.h"
#include "workbench/printing/CalibrationDialog.h"
#include "workbench/printing/PrintDialog.h"
#include "workbench/profiles/ProfilesDialog.h"

#include "base/Error.h"
#include "project/ProfileFields.h"
#include "workbench/profiles/ProfileSpecs.h"
#include "workbench/project/PropertyField.h"
#include "workbench/widgets/PictureView.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

using namespace dipwright;

namespace {

PrinterProfile printer(const ProfileLibrary& library, const QString& name) {
    return std::get<PrinterProfile>(library.profile(ProfileKind::Printer, name));
}

QPushButton* button(QDialog& dialog, const QString& text) {
    for (auto* candidate : dialog.findChildren<QPushButton*>()) {
        if (candidate->text().remove(QLatin1Char('&')) == text) {
            return candidate;
        }
    }
    return nullptr;
}

} // namespace

class PaperDialogTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    ProfileLibrary library_{folder_.filePath("profiles")};

private slots:
    void initTestCase() {
        PrinterProfile mine;
        mine.name = QStringLiteral("Mine");
        library_.replace(mine);
    }

    void profileSections_everyProfileValue_hasField() {
        for (const auto kind : {ProfileKind::Printer, ProfileKind::Film, ProfileKind::Tank}) {
            QStringList shown{QStringLiteral("icc_profile"),
                              QStringLiteral("device_link")}; // files
            for (const PropertySection& section : profileSections(kind)) {
                for (const PropertySpec& spec : section.specs) {
                    QVERIFY2(!spec.label.isEmpty() && !spec.help.isEmpty(), qPrintable(spec.path));
                    shown << spec.path;
                    const FieldRule rule = profileRule(kind, spec.path);
                    QVERIFY(rule.kind != FieldKind::Choice ||
                            QSet<QString>(spec.words.keyBegin(), spec.words.keyEnd()) ==
                                QSet<QString>(rule.choices.begin(), rule.choices.end()));
                }
            }
            for (const QString& path : profilePaths(kind)) {
                QVERIFY2(shown.contains(path), qPrintable(path));
            }
        }
    }

    void profilesDialog_closed_savesTypedValues() {
        ProfilesDialog dialog(library_, LengthUnit::Millimetre);
        dialog.choose(ProfileKind::Printer, "Mine");
        dialog.findChildren<QDoubleSpinBox*>("scale").at(0)->setValue(1.004);
        dialog.findChildren<QDoubleSpinBox*>("margins_mm").at(1)->setValue(4.5);
        QCOMPARE(printer(library_, "Mine").scaleX, 1.0); // not saved yet
        dialog.reject();
        QCOMPARE(printer(library_, "Mine").scaleX, 1.004);
        QCOMPARE(printer(library_, "Mine").margins[1].value(), 4.5);
    }

    void profilesDialog_longText_isShownInFull() {
        ProfilesDialog dialog(library_, LengthUnit::Millimetre);
        dialog.choose(ProfileKind::Printer, "Mine");
        auto* text = dialog.findChild<QLabel*>("device_link.content");
        text->setText("None, as in a language that needs many more words to say so");
        dialog.resize(dialog.minimumSizeHint().width(), 620);
        dialog.show();
        QTRY_VERIFY(text->width() > 0 && text->height() >= text->heightForWidth(text->width()));
        QVERIFY(!dialog.findChild<QScrollArea*>()->horizontalScrollBar()->isVisible());
    }

    void profilesDialog_severalFilesOfOneName_areMarked() {
        const QString twin = folder_.filePath("profiles/printer/twin.json");
        const auto mine = [this] {
            const ProfilesDialog dialog(library_, LengthUnit::Millimetre);
            const auto* list = dialog.findChild<QTreeWidget*>();
            return *list->findItems("Mine", Qt::MatchExactly | Qt::MatchRecursive).first();
        };
        QVERIFY(mine().icon(0).isNull());
        exportProfile(library_.profile(ProfileKind::Printer, "Mine"), twin);
        const QTreeWidgetItem marked = mine();
        QVERIFY(!marked.icon(0).isNull());
        QVERIFY2(marked.toolTip(0).contains("Several files"), qPrintable(marked.toolTip(0)));
        QVERIFY(QFile::remove(twin));
    }

    void profilesDialog_newName_renamesProfile() {
        ProfilesDialog dialog(library_, LengthUnit::Millimetre);
        dialog.choose(ProfileKind::Printer, "Mine");
        auto* name = dialog.findChild<QLineEdit*>("name");
        name->clear();
        QTest::keyClicks(name, "Ours");
        dialog.choose(ProfileKind::Film, "Ideal film, A4"); // leaves the profile
        QVERIFY(library_.contains(ProfileKind::Printer, "Ours"));
        QVERIFY(!library_.contains(ProfileKind::Printer, "Mine"));
        PrinterProfile back = printer(library_, "Ours");
        back.name = QStringLiteral("Mine");
        library_.replace(back);
        library_.remove(ProfileKind::Printer, "Ours");
    }

    void profilesDialog_takenName_isRefused() {
        const QString taken = library_.profiles(ProfileKind::Tank).front().name;
        const QString other = library_.profiles(ProfileKind::Tank).back().name;
        ProfilesDialog dialog(library_, LengthUnit::Millimetre);
        dialog.choose(ProfileKind::Tank, other);
        auto* name = dialog.findChild<QLineEdit*>("name");
        name->clear();
        QTest::keyClicks(name, taken);
        dialog.choose(ProfileKind::Printer, "Mine");
        QCOMPARE(kindOf(*dialog.chosen()), ProfileKind::Tank);
        QVERIFY(dialog.findChild<QLabel*>("message")->text().contains("already"));
        QVERIFY_EXCEPTION_THROWN(dialog.copyAs(taken), Error);
    }

    void profilesDialog_exportAndImport_keepsProfile() {
        const QString path = folder_.filePath("mine.json");
        ProfilesDialog dialog(library_, LengthUnit::Millimetre);
        dialog.choose(ProfileKind::Printer, "Mine");
        dialog.exportFile(path);
        dialog.copyAs("Copy of mine");
        QCOMPARE(nameOf(*dialog.chosen()), QString("Copy of mine"));
        library_.remove(ProfileKind::Printer, "Mine");
        dialog.importFile(path);
        QCOMPARE(nameOf(*dialog.chosen()), QString("Mine"));
        QCOMPARE(printer(library_, "Mine").scaleX, 1.004);
        QVERIFY_EXCEPTION_THROWN(dialog.setIccFile(path, &PrinterProfile::iccProfile), Error);
        QVERIFY(printer(library_, "Mine").iccProfile.isEmpty());
    }

    void printDialog_paperAndOrientation_changePage() {
        qputenv("CUPS_SERVER", "/nonexistent");
        Sheet sheet;
        sheet.settings.resolution = DotsPerInch(50);
        sheet.image = QImage(sheetPixels(sheet.filmWidth, sheet.filmHeight, DotsPerInch(50)),
                             QImage::Format_RGBA8888);
        sheet.image.fill(Qt::transparent);
        auto result = std::make_shared<JobResult>();
        result->immersions.resize(1);
        result->immersions[0].sheet = sheet;
        PrintDialog dialog({result, {}, {sheetPreview(sheet)}}, 0, {});
        const auto shape = [&] { // width over height of the shown page
            const QImage& page = dialog.findChild<PictureView*>()->picture();
            return double(page.width()) / page.height();
        };
        QVERIFY(std::abs(shape() - 210.0 / 297) < 0.01);
        const QList<QComboBox*> choices = dialog.findChildren<QComboBox*>();
        QComboBox* paper = nullptr;
        QComboBox* orientation = nullptr;
        for (QComboBox* box : choices) {
            paper = box->findData("Letter") >= 0 ? box : paper;
            orientation = box->findText("Landscape") >= 0 ? box : orientation;
        }
        QVERIFY(paper && orientation && !orientation->isEnabled());
        paper->setCurrentText("A3");
        QVERIFY(orientation->isEnabled());
        orientation->setCurrentText("Landscape");
        QVERIFY(std::abs(shape() - 420.0 / 297) < 0.01);
        // Without a printer, the dialog says what to do, and Print is disabled.
        const auto saysWhatToDo = [&] {
            for (const QLabel* label : dialog.findChildren<QLabel*>()) {
                if (label->text().contains("No printer is set up")) {
                    return true;
                }
            }
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(saysWhatToDo(), patience());
        QVERIFY(!button(dialog, "Print")->isEnabled());
        QVERIFY(button(dialog, "Save as file…")->isEnabled());
    }

    void calibrationDialog_measuredRulers_setScale() {
        CalibrationDialog dialog(library_);
        dialog.findChildren<QComboBox*>().at(0)->setCurrentText("Mine");
        QVERIFY(!dialog.page().verifies());
        const QList<QDoubleSpinBox*> lengths = dialog.findChildren<QDoubleSpinBox*>();
        QCOMPARE(lengths.at(0)->value(), 170.0);
        QCOMPARE(lengths.at(1)->value(), 220.0);
        QPushButton* take = button(dialog, "Save scale to profile");
        lengths.at(0)->setValue(250); // far off: the printer scales to the page
        QVERIFY(!take->isEnabled());
        lengths.at(0)->setValue(170 * 1.004);
        lengths.at(1)->setValue(220 * 0.997);
        QSignalSpy calibrated(&dialog, &CalibrationDialog::calibrated);
        take->click();
        QCOMPARE(calibrated.count(), 1);
        QVERIFY(std::abs(printer(library_, "Mine").scaleX - 1.004) < 1e-9);
        QVERIFY(std::abs(printer(library_, "Mine").scaleY - 0.997) < 1e-9);
        // Next comes the second page. Its remaining error multiplies the scale.
        QVERIFY(dialog.page().verifies());
        QCOMPARE(dialog.page().scaleX, printer(library_, "Mine").scaleX);
        lengths.at(0)->setValue(170.17);
        take->click();
        QVERIFY(std::abs(printer(library_, "Mine").scaleX - 1.004 * 1.001) < 1e-9);
    }
};

QTEST_MAIN(PaperDialogTest)
#include "PaperDialogTest.moc"

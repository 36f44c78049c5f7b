// Uses the print dialog like a user and measures what arrives at a software printer.
#include "workbench/printing/PrintDialog.h"
#include "Patience.h"

#include "ChessSheet.h"
#include "PaperMeasure.h"
#include "PrivateCups.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QtTest>

using namespace dipwright;

class PrintDialogTest : public QObject {
    Q_OBJECT

    PrivateCups cups_;
    QTemporaryDir history_;

    static DipOutcome twoSheets() {
        auto result = std::make_shared<JobResult>();
        DipOutcome outcome;
        for (const char* name : {"Top", "Below"}) {
            ImmersionResult immersion;
            immersion.immersion.name = QString::fromLatin1(name);
            immersion.sheet = chessSheet(immersion.immersion.name);
            outcome.sheets.push_back(sheetPreview(immersion.sheet));
            result->immersions.push_back(immersion);
        }
        outcome.result = result;
        return outcome;
    }
    template <typename Widget>
    static Widget* named(QDialog& dialog, const QString& text) {
        for (auto* candidate : dialog.findChildren<Widget*>()) {
            if (candidate->text().contains(text)) {
                return candidate;
            }
        }
        return nullptr;
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
        QVERIFY2(cups_.problem().isEmpty(), qPrintable(cups_.problem()));
        QVERIFY(cups_.add({"pigment"}));
        qputenv("DIPWRIGHT_PRINT_HISTORY", history_.path().toUtf8());
    }

    void printDialog_twoSheets_arriveInOrderAtTrueSize() {
        PrintDialog dialog(twoSheets(), 0, QStringLiteral("turtle.dipw"));
        QSignalSpy printed(&dialog, &PrintDialog::printed);
        QVERIFY(named<QCheckBox>(dialog, "Top")->isChecked());
        QVERIFY(named<QCheckBox>(dialog, "Below")->isChecked());
        QTRY_VERIFY_WITH_TIMEOUT(named<QLabel>(dialog, "Pages: 2"), patience());
        auto* print = named<QPushButton>(dialog, "Print");
        QVERIFY(print->isEnabled());
        print->click();
        QTRY_COMPARE_WITH_TIMEOUT(printed.count(), 1, patience());
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const std::vector<PrintRecord> kept = PrintHistory().records();
        QCOMPARE(kept.size(), std::size_t(2));
        QCOMPARE(kept[0].immersion, QStringLiteral("Below"));
        QCOMPARE(kept[0].fate, PrintOutcome::Printed);
        QCOMPARE(QFileInfo(kept[0].source.projectFile).fileName(), QStringLiteral("turtle.dipw"));
        const QStringList files = cups_.received("pigment");
        QCOMPARE(files.size(), 2);
        QVERIFY(pdfWords(files[0]).contains("Top"));
        QVERIFY(pdfWords(files[1]).contains("Below"));
        for (const QString& file : files) {
            QVERIFY(std::abs(pdfPage(file).width() - 210) < 0.1);
            for (const bool across : {true, false}) {
                const std::vector<double> sizes = squares(file, across);
                QVERIFY(sizes.size() >= 8);
                for (const double size : sizes) {
                    QVERIFY2(
                        std::abs(size - 17) <= 0.02,
                        qPrintable(
                            QStringLiteral("a square is %1 mm, expected 17 ± 0.02 mm").arg(size)));
                }
            }
        }
    }

    void printDialog_notesOfJobs_areShownAlsoForSeveralJobs() {
        const DipOutcome films = twoSheets();
        auto noted = std::make_shared<JobResult>(*films.result);
        noted->notes = QStringList{QStringLiteral("Logo is in CMYK and has no ICC profile")};
        PrintDialog packed(films, 0, {}, nullptr, {noted});
        QVERIFY(named<QLabel>(packed, noted->notes.front()));
        QVERIFY(named<QLabel>(packed, "choose a profile in the first project"));
        DipOutcome one = films;
        one.result = noted;
        PrintDialog single(one, 0, {});
        QVERIFY(named<QLabel>(single, noted->notes.front()));
        QVERIFY(named<QLabel>(single, "choose a profile under Sheet"));
    }
};

QTEST_MAIN(PrintDialogTest)
#include "PrintDialogTest.moc"

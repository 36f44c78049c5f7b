// Uses the window of the plates like a user.
#include "workbench/printing/PlatesDialog.h"
#include "Patience.h"
#include "TestProfiles.h"

#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PictureView.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QtTest>

using namespace dipwright;

class PlatesDialogTest : public QObject {
    Q_OBJECT

    // A film of 40 × 20 mm: left cyan, right black, which the printer limits to 220 %.
    static std::shared_ptr<JobResult> result(bool hasProfile) {
        auto made = std::make_shared<JobResult>();
        made->immersions.resize(1);
        Sheet& sheet = made->immersions[0].sheet;
        sheet.filmWidth = Millimetres(40);
        sheet.filmHeight = Millimetres(20);
        sheet.settings.resolution = DotsPerInch(127);
        sheet.image = QImage(200, 100, QImage::Format_RGBA8888);
        for (int x = 0; x < 200; ++x) {
            for (int y = 0; y < 100; ++y) {
                sheet.image.setPixelColor(x, y, x < 100 ? Qt::cyan : Qt::black);
            }
        }
        if (hasProfile) {
            PrinterProfile& printer = made->project.profiles.printer.emplace();
            printer.name = QStringLiteral("Press");
            printer.iccProfile = simpleCmykProfile(0.002);
            printer.totalInk = 2.2;
        }
        return made;
    }

    static QTableWidget& tableOf(PlatesDialog& dialog) {
        return *dialog.findChild<QTableWidget*>(QStringLiteral("plates"));
    }
    static PictureView& viewOf(PlatesDialog& dialog) { return *dialog.findChild<PictureView*>(); }
    static QColor shownAt(PlatesDialog& dialog, QPoint pixel) {
        const QImage& picture = viewOf(dialog).picture();
        return picture.isNull() ? QColor() : picture.pixelColor(pixel);
    }

private slots:
    void plates_ticked_arePrintedInThePicture() {
        PlatesDialog dialog(result(true), 0, LengthUnit::Millimetre);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(!viewOf(dialog).isEmpty(), patience());
        QTableWidget& table = tableOf(dialog);
        QCOMPARE(table.rowCount(), 6);                         // four inks, their sum, all plates
        QVERIFY(shownAt(dialog, {150, 50}).lightness() < 160); // 220 % of three inks
        table.item(0, 0)->setCheckState(Qt::Unchecked);
        QTRY_VERIFY_WITH_TIMEOUT(shownAt(dialog, {50, 50}).red() > 250, patience()); // no cyan
        table.setCurrentCell(0, 0);
        dialog.findChild<QComboBox*>(QStringLiteral("platesView"))->setCurrentIndex(1);
        QTRY_VERIFY_WITH_TIMEOUT(shownAt(dialog, {50, 50}).lightness() < 10, patience());
        table.setCurrentCell(1, 0); // there is no magenta on the left
        QTRY_VERIFY_WITH_TIMEOUT(shownAt(dialog, {50, 50}).lightness() > 245, patience());
    }

    void ink_underTheCursor_isReachedByKeys() {
        PlatesDialog dialog(result(true), 0, LengthUnit::Millimetre);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(!viewOf(dialog).isEmpty(), patience());
        QTableWidget& table = tableOf(dialog);
        emit viewOf(dialog).hovered({10, 10});
        QVERIFY(table.item(0, 1)->text().toInt() >= 98); // cyan
        QCOMPARE(table.item(3, 1)->text(), QStringLiteral("0"));
        QVERIFY(table.item(4, 1)->text().toInt() < 105);
        emit viewOf(dialog).hoverLeft();
        QCOMPARE(table.item(0, 1)->text(), QString());
        QTest::keyClick(&viewOf(dialog), Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(table.item(4, 1)->text().toInt() > 210); // from the middle into the black
    }

    void limit_belowTheInk_isMeasuredAndMarked() {
        PlatesDialog dialog(result(true), 0, LengthUnit::Millimetre);
        dialog.show();
        const auto figures = [&] {
            return dialog.findChild<QLabel*>(QStringLiteral("platesFigures"))->text();
        };
        QTRY_VERIFY_WITH_TIMEOUT(figures().contains(QStringLiteral("220 %: 0 mm²")), patience());
        dialog.findChild<QComboBox*>(QStringLiteral("platesView"))->setCurrentIndex(2);
        dialog.findChild<NumberBox*>(QStringLiteral("platesLimit"))->setValue(200);
        QTRY_VERIFY_WITH_TIMEOUT(figures().contains(QStringLiteral("400 mm², 50.00 %")),
                                 patience());
        QTRY_VERIFY_WITH_TIMEOUT(shownAt(dialog, {150, 50}).red() > 200 &&
                                     shownAt(dialog, {150, 50}).blue() < 100,
                                 patience());
        emit viewOf(dialog).hovered({30, 10});
        QVERIFY(tableOf(dialog).item(4, 1)->text().contains(QStringLiteral("> limit")));
    }

    void limit_changedBeforeThePlatesAreMade_isMeasured() {
        PlatesDialog dialog(result(true), 0, LengthUnit::Millimetre);
        dialog.findChild<NumberBox*>(QStringLiteral("platesLimit"))->setValue(200);
        dialog.show();
        QTRY_VERIFY_WITH_TIMEOUT(dialog.findChild<QLabel*>(QStringLiteral("platesFigures"))
                                     ->text()
                                     .contains(QStringLiteral("400 mm², 50.00 %")),
                                 patience());
    }

    void stop_thenAnotherView_startsAgain() {
        PlatesDialog dialog(result(true), 0, LengthUnit::Millimetre);
        dialog.show();
        dialog.findChild<QPushButton*>(QStringLiteral("platesStop"))->click();
        dialog.findChild<QComboBox*>(QStringLiteral("platesView"))->setCurrentIndex(2);
        QTRY_VERIFY_WITH_TIMEOUT(!viewOf(dialog).isEmpty(), patience());
    }

    void plates_withoutCmykProfile_saysWhatToDo() {
        PlatesDialog dialog(result(false), 0, LengthUnit::Millimetre);
        dialog.show();
        QVERIFY(viewOf(dialog).isEmpty());
        QVERIFY(!tableOf(dialog).isEnabled());
    }
};

QTEST_MAIN(PlatesDialogTest)
#include "PlatesDialogTest.moc"

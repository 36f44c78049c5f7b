// Tests what is said of sheets that leave the area that a printer reaches.
#include "printing/PrintReach.h"
#include "TestProfiles.h"
#include "base/Error.h"
#include "sheet/prepress/PrinterColour.h"

#include <QtTest>

using namespace dipwright;

class PrintReachTest : public QObject {
    Q_OBJECT

private slots:
    // Nothing but the cut contour lies in the margins: it runs along the edge of the film.
    void withinReach_cutContourInMargins_warnsOnce() {
        PrinterProfile printer;
        printer.iccProfile = simpleCmykProfile(0.002);
        const PrinterColour colour(printer, {});
        Sheet sheet;
        sheet.filmWidth = sheet.filmHeight = Millimetres(100);
        sheet.image = QImage(100, 100, QImage::Format_RGBA8888);
        sheet.image.fill(Qt::transparent);
        sheet.image.setPixelColor(50, 50, Qt::black);
        sheet.settings.paper = QStringLiteral("film");
        sheet.settings.cutLine = CutLine::Film;
        const auto warnings = [&](const QMarginsF& margins, const PrintCorrection& correction) {
            QStringList found;
            withinReach(sheet, margins, correction, false, {}, found);
            return found;
        };
        const PrintCorrection inks{.colour = &colour};
        QCOMPARE(warnings({}, inks), QStringList());
        QCOMPARE(warnings({2, 2, 2, 2}, {}), QStringList()); // without inks there is no contour
        const QStringList found = warnings({2, 2, 2, 2}, inks);
        QCOMPARE(found.size(), qsizetype(1));
        QVERIFY2(found[0].contains("outer 2 mm of the paper, and a part of the cut contour"),
                 qPrintable(found[0]));
        PrintCorrection enlarged = inks; // the printer prints too small
        enlarged.scaleX = enlarged.scaleY = 0.97;
        QVERIFY_EXCEPTION_THROWN(warnings({}, enlarged), Error);
    }

    // Traveller and cradle have their pins where the job's sheet has its marks.
    void withinReach_marksMove_isAWarning() {
        Sheet sheet;
        sheet.filmWidth = sheet.filmHeight = Millimetres(100);
        sheet.image = QImage(10, 10, QImage::Format_RGBA8888);
        sheet.image.fill(Qt::transparent);
        sheet.settings.paper = QStringLiteral("film");
        QStringList warnings;
        withinReach(sheet, {3, 3, 3, 3}, {}, false, {}, warnings);
        QCOMPARE(warnings, QStringList());
        const Sheet inside = withinReach(sheet, {0, 5, 0, 0}, {}, false, {}, warnings);
        QCOMPARE(inside.clearance, Millimetres(5));
        QCOMPARE(warnings.size(), qsizetype(1));
        QVERIFY2(warnings[0].contains("2.0 mm farther inside"), qPrintable(warnings[0]));
        // Marks on the paper round the film would come too near to the paper's edge.
        Sheet larger = sheet;
        larger.settings.paper = QStringLiteral("custom");
        larger.settings.customWidth = larger.settings.customHeight = Millimetres(130);
        withinReach(larger, {3, 3, 3, 3}, {}, false, {}, warnings);
        QCOMPARE(warnings.size(), qsizetype(1));
        withinReach(larger, {12, 12, 12, 12}, {}, false, {}, warnings);
        QCOMPARE(warnings.size(), qsizetype(2));
        QVERIFY2(warnings[1].contains("15.0 mm farther inside"), qPrintable(warnings[1]));
        sheet.clearance = Millimetres(5); // by the job's printer profile
        withinReach(sheet, {0, 5, 0, 0}, {}, false, {}, warnings);
        QCOMPARE(warnings.size(), qsizetype(2));
    }
};

QTEST_MAIN(PrintReachTest)
#include "PrintReachTest.moc"

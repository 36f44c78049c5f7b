// Tests the sheet by measuring the finished PDF and PNG with poppler's tools.
#include "PaperMeasure.h"

#include "sheet/page/SheetLayout.h"
#include "sheet/prepress/SheetFiles.h"

#include "base/Error.h"

#include <QBuffer>
#include <QColorSpace>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

using namespace dipwright;

namespace {

Sheet sheetOf(Millimetres width, Millimetres height) {
    Sheet sheet;
    sheet.filmWidth = width;
    sheet.filmHeight = height;
    sheet.image =
        QImage(sheetPixels(width, height, sheet.settings.resolution), QImage::Format_RGBA8888);
    sheet.image.fill(Qt::transparent);
    sheet.job = {QStringLiteral("Turtle"),           QStringLiteral("Top"),
                 QStringLiteral("2026-03-01"),       QStringLiteral("A4 210 × 297 mm"),
                 QStringLiteral("1:1, swell 1 × 1"), QStringLiteral("3fa9c2d1")};
    return sheet;
}

void fillMillimetres(Sheet& sheet, const QRectF& box, QColor colour) {
    QPainter painter(&sheet.image);
    painter.scale(sheet.image.width() / sheet.filmWidth.value(),
                  sheet.image.height() / sheet.filmHeight.value());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(box, colour);
}

// Returns a sheet with squares of 17 mm over the whole film; four squares meet in the film's
// middle.
Sheet chessSheet() {
    Sheet sheet = sheetOf(Millimetres(210), Millimetres(297));
    sheet.image.fill(Qt::white);
    for (int row = -9; row < 9; ++row) {
        for (int column = -7; column < 7; ++column) {
            if ((row + column) % 2 == 0) {
                fillMillimetres(sheet, QRectF(105 + 17 * column, 148.5 + 17 * row, 17, 17),
                                Qt::black);
            }
        }
    }
    return sheet;
}

// Returns a sheet with a patch in the middle of an otherwise unprinted film.
Sheet patchSheet(Millimetres width = Millimetres(210), Millimetres height = Millimetres(297)) {
    Sheet sheet = sheetOf(width, height);
    fillMillimetres(sheet, QRectF(width.value() / 2 - 30, height.value() / 2 - 30, 60, 60),
                    QColor(20, 90, 160));
    return sheet;
}

QByteArray pdfOf(const Sheet& sheet) {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeSheetPdf(sheet, buffer);
    return buffer.data();
}

} // namespace

class SheetTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString save(const QByteArray& bytes, const QString& name) {
        QFile file(folder_.filePath(name));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        file.write(bytes);
        return file.fileName();
    }

private slots:
    void sheetPixels_a4And300Dpi_are2480x3508();
    void sheetPixels_pastTheLimit_isRefused();
    void writeSheetPng_hasResolutionAndProfile();
    void writeSheetPdf_squares_measure17mm();
    void writeSheetPdf_image_isBitExact();
    void writeSheetPdf_ruler_measures100mm();
    void sheetLayout_marks_areInTheCorners();
    void writeSheetPdf_jobLine_canBeRead();
    void writeSheetPdf_letterWithoutGlyph_isPrintedAsItsCode();
    void writeSheetPdf_marksRulerAndJobLine_canBeSwitchedOff();
    void sheetLayout_rulerAndJobLine_avoidPaint();
    void sheetLayout_littleRoom_takesShorterRulerAndText();
    void sheetLayout_fullyPaintedSheet_putsRulerAndJobLineOnPaint();
    void writeSheetPdf_everyPaper_hasItsPageSize_data();
    void writeSheetPdf_everyPaper_hasItsPageSize();
    void sheetLayout_largerPaper_centresTheFilm();
    void writeSheetPdf_tooSmallPaper_isRefused();
    void pageSize_unknownPaper_isRefused();
    void writeSheetPdf_twice_givesTheSameBytes();
    void writeSheetPdf_asksViewersNotToScale();
    void writeSheetPdf_title_namesProjectAndDip();
    void writeSheet_unwritableDevice_throwsError();
};

void SheetTest::sheetPixels_a4And300Dpi_are2480x3508() {
    QCOMPARE(sheetPixels(Millimetres(210), Millimetres(297), DotsPerInch(300)), QSize(2480, 3508));
    QCOMPARE(sheetPixels(Millimetres(297), Millimetres(420), DotsPerInch(600)), QSize(7016, 9921));
}

void SheetTest::sheetPixels_pastTheLimit_isRefused() {
    QVERIFY_EXCEPTION_THROWN(sheetPixels(Millimetres(5000), Millimetres(297), DotsPerInch(1200)),
                             Error);
    QVERIFY_EXCEPTION_THROWN(sheetPixels(Millimetres(0), Millimetres(297), DotsPerInch(300)),
                             Error);
    QVERIFY_EXCEPTION_THROWN(sheetPixels(Millimetres(210), Millimetres(297), DotsPerInch(qQNaN())),
                             Error);
}

void SheetTest::writeSheetPng_hasResolutionAndProfile() {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    writeSheetPng(patchSheet(), buffer);
    QVERIFY(buffer.data().contains("iCCP"));
    const QImage image = QImage::fromData(buffer.data());
    QCOMPARE(image.size(), QSize(2480, 3508));
    QCOMPARE(image.dotsPerMeterX(), 11811);
    QCOMPARE(image.dotsPerMeterY(), 11811);
    QCOMPARE(image.colorSpace(), QColorSpace(QColorSpace::SRgb));
    QCOMPARE(image.pixelColor(0, 0), QColor(Qt::white));
    QCOMPARE(image.pixelColor(1240, 1754), QColor(20, 90, 160));
}

void SheetTest::writeSheetPdf_squares_measure17mm() {
    const QString path = save(pdfOf(chessSheet()), "chess.pdf");
    constexpr int dpi = 600;
    const double millimetre = dpi / millimetresPerInch;
    // Strips through the middle of a row and of a column of squares, away from the marks.
    const QImage row = renderedPage(path, dpi, QRectF(15, 157, 180, 1));
    const QImage column = renderedPage(path, dpi, QRectF(113.5, 15, 1, 267));
    for (const QImage& strip : {row, column.transformed(QTransform().rotate(90))}) {
        const std::vector<double> found = edges(strip, strip.height() / 2, 0);
        QVERIFY2(found.size() >= 11,
                 qPrintable(QStringLiteral("%1 edges, expected 11 or more").arg(found.size())));
        for (std::size_t i = 1; i < found.size(); ++i) {
            const double square = (found[i] - found[i - 1]) / millimetre;
            QVERIFY2(
                std::abs(square - 17) < 0.02,
                qPrintable(QStringLiteral("a square measures %1 mm, expected 17 mm").arg(square)));
        }
    }
}

void SheetTest::writeSheetPdf_image_isBitExact() {
    const Sheet sheet = patchSheet();
    const QString path = save(pdfOf(sheet), "patch.pdf");
    output("pdfimages", {"-png", path, folder_.filePath("image")});
    QImage image(folder_.filePath("image-000.png"));
    QVERIFY(!image.isNull());
    image.setColorSpace(
        QColorSpace::SRgb); // the PDF states the colour space only in the output intent
    QCOMPARE(image.convertToFormat(QImage::Format_RGB888), flattened(sheet.image));
    QVERIFY(!QFile::exists(folder_.filePath("image-001.png")));
}

void SheetTest::writeSheetPdf_ruler_measures100mm() {
    const Sheet sheet = patchSheet();
    const SheetLayout layout = sheetLayout(sheet);
    QVERIFY(layout.ruler);
    const QString path = save(pdfOf(sheet), "ruler.pdf");
    constexpr int dpi = 1200;
    const QRectF box = layout.ruler->box();
    const QImage strip = renderedPage(path, dpi, box);
    const double millimetre = dpi / millimetresPerInch;
    // Just above the base line, the middle of each dark run is the place of a tick.
    std::vector<double> ticks = darkMiddles(strip, true, strip.height() - int(0.6 * millimetre));
    for (double& tick : ticks) {
        tick /= millimetre;
    }
    QCOMPARE(ticks.size(), std::size_t(101));
    QVERIFY2(std::abs(ticks.back() - ticks.front() - 100) < 0.01,
             qPrintable(QStringLiteral("the ruler measures %1 mm, expected 100 mm")
                            .arg(ticks.back() - ticks.front())));
    QVERIFY(std::abs(ticks[50] - ticks[0] - 50) < 0.01);
    QVERIFY(output("pdftotext", {path, "-"}).contains("100 mm"));
}

void SheetTest::sheetLayout_marks_areInTheCorners() {
    const SheetLayout layout = sheetLayout(patchSheet());
    QCOMPARE(layout.marks.size(), std::size_t(4));
    QCOMPARE(layout.marks[0].centre, QPointF(6, 6));
    QCOMPARE(layout.marks[3].centre, QPointF(204, 291));
    const QString path = save(pdfOf(patchSheet()), "marks.pdf");
    constexpr int dpi = 600;
    for (const SheetMark& mark : layout.marks) {
        const QImage arm =
            renderedPage(path, dpi, QRectF(mark.centre - QPointF(1, 2.8), QSizeF(2, 0.6)));
        const std::vector<double> found = darkMiddles(arm, true, arm.height() / 2);
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(std::abs(found[0] / dpi * millimetresPerInch - 1) < 0.05);
    }
    for (const QRectF& edge : {QRectF(0, 0, 210, 2.7), QRectF(0, 297 - 2.7, 210, 2.7),
                               QRectF(0, 0, 2.7, 297), QRectF(210 - 2.7, 0, 2.7, 297)}) {
        const QImage strip = renderedPage(path, 150, edge);
        for (int y = 0; y < strip.height(); ++y) {
            QVERIFY(darkMiddles(strip, true, y).empty());
        }
    }
}

void SheetTest::writeSheetPdf_jobLine_canBeRead() {
    Sheet sheet = patchSheet();
    sheet.job.project = QStringLiteral("Zürich Straße\nNo. 5");
    const QString text = pdfWords(save(pdfOf(sheet), "job.pdf"));
    for (const QString& part : {QStringLiteral("Zürich Straße No. 5"), QStringLiteral("Top"),
                                QStringLiteral("2026-03-01"), QStringLiteral("A4 210 × 297 mm"),
                                QStringLiteral("1:1, swell 1 × 1"), QStringLiteral("3fa9c2d1")}) {
        QVERIFY2(text.contains(part), qPrintable(part + " in " + text));
    }
}

// U+0378 is not assigned to a letter, so no font has it.
void SheetTest::writeSheetPdf_letterWithoutGlyph_isPrintedAsItsCode() {
    Sheet sheet = patchSheet();
    sheet.job.project = QStringLiteral("Box \u0378");
    const QString text = pdfWords(save(pdfOf(sheet), "letters.pdf"));
    QVERIFY2(text.contains(QStringLiteral("Box \\u0378")), qPrintable(text));
}

void SheetTest::writeSheetPdf_marksRulerAndJobLine_canBeSwitchedOff() {
    Sheet sheet = patchSheet();
    sheet.settings.marks = sheet.settings.ruler = sheet.settings.jobLine = false;
    const QString path = save(pdfOf(sheet), "bare.pdf");
    QVERIFY(output("pdftotext", {path, "-"}).trimmed().isEmpty());
    const QImage page = renderedPage(path, 100);
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < page.width(); ++x) {
            QVERIFY(qGray(page.pixel(x, y)) > 250);
        }
    }
}

void SheetTest::sheetLayout_rulerAndJobLine_avoidPaint() {
    Sheet sheet = sheetOf(Millimetres(210), Millimetres(297));
    fillMillimetres(sheet, QRectF(0, 0, 210, 20), Qt::red);   // where the job line would be
    fillMillimetres(sheet, QRectF(0, 280, 120, 17), Qt::red); // where the ruler would be
    const SheetLayout layout = sheetLayout(sheet);
    QVERIFY(layout.jobLine && layout.ruler);
    QVERIFY(!layout.jobLine->overPaint);
    QVERIFY(!layout.ruler->overPaint);
    QVERIFY(!layout.jobLine->box().intersects(layout.ruler->box()));
}

// At the lower edge, there is room for 20 mm of the ruler; at the upper edge, for a short text.
void SheetTest::sheetLayout_littleRoom_takesShorterRulerAndText() {
    Sheet sheet = sheetOf(Millimetres(210), Millimetres(297));
    fillMillimetres(sheet, QRectF(0, 0, 75, 297), Qt::red);
    fillMillimetres(sheet, QRectF(135, 0, 75, 297), Qt::red);
    sheet.settings.marks = false;
    const SheetLayout layout = sheetLayout(sheet);
    QVERIFY(!layout.jobLine->overPaint && !layout.ruler->overPaint);
    QVERIFY(layout.ruler->size.width() < 100 && layout.jobLineText.size() == 1);
    QVERIFY(coveredPictureNote(sheet).isEmpty());
}

void SheetTest::sheetLayout_fullyPaintedSheet_putsRulerAndJobLineOnPaint() {
    Sheet sheet = chessSheet();
    fillMillimetres(sheet, QRectF(0, 0, 210, 297), Qt::darkGreen);
    QVERIFY(coveredPictureNote(sheet).contains(QStringLiteral("cover a part of the picture")));
    const SheetLayout layout = sheetLayout(sheet);
    QVERIFY(layout.jobLine && layout.ruler);
    QVERIFY(layout.jobLine->overPaint && layout.ruler->overPaint);
    const QByteArray text = output("pdftotext", {save(pdfOf(sheet), "full.pdf"), "-"});
    QVERIFY(text.contains("Turtle") && text.contains("100 mm"));
}

void SheetTest::writeSheetPdf_everyPaper_hasItsPageSize_data() {
    QTest::addColumn<QString>("paper");
    QTest::addColumn<bool>("landscape");
    QTest::addColumn<QSizeF>("film");
    QTest::addColumn<QSizeF>("page");
    QTest::newRow("film") << "film" << false << QSizeF(210, 297) << QSizeF(210, 297);
    QTest::newRow("film, wide") << "film" << false << QSizeF(297, 210) << QSizeF(297, 210);
    QTest::newRow("film of an odd size")
        << "film" << false << QSizeF(133.3, 88.8) << QSizeF(133.3, 88.8);
    QTest::newRow("A4") << "A4" << false << QSizeF(180, 250) << QSizeF(210, 297);
    QTest::newRow("A4 landscape") << "A4" << true << QSizeF(250, 180) << QSizeF(297, 210);
    QTest::newRow("A3") << "A3" << false << QSizeF(210, 297) << QSizeF(297, 420);
    QTest::newRow("A3 landscape") << "A3" << true << QSizeF(297, 210) << QSizeF(420, 297);
    QTest::newRow("Letter") << "Letter" << false << QSizeF(200, 270) << QSizeF(215.9, 279.4);
    QTest::newRow("custom") << "custom" << false << QSizeF(210, 297) << QSizeF(330, 483);
    QTest::newRow("small") << "film" << false << QSizeF(40, 40) << QSizeF(40, 40);
}

void SheetTest::writeSheetPdf_everyPaper_hasItsPageSize() {
    QFETCH(QString, paper);
    QFETCH(bool, landscape);
    QFETCH(QSizeF, film);
    QFETCH(QSizeF, page);
    Sheet sheet = sheetOf(Millimetres(film.width()), Millimetres(film.height()));
    fillMillimetres(sheet, QRectF(film.width() / 2 - 10, film.height() / 2 - 10, 20, 20),
                    Qt::darkGreen);
    sheet.settings.paper = paper;
    sheet.settings.landscape = landscape;
    sheet.settings.customWidth = Millimetres(330);
    sheet.settings.customHeight = Millimetres(483);
    const QSizeF measured = pdfPage(save(pdfOf(sheet), "paper.pdf"));
    QVERIFY2(std::abs(measured.width() - page.width()) < 0.01,
             qPrintable(QStringLiteral("the page is %1 mm wide, expected %2 mm")
                            .arg(measured.width())
                            .arg(page.width())));
    QVERIFY2(std::abs(measured.height() - page.height()) < 0.01,
             qPrintable(QStringLiteral("the page is %1 mm high, expected %2 mm")
                            .arg(measured.height())
                            .arg(page.height())));
    QVERIFY(sheetLayout(sheet).jobLine);
    QVERIFY(sheetLayout(sheet).jobLineText.join(u' ').contains("3fa9c2d1"));
    QCOMPARE(bool(sheetLayout(sheet).ruler), std::max(page.width(), page.height()) > 60);
}

void SheetTest::sheetLayout_largerPaper_centresTheFilm() {
    Sheet sheet = patchSheet();
    sheet.settings.paper = QStringLiteral("A3");
    const SheetLayout layout = sheetLayout(sheet);
    QCOMPARE(layout.film, QRectF(43.5, 61.5, 210, 297));
    for (const SheetMark& mark : layout.marks) {
        QVERIFY(!mark.box().intersects(layout.film));
    }
    QVERIFY(!layout.ruler->box().intersects(layout.film));
    QVERIFY(!layout.jobLine->box().intersects(layout.film));
}

void SheetTest::writeSheetPdf_tooSmallPaper_isRefused() {
    Sheet sheet = patchSheet();
    sheet.settings.paper = QStringLiteral("A4");
    sheet.settings.landscape = true;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    try {
        writeSheetPdf(sheet, buffer);
        QFAIL("a film of 297 mm was put on paper of 210 mm, expected a refusal");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains("smaller than the film"), qPrintable(error.sentence()));
        QVERIFY(error.sentence().contains("297"));
    }
    QVERIFY(buffer.data().isEmpty());
}

void SheetTest::pageSize_unknownPaper_isRefused() {
    Sheet sheet = patchSheet();
    sheet.settings.paper = QStringLiteral("B7");
    QVERIFY_EXCEPTION_THROWN(pageSize(sheet), Error);
}

void SheetTest::writeSheetPdf_twice_givesTheSameBytes() {
    const QByteArray first = pdfOf(patchSheet());
    QVERIFY(!first.contains("/CreationDate")); // the only value that depends on the time
    QCOMPARE(pdfOf(patchSheet()), first);
    Sheet other = patchSheet();
    other.job.immersion = QStringLiteral("Bottom");
    QVERIFY(pdfOf(other) != first);
}

void SheetTest::writeSheetPdf_asksViewersNotToScale() {
    const QString path = save(pdfOf(patchSheet()), "prefs.pdf");
    const QByteArray json = output("qpdf", {"--json", path});
    QVERIFY(json.contains("\"/PrintScaling\": \"/None\""));
    QVERIFY(json.contains("/OutputIntent"));
    QVERIFY(json.contains("\"/TrimBox\""));
    QVERIFY(json.contains("\"/Trapped\": \"/False\""));
    QVERIFY(!output("qpdf", {"--check", path}).isEmpty());
}

// Two dips give two documents, which the title distinguishes.
void SheetTest::writeSheetPdf_title_namesProjectAndDip() {
    Sheet sheet = patchSheet();
    sheet.job.project = QStringLiteral("Turtle");
    sheet.job.immersion = QStringLiteral("Top");
    const QByteArray info = output("pdfinfo", {save(pdfOf(sheet), "title.pdf")});
    QVERIFY2(info.contains("Turtle – Top"), info);
}

void SheetTest::writeSheet_unwritableDevice_throwsError() {
    QBuffer readOnly;
    readOnly.open(QIODevice::ReadOnly);
    QVERIFY_EXCEPTION_THROWN(writeSheetPdf(patchSheet(), readOnly), Error);
    QVERIFY_EXCEPTION_THROWN(writeSheetPng(patchSheet(), readOnly), Error);
}

QTEST_MAIN(SheetTest)
#include "SheetTest.moc"

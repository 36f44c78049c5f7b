// Prints sheets through a real print system to software printers and measures what arrives.
#include "ChessSheet.h"
#include "PaperMeasure.h"
#include "PrivateCups.h"
#include "TestProfiles.h"

#include "base/Error.h"
#include "printing/PrintService.h"

#include <QColorSpace>
#include <QElapsedTimer>
#include <QScopeGuard>
#include <QTcpServer>
#include <QTcpSocket>
#include <QThread>
#include <QtTest>
#include <cmath>

using namespace dipwright;

namespace {

void verifySquares(const QString& path, bool across, double size, double tolerance = 0.02) {
    const std::vector<double> found = squares(path, across);
    QVERIFY2(found.size() >= 8,
             qPrintable(QStringLiteral("found %1 squares, expected at least 8").arg(found.size())));
    for (const double one : found) {
        QVERIFY2(std::abs(one - size) <= tolerance,
                 qPrintable(QStringLiteral("a square is %1 mm, expected %2 ± %3 mm")
                                .arg(one)
                                .arg(size)
                                .arg(tolerance)));
    }
}

// A roll printer, 24 inches wide, that takes PDF.
QByteArray rollPpd() {
    return R"ppd(*PPD-Adobe: "4.3"
*FormatVersion: "4.3"
*FileVersion: "1.0"
*LanguageVersion: English
*LanguageEncoding: ISOLatin1
*PCFileName: "ROLL.PPD"
*Manufacturer: "Test"
*Product: "(Roll)"
*ModelName: "Roll"
*ShortNickName: "Roll"
*NickName: "Roll, for tests"
*PSVersion: "(3010.000) 0"
*ColorDevice: True
*DefaultColorSpace: RGB
*cupsFilter2: "application/vnd.cups-pdf application/pdf 0 -"
*VariablePaperSize: True
*MaxMediaWidth: "1729.13"
*MaxMediaHeight: "8503.94"
*HWMargins: 9 9 9 9
*NonUIOrderDependency: 100 AnySetup *CustomPageSize
*CustomPageSize True: "pop"
*ParamCustomPageSize Width: 1 points 283.46 1729.13
*ParamCustomPageSize Height: 2 points 141.73 8503.94
*ParamCustomPageSize WidthOffset: 3 points 0 0
*ParamCustomPageSize HeightOffset: 4 points 0 0
*ParamCustomPageSize Orientation: 5 int 0 3
*OpenUI *PageSize/Media Size: PickOne
*OrderDependency: 10 AnySetup *PageSize
*DefaultPageSize: A4
*PageSize A4/A4: "pop"
*CloseUI: *PageSize
*OpenUI *PageRegion/Media Size: PickOne
*OrderDependency: 10 AnySetup *PageRegion
*DefaultPageRegion: A4
*PageRegion A4/A4: "pop"
*CloseUI: *PageRegion
*DefaultImageableArea: A4
*ImageableArea A4: "9 9 586.28 832.89"
*DefaultPaperDimension: A4
*PaperDimension A4: "595.28 841.89"
)ppd";
}

QString refusal(PrintSystem& system, const Sheet& sheet, const PrintRequest& request) {
    try {
        planPrint(system, sheet, request);
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

PrintRequest to(const QString& printer) {
    PrintRequest request;
    request.printer = printer;
    return request;
}

} // namespace

class PrintTest : public QObject {
    Q_OBJECT

    std::unique_ptr<PrivateCups> cups_;
    std::unique_ptr<PrintSystem> system_;

    JobState print(const Sheet& sheet, const PrintRequest& request) {
        return followJob(*system_, system_->submit(planPrint(*system_, sheet, request).task), {});
    }
    int receivedBy(const QString& printer) const { return int(cups_->received(printer).size()); }

private slots:
    void initTestCase();
    void printersAreListed();
    void printer_capabilities_areRead();
    void print_twoSheets_arriveInOrderAtTrueSize();
    void print_image_arrivesWithoutLoss();
    void print_printerScale_isCompensated();
    void print_cmykSheet_arrivesAtTrueSize();
    void print_landscapeSheet_isTurnedOnPaper();
    void print_twoCopies_arrive();
    void print_paperNotDefault_isRequested();
    void print_queueDefaults_areOverridden();
    void planPrint_printerAlwaysScales_isRefused();
    void print_printerScalesByDefault_bypassesQueue();
    void planPrint_scaledSheetLargerThanPaper_isRefused();
    void print_printerPrintsTooSmall_marksStayOnPaper();
    void print_largeSheet_arrivesInTiles();
    void print_rollPrinter_getsItsOwnSize();
    void print_seriesOnRoll_isOnePageWithCutMarks();
    void print_passesOnRoll_areNoSeries();
    void print_packedFilm_isNeverTurnedOnRoll();
    void print_filmWithWebAcross_isTurnedOnRoll();
    void print_printerMargins_marksStayInside();
    void planPrint_unknownPrinter_isRefused();
    void planPrint_stoppedPrinter_isRefused();
    void planPrint_printerRejectsJobs_isRefused();
    void planPrint_otherPaperSize_isRefused();
    void planPrint_paperNotLoaded_isRefused();
    void planPrint_paperTooSmall_isRefused();
    void planPrint_colourInMargins_isRefused();
    void planPrint_greyPrinterForColour_isRefused();
    void planPrint_refused_printsNothing();
    void followJob_cancelled_isNotPrinted();
    void followJob_printerStopped_endsWithReason();
    void followJob_printerGoneMidJob_cancelsJob();
    void followJob_printerNotThere_cancelsJob_data();
    void followJob_printerNotThere_cancelsJob();
    void followJob_printingNotConfirmed_isNotPrinted();
    void print_socketDevice_receivesOnlyTheSheet();
    void qtPrintSystem_sheet_arrivesAtTrueSize();
};

void PrintTest::initTestCase() {
    cups_ = std::make_unique<PrivateCups>();
    QVERIFY2(cups_->problem().isEmpty(), qPrintable(cups_->problem()));
    const TestMedia a4{"iso_a4_210x297mm", 210, 297, 0};
    const TestMedia a4Margins{"iso_a4_210x297mm", 210, 297, 6.35};
    const TestMedia letter{"na_letter_8.5x11in", 215.9, 279.4, 6.35};
    QVERIFY(cups_->add({"pigment", true, {a4, a4Margins, letter}}));
    QVERIFY(cups_->add({"grey", false, {a4}}));
    TestMedia a3{"iso_a3_297x420mm", 297, 420, 6.35};
    a3.loaded = false;
    QVERIFY(cups_->add({"office", true, {a4Margins, a3}}));
    QVERIFY(cups_->add({"refusing", true, {letter}})); // the tests make it refuse jobs
    system_ = cupsPrintSystem();
    QVERIFY2(system_, "built without CUPS");
}

void PrintTest::printersAreListed() {
    QCOMPARE(system_->printers(), QStringList({"grey", "office", "pigment", "refusing"}));
    QVERIFY(!system_->printer("nosuch"));
}

void PrintTest::printer_capabilities_areRead() {
    const auto pigment = system_->printer("pigment");
    QVERIFY(pigment);
    QCOMPARE(pigment->state, PrinterState::Idle);
    QVERIFY(pigment->acceptsJobs);
    QVERIFY(pigment->printsColour);
    const auto isA4 = [](const PrinterMedia& media) {
        return std::abs(media.size.width() - 210) < 0.1 &&
               std::abs(media.size.height() - 297) < 0.1;
    };
    const auto borderless = [&](const PrinterMedia& media) {
        return isA4(media) && media.margins == QMarginsF(0, 0, 0, 0);
    };
    QVERIFY(std::any_of(pigment->media.begin(), pigment->media.end(), borderless));
    const auto office = system_->printer("office");
    QVERIFY(office);
    QVERIFY(std::none_of(office->media.begin(), office->media.end(), borderless));
    QVERIFY(std::any_of(office->media.begin(), office->media.end(), isA4));
    QVERIFY(!system_->printer("grey")->printsColour);
}

void PrintTest::print_twoSheets_arriveInOrderAtTrueSize() {
    const int before = receivedBy("pigment");
    for (const char* immersion : {"Top", "Bottom"}) {
        QCOMPARE(print(chessSheet(immersion), to("pigment")), JobState::Printed);
    }
    const QStringList papers = cups_->received("pigment").mid(before);
    QCOMPARE(papers.size(), 2);
    QVERIFY(pdfWords(papers[0]).contains("Top"));
    QVERIFY(pdfWords(papers[1]).contains("Bottom"));
    for (const QString& paper : papers) {
        const QSizeF page = pdfPage(paper);
        QVERIFY(std::abs(page.width() - 210) < 0.02 && std::abs(page.height() - 297) < 0.02);
        verifySquares(paper, true, 17);
        verifySquares(paper, false, 17);
        QVERIFY(pdfWords(paper).contains("100 mm"));
        // The registration mark's upper arm, 6 mm from the corner's edges.
        const QImage corner = renderedPage(paper, 600, QRectF(5, 3.2, 2, 0.6));
        QVERIFY(!darkMiddles(corner, true, corner.height() / 2).empty());
        QVERIFY(std::abs(darkMiddles(corner, true, corner.height() / 2)[0] / 600 * 25.4 - 1) < 0.1);
    }
}

void PrintTest::print_image_arrivesWithoutLoss() {
    const Sheet sheet = chessSheet("Top");
    QCOMPARE(print(sheet, to("pigment")), JobState::Printed);
    const QTemporaryDir folder;
    output("pdfimages", {"-png", cups_->received("pigment").last(), folder.filePath("image")});
    const QImage image(folder.filePath("image-000.png"));
    QCOMPARE(image.size(), sheet.image.size());
    QImage sent = flattened(sheet.image);
    sent.setColorSpace(QColorSpace());
    QCOMPARE(image.convertToFormat(QImage::Format_RGB888), sent);
}

void PrintTest::print_printerScale_isCompensated() {
    PrintRequest request = to("pigment");
    request.profile.emplace();
    request.profile->name = "Measured";
    request.profile->scaleX = 1.004;
    request.profile->scaleY = 0.997;
    QCOMPARE(print(chessSheet("Top"), request), JobState::Printed);
    // The received page is scaled by the inverse of the printer's scale.
    verifySquares(cups_->received("pigment").last(), true, 17 / 1.004);
    verifySquares(cups_->received("pigment").last(), false, 17 / 0.997);
}

// Measures the mean of a black square and the white square next to it. The pixels at their edges
// are only half inked, and are darker in CMYK than in RGB.
void PrintTest::print_cmykSheet_arrivesAtTrueSize() {
    PrintRequest request = to("pigment");
    request.profile.emplace();
    request.profile->name = "Press";
    request.profile->iccProfile = simpleCmykProfile(0.002);
    QCOMPARE(print(chessSheet("Top"), request), JobState::Printed);
    const QString paper = cups_->received("pigment").last();
    QVERIFY(output("pdfimages", {"-list", paper}).contains(" cmyk "));
    for (const bool across : {true, false}) {
        const std::vector<double> sizes = squares(paper, across);
        QVERIFY(sizes.size() >= 8);
        for (std::size_t i = 1; i < sizes.size(); ++i) {
            const double pitch = (sizes[i - 1] + sizes[i]) / 2;
            QVERIFY2(std::abs(pitch - 17) <= 0.02,
                     qPrintable(QStringLiteral("the squares' pitch is %1 mm, expected 17 ± 0.02 mm")
                                    .arg(pitch)));
        }
    }
}

void PrintTest::print_landscapeSheet_isTurnedOnPaper() {
    QCOMPARE(print(chessSheet("Top", {297, 210}), to("pigment")), JobState::Printed);
    const QString paper = cups_->received("pigment").last();
    QVERIFY(std::abs(pdfPage(paper).width() - 210) < 0.02);
    verifySquares(paper, true, 17);
    verifySquares(paper, false, 17);
}

void PrintTest::print_twoCopies_arrive() {
    const int before = receivedBy("pigment");
    PrintRequest request = to("pigment");
    request.copies = 2;
    QCOMPARE(print(chessSheet("Top"), request), JobState::Printed);
    int pages = 0;
    for (const QString& paper : cups_->received("pigment").mid(before)) {
        const QByteArray info = output("pdfinfo", {paper});
        pages += info.mid(info.indexOf("Pages:") + 6, 20).simplified().split(' ').first().toInt();
    }
    QCOMPARE(pages, 2);
}

// The queue's default paper is A4, so the job must request Letter, although Letter has margins.
void PrintTest::print_paperNotDefault_isRequested() {
    QCOMPARE(print(chessSheet("Top", {215.9, 279.4}), to("pigment")), JobState::Printed);
    const QString paper = cups_->received("pigment").last();
    QVERIFY(std::abs(pdfPage(paper).width() - 215.9) < 0.02);
    QVERIFY(std::abs(pdfPage(paper).height() - 279.4) < 0.02);
    verifySquares(paper, true, 17);
    verifySquares(paper, false, 17);
}

// A queue may be set up for duplex, two pages on one, mirroring or grey.
void PrintTest::print_queueDefaults_areOverridden() {
    const QStringList habits{"sides=two-sided-long-edge",
                             "number-up=2",
                             "mirror=true",
                             "fit-to-page=true",
                             "print-scaling=fill",
                             "orientation-requested=4",
                             "copies=2",
                             "print-color-mode=monochrome"};
    QStringList taken{"-p", "pigment"};
    QStringList given{"-p", "pigment"};
    for (const QString& habit : habits) {
        taken << "-o" << QString(habit).replace("=", "-default=");
        given << "-R" << habit.section('=', 0, 0) + "-default";
    }
    QVERIFY(cups_->command("lpadmin", taken));
    PrintRequest request = to("pigment");
    request.copies = 2;
    const Sheet sheet = chessSheet("Habits");
    const int before = receivedBy("pigment");
    QCOMPARE(print(sheet, request), JobState::Printed);
    QVERIFY(cups_->command("lpadmin", given));
    QCOMPARE(receivedBy("pigment"), before + 1);
    const QString path = cups_->received("pigment").last();
    QVERIFY(output("pdfinfo", {path}).contains("Pages:           2"));
    verifySquares(path, true, 17);
    verifySquares(path, false, 17);
    QCOMPARE(pdfWords(path).count("Habits"), 1);
    // The red square is to the right of the page's middle, so the page is not mirrored.
    const QImage middle = renderedPage(path, 100, QRectF(105 - 17, 148.5, 34, 17));
    const int red = qGray(middle.pixel(middle.width() * 3 / 4, middle.height() / 2));
    QVERIFY2(red > 40 && red < 150,
             qPrintable(
                 QStringLiteral("grey level of the red square: %1, expected 40 to 150").arg(red)));
    QVERIFY(qGray(middle.pixel(middle.width() / 4, middle.height() / 2)) > 250);
}

// The queue does not pass the scaling option on to the printer, and this printer does not support
// the option.
void PrintTest::planPrint_printerAlwaysScales_isRefused() {
    const TestMedia margins{"iso_a4_210x297mm", 210, 297, 6.35};
    QVERIFY(cups_->add({"fitting", true, {margins}, "fit", {}, false}));
    const QString sentence = refusal(*system_, chessSheet("Top"), to("fitting"));
    QVERIFY2(sentence.contains("\"fit\"") && sentence.contains("fitting"), qPrintable(sentence));
    CalibrationPage page;
    page.clearance = Millimetres(10);
    QVERIFY_EXCEPTION_THROWN(planCalibration(*system_, page, to("fitting")), Error);
    QVERIFY(cups_->received("fitting").isEmpty());
}

// The option reaches a printer to which the job is sent past its queue. The job is followed and
// cancelled at the printer.
void PrintTest::print_printerScalesByDefault_bypassesQueue() {
    const TestMedia margins{"iso_a4_210x297mm", 210, 297, 6.35};
    QVERIFY(cups_->add({"filling", true, {margins}, "fill"}));
    const PrintPlan plan = planPrint(*system_, chessSheet("Top"), to("filling"));
    QVERIFY2(plan.warnings.join(' ').contains("bypasses the queue"),
             qPrintable(plan.warnings.join(' ')));
    QCOMPARE(followJob(*system_, system_->submit(plan.task), {}), JobState::Printed);
    QCOMPARE(cups_->receivedAttribute("filling", "print-scaling"), QByteArray("none"));
    const QStringList papers = cups_->received("filling");
    QCOMPARE(papers.size(), 1);
    verifySquares(papers.back(), true, 17);
    verifySquares(papers.back(), false, 17);

    QVERIFY(cups_->add({"stuck", true, {margins}, "fit", "marker-supply-empty-error"}));
    const PrintJob job = system_->submit(planPrint(*system_, chessSheet("Top"), to("stuck")).task);
    QTRY_COMPARE_WITH_TIMEOUT(system_->status(job).state, JobState::Printing, 30000);
    QTRY_VERIFY_WITH_TIMEOUT(system_->printer("stuck")->stateReason.contains("marker supply empty"),
                             30000);
    Progress progress;
    progress.cancelToken.cancel();
    QVERIFY_EXCEPTION_THROWN(followJob(*system_, job, progress), std::exception);
    QTRY_COMPARE_WITH_TIMEOUT(system_->status(job).state, JobState::Cancelled, 60000);
}

// A printer that prints too small gets a larger page, which may exceed the paper.
void PrintTest::planPrint_scaledSheetLargerThanPaper_isRefused() {
    Sheet sheet = chessSheet("Top");
    sheet.image.fill(Qt::darkGreen);
    PrintRequest request = to("pigment");
    request.profile.emplace();
    QVERIFY(planPrint(*system_, sheet, request).warnings.isEmpty());
    request.profile->scaleX = request.profile->scaleY = 0.985;
    const QString sentence = refusal(*system_, sheet, request);
    QVERIFY2(sentence.contains("2.23 mm"), qPrintable(sentence)); // half of 1.5 % of 297 mm
    request.acceptClipping = true;
    const QStringList warnings = planPrint(*system_, sheet, request).warnings;
    QCOMPARE(warnings.size(), 2); // and the marks move
    QVERIFY2(warnings.filter("farther inside").size() == 1, qPrintable(warnings.join(u'\n')));
}

void PrintTest::print_printerPrintsTooSmall_marksStayOnPaper() {
    PrintRequest request = to("pigment");
    request.profile.emplace();
    // 4.5 mm of 297 mm are missing on each side.
    request.profile->scaleX = request.profile->scaleY = 0.97;
    QCOMPARE(print(chessSheet("Top"), request), JobState::Printed);
    const QString paper = cups_->received("pigment").last();
    QVERIFY(pdfWords(paper).contains("100 mm"));
    for (const QRectF& edge : {QRectF(0, 0, 210, 2.8), QRectF(0, 297 - 2.8, 210, 2.8)}) {
        const QImage strip = renderedPage(paper, 150, edge);
        for (int y = 0; y < strip.height(); ++y) {
            QVERIFY(darkMiddles(strip, true, y).empty());
        }
    }
}

void PrintTest::print_largeSheet_arrivesInTiles() {
    PrintRequest request = to("office");
    request.tile = true;
    const Sheet sheet = chessSheet("Top", {400, 560});
    QVERIFY(refusal(*system_, sheet, to("office")).contains("larger than every paper"));
    QCOMPARE(print(sheet, request), JobState::Printed);
    const QString paper = cups_->received("office").last();
    // Two of the nine tiles are blank.
    QVERIFY(output("pdfinfo", {paper}).contains("Pages:           7"));
    QVERIFY(pdfWords(paper, 4).contains("Row 2 of 3, column 1 of 3"));
    // A sheet that fits a paper of the printer is not tiled.
    QCOMPARE(planPrint(*system_, chessSheet("Top"), request).task.pages, 1);
}

// Roll printers report a range of sizes instead of papers.
void PrintTest::print_rollPrinter_getsItsOwnSize() {
    QVERIFY(cups_->addFileQueue("roll", rollPpd()));
    const auto roll = system_->printer("roll");
    QVERIFY(roll && roll->customMedia);
    QVERIFY(std::abs(roll->customMedia->most.width() - 610) < 0.5);
    QVERIFY(std::abs(roll->customMedia->most.height() - 3000) < 0.5);
    const auto count = [&](const PrinterMedia& media) {
        return std::count_if(roll->media.begin(), roll->media.end(),
                             [&](const PrinterMedia& other) {
                                 return other.name == media.name && other.margins == media.margins;
                             });
    };
    for (const PrinterMedia& media : roll->media) {
        QCOMPARE(count(media), 1);
    }
    QCOMPARE(print(chessSheet("Top", {420, 640}), to("roll")), JobState::HandedOver);
    const QString paper = cups_->filePrinted("roll");
    QVERIFY2(std::abs(pdfPage(paper).width() - 420) < 0.5, qPrintable(paper));
    QVERIFY(std::abs(pdfPage(paper).height() - 640) < 0.5);
    verifySquares(paper, true, 17);
    verifySquares(paper, false, 17);
    // A sheet that is wider than the roll is turned.
    QCOMPARE(planPrint(*system_, chessSheet("Top", {700, 500}), to("roll")).task.media.size,
             QSizeF(500, 700));
    const QString sentence = refusal(*system_, chessSheet("Top", {650, 700}), to("roll"));
    QVERIFY2(sentence.contains("any size from 100 × 50 mm to 610 × 3000 mm"), qPrintable(sentence));
}

// With a gap for rolls, all copies of both sheets go to the roll as one page.
void PrintTest::print_seriesOnRoll_isOnePageWithCutMarks() {
    QVERIFY(cups_->addFileQueue("series", rollPpd()));
    PrintRequest request = to("series");
    request.profile = PrinterProfile{};
    request.profile->rollGap = Millimetres(10);
    request.copies = 3;
    request.turning = Turning::Never;
    const std::vector<Sheet> sheets{chessSheet("Top"), chessSheet("Bottom")};
    const std::vector<PrintPlan> plans = planPrints(*system_, sheets, request);
    QCOMPARE(plans.size(), std::size_t(1));
    QCOMPARE(plans[0].task.pages, 1);
    QVERIFY(std::abs(plans[0].task.media.size.width() - 610) < 0.5);
    // Two sheets lie side by side, in three rows with gaps between them.
    const double length = plans[0].task.media.size.height();
    QVERIFY2(std::abs(length - (5 + 3 * 297 + 2 * 10 + 10)) < 2,
             qPrintable(QString::number(length)));
    QCOMPARE(followJob(*system_, system_->submit(plans[0].task), {}), JobState::HandedOver);
    const QString paper = cups_->filePrinted("series");
    QVERIFY(std::abs(pdfPage(paper).width() - 610) < 0.5);
    QVERIFY(std::abs(pdfPage(paper).height() - length) < 0.5);
    const QString words = pdfWords(paper);
    for (const char* copy : {"Top · copy 1 of 3", "Top · copy 3 of 3", "Bottom · copy 2 of 3"}) {
        QVERIFY2(words.contains(QString::fromUtf8(copy)), qPrintable(words));
    }
    // Longer series continue on a further page, because the printer's longest has 3000 mm.
    request.copies = 12;
    const std::vector<PrintPlan> more = planPrints(*system_, sheets, request);
    QCOMPARE(more.size(), std::size_t(2));
    QVERIFY(more[0].task.media.size.height() <= 3000.5);
    // A narrower roll takes one sheet beside the other no longer.
    request.copies = 1;
    request.profile->rollWidth = Millimetres(300);
    const std::vector<PrintPlan> narrow = planPrints(*system_, sheets, request);
    QCOMPARE(narrow.size(), std::size_t(1));
    QVERIFY(std::abs(narrow[0].task.media.size.width() - 300) < 0.5);
    QVERIFY(narrow[0].task.media.size.height() > 600);
    // A printer that prints too short gets a longer page, whose ends it still reaches.
    request.copies = 6;
    request.profile->rollWidth.reset();
    request.profile->scaleY = 0.99;
    QCOMPARE(planPrints(*system_, sheets, request).size(), std::size_t(1));
}

// The film of a sheet with several passes is fed again for each pass.
void PrintTest::print_passesOnRoll_areNoSeries() {
    PrintRequest request = to("roll");
    request.profile = PrinterProfile{};
    request.profile->rollGap = Millimetres(10);
    std::vector<Sheet> sheets{chessSheet("Top"), chessSheet("Bottom")};
    sheets[0].passes = sheets[1].passes = 2;
    const std::vector<PrintPlan> plans = planPrints(*system_, sheets, request);
    QCOMPARE(plans.size(), std::size_t(2));
    QVERIFY(plans[0].warnings.join(u' ').contains("2 times"));
}

// Packed films are laid out for the web of the roll, whatever the request says.
void PrintTest::print_packedFilm_isNeverTurnedOnRoll() {
    Sheet film = chessSheet("Top", {300, 420});
    film.pieces.emplace_back();
    PrintRequest request = to("roll");
    for (const Turning turning : {Turning::Allowed, Turning::Always}) {
        request.turning = turning;
        QCOMPARE(planPrint(*system_, film, request).task.media.size, QSizeF(300, 420));
    }
    film = chessSheet("Top", {700, 500});
    film.pieces.emplace_back();
    QVERIFY(!refusal(*system_, film, request).isEmpty());
}

// The web of a film that was computed for its long edge first runs across the sheet.
void PrintTest::print_filmWithWebAcross_isTurnedOnRoll() {
    PrintRequest request = to("roll");
    const Sheet sheet = chessSheet("Top", {300, 420});
    QCOMPARE(planPrint(*system_, sheet, request).task.media.size, QSizeF(300, 420));
    request.turning = Turning::Always;
    QCOMPARE(planPrint(*system_, sheet, request).task.media.size, QSizeF(420, 300));
    request.turning = Turning::Never;
    QVERIFY(!refusal(*system_, chessSheet("Top", {700, 500}), request).isEmpty());
}

void PrintTest::print_printerMargins_marksStayInside() {
    QCOMPARE(print(chessSheet("Top"), to("office")), JobState::Printed);
    const QString paper = cups_->received("office").last();
    for (const QRectF& edge : {QRectF(0, 0, 210, 6.2), QRectF(0, 297 - 6.2, 210, 6.2)}) {
        const QImage strip = renderedPage(paper, 150, edge);
        for (int y = 0; y < strip.height(); ++y) {
            QVERIFY(darkMiddles(strip, true, y).empty());
        }
    }
    QVERIFY(pdfWords(cups_->received("office").last()).contains("100 mm"));
}

void PrintTest::planPrint_unknownPrinter_isRefused() {
    const QString sentence = refusal(*system_, chessSheet("Top"), to("nosuch"));
    QVERIFY2(sentence.contains("no such printer") && sentence.contains("pigment"),
             qPrintable(sentence));
}

void PrintTest::planPrint_stoppedPrinter_isRefused() {
    QVERIFY(cups_->command("cupsdisable", {"-r", "out of ink", "refusing"}));
    const QString sentence = refusal(*system_, chessSheet("Top"), to("refusing"));
    QVERIFY2(sentence.contains("stopped") && sentence.contains("refusing"), qPrintable(sentence));
    QVERIFY(cups_->command("cupsenable", {"refusing"}));
}

void PrintTest::planPrint_printerRejectsJobs_isRefused() {
    QVERIFY(cups_->command("cupsreject", {"refusing"}));
    const QString sentence = refusal(*system_, chessSheet("Top"), to("refusing"));
    QVERIFY2(sentence.contains("does not accept jobs"), qPrintable(sentence));
    QVERIFY(cups_->command("cupsaccept", {"refusing"}));
}

void PrintTest::planPrint_otherPaperSize_isRefused() {
    // A sheet of 200 × 260 mm fits on Letter paper, but its position on the paper would be unknown.
    const QString sentence = refusal(*system_, chessSheet("Top", {200, 260}), to("refusing"));
    QVERIFY2(sentence.contains("no paper of 200 × 260 mm") && sentence.contains("215.9"),
             qPrintable(sentence));
}

void PrintTest::planPrint_paperNotLoaded_isRefused() {
    const Sheet sheet = chessSheet("Top", {297, 420});
    const QString sentence = refusal(*system_, sheet, to("office"));
    QVERIFY2(sentence.contains("no paper of 297 × 420 mm loaded"), qPrintable(sentence));
    PrintRequest request = to("office");
    request.acceptOtherPaper = true; // the user will load the paper
    const QStringList warnings = planPrint(*system_, sheet, request).warnings;
    QCOMPARE(warnings.size(), 2); // and the marks move
    QVERIFY2(warnings.filter("farther inside").size() == 1, qPrintable(warnings.join(u'\n')));
}

void PrintTest::planPrint_paperTooSmall_isRefused() {
    const QString sentence = refusal(*system_, chessSheet("Top"), to("refusing"));
    QVERIFY2(sentence.contains("larger than every paper"), qPrintable(sentence));
}

void PrintTest::planPrint_colourInMargins_isRefused() {
    Sheet sheet = chessSheet("Top");
    sheet.image.fill(Qt::darkGreen);
    const QString sentence = refusal(*system_, sheet, to("office"));
    QVERIFY2(sentence.contains("6.35 mm"), qPrintable(sentence));
    PrintRequest request = to("office");
    request.acceptClipping = true;
    const QStringList warnings = planPrint(*system_, sheet, request).warnings;
    QCOMPARE(warnings.size(), 2); // and the marks move
    QVERIFY2(warnings.filter("farther inside").size() == 1, qPrintable(warnings.join(u'\n')));
    QVERIFY(planPrint(*system_, sheet, to("pigment")).warnings.isEmpty());
}

void PrintTest::planPrint_greyPrinterForColour_isRefused() {
    const Sheet coloured = chessSheet("Top");
    const QString sentence = refusal(*system_, coloured, to("grey"));
    QVERIFY2(sentence.contains("grey only"), qPrintable(sentence));
    PrintRequest request = to("grey");
    request.acceptMonochrome = true;
    QCOMPARE(planPrint(*system_, coloured, request).warnings.size(), 1);
    Sheet black = coloured;
    black.image = coloured.image.convertToFormat(QImage::Format_Grayscale8);
    QVERIFY(planPrint(*system_, black, to("grey")).warnings.isEmpty());
}

void PrintTest::planPrint_refused_printsNothing() {
    QCOMPARE(receivedBy("refusing"), 0);
    QCOMPARE(receivedBy("grey"), 0);
}

void PrintTest::followJob_cancelled_isNotPrinted() {
    // "cupsdisable --hold" is not enough: CUPS still prints a job whose document arrives later.
    const auto queueHolds = [&](const QString& until) {
        return cups_->command("lpadmin",
                              {"-p", "pigment", "-o", "job-hold-until-default=" + until});
    };
    const PrintTask task = planPrint(*system_, chessSheet("Cancelled"), to("pigment")).task;
    const int before = receivedBy("pigment");
    const auto release = qScopeGuard([&] { queueHolds("no-hold"); });
    QVERIFY(queueHolds("indefinite"));
    const PrintJob job = system_->submit(task);
    QCOMPARE(system_->status(job).state, JobState::Held);
    Progress progress;
    progress.cancelToken.cancel();
    // A held job causes no error. The program waits until the user cancels the job.
    QVERIFY_EXCEPTION_THROWN(followJob(*system_, job, progress), std::exception);
    QCOMPARE(system_->status(job).state, JobState::Cancelled);
    QVERIFY(queueHolds("no-hold"));
    QCOMPARE(print(chessSheet("After"), to("pigment")), JobState::Printed);
    QCOMPARE(receivedBy("pigment"), before + 1);
    QVERIFY(pdfWords(cups_->received("pigment").last()).contains("After"));
}

void PrintTest::followJob_printerStopped_endsWithReason() {
    const PrintTask task = planPrint(*system_, chessSheet("Top"), to("office")).task;
    const int before = receivedBy("office");
    QVERIFY(cups_->command("cupsdisable", {"-r", "out of ink", "office"}));
    const PrintJob job = system_->submit(task);
    try {
        followJob(*system_, job, {});
        QFAIL("followJob() returned on a stopped printer, expected Error");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains("stopped"), qPrintable(error.sentence()));
    }
    QCOMPARE(system_->status(job).state, JobState::Cancelled);
    QVERIFY(cups_->command("cupsenable", {"office"}));
    QCOMPARE(receivedBy("office"), before);
}

void PrintTest::followJob_printerGoneMidJob_cancelsJob() {
    QVERIFY(cups_->add({"fading",
                        true,
                        {{"iso_a4_210x297mm", 210, 297, 0}},
                        "none",
                        "marker-supply-empty-error"}));
    const PrintJob job = system_->submit(planPrint(*system_, chessSheet("Top"), to("fading")).task);
    Progress progress;
    QString printerMessage;
    progress.report = [&](double, const QString& text) {
        if (printerMessage.isEmpty() && text.contains("marker supply empty")) {
            printerMessage = text;
            cups_->switchOff("fading");
        }
    };
    try {
        followJob(*system_, job, progress, std::chrono::milliseconds(500));
        QFAIL("followJob() returned with the printer gone, expected Error");
    } catch (const Error& error) {
        QVERIFY2(error.sentence().contains("does not answer"), qPrintable(error.sentence()));
    }
    QVERIFY(printerMessage.contains("Printing: "));
    QCOMPARE(system_->status(job).state, JobState::Cancelled);
}

// Each of these backends or queues would retry for days.
void PrintTest::followJob_printerNotThere_cancelsJob_data() {
    QTest::addColumn<QString>("device");
    QTest::addColumn<QString>("policy");
    QTest::newRow("backend that tries again") << "socket://localhost:%1"
                                              << "stop-printer";
    QTest::newRow("backend around a backend") << "beh:/1/0/1/socket://localhost:%1/?contimeout=1"
                                              << "stop-printer";
    QTest::newRow("queue that tries again") << "socket://localhost:%1/?contimeout=1"
                                            << "retry-job";
}

void PrintTest::followJob_printerNotThere_cancelsJob() {
    QFETCH(QString, device);
    QFETCH(QString, policy);
    const auto remove = qScopeGuard([&] { cups_->command("lpadmin", {"-x", "dead"}); });
    QVERIFY(cups_->addQueue("dead", device.arg(PrivateCups::freePort()), "pigment"));
    QVERIFY(cups_->command("lpadmin", {"-p", "dead", "-o", "printer-error-policy=" + policy}));
    const PrintJob job = system_->submit(planPrint(*system_, chessSheet("Top"), to("dead")).task);
    QElapsedTimer clock;
    clock.start();
    Progress progress; // cancels after 20 s
    progress.report = [&](double, const QString&) {
        if (clock.hasExpired(20'000)) {
            progress.cancelToken.cancel();
        }
    };
    try {
        followJob(*system_, job, progress, std::chrono::milliseconds(500));
        QFAIL("followJob() returned without a printer, expected NotPrinted");
    } catch (const NotPrinted& end) {
        QCOMPARE(end.fate(), PrintOutcome::Stopped);
        QVERIFY2(end.sentence().contains("does not answer") &&
                     end.sentence().contains("the job was cancelled"),
                 qPrintable(end.sentence()));
    } catch (const Cancelled&) {
        QFAIL("followJob() waited longer than 20 s, expected NotPrinted");
    }
    QCOMPARE(system_->status(job).state, JobState::Cancelled);
}

// For such a queue, "completed" only means that the job was sent, and with some backends not even
// that.
void PrintTest::followJob_printingNotConfirmed_isNotPrinted() {
    const auto remove = qScopeGuard([&] {
        cups_->command("lpadmin", {"-x", "nothing"});
        cups_->command("lpadmin", {"-x", "dropping"});
    });
    QVERIFY(cups_->addQueue("nothing", "file:/dev/null", "pigment"));
    QCOMPARE(print(chessSheet("Top"), to("nothing")), JobState::HandedOver);
    const QString once = "beh:/1/1/1/socket://localhost:%1/?contimeout=1";
    QVERIFY(cups_->addQueue("dropping", once.arg(PrivateCups::freePort()), "pigment"));
    try {
        print(chessSheet("Top"), to("dropping"));
        QFAIL("print() returned without a printer, expected NotPrinted");
    } catch (const NotPrinted& end) {
        QCOMPARE(end.fate(), PrintOutcome::Unknown);
        QVERIFY2(end.sentence().contains("does not answer"), qPrintable(end.sentence()));
    }
}

// A device that does not speak IPP would print an IPP request.
void PrintTest::print_socketDevice_receivesOnlyTheSheet() {
    QTcpServer device;
    QVERIFY(device.listen(QHostAddress::LocalHost));
    QByteArrayList received;
    connect(&device, &QTcpServer::newConnection, this, [&] {
        QTcpSocket* const socket = device.nextPendingConnection();
        const qsizetype number = received.size();
        received << QByteArray();
        connect(socket, &QTcpSocket::readyRead, &device,
                [&received, socket, number] { received[number] += socket->readAll(); });
    });
    const auto remove = qScopeGuard([&] { cups_->command("lpadmin", {"-x", "plain"}); });
    const QString uri = QStringLiteral("socket://localhost:%1").arg(device.serverPort());
    QVERIFY(cups_->addQueue("plain", uri, "pigment"));
    // This thread acts as the device, so the print system works on another thread.
    JobState end = JobState::Waiting;
    const std::unique_ptr<QThread> printing(QThread::create([&] {
        const auto system = cupsPrintSystem();
        end = followJob(
            *system, system->submit(planPrint(*system, chessSheet("Top"), to("plain")).task), {});
    }));
    printing->start();
    QTRY_VERIFY_WITH_TIMEOUT(printing->isFinished(), 30000);
    QCOMPARE(end, JobState::HandedOver);
    received.removeAll(QByteArray()); // an empty connection only checks whether the device answers
    QCOMPARE(received.size(), 1);
    QVERIFY2(!received[0].startsWith("POST"), received[0].left(100).constData());
}

void PrintTest::qtPrintSystem_sheet_arrivesAtTrueSize() {
    const auto portable = qtPrintSystem();
    QVERIFY2(portable, "built without Qt's printing");
    QVERIFY(portable->printers().contains("pigment"));
    QVERIFY(!portable->printer("nosuch"));
    QVERIFY(refusal(*portable, chessSheet("Top"), to("nosuch")).contains("no such printer"));
    const int before = receivedBy("pigment");
    const PrintPlan plan = planPrint(*portable, chessSheet("Portable"), to("pigment"));
    QCOMPARE(followJob(*portable, portable->submit(plan.task), {}), JobState::HandedOver);
    QTRY_COMPARE_WITH_TIMEOUT(receivedBy("pigment"), before + 1, 30000);
    // The PDF is complete only when pdfinfo can read it.
    const QString paper = cups_->received("pigment").last();
    QTRY_VERIFY_WITH_TIMEOUT(!output("pdfinfo", {paper}).isEmpty(), 30000);
    verifySquares(paper, true, 17);
    verifySquares(paper, false, 17);
}

QTEST_MAIN(PrintTest)
#include "PrintTest.moc"

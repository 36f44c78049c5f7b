// Tests the print history with simulated printers. Every print must be found by the job number on
// its sheet, whatever its outcome.
#include "printing/PrintHistory.h"

#include "ChessSheet.h"
#include "PaperMeasure.h"
#include "TestProfiles.h"

#include "base/Error.h"
#include "printing/PrintFile.h"
#include "printing/PrintService.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

// A simulated printer with A4 paper. The test sets how its jobs end.
class ScriptedPrinter : public PrintSystem {
public:
    JobStatus end{JobState::Printed, {}};
    bool isGone = false; // the printer stops answering after submit()
    bool reportsPrinted = true;

    QStringList printers() override { return {QStringLiteral("pigment")}; }
    std::optional<PrinterInfo> printer(const QString& name) override {
        PrinterInfo info;
        info.name = name;
        info.reportsPrinted = reportsPrinted;
        info.media = {{QStringLiteral("iso_a4_210x297mm"), QSizeF(210, 297), {}, true}};
        return info;
    }
    PrintJob submit(const PrintTask& task) override { return {task.printer, 1}; }
    JobStatus status(const PrintJob& job) override {
        if (isGone) {
            throw Error(QStringLiteral("no answer"), job.printer);
        }
        return end;
    }
    void cancel(const PrintJob&) override {}
};

PrintRequest request() {
    PrintRequest request;
    request.printer = QStringLiteral("pigment");
    request.copies = 2;
    request.source = {QStringLiteral("/jobs/turtle.dipw"), QStringLiteral("Blue film, lot 7")};
    return request;
}

} // namespace

class PrintHistoryTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    ScriptedPrinter printer_;

    PrintHistory history() const {
        return PrintHistory(folder_->filePath(QStringLiteral("prints")));
    }
    PrintEnd print(const QStringList& immersions, const PrintHistory& history,
                   const Progress& progress = {}) {
        std::vector<Sheet> sheets;
        for (const QString& name : immersions) {
            sheets.push_back(chessSheet(name));
        }
        return printPlans(printer_, planPrints(printer_, sheets, request()), history, progress);
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        printer_ = {};
    }

    void printHistory_twoSheets_areRecorded() {
        QVERIFY(history().records().empty());
        const QDateTime before = QDateTime::currentDateTime().addMSecs(-1);
        print({QStringLiteral("Top"), QStringLiteral("Below")}, history());
        const std::vector<PrintRecord> records = history().records();
        QCOMPARE(records.size(), std::size_t(2));
        QCOMPARE(records[0].immersion, QStringLiteral("Below")); // the newest first
        const PrintRecord& top = records[1];
        QCOMPARE(top.immersion, QStringLiteral("Top"));
        QCOMPARE(top.job, QStringLiteral("3fa9c2d1"));
        QCOMPARE(top.project, QStringLiteral("Turtle"));
        QCOMPARE(top.printer, QStringLiteral("pigment"));
        QCOMPARE(top.mediumName, QStringLiteral("iso_a4_210x297mm"));
        QCOMPARE(top.mediumSize, QSizeF(210, 297));
        QCOMPARE(top.copies, 2);
        QCOMPARE(top.source.projectFile, QStringLiteral("/jobs/turtle.dipw"));
        QCOMPARE(top.source.film, QStringLiteral("Blue film, lot 7"));
        QVERIFY(top.when >= before && top.when <= QDateTime::currentDateTime());
        QCOMPARE(top.fate, PrintOutcome::Printed);
    }

    void printHistory_failedJob_keepsReason() {
        printer_.end = {JobState::Failed, QStringLiteral("out of paper")};
        QVERIFY_EXCEPTION_THROWN(print({QStringLiteral("Top"), QStringLiteral("Below")}, history()),
                                 Error);
        const std::vector<PrintRecord> records = history().records();
        QCOMPARE(records.size(), std::size_t(1)); // the second sheet was never sent
        QCOMPARE(records[0].fate, PrintOutcome::Failed);
        QVERIFY2(outcomeText(records[0]).contains(QStringLiteral("out of paper")),
                 qPrintable(outcomeText(records[0])));
    }

    // The printer stops, or the print system stops answering. The sheet may have been printed
    // anyway.
    void printHistory_printerStoppedOrGone_isNotFailed() {
        printer_.end = {JobState::Stopped, QStringLiteral("cover open")};
        QVERIFY_EXCEPTION_THROWN(print({QStringLiteral("Top")}, history()), Error);
        QCOMPARE(history().records()[0].fate, PrintOutcome::Stopped);
        QVERIFY(outcomeText(history().records()[0]).contains(QStringLiteral("cover open")));
        printer_.isGone = true;
        QVERIFY_EXCEPTION_THROWN(print({QStringLiteral("Below")}, history()), Error);
        QCOMPARE(history().records()[0].fate, PrintOutcome::Unknown);
        QVERIFY(outcomeText(history().records()[0]).contains(QStringLiteral("no answer")));
    }

    void printHistory_printingNotConfirmed_isHandedOver() {
        printer_.reportsPrinted = false;
        QCOMPARE(print({QStringLiteral("Top")}, history()).state, JobState::HandedOver);
        QCOMPARE(history().records()[0].fate, PrintOutcome::HandedOver);
    }

    void printHistory_cancelledJob_isCancelled() {
        printer_.end = {JobState::Held, {}};
        Progress progress;
        progress.report = [&](double, const QString&) {
            QCOMPARE(history().records()[0].fate,
                     PrintOutcome::Sent); // the job is recorded before it ends
            progress.cancelToken.cancel();
        };
        QVERIFY_EXCEPTION_THROWN(print({QStringLiteral("Top")}, history(), progress), Cancelled);
        QCOMPARE(history().records().size(), std::size_t(1));
        QCOMPARE(history().records()[0].fate, PrintOutcome::Cancelled);
    }

    void printHistory_sheetWrittenToFile_isRecorded() {
        const QString path = folder_->filePath(QStringLiteral("sheet.pdf"));
        PrintFileRequest file;
        file.tilePaper = QSizeF(120, 160);
        writePrintFile(chessSheet(QStringLiteral("Top")), file, path, history());
        const std::vector<PrintRecord> records = history().records();
        QCOMPARE(records.size(), std::size_t(1));
        QCOMPARE(records[0].file, path);
        QCOMPARE(records[0].mediumSize, QSizeF(120, 160));
        QCOMPARE(records[0].fate, PrintOutcome::WrittenToFile);
    }

    // With different profiles, one job gives different sheets, so each sheet has its own job
    // number.
    void jobNumber_differentPlates_differs() {
        PrinterProfile inks;
        inks.name = QStringLiteral("Pigment");
        inks.iccProfile = simpleCmykProfile(0.002);
        std::vector<PrinterProfile> profiles(7, inks);
        profiles[1].intent = RenderingIntent::Perceptual;
        profiles[2].iccProfile = simpleCmykProfile(0.01);
        profiles[3].totalInk = 2.4;
        profiles[4].blackPoint = false;
        profiles[5].scaleX = 1.01;
        profiles[6].keptInks = KeptInks::Black;
        const QString path = folder_->filePath(QStringLiteral("sheet.pdf"));
        QStringList jobs;
        for (const PrinterProfile& profile : profiles) {
            PrintFileRequest file;
            file.profile = profile;
            writePrintFile(chessSheet(QStringLiteral("Top")), file, path, history());
            jobs << history().records()[0].job;
            QVERIFY2(jobs.back().startsWith(QStringLiteral("3fa9c2d1-")), qPrintable(jobs.back()));
        }
        PrintRequest toPrinter = request();
        toPrinter.profile = profiles[3];
        QCOMPARE(planPrint(printer_, chessSheet(QStringLiteral("Top")), toPrinter).record->job,
                 jobs[3]);
        jobs.removeDuplicates();
        QCOMPARE(jobs.size(), qsizetype(profiles.size()));
        // This profile does not change what is printed.
        PrinterProfile plain = inks;
        plain.iccProfile.clear();
        plain.queue = QStringLiteral("pigment");
        PrintFileRequest file;
        file.profile = plain;
        writePrintFile(chessSheet(QStringLiteral("Top")), file, path, history());
        QCOMPARE(history().records()[0].job, QStringLiteral("3fa9c2d1"));
    }

    // The PDF is written in RGB, because its lettering is text only in RGB.
    void writePrintFile_jobNumber_isOnSheet() {
        PrintFileRequest file;
        file.profile = PrinterProfile();
        file.profile->scaleY = 0.99;
        const QString path = folder_->filePath(QStringLiteral("sheet.pdf"));
        writePrintFile(chessSheet(QStringLiteral("Top")), file, path, history());
        const QByteArray words = output("pdftotext", {path, "-"}).simplified();
        QVERIFY2(words.contains("Job " + history().records()[0].job.toLatin1()), words);
    }

    void printHistory_folderNotWritable_stillPrints() {
        QFile inTheWay(folder_->filePath(QStringLiteral("prints")));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        const PrintEnd end = print({QStringLiteral("Top")}, history());
        QCOMPARE(end.state, JobState::Printed);
        QVERIFY(!end.historyFailure.isEmpty());
    }

    void printHistory_damagedRecords_areSkipped() {
        print({QStringLiteral("Top")}, history());
        const QDir folder(folder_->filePath(QStringLiteral("prints")));
        QFile whole(folder.filePath(folder.entryList(QDir::Files).front()));
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray bytes = whole.readAll();
        for (qsizetype length = 0; length < bytes.size() - 2; length += 7) {
            QFile cut(folder.filePath(QStringLiteral("2%1.print.json").arg(length)));
            QVERIFY(cut.open(QIODevice::WriteOnly));
            cut.write(bytes.left(length));
        }
        QCOMPARE(history().records().size(), std::size_t(1));
    }

    void printHistory_full_removesOldest() {
        const QDir folder(folder_->filePath(QStringLiteral("prints")));
        QVERIFY(folder.mkpath(QStringLiteral(".")));
        for (int i = 0; i < PrintHistory::mostRecords + 3; ++i) {
            QFile old(
                folder.filePath(QStringLiteral("1%1.print.json").arg(i, 6, 10, QLatin1Char('0'))));
            QVERIFY(old.open(QIODevice::WriteOnly));
        }
        QFile others(folder.filePath(QStringLiteral("0.json"))); // not a record
        QVERIFY(others.open(QIODevice::WriteOnly));
        print({QStringLiteral("Top")}, history());
        QVERIFY(others.exists());
        QVERIFY(!folder.exists(QStringLiteral("1000003.print.json")));
        QVERIFY(folder.exists(QStringLiteral("1000004.print.json")));
        QCOMPARE(folder.entryList({QStringLiteral("*.print.json")}).size(),
                 PrintHistory::mostRecords);
        QCOMPARE(history().records().size(), std::size_t(1));
    }
};

QTEST_MAIN(PrintHistoryTest)
#include "PrintHistoryTest.moc"

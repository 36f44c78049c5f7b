// Tests `dipwright-cli watch`, the hot folder, with a print system of the test's own.
#include "CliProcess.h"
#include "PrivateCups.h"
#include "TestFolders.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;
using dipwright::test::cli;
using dipwright::test::cliPath;
using dipwright::test::Outcome;

namespace {

// Coarse settings, to be fast.
const QStringList coarse{"--set",     "film.points=41x58",
                         "--set",     "body.sdf_resolution=64",
                         "--set",     "sheet.dpi=60",
                         "--set",     "sheet.paper=A4",
                         "--require", "any",
                         "--quiet"};

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class WatchCommandTest : public QObject {
    Q_OBJECT

    std::unique_ptr<PrivateCups> cups_;
    std::unique_ptr<QTemporaryDir> folder_;

    QString in(const QString& name) const { return folder_->filePath(name); }
    bool drop(const QString& name, const QByteArray& contents) const {
        QDir().mkpath(QFileInfo(in(name)).path());
        QFile file(in(name));
        return file.open(QIODevice::WriteOnly) && file.write(contents) == contents.size();
    }
    bool drop(const QString& name) const { return drop(name, read(sampleFolder("/sphere.dipw"))); }
    QStringList arguments() const { return {"watch", in("jobs"), "--out", in("results")}; }
    Outcome watchOnce(const QStringList& more = {}) const {
        return cli(arguments() + QStringList{"--once"} + coarse + more);
    }

private slots:
    void initTestCase() {
        cups_ = std::make_unique<PrivateCups>();
        QVERIFY2(cups_->problem().isEmpty(), qPrintable(cups_->problem()));
        QVERIFY(cups_->add({"pigment"}));
    }
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void watch_projects_areRunAndPrinted() {
        QVERIFY(drop("jobs/first.dipw"));
        const Outcome outcome = watchOnce({"--printer", "pigment"});
        QVERIFY2(outcome.exitCode == 0, outcome.err);
        QVERIFY2(outcome.out.contains("first.dipw: done"), outcome.out);
        QVERIFY(!QFile::exists(in("jobs/first.dipw")));
        QVERIFY(QFile::exists(in("jobs/done/first.dipw")));
        QVERIFY2(read(in("jobs/done/first.dipw.txt")).contains("Printed"),
                 read(in("jobs/done/first.dipw.txt")));
        QVERIFY(QFile::exists(in("results/first/immersion-1/sheet.pdf")));
        QCOMPARE(cups_->received("pigment").size(), 1);
    }

    void watch_ticket_setsCopiesAndValues() {
        QVERIFY(drop("jobs/projects/ball.dipw"));
        QVERIFY(drop("jobs/order.json",
                     R"({"format": "dipwright-print-ticket", "version": 1, "project": "ball.dipw",
                         "copies": 2, "set": {"film.points": "30x40"}})"));
        const Outcome outcome = watchOnce({"--printer", "pigment"});
        QVERIFY2(outcome.out.contains("order.json: done"), outcome.out);
        QVERIFY(QFile::exists(in("jobs/projects/ball.dipw"))); // serves other tickets, too
        QVERIFY(read(in("results/order/report.json")).contains("\"columns\": 30"));
        QVERIFY(cups_->receivedAttribute("pigment", "job-name").contains("phere"));
    }

    void watch_badJobs_areFailedWithReason() {
        const QByteArray head = R"({"format": "dipwright-print-ticket", "version": 1)";
        const std::vector<std::tuple<QString, QByteArray, QByteArray>> jobs{
            {"damaged.dipw", "nothing", "not a Dipwright project"},
            {"list.json", "[1]", "no print ticket"},
            {"outside.json", head + R"(, "project": "../../secret.dipw"})", "name of a file"},
            {"entry.json", head + R"(, "project": "b.dipw", "copys": 2})", "copys"},
            {"copies.json", head + R"(, "project": "b.dipw", "copies": 0})", "1 to 999"},
            {"missing.json", head + R"(, "project": "b.dipw"})", "b.dipw"}};
        for (const auto& [name, contents, reason] : jobs) {
            QVERIFY(drop("jobs/" + name, contents));
        }
        const Outcome outcome = watchOnce();
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.err.contains("Jobs that failed: 6"), outcome.err);
        for (const auto& [name, contents, reason] : jobs) {
            QVERIFY2(QFile::exists(in("jobs/failed/" + name)), qPrintable(name));
            const QByteArray text = read(in("jobs/failed/" + name + ".txt"));
            QVERIFY2(text.contains(reason), text);
        }
        QVERIFY(!QFile::exists(in("results")));
    }

    // The shared options accept any verdict; the last --require counts.
    void watch_worseVerdict_isHeldUntilReleased() {
        QVERIFY(drop("jobs/ball.dipw"));
        const QStringList strict{"--require", "print", "--printer", "pigment"};
        const qsizetype before = cups_->received("pigment").size();
        QVERIFY2(watchOnce(strict).out.contains("ball.dipw: held"), "held");
        QVERIFY(read(in("jobs/held/ball.dipw.txt")).contains("worse than required"));
        QVERIFY(QFile::exists(in("results/ball/report.json")));
        QCOMPARE(cups_->received("pigment").size(), before);
        QVERIFY(QFile::rename(in("jobs/held/ball.dipw"), in("jobs/release/ball.dipw")));
        QVERIFY(watchOnce(strict).out.contains("ball.dipw: done"));
        QCOMPARE(cups_->received("pigment").size(), before + 1);
    }

    void watch_killed_startsTheJobAgain() {
        QVERIFY(drop("jobs/ball.dipw"));
        QProcess process;
        process.start(cliPath(), arguments() + QStringList{"--set", "film.points=300x400"});
        QVERIFY(process.waitForStarted());
        process.setReadChannel(QProcess::StandardError);
        QVERIFY(process.waitForReadyRead(20'000)); // the job runs
        process.kill();
        QVERIFY(process.waitForFinished());
        QVERIFY(QFile::exists(in("jobs/ball.dipw")));
        QVERIFY(!QFile::exists(in("results/ball/report.json")));
        QVERIFY(watchOnce().out.contains("ball.dipw: done"));
        QVERIFY(QFile::exists(in("results/ball/report.json")));
    }

    // Sheets of such a job may be printed already, so it is not printed again unasked.
    void watch_killedWhilePrinting_holdsTheJob() {
        QVERIFY(drop("jobs/printing/ball.dipw"));
        const qsizetype before = cups_->received("pigment").size();
        const Outcome watched = watchOnce({"--printer", "pigment"});
        QCOMPARE(watched.exitCode, 0);
        QVERIFY2(watched.out.contains("ball.dipw: held"), watched.out);
        QVERIFY(QFile::exists(in("jobs/held/ball.dipw")));
        QVERIFY(read(in("jobs/held/ball.dipw.txt")).contains("Check which sheets"));
        QCOMPARE(cups_->received("pigment").size(), before);
    }

    void watch_resultsInAFile_isRefusedAtOnce() {
        QVERIFY(drop("jobs/ball.dipw"));
        const Outcome watched =
            cli({"watch", in("jobs"), "--out", in("jobs/ball.dipw/results"), "--once", "--quiet"});
        QCOMPARE(watched.exitCode, 1);
        QVERIFY2(watched.err.contains("is not a folder"), watched.err);
        QVERIFY(QFile::exists(in("jobs/ball.dipw")));
    }

    void watch_watchedFolder_isRefused() {
        QProcess process;
        process.start(cliPath(), arguments() + coarse);
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(in("jobs/held")), 20'000);
        const Outcome second = watchOnce();
        QCOMPARE(second.exitCode, 1);
        QVERIFY2(second.err.contains("already used"), second.err);
        process.terminate();
        QVERIFY(process.waitForFinished());
    }
};

QTEST_MAIN(WatchCommandTest)
#include "WatchCommandTest.moc"

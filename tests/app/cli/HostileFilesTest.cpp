// Tests malicious files that try to read private files, crash the program or exhaust the machine.
// Each must be refused with one sentence, within five seconds of processor time and with less than
// one gigabyte of memory.
#include "HostileFiles.h"
#include "CliProcess.h"
#include "TestFiles.h"
#include "TestFolders.h"

#include <QDir>
#include <QtTest>

#ifdef Q_OS_UNIX
#include <sys/resource.h>
#endif

using namespace dipwright::test;

namespace {

const QDir shared(sharedFolder("/data/hostile"));

// Runs dipwright-cli. The system ends it after `seconds` of processor time.
Outcome cliWithin(int seconds, const QStringList& arguments) {
#ifdef Q_OS_UNIX
    return program("/bin/sh", QStringList{"-c", "ulimit -t \"$0\"; exec \"$@\"",
                                          QString::number(seconds), cliPath()} +
                                  arguments);
#else
    Q_UNUSED(seconds);
    return cli(arguments);
#endif
}

} // namespace

class HostileFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY(folder_.isValid());
        writeHostileFiles(folder_.path());
        QVERIFY(!QDir(folder_.path()).isEmpty());
    }

    void cli_hostileFile_isRefused_data() { listFiles(QDir(folder_.path())); }
    void cli_hostileFile_isRefused() { refused(); }

    void cli_sharedHostileFile_isRefused_data() {
        QTest::addColumn<QString>("file");
        if (shared.exists()) {
            listFiles(shared);
        } else {
            QTest::newRow("none") << QString();
        }
    }
    void cli_sharedHostileFile_isRefused() {
        if (!shared.exists()) {
            QSKIP("no shared models");
        }
        refused();
    }

    // Measures the largest memory of all programs run so far and of their child processes.
    void cli_hostileFiles_useLessThanOneGigabyte() {
#ifdef Q_OS_UNIX
#if !defined(DIPWRIGHT_SANITIZED) // sanitizers need more memory themselves
        rusage used{};
        QCOMPARE(getrusage(RUSAGE_CHILDREN, &used), 0);
#ifdef Q_OS_MACOS
        const qint64 bytes = used.ru_maxrss;
#else
        const qint64 bytes = qint64(used.ru_maxrss) << 10;
#endif
        QVERIFY2(bytes < qint64(1) << 30,
                 qPrintable(QStringLiteral("a program used %1 MiB, expected less than 1024 MiB")
                                .arg(bytes >> 20)));
#endif
#endif
    }

private:
    static void listFiles(const QDir& folder) {
        QTest::addColumn<QString>("file");
        for (const QString& name : folder.entryList(QDir::Files)) {
            QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }

    void refused() const {
        QFETCH(QString, file);
        const QString out = folder_.filePath(QStringLiteral("out/made.dipw"));
        QDir().mkpath(QFileInfo(out).path());
        const bool isProject = file.endsWith(QLatin1String(".dipw"));
#if defined(DIPWRIGHT_SANITIZED)
        constexpr int mostSeconds = 100; // sanitizers are up to 20 times slower
#else
        constexpr int mostSeconds = 5;
#endif
        const Outcome outcome =
            cliWithin(mostSeconds, isProject ? QStringList{"info", file}
                                             : QStringList{"new", out, "--model", file, "--quiet"});
        QVERIFY2(outcome.exitCode == 1, outcome.out + outcome.err);
        // Standard error has no output of libraries, and no escape character for the terminal.
        QVERIFY2(outcome.err.count('\n') == 1 && outcome.errorLines().size() == 1, outcome.err);
        QVERIFY(!outcome.err.contains('\x1b'));
        QVERIFY(!QFileInfo::exists(out));
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(HostileFilesTest)
#include "HostileFilesTest.moc"

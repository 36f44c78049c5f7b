// Tests unusual but valid names and paths. The program must either handle them or refuse them in
// one line.
#include "CliProcess.h"
#include "TestFolders.h"

#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright::test;

namespace {

const QString model = sampleFolder("/models/tetrahedron.obj");
const QString sample = sampleFolder("/tetrahedron.dipw");
const QStringList small{"--set", "film.points=17x17", "--set",          "body.sdf_resolution=64",
                        "--set", "sheet.dpi=40",      "--no-certainty", "--quiet"};

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns all files below a folder, except files that contain times.
QMap<QString, QByteArray> timelessFiles(const QString& folder) {
    QMap<QString, QByteArray> files;
    QDirIterator all(folder, QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        const QString path = all.next();
        if (!path.endsWith(QLatin1String(".json")) && !path.endsWith(QLatin1String(".pdf"))) {
            files[QDir(folder).relativeFilePath(path)] = contentsOf(path);
        }
    }
    return files;
}

bool isOneLine(const Outcome& outcome) {
    return outcome.exitCode != 0 && outcome.errorLines().size() == 1;
}

} // namespace

class OddPlacesTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }
    void cli_longestFileName_isWritten();
    void cli_pathTooLong_isRefused();
    void cli_nameNotUtf8_isRefused();
    void cli_escapeBytesInName_areNotPrinted_data();
    void cli_escapeBytesInName_areNotPrinted();
    void cli_lineBreakInName_isPrintedOnOneLine();
    void run_anyLocale_writesSameFiles_data();
    void run_anyLocale_writesSameFiles();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }

    std::unique_ptr<QTemporaryDir> folder_;
};

// While a file is written, a hidden file with a longer name lies next to it.
void OddPlacesTest::cli_longestFileName_isWritten() {
    const QString job = path(QString(250, QLatin1Char('x')) + QStringLiteral(".dipw"));
    for (int time = 0; time < 2; ++time) { // created, then replaced
        const Outcome made = cli({"new", job, "--model", model, "--size-mm", "40", "--quiet"});
        QVERIFY2(made.exitCode == 0, made.err.constData());
    }
    const QString umlauts = path(QString(125, QChar(0xfc)) + QStringLiteral(".dipw"));
    QCOMPARE(cli({"new", umlauts, "--model", model, "--quiet"}).exitCode, 0);
    const QString out = path(QString(255, QLatin1Char('r')));
    const Outcome ran = cli(QStringList{"run", job, "--out", out} + small);
    QVERIFY2(ran.exitCode == 0, ran.err.constData());
    QVERIFY(QFileInfo::exists(out + QStringLiteral("/immersion-1/sheet.pdf")));
    QCOMPARE(
        QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
        QStringList(
            {QFileInfo(out).fileName(), QFileInfo(job).fileName(), QFileInfo(umlauts).fileName()}));
}

void OddPlacesTest::cli_pathTooLong_isRefused() {
    QString deep = folder_->path();
    while (deep.size() < 4200) {
        deep += QLatin1Char('/') + QString(200, QLatin1Char('d'));
    }
    const QString job = deep + QStringLiteral("/job.dipw");
    QVERIFY(isOneLine(cli({"info", job})));
    QVERIFY(isOneLine(cli({"new", job, "--model", model, "--quiet"})));
    QVERIFY(isOneLine(cli({"new", path("job.dipw"), "--model", job, "--quiet"})));
    QVERIFY(isOneLine(cli(QStringList{"run", sample, "--out", deep} + small)));
    QVERIFY(QDir(folder_->path()).isEmpty());
}

// If such names were decoded as text, they could be mistaken for other names.
void OddPlacesTest::cli_nameNotUtf8_isRefused() {
#ifndef Q_OS_UNIX
    return; // on Windows, every name is valid text
#endif
    QProcess shell;
    shell.setWorkingDirectory(folder_->path());
    shell.start(
        QStringLiteral("sh"),
        {"-c", "\"$0\" new \"$(printf 'a\\377.dipw')\" --model \"$1\" --quiet", cliPath(), model});
    QVERIFY(shell.waitForFinished(-1));
    QCOMPARE(shell.exitCode(), 2);
    const QByteArray said = shell.readAllStandardError();
    QCOMPARE(said.count('\n'), 1);
    QVERIFY2(said.contains("not UTF-8 text"), said.constData());
    QVERIFY(QDir(folder_->path()).isEmpty());
    // Files in a folder with such a name are refused, too, whatever path leads to them.
    shell.start(QStringLiteral("sh"),
                {"-c",
                 "mkdir \"$(printf 'b\\377')\" && cd b* && \"$0\" new a.dipw --model \"$1\" "
                 "--quiet; told=$?; cd .. && rm -r b*; exit $told",
                 cliPath(), model});
    QVERIFY(shell.waitForFinished(-1));
    QCOMPARE(shell.exitCode(), 2);
    QVERIFY(shell.readAllStandardError().contains("working folder"));
    QVERIFY(QDir(folder_->path()).isEmpty());
}

void OddPlacesTest::cli_escapeBytesInName_areNotPrinted_data() {
    QTest::addColumn<QString>("words");
    QTest::newRow("a file that is not there") << "info NAME";
    QTest::newRow("a model that is not there") << "new OUT --model NAME";
    QTest::newRow("a project that is made") << "new NAME --model MODEL";
    QTest::newRow("a folder of results")
        << "run SAMPLE --out NAME --no-certainty --set film.points=17x17 "
           "--set body.sdf_resolution=64 --set sheet.dpi=40";
    QTest::newRow("a picture") << "run SAMPLE --out OUT --film-image NAME";
    QTest::newRow("a command") << "NAME";
    QTest::newRow("an option") << "info SAMPLE --NAME";
    QTest::newRow("a setting") << "info SAMPLE --set NAME=1";
    QTest::newRow("a value") << "info SAMPLE --set film.swell=NAME";
    QTest::newRow("a solver") << "run SAMPLE --out OUT --solver NAME";
    QTest::newRow("a profile") << "profile show film NAME";
    QTest::newRow("a printer") << "print SAMPLE --printer NAME";
}

// If the name were printed unchanged, it would rename the window, ring the bell and clear the
// screen.
void OddPlacesTest::cli_escapeBytesInName_areNotPrinted() {
    QFETCH(QString, words);
    const QString name =
        path(QStringLiteral("e\x1b]0;owned\x07\x1b[2J") + QChar(0x9b) + QStringLiteral("31m.dipw"));
    QStringList arguments = words.split(QLatin1Char(' '));
    for (QString& argument : arguments) {
        argument.replace(QLatin1String("NAME"), name).replace(QLatin1String("SAMPLE"), sample);
        argument.replace(QLatin1String("MODEL"), model).replace(QLatin1String("OUT"), path("out"));
    }
    const Outcome outcome = cli(arguments);
    const QByteArray said = outcome.out + outcome.err;
    QVERIFY(!said.isEmpty());
    for (const char* byte : {"\x1b", "\x07", "\xc2\x9b"}) {
        QVERIFY2(!said.contains(byte), said.toPercentEncoding(" /").constData());
    }
}

void OddPlacesTest::cli_lineBreakInName_isPrintedOnOneLine() {
    const Outcome outcome = cli({"new", path("two\nlines.dipw"), "--model", model});
    QVERIFY2(outcome.out.contains("two lines.dipw\n"), outcome.out + outcome.err);
}

void OddPlacesTest::run_anyLocale_writesSameFiles_data() {
    QTest::addColumn<QString>("locale");
    QTest::newRow("C") << "C";
    QTest::newRow("German") << "de_DE.UTF-8";
    QTest::newRow("Portuguese") << "pt_BR.UTF-8";
    QTest::newRow("Turkish") << "tr_TR.UTF-8";
    QTest::newRow("Arabic") << "ar_EG.UTF-8";
}

void OddPlacesTest::run_anyLocale_writesSameFiles() {
    QFETCH(QString, locale);
    const auto run = [&](const QString& language, const QString& out) {
        return cli(QStringList{"run", sample, "--out", path(out), "--set", "film.swell=1.06x1.02"} +
                       small,
                   {QStringLiteral("LC_ALL=") + language});
    };
    const Outcome plain = run(QStringLiteral("C.UTF-8"), QStringLiteral("plain"));
    const Outcome other = run(locale, QStringLiteral("other"));
    QCOMPARE(other.exitCode, 0);
    const auto steps = [](const QByteArray& said) { return said.split('\n').mid(0, 2); };
    QCOMPARE(steps(other.out), steps(plain.out));
    const auto files = timelessFiles(path(QStringLiteral("plain")));
    QVERIFY(files.size() > 5);
    const auto others = timelessFiles(path(QStringLiteral("other")));
    for (auto file = files.begin(); file != files.end(); ++file) {
        QVERIFY2(others.value(file.key()) == file.value(), qPrintable(file.key()));
    }
}

QTEST_GUILESS_MAIN(OddPlacesTest)
#include "OddPlacesTest.moc"

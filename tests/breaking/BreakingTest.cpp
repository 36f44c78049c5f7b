// Breaks the programs at every file operation while they write. Either the program is killed, the
// operation fails, or the folder vanishes as a network folder does. At the next start, either the
// complete old state or the complete new state must be there, and nothing else.
//
// DIPWRIGHT_BREAK_EVERYWHERE=1 breaks at every operation; =3/16 breaks at the third operation and
// every 16th after it. If it is unset, each case is broken at a few operations only, because
// breaking at every operation takes long. The counts are printed (scripts/break).

#include "CliProcess.h"
#include "TestFolders.h"
#include "WholeSample.h"

#include <QCryptographicHash>
#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright::test;

namespace {

constexpr int mostGrowth = 4 * 1024;       // kB over many cycles; libraries cache memory
const int pointsOfACase = sampleOf(4, 12); // breaks per case, unless isEverywhere() is true
// The least number of file operations in a recovery, which runs when a program starts.
constexpr int operationsOfAStart = 16;

bool isEverywhere() {
    return qEnvironmentVariableIsSet("DIPWRIGHT_BREAK_EVERYWHERE");
}

// The operations to break: number `first`, counted from 1, and every `stride`th after it.
struct Points {
    long first = 1;
    long stride = 1;
};
Points pointsOf(long count, int atMost) {
    if (!isEverywhere()) {
        return {1, std::max(1L, count / atMost)};
    }
    const QStringList part =
        qEnvironmentVariable("DIPWRIGHT_BREAK_EVERYWHERE").split(QLatin1Char('/'));
    return part.size() == 2 ? Points{std::max(1L, part[0].toLong()), std::max(1L, part[1].toLong())}
                            : Points();
}

// Where and how a program is broken. If `at` is 0, it is not broken.
struct Break {
    int at = 0;
    QString how = {};
    QString log = {};
};

// A folder with all files that a case reads and writes, and with the user's data of the program.
class Place {
public:
    QString path(const QString& name = {}) const { return root_.filePath(name); }

    QStringList environment() const {
        return {QStringLiteral("XDG_DATA_HOME=") + path(QStringLiteral("data")),
                QStringLiteral("DIPWRIGHT_PROFILE_PATH=") + path(QStringLiteral("profiles")),
                QStringLiteral("QT_QPA_PLATFORM=offscreen"),
                QStringLiteral("MALLOC_ARENA_MAX=1"), // for counting memory (program_manyCycles_…)
                QStringLiteral("DIPWRIGHT_CACHE=") + cache_.path()};
    }
    Outcome run(const QString& program, const QStringList& arguments,
                const Break& broken = {}) const {
        QStringList all = environment();
        if (broken.at > 0 || !broken.log.isEmpty()) {
            all << QStringLiteral("LD_PRELOAD=" DIPWRIGHT_BREAK_FILES)
                << QStringLiteral("DIPWRIGHT_BREAK_BELOW=") + path()
                << QStringLiteral("DIPWRIGHT_BREAK_AT=%1").arg(broken.at)
                << QStringLiteral("DIPWRIGHT_BREAK_HOW=") + broken.how;
            if (!broken.log.isEmpty()) {
                all << QStringLiteral("DIPWRIGHT_BREAK_LOG=") + broken.log;
            }
        }
        return dipwright::test::program(program, arguments, all);
    }
    Outcome cli(const QStringList& arguments) const { return run(cliPath(), arguments); }

private:
    QTemporaryDir root_, cache_;
};

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns the report without its times, which differ from run to run.
QByteArray reportOf(const QString& path) {
    QJsonObject report = QJsonDocument::fromJson(contentsOf(path)).object();
    QJsonArray immersions;
    for (const QJsonValue& value : report[QLatin1String("immersions")].toArray()) {
        QJsonObject immersion = value.toObject();
        immersion.remove(QStringLiteral("wall_seconds"));
        immersion.remove(QStringLiteral("steps_per_second"));
        immersions << immersion;
    }
    report[QLatin1String("immersions")] = immersions;
    return QJsonDocument(report).toJson();
}

// Names and hashes of all files below a folder. Hidden files count, because they are leftovers.
using Snapshot = QMap<QString, QByteArray>;
Snapshot snapshot(const QString& folder) {
    static const QRegularExpression uuid(
        QStringLiteral("[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}"));
    Snapshot files;
    QDirIterator all(folder, QDir::Files | QDir::Hidden | QDir::System,
                     QDirIterator::Subdirectories);
    while (all.hasNext()) {
        const QString path = all.next();
        const QString name = QDir(folder).relativeFilePath(path).replace(uuid, "UUID");
        const bool isReport = name.endsWith(QLatin1String("report.json"));
        files[name] = QCryptographicHash::hash(isReport ? reportOf(path) : contentsOf(path),
                                               QCryptographicHash::Sha1);
    }
    return files;
}

void copyFolder(const QString& from, const QString& to) {
    QDirIterator all(from,
                     QDir::Files | QDir::Hidden | QDir::System | QDir::Dirs | QDir::NoDotAndDotDot,
                     QDirIterator::Subdirectories);
    while (all.hasNext()) {
        const QString path = all.next();
        const QString target = to + QLatin1Char('/') + QDir(from).relativeFilePath(path);
        if (all.fileInfo().isDir()) {
            QDir().mkpath(target);
        } else {
            QDir().mkpath(QFileInfo(target).path());
            QFile::copy(path, target);
        }
    }
}

void emptyFolder(const QString& folder) {
    QDir(folder).removeRecursively();
    QDir().mkpath(folder);
}

} // namespace

class BreakingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void writes_killedOrFailing_areWholeAtNextStart_data();
    void writes_killedOrFailing_areWholeAtNextStart();
    void projectFile_failingAllocations_loseNothing();
    void program_manyCycles_leavesNothingBehind();

private:
    void restore() const;
    QString kept(const QString& name) const { return kept_.filePath(name); }

    Place place_;
    QTemporaryDir kept_; // a copy of place_ before each break
};

void BreakingTest::initTestCase() {
    const auto made = [this](const QStringList& arguments) {
        const Outcome outcome = place_.cli(arguments);
        if (outcome.exitCode != 0) {
            qWarning("%s", outcome.err.constData());
        }
        return outcome.exitCode == 0;
    };
    // Small, because a job runs again for every break.
    QImage texture(16, 16, QImage::Format_RGB32);
    texture.fill(Qt::darkCyan);
    QVERIFY(texture.save(place_.path(QStringLiteral("a.png"))));
    const QString model = sampleFolder("/models/tetrahedron.obj");
    const auto project = [&](const QString& name, const QStringList& more) {
        return QStringList{QStringLiteral("new"),       place_.path(name),
                           QStringLiteral("--model"),   model,
                           QStringLiteral("--size-mm"), QStringLiteral("40"),
                           QStringLiteral("--texture"), place_.path(QStringLiteral("a.png"))} +
               more;
    };
    const QStringList small{QStringLiteral("--set"), QStringLiteral("film.size_mm=80x80"),
                            QStringLiteral("--set"), QStringLiteral("film.points=17x17"),
                            QStringLiteral("--set"), QStringLiteral("body.sdf_resolution=64"),
                            QStringLiteral("--set"), QStringLiteral("sheet.dpi=40")};
    // The earlier results have two dips. Each of their files differs from the file that replaces
    // it.
    QVERIFY(made(project(QStringLiteral("old.dipw"),
                         small + QStringList{QStringLiteral("--immersion"),
                                             QStringLiteral("name=A,rotation=10;20;30"),
                                             QStringLiteral("--immersion"),
                                             QStringLiteral("name=B,rotation=50;60;70")})));
    QVERIFY(made({QStringLiteral("run"), place_.path(QStringLiteral("old.dipw")),
                  QStringLiteral("--out"), place_.path(QStringLiteral("out"))}));
    QFile::remove(place_.path(QStringLiteral("old.dipw")));
    QVERIFY(made(project(QStringLiteral("job.dipw"), small)));
    QFile notes(place_.path(QStringLiteral("out/immersion-2/notes.txt")));
    QVERIFY(notes.open(QIODevice::WriteOnly) && notes.write("mine") == 4);
    notes.close();
    QVERIFY(
        made({QStringLiteral("profile"), QStringLiteral("set"), QStringLiteral("film"),
              QStringLiteral("Mine"), QStringLiteral("--set"), QStringLiteral("swell=1.1;1.1")}));
    QVERIFY(made({QStringLiteral("profile"), QStringLiteral("set"), QStringLiteral("printer"),
                  QStringLiteral("Office"), QStringLiteral("--set"), QStringLiteral("dpi=60")}));
    QDir().mkpath(place_.path(QStringLiteral("recovery")));
    copyFolder(place_.path(), kept({}));
}

void BreakingTest::restore() const {
    emptyFolder(place_.path());
    copyFolder(kept({}), place_.path());
}

void BreakingTest::writes_killedOrFailing_areWholeAtNextStart_data() {
    QTest::addColumn<QString>("program");
    QTest::addColumn<QString>("words");
    const QString cli = cliPath();
    const QString document = QStringLiteral(DIPWRIGHT_KEEP_DOCUMENT);
    const auto row = [](const char* name, const QString& program, const char* words) {
        QTest::newRow(name) << program << QString::fromLatin1(words);
    };
    row("run over results", cli, "run @job.dipw --out @out --no-certainty --threads 1");
    row("run into a new folder", cli, "run @job.dipw --out @deep/down --no-certainty --threads 1");
    row("optimize", cli,
        "optimize @job.dipw --immersions 2 --candidates 6 --directions 6 --refined 0 --finer 1 "
        "--confirmed 0 --threads 1");
    row("profile set", cli, "profile set film Mine --set swell=1.2;1.2");
    row("new profile", cli, "profile set film Other --set swell=1.2;1.2");
    row("profile use", cli, "profile use film Mine @job.dipw");
    row("profile export", cli, "profile export film Mine @film.json");
    row("profile remove", cli, "profile remove film Mine");
    row("calibrate", cli, "calibrate --profile Office --measured 170.7x219.4 --paper A4");
    row("calibrate to a file", cli, "calibrate --profile Office --to @page.pdf");
    row("save", document, "save @job.dipw");
    row("autosave", document, "keep @job.dipw @recovery");
    row("export", document, "export @job.dipw @out");
}

void BreakingTest::writes_killedOrFailing_areWholeAtNextStart() {
    QFETCH(QString, program);
    QFETCH(QString, words);
    QStringList arguments = words.split(QLatin1Char(' '));
    for (QString& argument : arguments) {
        argument.replace(QLatin1Char('@'), place_.path() + QLatin1Char('/'));
    }
    const auto nextStart = [this] {
        const QString job = place_.path(QStringLiteral("job.dipw"));
        place_.run(QStringLiteral(DIPWRIGHT_KEEP_DOCUMENT),
                   {QStringLiteral("recover"), place_.path(QStringLiteral("recovery"))});
        // Removes the marker files that a program killed while loading solvers has left.
        place_.cli({QStringLiteral("solvers")});
        return place_.cli({QStringLiteral("info"), job}).exitCode == 0;
    };
    restore();
    const Snapshot before = snapshot(place_.path());
    const QTemporaryDir logs;
    const QString log = logs.filePath(QStringLiteral("log"));
    const Outcome whole = place_.run(program, arguments, {0, {}, log});
    QVERIFY2(whole.exitCode == 0, whole.err.constData());
    QVERIFY(nextStart());
    const Snapshot after = snapshot(place_.path());
    QVERIFY(before != after);
    const int operations = int(contentsOf(log).count('\n'));
    const std::vector<const char*> ways{"kill", "EIO", "ENOSPC", "ESTALE"};
    const Points points = pointsOf(operations, pointsOfACase);
    // If every operation is broken, also breaks at the next two, because a failure may cause
    // further operations.
    const int last = operations + (isEverywhere() ? 2 : 0);
    int breaks = 0;
    QStringList faults;
    for (int at = int(points.first); at <= last; at += int(points.stride)) {
        for (std::size_t way = 0; way < ways.size(); ++way) {
            const char* const how = ways[way];
            if (!isEverywhere() && std::size_t(at / points.stride) % ways.size() != way) {
                continue; // tests only one way at each operation, in turn
            }
            restore();
            const Outcome outcome =
                place_.run(program, arguments, {at, QString::fromLatin1(how), {}});
            ++breaks;
            if (way == 0) { // also breaks the recovery once
                place_.run(cliPath(),
                           {QStringLiteral("info"), place_.path(QStringLiteral("job.dipw"))},
                           {1 + breaks % operationsOfAStart, QStringLiteral("EIO"), {}});
            }
            const bool opens = nextStart();
            const Snapshot now = snapshot(place_.path());
            const bool isWhole = now == before || now == after;
            const bool isTrue = outcome.exitCode != 0 || now == after;
            if (!opens || !isWhole || !isTrue) {
                QStringList others;
                for (auto file = now.begin(); file != now.end(); ++file) {
                    if (before.value(file.key()) != file.value() &&
                        after.value(file.key()) != file.value()) {
                        others << file.key();
                    }
                }
                faults << QStringLiteral("%1 at %2: %3 %4")
                              .arg(QLatin1String(how))
                              .arg(at)
                              .arg(!opens     ? QStringLiteral("does not open")
                                   : !isWhole ? QStringLiteral("is mixed")
                                              : QStringLiteral("failed and said nothing"),
                                   others.join(QLatin1Char(' ')));
            }
        }
    }
    qInfo("%d operations, broken at %d of them: %d times the files were not whole", operations,
          breaks, int(faults.size()));
    QVERIFY2(faults.isEmpty(), qPrintable(faults.mid(0, 60).join(QLatin1Char('\n'))));
}

void BreakingTest::projectFile_failingAllocations_loseNothing() {
    restore();
    const QString job = place_.path(QStringLiteral("job.dipw"));
    const QString document = QStringLiteral(DIPWRIGHT_KEEP_DOCUMENT);
    const Break counting{0, {}, QStringLiteral("/dev/null")};
    const long count = place_.run(document, {QStringLiteral("count-allocations"), job}, counting)
                           .out.trimmed()
                           .toLong();
    QVERIFY(count > 100);
    const Points points = pointsOf(count, sampleOf(40, 100));
    const Outcome outcome =
        place_.run(document,
                   {QStringLiteral("allocations"), job, QString::number(points.first),
                    QString::number(count), QString::number(points.stride)},
                   counting);
    qInfo("%s", outcome.out.trimmed().constData());
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY2(outcome.out.contains(" lost 0"), outcome.out.constData());
}

void BreakingTest::program_manyCycles_leavesNothingBehind() {
    restore();
    const int count = isEverywhere() ? 500 : 20;
    const QString job = place_.path(QStringLiteral("job.dipw"));
    const QString day = place_.path(QStringLiteral("day"));
    const QTemporaryDir temporary;
    qputenv("TMPDIR", QFile::encodeName(temporary.path()));
    const Outcome outcome =
        place_.run(QStringLiteral(DIPWRIGHT_KEEP_DOCUMENT),
                   {QStringLiteral("cycles"), job, day, QString::number(count)});
    qunsetenv("TMPDIR");
    QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    const QList<QByteArray> told = outcome.out.trimmed().split('\n');
    QCOMPARE(told.size(), 2);
    const QList<QByteArray> early = told[0].split(' '), late = told[1].split(' ');
    qInfo("kB, handles and temporary files after %d cycles: %s; after %d: %s", count / 10,
          told[0].constData(), count, told[1].constData());
    QCOMPARE(late.value(1), early.value(1));
    QCOMPARE(late.value(2), early.value(2));
    QVERIFY(late.value(0).toInt() - early.value(0).toInt() < mostGrowth);
    QStringList left;
    const Snapshot files = snapshot(place_.path());
    for (auto file = files.begin(); file != files.end(); ++file) {
        if (file.key().contains(QLatin1String("/.")) || file.key().startsWith(QLatin1Char('.')) ||
            file.key().contains(QLatin1String("recovery/")) ||
            file.key().contains(QLatin1String("unfinished/"))) {
            left << file.key();
        }
    }
    QVERIFY2(left.isEmpty(), qPrintable(left.join(QLatin1Char(' '))));
}

QTEST_GUILESS_MAIN(BreakingTest)
#include "BreakingTest.moc"

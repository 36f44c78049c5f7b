// Two who write one file: the second is told, and nothing of the first's work is lost.

#include "CliProcess.h"
#include "TestFolders.h"
#include "disk/AtomicFile.h"
#include "disk/FileLock.h"
#include "disk/FolderTransaction.h"
#include "disk/UnfinishedWrites.h"
#include "project/ProfileLibrary.h"
#include "project/Project.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#include <unistd.h>
#endif

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr int races = 12;

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

} // namespace

class WritersTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void whatIsOpenElsewhereIsNotWritten_data();
    void whatIsOpenElsewhereIsNotWritten();
    void resultsAreNotWrittenBesideOthers();
    void twoAtOnceLoseNothing();
    void whatWasChangedMeanwhileIsNotReplaced();
    void aProfileThatWasChangedMeanwhileIsNotReplaced();
    void aFolderThatCannotTakeResultsIsRefusedBeforeTheWork();
    void linksInAFolderForResultsLeadNowhere();
    void whatADeadWriterSeemsToHaveLeftIsNotMovedThroughLinks();
    void whatADeadWriterSeemsToHaveLeftIsNoLink();
    void aJournalOfWhatIsNoResultTouchesNothing();
    void aJournalOfNamesThatAreNoneTouchesNothing_data();
    void aJournalOfNamesThatAreNoneTouchesNothing();
    void noStartDependsOnWhatOthersLeft();
    void recoveryEndsWhenItIsCancelled();
    void resultsThatWentMissingMeanwhileReplaceNothing();
    void foldersThatNothingCameIntoGo();
    void pipesAndCirclesOfLinksAreNotReplaced();
    void whatAnotherUserHasOpenIsNotWritten();
    void theNextStartRemovesNothingByTheNameOfAFolder();
    void onlyWhatCanBeReadIsReplacedAsAProfile();

private:
    QString path(const QString& name) const { return folder_->filePath(name); }
    QStringList environment() const {
        return {QStringLiteral("DIPWRIGHT_PROFILE_PATH=") + path(QStringLiteral("profiles"))};
    }

    std::unique_ptr<QTemporaryDir> folder_;
    QString job_;
};

void WritersTest::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    job_ = path(QStringLiteral("job.dipw"));
    QVERIFY(QFile::copy(sampleFolder("/tetrahedron.dipw"), job_));
    QVERIFY(QFile::setPermissions(job_, QFile::ReadOwner | QFile::WriteOwner));
}

void WritersTest::whatIsOpenElsewhereIsNotWritten_data() {
    QTest::addColumn<QString>("words");
    QTest::newRow("optimize") << "optimize JOB --immersions 1 --candidates 6";
    QTest::newRow("use") << "profile use film DIPPED JOB";
    QTest::newRow("new") << "new JOB --model " + sampleFolder("/models/sphere.obj");
}

void WritersTest::whatIsOpenElsewhereIsNotWritten() {
    QFETCH(QString, words);
    const QByteArray before = contentsOf(job_);
    FileLock window;
    QVERIFY(window.acquire(job_).acquired);
    QStringList arguments = words.split(QLatin1Char(' '));
    for (QString& argument : arguments) {
        argument = argument == QLatin1String("JOB") ? job_ : argument;
    }
    const Outcome outcome = cli(arguments, environment());
    QCOMPARE(outcome.exitCode, 1);
    QCOMPARE(outcome.errorLines().size(), 1);
    QVERIFY2(outcome.err.contains("open elsewhere"), outcome.err.constData());
    QVERIFY(outcome.err.contains(QByteArray::number(QCoreApplication::applicationPid())));
    QVERIFY(contentsOf(job_) == before);
    QCOMPARE(cli({QStringLiteral("info"), job_}).exitCode, 0); // may be read
}

void WritersTest::resultsAreNotWrittenBesideOthers() {
    const FolderTransaction other(path(QStringLiteral("out")), {QStringLiteral("proof.png")});
    const Outcome outcome =
        cli({QStringLiteral("run"), job_, QStringLiteral("--out"), path(QStringLiteral("out"))});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains("writing results there"), outcome.err.constData());
}

void WritersTest::twoAtOnceLoseNothing() {
    int told = 0;
    for (int race = 0; race < races; ++race) {
        init();
        QProcessEnvironment all = QProcessEnvironment::systemEnvironment();
        all.insert(QStringLiteral("DIPWRIGHT_PROFILE_PATH"), path(QStringLiteral("profiles")));
        for (const QString& kind : {QStringLiteral("film"), QStringLiteral("printer")}) {
            QCOMPARE(cli({"profile", "set", kind, "Mine"}, environment()).exitCode, 0);
        }
        QProcess film, printer;
        for (QProcess* process : {&film, &printer}) {
            process->setProcessEnvironment(all);
            process->start(cliPath(),
                           {"profile", "use", process == &film ? "film" : "printer", "Mine", job_});
        }
        QVERIFY(film.waitForFinished(-1) && printer.waitForFinished(-1));
        const Project project = loadProject(job_);
        QCOMPARE(project.profiles.film.has_value(), film.exitCode() == 0);
        QCOMPARE(project.profiles.printer.has_value(), printer.exitCode() == 0);
        QVERIFY(film.exitCode() == 0 || printer.exitCode() == 0);
        for (QProcess* process : {&film, &printer}) {
            told +=
                process->exitCode() == 1 && process->readAllStandardError().startsWith("error: ")
                    ? 1
                    : 0;
        }
    }
    qInfo("%d races, the second was told in %d", races, told);
}

void WritersTest::whatWasChangedMeanwhileIsNotReplaced() {
    ProjectFile file(job_);
    Project mine = loadProject(job_);
    Project theirs = mine;
    theirs.film.swellX = 1.25;
    saveProject(theirs, job_); // by who does not ask
    const QByteArray before = contentsOf(job_);
    mine.film.swellX = 1.125;
    QVERIFY_EXCEPTION_THROWN(file.save(mine), ChangedFile);
    QVERIFY(contentsOf(job_) == before);
}

void WritersTest::aProfileThatWasChangedMeanwhileIsNotReplaced() {
    const ProfileLibrary library(path(QStringLiteral("profiles")));
    FilmProfile profile;
    profile.name = QStringLiteral("Mine");
    library.save(Profile(profile), std::nullopt);
    const auto known = library.found(ProfileKind::Film, profile.name);
    profile.swellX = 1.25;
    library.save(Profile(profile), known); // the other
    profile.swellX = 1.125;
    QVERIFY_EXCEPTION_THROWN(library.save(Profile(profile), known), ChangedFile);
    QCOMPARE(std::get<FilmProfile>(*library.found(ProfileKind::Film, profile.name)).swellX, 1.25);
    library.replace(Profile(profile));
    QCOMPARE(std::get<FilmProfile>(*library.found(ProfileKind::Film, profile.name)).swellX, 1.125);
}

void WritersTest::aFolderThatCannotTakeResultsIsRefusedBeforeTheWork() {
    const QString out = path(QStringLiteral("out"));
    QVERIFY(QDir().mkpath(out + QStringLiteral("/proof.png")));
    const Outcome outcome = cli({QStringLiteral("run"), job_, QStringLiteral("--out"), out});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains("in the way"), outcome.err.constData());
    QVERIFY2(!outcome.err.contains("Dipping"), outcome.err.constData()); // no work was begun
}

// Who shares a folder with somebody could have put them there.
void WritersTest::linksInAFolderForResultsLeadNowhere() {
    const QString thesis = path(QStringLiteral("documents/thesis.txt"));
    QVERIFY(QDir().mkpath(path(QStringLiteral("documents"))));
    QVERIFY(QDir().mkpath(path(QStringLiteral("out"))));
    write(thesis, "mine");
    for (const QString& name : {FolderTransaction::workName(), QStringLiteral("immersion-1")}) {
        const QString link = path(QStringLiteral("out/")) + name;
        QVERIFY(QFile::link(path(QStringLiteral("documents")), link));
        const Outcome outcome = cli(
            {QStringLiteral("run"), job_, QStringLiteral("--out"), path(QStringLiteral("out"))});
        QCOMPARE(outcome.exitCode, 1);
        QVERIFY2(outcome.err.contains("in the way"), outcome.err.constData());
        QCOMPARE(contentsOf(thesis), QByteArray("mine"));
        QCOMPARE(QDir(path(QStringLiteral("documents")))
                     .entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden),
                 QStringList(QStringLiteral("thesis.txt")));
        QVERIFY(QFile::remove(link));
    }
}

void WritersTest::whatADeadWriterSeemsToHaveLeftIsNotMovedThroughLinks() {
    const QString keys = path(QStringLiteral("home/keys/allowed"));
    const QString work = path(QStringLiteral("out/")) + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(path(QStringLiteral("home/keys"))));
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new/a/keys")));
    write(keys, "mine");
    write(work + QStringLiteral("/new/a/keys/allowed"), "another's");
    write(work + QStringLiteral("/journal.json"), R"({"written":["a/keys/allowed"],"there":[]})");
    QVERIFY(QFile::link(path(QStringLiteral("home")), path(QStringLiteral("out/a"))));
    QVERIFY_EXCEPTION_THROWN(
        FolderTransaction(path(QStringLiteral("out")), {QStringLiteral("a/keys/allowed")}), Error);
    QCOMPARE(contentsOf(keys), QByteArray("mine"));
}

// Nor are files of other folders fetched by a link in the hidden one.
void WritersTest::whatADeadWriterSeemsToHaveLeftIsNoLink() {
    const QString victim = path(QStringLiteral("documents/proof.png"));
    const QString work = path(QStringLiteral("out/")) + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(path(QStringLiteral("documents"))));
    QVERIFY(QDir().mkpath(work));
    write(victim, "mine");
    for (const char* folder : {"/new", "/old"}) {
        const QString link = work + QLatin1String(folder);
        QVERIFY(QFile::link(path(QStringLiteral("documents")), link));
        write(work + QStringLiteral("/journal.json"),
              R"({"written":["proof.png"],"there":["proof.png"]})");
        QVERIFY_EXCEPTION_THROWN(
            FolderTransaction(path(QStringLiteral("out")), {QStringLiteral("proof.png")}), Error);
        QCOMPARE(contentsOf(victim), QByteArray("mine"));
        QVERIFY(!QFileInfo::exists(path(QStringLiteral("out/proof.png"))));
        QVERIFY(QFile::remove(link));
    }
}

// An unpacked archive of somebody's could hold it.
void WritersTest::aJournalOfWhatIsNoResultTouchesNothing() {
    const QString out = path(QStringLiteral("out/")), work = out + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new")));
    QVERIFY(QDir().mkpath(work + QStringLiteral("/old")));
    for (const QString& name : {QStringLiteral("thesis.odt"), QStringLiteral("proof.png")}) {
        write(out + name, "mine");
    }
    write(work + QStringLiteral("/new/.bashrc"), "another's");
    for (const QByteArray journal :
         {R"({"written":[".bashrc"],"there":["thesis.odt","proof.png"]})", "[", ""}) {
        for (const QString& name : {QStringLiteral("journal.json"), QStringLiteral("undo.json")}) {
            write(work + QLatin1Char('/') + name, journal);
            QVERIFY_EXCEPTION_THROWN(
                FolderTransaction(path(QStringLiteral("out")), {QStringLiteral("proof.png")}),
                Error);
            QCOMPARE(contentsOf(out + QStringLiteral("thesis.odt")), QByteArray("mine"));
            QCOMPARE(contentsOf(out + QStringLiteral("proof.png")), QByteArray("mine"));
            QVERIFY(!QFileInfo::exists(out + QStringLiteral(".bashrc")));
            QVERIFY(QFileInfo::exists(work + QStringLiteral("/new/.bashrc")));
            QVERIFY(QFile::remove(work + QLatin1Char('/') + name));
        }
    }
}

void WritersTest::aJournalOfNamesThatAreNoneTouchesNothing_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString();
    QTest::newRow("the folder itself") << QStringLiteral(".");
    QTest::newRow("the folder above") << QStringLiteral("..");
    QTest::newRow("a detour") << QStringLiteral("a/../proof.png");
    QTest::newRow("a path") << QStringLiteral("/proof.png");
    QTest::newRow("a file of the hidden folder") << QStringLiteral(".dipwright-results/new/a");
    QTest::newRow("deep") << QStringLiteral("a/").repeated(500'000) + QLatin1Char('a');
}

void WritersTest::aJournalOfNamesThatAreNoneTouchesNothing() {
    QFETCH(QString, name);
    const QString out = path(QStringLiteral("out/")), work = out + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new")));
    write(out + QStringLiteral("proof.png"), "mine");
    for (const QString& list : {QStringLiteral("written"), QStringLiteral("there")}) {
        const QJsonObject journal{{list, QJsonArray{name}}};
        write(work + QStringLiteral("/journal.json"), QJsonDocument(journal).toJson());
        QVERIFY(!FolderTransaction::putRight(path(QStringLiteral("out"))));
        QVERIFY_EXCEPTION_THROWN(
            FolderTransaction(path(QStringLiteral("out")), {QStringLiteral("proof.png")}), Error);
        QCOMPARE(contentsOf(out + QStringLiteral("proof.png")), QByteArray("mine"));
        QVERIFY(QFileInfo::exists(work + QStringLiteral("/journal.json")));
    }
}

// Notes of folders with such a journal, of what cannot be, and what is no note.
void WritersTest::noStartDependsOnWhatOthersLeft() {
    const QString work = path(QStringLiteral("out/")) + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work));
    write(work + QStringLiteral("/journal.json"), R"({"written":[],"there":[""]})");
    const QString home = path(QStringLiteral("data"));
    const QString notes = home + QStringLiteral("/Dipwright/dipwright/unfinished/");
    QVERIFY(QDir().mkpath(notes));
    for (int number = 0; number < 50; ++number) {
        write(notes + QStringLiteral("results-%1").arg(number),
              QJsonDocument(QJsonArray{work}).toJson());
    }
    write(notes + QStringLiteral("rubbish"), "[\"\", 3, [");
    write(notes + QStringLiteral("elsewhere"),
          QJsonDocument(
              QJsonArray{path(QStringLiteral("nowhere/.~new.a")), path(QStringLiteral("profiles"))})
              .toJson());
    QVERIFY(QDir().mkpath(path(QStringLiteral("profiles"))));
#ifdef Q_OS_UNIX
    QCOMPARE(mkfifo(QFile::encodeName(notes + QStringLiteral("pipe")).constData(), 0666), 0);
#endif
    const auto start = [&](const QStringList& arguments) {
        const Outcome outcome =
            cli(arguments, environment() + QStringList{QStringLiteral("XDG_DATA_HOME=") + home});
        QVERIFY2(outcome.exitCode == 0, outcome.err.constData());
    };
    const auto count = [&] {
        return QDir(notes).entryList(QDir::Files | QDir::System | QDir::NoDotAndDotDot).size();
    };
    const auto before = count();
    for (const char* command :
         {"--version", "--help", "run --help", "info --version", "manual man", "solvers"}) {
        start(QString::fromLatin1(command).split(QLatin1Char(' ')));
        QCOMPARE(count(), before); // nothing was looked at
    }
    start({QStringLiteral("info"), job_});
    QCOMPARE(count(), before - 2);                                // of which nothing is to be done
    QVERIFY(QFileInfo::exists(path(QStringLiteral("profiles")))); // not made for that work
}

void WritersTest::recoveryEndsWhenItIsCancelled() {
    qputenv("XDG_DATA_HOME", QFile::encodeName(path(QStringLiteral("data"))));
    const QString left = path(QStringLiteral(".~new.left"));
    write(left, "half");
    UnfinishedWrite(left).leave();
    CancelToken cancelToken;
    cancelToken.cancel();
    recoverUnfinishedWrites(cancelToken);
    QVERIFY(QFileInfo::exists(left));
    recoverUnfinishedWrites();
    qunsetenv("XDG_DATA_HOME");
    QVERIFY(!QFileInfo::exists(left));
}

void WritersTest::resultsThatWentMissingMeanwhileReplaceNothing() {
    const QString out = path(QStringLiteral("out/"));
    const QStringList names{QStringLiteral("a.txt"), QStringLiteral("b.txt")};
    QVERIFY(QDir().mkpath(out));
    write(out + names[0], "old");
    {
        FolderTransaction results(out, names);
        for (const QString& name : names) {
            results.write(name, "new");
        }
        QVERIFY(QFile::remove(out + FolderTransaction::workName() + QStringLiteral("/new/a.txt")));
        QVERIFY_EXCEPTION_THROWN(results.commit(), Error);
    }
    {
        FolderTransaction results(out, names);
        const QString work = out + FolderTransaction::workName();
        QVERIFY(QDir().rename(work + QStringLiteral("/new"), work + QStringLiteral("/away")));
        QVERIFY_EXCEPTION_THROWN(results.write(names[1], "new"), Error);
    }
    QCOMPARE(contentsOf(out + names[0]), QByteArray("old"));
    QCOMPARE(QDir(out).entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden),
             QStringList(names[0]));
}

// Killed when they are made for what is to come, and before it counts.
void WritersTest::foldersThatNothingCameIntoGo() {
    const QString out = path(QStringLiteral("out/")), work = out + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new/immersion-1")));
    QVERIFY(QDir().mkpath(out + QStringLiteral("immersion-1")));
    QVERIFY(QDir().mkpath(out + QStringLiteral("immersion-2"))); // somebody's
    write(work + QStringLiteral("/new/immersion-1/sheet.png"), "new");
    QVERIFY(FolderTransaction::putRight(path(QStringLiteral("out"))));
    QCOMPARE(QDir(out).entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden),
             QStringList(QStringLiteral("immersion-2")));
}

void WritersTest::pipesAndCirclesOfLinksAreNotReplaced() {
    const QString one = path(QStringLiteral("one")), other = path(QStringLiteral("other"));
    QVERIFY(QFile::link(one, other) && QFile::link(other, one));
    QVERIFY(!replaceFile(one, "new").isEmpty());
    QVERIFY(QFileInfo(one).isSymLink() && QFileInfo(other).isSymLink());
#ifdef Q_OS_UNIX
    const QString pipe = path(QStringLiteral("pipe"));
    QCOMPARE(mkfifo(QFile::encodeName(pipe).constData(), 0666), 0);
    QVERIFY(!replaceFile(pipe, "new").isEmpty());
    QVERIFY(QFileInfo::exists(pipe) && !QFileInfo(pipe).isFile());
#endif
}

// In a folder that several share. What one of them holds, the others may only read.
void WritersTest::whatAnotherUserHasOpenIsNotWritten() {
#ifdef Q_OS_UNIX
    constexpr int nobody = 65534;
    const auto all = QFile::Permissions(0x7777), readable = QFile::Permissions(0x4444);
    QVERIFY(QFile::setPermissions(folder_->path(), all));
    QVERIFY(QFile::setPermissions(job_, all & ~QFile::Permissions(0x1111)));
    QCOMPARE(cli({"profile", "set", "film", "Mine"}, environment()).exitCode, 0);
    const QByteArray before = contentsOf(job_);
    FileLock lock;
    QVERIFY(lock.acquire(job_).acquired);
    QVERIFY(QFile::setPermissions(path(QStringLiteral(".~lock.job.dipw")), readable));
    QProcess process; // root may write what it may only read
    process.setChildProcessModifier([] {
        if (geteuid() == 0 && (setgid(nobody) != 0 || setuid(nobody) != 0)) {
            _exit(1);
        }
    });
    QProcessEnvironment variables = QProcessEnvironment::systemEnvironment();
    variables.insert(QStringLiteral("DIPWRIGHT_PROFILE_PATH"), path(QStringLiteral("profiles")));
    variables.insert(QStringLiteral("XDG_DATA_HOME"), path(QStringLiteral("data")));
    process.setProcessEnvironment(variables);
    process.start(cliPath(), {"profile", "use", "film", "Mine", job_});
    QVERIFY(process.waitForFinished(-1));
    QCOMPARE(process.exitCode(), 1);
    const QByteArray told = process.readAllStandardError();
    QVERIFY2(told.contains("open elsewhere"), told.constData());
    QCOMPARE(contentsOf(job_), before);
#endif
}

// What it says was written by a program of ours, yet of a folder with whatever name.
void WritersTest::theNextStartRemovesNothingByTheNameOfAFolder() {
    const QString kept = path(QStringLiteral("keep")), odd = kept + QStringLiteral("\nx");
    write(kept, "mine");
    QVERIFY(QDir().mkpath(odd));
    qputenv("XDG_DATA_HOME", path(QStringLiteral("data")).toUtf8());
    {
        UnfinishedWrite note(odd + QStringLiteral("/.~new.a"), {odd});
        note.leave(); // as the dying do
    }
    UnfinishedWrite(kept).leave();
    recoverUnfinishedWrites();
    qunsetenv("XDG_DATA_HOME");
    QCOMPARE(contentsOf(kept), QByteArray("mine"));
    QVERIFY(!QFileInfo::exists(odd)); // empty, and made for what was left
}

void WritersTest::onlyWhatCanBeReadIsReplacedAsAProfile() {
    const ProfileLibrary library(path(QStringLiteral("profiles")));
    FilmProfile profile;
    profile.name = QStringLiteral("Mine");
    library.save(Profile(profile), std::nullopt);
    const std::vector<ProfileEntry> all = library.profiles(ProfileKind::Film);
    const auto mine = std::find_if(all.begin(), all.end(), [&](const ProfileEntry& entry) {
        return entry.name == profile.name;
    });
    QVERIFY(mine != all.end());
    const QString file = mine->path;
    write(file, contentsOf(file).replace('{', "{,"));
    const QByteArray before = contentsOf(file);
    const Outcome outcome =
        cli({"profile", "set", "film", "Mine", "--set", "swell=1.1;1.1"}, environment());
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains("cannot be read"), outcome.err.constData());
    QVERIFY_EXCEPTION_THROWN(library.replace(Profile(profile)), Error);
    QVERIFY(contentsOf(file) == before);
}

QTEST_GUILESS_MAIN(WritersTest)
#include "WritersTest.moc"

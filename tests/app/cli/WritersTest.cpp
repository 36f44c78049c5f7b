// Tests two programs that write the same file or folder at the same time. The second must get an
// error, and the first must lose nothing.

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
    void cli_projectOpenElsewhere_isNotWritten_data();
    void cli_projectOpenElsewhere_isNotWritten();
    void run_folderUsedByOtherRun_isRefused();
    void profileUse_twoProcessesAtOnce_loseNothing();
    void projectFile_changedMeanwhile_isNotReplaced();
    void profileLibrary_changedMeanwhile_isNotReplaced();
    void run_folderCannotTakeResults_isRefusedBeforeDip();
    void run_linkInResultsFolder_isRefused();
    void folderTransaction_linkInTarget_isNotFollowed();
    void folderTransaction_linkInHiddenFolder_isNotFollowed();
    void folderTransaction_journalOfOtherFiles_changesNothing();
    void folderTransaction_journalWithInvalidName_changesNothing_data();
    void folderTransaction_journalWithInvalidName_changesNothing();
    void programStart_foreignNotes_startsAnyway();
    void recoverUnfinishedWrites_cancelled_removesNothing();
    void folderTransaction_resultMissing_replacesNothing();
    void folderTransaction_unfilledFolder_isRemoved();
    void replaceFile_pipeOrLinkCycle_isRefused();
    void profileUse_projectOpenByOtherUser_isNotWritten();
    void recoverUnfinishedWrites_lineBreakInFolderName_keepsOtherFiles();
    void profileSet_unreadableProfile_isNotReplaced();

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

void WritersTest::cli_projectOpenElsewhere_isNotWritten_data() {
    QTest::addColumn<QString>("words");
    QTest::newRow("optimize") << "optimize JOB --immersions 1 --candidates 6";
    QTest::newRow("use") << "profile use film DIPPED JOB";
    QTest::newRow("new") << "new JOB --model " + sampleFolder("/models/sphere.obj");
}

void WritersTest::cli_projectOpenElsewhere_isNotWritten() {
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
    QCOMPARE(cli({QStringLiteral("info"), job_}).exitCode, 0); // reading is allowed
}

void WritersTest::run_folderUsedByOtherRun_isRefused() {
    const FolderTransaction other(path(QStringLiteral("out")), {QStringLiteral("proof.png")});
    const Outcome outcome =
        cli({QStringLiteral("run"), job_, QStringLiteral("--out"), path(QStringLiteral("out"))});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains("writing results to this folder"), outcome.err.constData());
}

void WritersTest::profileUse_twoProcessesAtOnce_loseNothing() {
    int refusals = 0;
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
            refusals +=
                process->exitCode() == 1 && process->readAllStandardError().startsWith("error: ")
                    ? 1
                    : 0;
        }
    }
    qInfo("%d races; in %d of them the second process got an error", races, refusals);
}

void WritersTest::projectFile_changedMeanwhile_isNotReplaced() {
    ProjectFile file(job_);
    Project mine = loadProject(job_);
    Project theirs = mine;
    theirs.film.swellX = 1.25;
    saveProject(theirs, job_); // simulates another program, without the lock
    const QByteArray before = contentsOf(job_);
    mine.film.swellX = 1.125;
    QVERIFY_EXCEPTION_THROWN(file.save(mine), ChangedFile);
    QVERIFY(contentsOf(job_) == before);
}

void WritersTest::profileLibrary_changedMeanwhile_isNotReplaced() {
    const ProfileLibrary library(path(QStringLiteral("profiles")));
    FilmProfile profile;
    profile.name = QStringLiteral("Mine");
    library.save(Profile(profile), std::nullopt);
    const auto known = library.found(ProfileKind::Film, profile.name);
    profile.swellX = 1.25;
    library.save(Profile(profile), known); // simulates another program
    profile.swellX = 1.125;
    QVERIFY_EXCEPTION_THROWN(library.save(Profile(profile), known), ChangedFile);
    QCOMPARE(std::get<FilmProfile>(*library.found(ProfileKind::Film, profile.name)).swellX, 1.25);
    library.replace(Profile(profile));
    QCOMPARE(std::get<FilmProfile>(*library.found(ProfileKind::Film, profile.name)).swellX, 1.125);
}

void WritersTest::run_folderCannotTakeResults_isRefusedBeforeDip() {
    const QString out = path(QStringLiteral("out"));
    QVERIFY(QDir().mkpath(out + QStringLiteral("/proof.png")));
    const Outcome outcome = cli({QStringLiteral("run"), job_, QStringLiteral("--out"), out});
    QCOMPARE(outcome.exitCode, 1);
    QVERIFY2(outcome.err.contains("cannot be replaced"), outcome.err.constData());
    QVERIFY2(!outcome.err.contains("Dipping"), outcome.err.constData()); // the dip has not begun
}

// Another user of a shared folder could have put the links there.
void WritersTest::run_linkInResultsFolder_isRefused() {
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
        QVERIFY2(outcome.err.contains("cannot be replaced"), outcome.err.constData());
        QCOMPARE(contentsOf(thesis), QByteArray("mine"));
        QCOMPARE(QDir(path(QStringLiteral("documents")))
                     .entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden),
                 QStringList(QStringLiteral("thesis.txt")));
        QVERIFY(QFile::remove(link));
    }
}

void WritersTest::folderTransaction_linkInTarget_isNotFollowed() {
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

// A link in the hidden folder must not bring in files from other folders.
void WritersTest::folderTransaction_linkInHiddenFolder_isNotFollowed() {
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

// The journal could come from an unpacked archive of somebody else.
void WritersTest::folderTransaction_journalOfOtherFiles_changesNothing() {
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

void WritersTest::folderTransaction_journalWithInvalidName_changesNothing_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("empty") << QString();
    QTest::newRow("the folder itself") << QStringLiteral(".");
    QTest::newRow("the folder above") << QStringLiteral("..");
    QTest::newRow("a detour") << QStringLiteral("a/../proof.png");
    QTest::newRow("a path") << QStringLiteral("/proof.png");
    QTest::newRow("a file of the hidden folder") << QStringLiteral(".dipwright-results/new/a");
    QTest::newRow("deep") << QStringLiteral("a/").repeated(500'000) + QLatin1Char('a');
}

void WritersTest::folderTransaction_journalWithInvalidName_changesNothing() {
    QFETCH(QString, name);
    const QString out = path(QStringLiteral("out/")), work = out + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new")));
    write(out + QStringLiteral("proof.png"), "mine");
    for (const QString& list : {QStringLiteral("written"), QStringLiteral("there")}) {
        const QJsonObject journal{{list, QJsonArray{name}}};
        write(work + QStringLiteral("/journal.json"), QJsonDocument(journal).toJson());
        QVERIFY(!FolderTransaction::completeTransaction(path(QStringLiteral("out"))));
        QVERIFY_EXCEPTION_THROWN(
            FolderTransaction(path(QStringLiteral("out")), {QStringLiteral("proof.png")}), Error);
        QCOMPARE(contentsOf(out + QStringLiteral("proof.png")), QByteArray("mine"));
        QVERIFY(QFileInfo::exists(work + QStringLiteral("/journal.json")));
    }
}

// The notes name folders with an invalid journal or impossible paths, or they are no valid notes.
void WritersTest::programStart_foreignNotes_startsAnyway() {
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
        QCOMPARE(count(), before); // these commands do not read notes
    }
    start({QStringLiteral("info"), job_});
    QCOMPARE(count(), before - 2); // the two notes without unfinished work are removed
    QVERIFY(QFileInfo::exists(path(QStringLiteral("profiles")))); // not created for that work
}

void WritersTest::recoverUnfinishedWrites_cancelled_removesNothing() {
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

void WritersTest::folderTransaction_resultMissing_replacesNothing() {
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

// The program is killed after it made the folders and before the results are complete.
void WritersTest::folderTransaction_unfilledFolder_isRemoved() {
    const QString out = path(QStringLiteral("out/")), work = out + FolderTransaction::workName();
    QVERIFY(QDir().mkpath(work + QStringLiteral("/new/immersion-1")));
    QVERIFY(QDir().mkpath(out + QStringLiteral("immersion-1")));
    QVERIFY(QDir().mkpath(out + QStringLiteral("immersion-2"))); // made by somebody else
    write(work + QStringLiteral("/new/immersion-1/sheet.png"), "new");
    QVERIFY(FolderTransaction::completeTransaction(path(QStringLiteral("out"))));
    QCOMPARE(QDir(out).entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::Hidden),
             QStringList(QStringLiteral("immersion-2")));
}

void WritersTest::replaceFile_pipeOrLinkCycle_isRefused() {
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

// Several users share the folder. Other users can only read the lock file of the first user.
void WritersTest::profileUse_projectOpenByOtherUser_isNotWritten() {
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
    QProcess process; // not run as root, who may write everything
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
    const QByteArray errors = process.readAllStandardError();
    QVERIFY2(errors.contains("open elsewhere"), errors.constData());
    QCOMPARE(contentsOf(job_), before);
#endif
}

// The program itself wrote the note, but the folder has an unusual name.
void WritersTest::recoverUnfinishedWrites_lineBreakInFolderName_keepsOtherFiles() {
    const QString kept = path(QStringLiteral("keep")), odd = kept + QStringLiteral("\nx");
    write(kept, "mine");
    QVERIFY(QDir().mkpath(odd));
    qputenv("XDG_DATA_HOME", path(QStringLiteral("data")).toUtf8());
    {
        UnfinishedWrite note(odd + QStringLiteral("/.~new.a"), {odd});
        note.leave(); // leaves the note as a killed program does
    }
    UnfinishedWrite(kept).leave();
    recoverUnfinishedWrites();
    qunsetenv("XDG_DATA_HOME");
    QCOMPARE(contentsOf(kept), QByteArray("mine"));
    // The folder was empty and had been made for the unfinished work.
    QVERIFY(!QFileInfo::exists(odd));
}

void WritersTest::profileSet_unreadableProfile_isNotReplaced() {
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
    QVERIFY2(outcome.err.contains("is not a readable profile"), outcome.err.constData());
    QVERIFY_EXCEPTION_THROWN(library.replace(Profile(profile)), Error);
    QVERIFY(contentsOf(file) == before);
}

QTEST_GUILESS_MAIN(WritersTest)
#include "WritersTest.moc"

// Tests the session that connects a document with its jobs, without a window: opening and
// restoring, replacing models, live runs, and messages to the user.
#include "BoxProject.h"
#include "Patience.h"
#include "base/Error.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "workbench/dip/DipSession.h"
#include "workbench/dip/LiveRun.h"
#include "workbench/document/DocumentSession.h"
#include "workbench/document/ModelImport.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/document/SnapshotEdits.h"
#include "workbench/jobs/WriteFiles.h"

#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright;

namespace {

// The session of one window, with the user's answers set in advance.
struct SessionHost {
    explicit SessionHost(const QString& recovery)
        : session(jobs, messages, recovery,
                  {[this](const Document&, const LockState&) {
                       ++timesAsked;
                       return opensLocked;
                   },
                   [this](const QString& path) { return path == openElsewhere; },
                   [this, recovery]() -> DocumentSession& {
                       other = std::make_unique<SessionHost>(recovery);
                       return other->session;
                   },
                   [this] { gaveUp = true; }}) {}

    bool waitUntilIdle() {
        return QTest::qWaitFor([this] { return !jobs.isBusy() && !session.isSaving(); },
                               patience());
    }

    Messages messages;
    JobRunner jobs;
    bool opensLocked = false;
    int timesAsked = 0;
    QString openElsewhere; // a file that another window has open
    bool gaveUp = false;
    std::unique_ptr<SessionHost> other; // the new window, if one was opened
    DocumentSession session;
};

// Writes a tetrahedron with edges of `size` along the axes. Returns its path.
QString writeModel(const QTemporaryDir& folder, double size) {
    const QString path = folder.filePath(QStringLiteral("model.obj"));
    QByteArray text = "v 0 0 0\nv S 0 0\nv 0 S 0\nv 0 0 S\n"
                      "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    text.replace("S", QByteArray::number(size));
    QFile file(path);
    if (file.open(QIODevice::WriteOnly)) {
        file.write(text);
    }
    return path;
}

std::shared_ptr<JobResult> resultOf(const Project& project) {
    auto result = std::make_shared<JobResult>();
    result->project = project;
    result->wantedSolver = result->chosenSolver = project.process.solver;
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        result->immersions.emplace_back().inputs =
            sheetInputs(project, {}, number, result->chosenSolver);
    }
    return result;
}

void setWidth(Document& document, double width) {
    document.edit({}, {}, [width](Project& project) { project.film.width = Millimetres(width); });
}

} // namespace

class SessionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        project_ = folder_->filePath(QStringLiteral("box.dipw"));
        saveProject(boxProject(), project_);
    }

    void openProject_emptyWindow_becomesDocument() {
        SessionHost host(recovery());
        QSignalSpy changed(&host.session, &DocumentSession::documentChanged);
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(changed.count(), 1);
        QCOMPARE(host.session.document()->path(), project_);
        QVERIFY(!host.session.document()->isModified());
        QCOMPARE(recentProjects().front(), project_);
    }

    void openProject_windowInUse_opensOtherWindow() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        const Document* first = host.session.document();
        const QString second = folder_->filePath(QStringLiteral("second.dipw"));
        saveProject(boxProject(), second);
        host.session.openProject(second);
        QVERIFY(host.other && host.other->waitUntilIdle());
        QCOMPARE(host.session.document(), first);
        QCOMPARE(host.other->session.document()->path(), second);
    }

    void openProject_twoAtOnce_opensBoth() {
        SessionHost host(recovery());
        const QString second = folder_->filePath(QStringLiteral("second.dipw"));
        saveProject(boxProject(), second);
        host.session.openProject(project_);
        host.session.openProject(second);
        QVERIFY(host.waitUntilIdle());
        QVERIFY(host.other && host.other->waitUntilIdle());
        QCOMPARE(host.session.document()->path(), project_);
        QCOMPARE(host.other->session.document()->path(), second);
    }

    void openCopy_project_hasNoFile() {
        SessionHost host(recovery());
        host.session.openCopy(project_);
        QVERIFY(host.waitUntilIdle());
        Document& copy = *host.session.document();
        QVERIFY(copy.path().isEmpty());
        QVERIFY(!copy.isModified()); // closing it loses nothing yet
        setWidth(copy, 123);
        QVERIFY(copy.isModified());
        copy.undoStack().undo();
        QVERIFY(!copy.isModified());
    }

    void openProject_openInOtherWindow_isNotOpenedAgain() {
        SessionHost host(recovery());
        host.openElsewhere = project_;
        host.session.openProject(project_);
        QVERIFY(!host.jobs.isBusy());
        QVERIFY(!host.session.document() && !host.other);
    }

    // As when a project is dropped twice.
    void openProject_openedElsewhereWhileReading_isNotOpenedAgain() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        host.openElsewhere = project_;
        QVERIFY(host.waitUntilIdle());
        QVERIFY(!host.session.document());
        QCOMPARE(host.timesAsked, 0);
    }

    void openProject_brokenFile_closesNewWindow() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        const QString broken = folder_->filePath(QStringLiteral("broken.dipw"));
        QVERIFY(QFile(broken).open(QIODevice::WriteOnly));
        QSignalSpy failures(&host.messages, &Messages::failed);
        host.session.openProject(broken);
        QVERIFY(host.other && host.other->waitUntilIdle());
        QCOMPARE(failures.count(), 1); // in the window where the user opened it
        QVERIFY(host.other->gaveUp);
    }

    void openProject_locked_asksFirst_data() {
        QTest::addColumn<bool>("anyway");
        QTest::newRow("cancel") << false;
        QTest::newRow("open anyway") << true;
    }
    void openProject_locked_asksFirst() {
        QFETCH(bool, anyway);
        FileLock another;
        QVERIFY(another.acquire(project_).acquired);
        SessionHost host(recovery());
        host.opensLocked = anyway;
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(host.timesAsked, 1);
        QCOMPARE(host.session.document() != nullptr, anyway);
    }

    void openProject_missingFile_reportsFailure() {
        SessionHost host(recovery());
        QSignalSpy failed(&host.messages, &Messages::failed);
        QSignalSpy logged(&host.messages, &Messages::logged);
        host.session.openProject(folder_->filePath(QStringLiteral("nowhere.dipw")));
        QVERIFY(host.waitUntilIdle());
        QVERIFY(!host.session.document());
        QCOMPARE(failed.count(), 1);
        QVERIFY(failed[0][1].toString().contains(QStringLiteral("nowhere.dipw")));
        QCOMPARE(logged[0][0].toString(), failed[0][1].toString());
    }

    void openProject_cancelledWhileReading_opensNothing() {
        SessionHost host(recovery());
        QSignalSpy failed(&host.messages, &Messages::failed);
        host.session.openProject(project_);
        host.jobs.cancelAll();
        QVERIFY(host.waitUntilIdle());
        QVERIFY(!host.session.document());
        QVERIFY(failed.isEmpty());
    }

    void restore_recoveryCopy_isModifiedAndKeptAgain() {
        QDir().mkpath(recovery());
        const QString copy = recovery() + QStringLiteral("/left.dipw");
        saveProject(boxProject(), copy);
        const auto left = findRecoveredDocuments(recovery());
        QCOMPARE(left.size(), std::size_t(1));
        SessionHost host(recovery());
        host.session.restore(left.front());
        QVERIFY(host.waitUntilIdle());
        QVERIFY(host.session.document()->isModified());
        QVERIFY(findRecoveredDocuments(recovery()).empty()); // the copy is in use
        host.session.setAutosaveInterval(0);
        setWidth(*host.session.document(), 123);
        QTRY_COMPARE_WITH_TIMEOUT(loadProject(copy).film.width.value(), 123, patience());
        QCOMPARE(QDir(recovery()).entryList({QStringLiteral("*.dipw")}).size(), 1);
        host.session.discardChanges();
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(copy), patience());
    }

    void setAutosaveInterval_copyNotWritable_isReportedOnce() {
        SessionHost host(project_ + QStringLiteral("/full")); // not writable
        QSignalSpy noticed(&host.messages, &Messages::noticed);
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        host.session.setAutosaveInterval(0);
        setWidth(*host.session.document(), 123);
        QTRY_COMPARE_WITH_TIMEOUT(noticed.count(), 1, patience());
        QVERIFY(noticed[0][0].toString().contains(QStringLiteral("Save often")));
    }

    void restore_fileChangedSinceCrash_isNotReplaced() {
        {
            Document document(loadProject(project_), project_, FileVersion::of(project_));
            AutoSaver saver(document, recovery());
            document.edit(QStringLiteral("Name"), {},
                          [](Project& project) { project.name = QStringLiteral("Mine"); });
            saver.keepNow();
            QVERIFY(saver.waitForCopy());
        }
        Project theirs = loadProject(project_);
        theirs.name = QStringLiteral("Theirs");
        saveProject(theirs, project_);
        SessionHost host(recovery());
        host.session.restore(findRecoveredDocuments(recovery()).front());
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(host.session.document()->project().name, QStringLiteral("Mine"));
        QSignalSpy changed(&host.session, &DocumentSession::fileWasChanged);
        host.session.save();
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(changed.count(), 1);
        QCOMPARE(loadProject(project_).name, QStringLiteral("Theirs"));
        host.session.discardChanges();
    }

    void saveAs_path_isReported() {
        SessionHost host(recovery());
        host.session.openCopy(project_);
        QVERIFY(host.waitUntilIdle());
        QSignalSpy saved(&host.session, &DocumentSession::saved);
        const QString path = folder_->filePath(QStringLiteral("saved.dipw"));
        host.session.saveAs(path);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(saved.count(), 1);
        QCOMPARE(saved[0][0].toString(), path);
        QVERIFY(!host.session.document()->isModified());
        QSignalSpy failed(&host.messages, &Messages::failed);
        host.session.saveAs(QStringLiteral("/no/such/folder/a.dipw"));
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(failed.count(), 1);
        QCOMPARE(host.session.document()->path(), path);
        QVERIFY(!host.session.document()->isModified());
    }

    // A save works on its own thread, so that these edits are made while it runs.
    void save_editedMeanwhile_fileHasSnapshot() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        Document& document = *host.session.document();
        setWidth(document, 111);
        host.session.save();
        QVERIFY(host.session.isSaving() && document.isModified());
        setWidth(document, 122);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(loadProject(project_).film.width.value(), 111);
        QCOMPARE(document.project().film.width.value(), 122);
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(!document.isModified());
    }

    void save_twice_secondStateIsSavedLast() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        const QString path = folder_->filePath(QStringLiteral("second.dipw"));
        setWidth(*host.session.document(), 111);
        host.session.saveAs(path);
        setWidth(*host.session.document(), 122);
        host.session.save();
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(host.session.document()->path(), path);
        QCOMPARE(loadProject(path).film.width.value(), 122);
        QCOMPARE(loadProject(project_).film.width.value(), 210);
        QVERIFY(!host.session.document()->isModified());
    }

    void cancelSave_beforeItsEnd_keepsOldFile() {
        SessionHost host(recovery());
        host.session.openProject(project_);
        QVERIFY(host.waitUntilIdle());
        Document& document = *host.session.document();
        QSignalSpy failed(&host.messages, &Messages::failed);
        setWidth(document, 111);
        host.session.save();
        host.session.cancelSave();
        QVERIFY(host.waitUntilIdle());
        const double saved = loadProject(project_).film.width.value();
        QVERIFY(saved == 210 || saved == 111); // the save may have ended before
        QCOMPARE(document.isModified(), saved == 210);
        QVERIFY(failed.isEmpty());
        setWidth(document, 122);
        host.session.save();
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(loadProject(project_).film.width.value(), 122);
    }

    void importModel_implausibleSize_isReported_data() {
        QTest::addColumn<double>("size");
        QTest::addColumn<int>("reports");
        QTest::newRow("tiny") << 1.0 << 1;
        QTest::newRow("usual") << 80.0 << 0;
        QTest::newRow("huge") << 5000.0 << 1;
    }
    void importModel_implausibleSize_isReported() {
        QFETCH(double, size);
        SessionHost host(recovery());
        QSignalSpy reported(&host.session, &DocumentSession::implausibleLengthFound);
        host.session.importModel(writeModel(*folder_, size), {},
                                 [](Project& project) { project.film.width = Millimetres(150); });
        QVERIFY(host.waitUntilIdle());
        QVERIFY(host.session.document());
        QCOMPARE(host.session.document()->project().name, QStringLiteral("model"));
        QCOMPARE(host.session.document()->project().film.width.value(), 150);
        QTEST(int(reported.count()), "reports");
    }

    void reloadAndReplaceModel_pose_isKeptOnlyByReload() {
        SessionHost host(recovery());
        host.session.importModel(writeModel(*folder_, 80), {});
        QVERIFY(host.waitUntilIdle());
        Document& document = *host.session.document();
        document.edit({}, {}, [](Project& project) {
            project.immersions[0].rotation[1] = Degrees(25);
            project.immersions[0].name = QStringLiteral("Bow");
        });
        const auto before = document.project().model;
        reloadModel(document, host.jobs, host.messages);
        QVERIFY(host.waitUntilIdle());
        QVERIFY(document.project().model != before);
        QCOMPARE(document.project().immersions[0].rotation[1].value(), 25);
        replaceModel(document, writeModel(*folder_, 60), host.jobs, host.messages);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(document.project().immersions[0].rotation[1].value(), 0);
        QCOMPARE(document.project().immersions[0].name, QStringLiteral("Bow"));
        document.undoStack().undo();
        document.undoStack().undo();
        QVERIFY(document.project().model == before);
    }

    void importModel_filesOutsideFolder_asksFirst() {
        SessionHost host(recovery());
        const QString model = writeModel(*folder_, 80);
        QVERIFY(QDir(folder_->path()).mkdir("in"));
        QFile picture(folder_->filePath("key.png"));
        QVERIFY(picture.open(QIODevice::WriteOnly));
        picture.close();
        QImage(2, 2, QImage::Format_RGB32).save(picture.fileName());
        QFile names(folder_->filePath("in/names.mtl"));
        QVERIFY(names.open(QIODevice::WriteOnly));
        names.write("newmtl a\nmap_Kd ../key.png\n");
        names.close();
        QFile text(model);
        QVERIFY(text.open(QIODevice::ReadOnly));
        QFile naming(folder_->filePath("in/names.obj"));
        QVERIFY(naming.open(QIODevice::WriteOnly));
        naming.write("mtllib names.mtl\nusemtl a\n" + text.readAll());
        naming.close();

        QStringList asked;
        std::function<void()> allow;
        connect(&host.messages, &Messages::askedToRead, this,
                [&](const QString&, const QString&, const QStringList& files,
                    const std::function<void()>& allowed) {
                    asked = files;
                    allow = allowed;
                });
        host.session.importModel(naming.fileName(), {});
        QVERIFY(host.waitUntilIdle());
        QVERIFY(!host.session.document());
        QCOMPARE(asked.size(), 1);
        QCOMPARE(QFileInfo(asked.first()).canonicalFilePath(),
                 QFileInfo(picture.fileName()).canonicalFilePath());
        allow();
        QVERIFY(host.waitUntilIdle());
        QVERIFY(host.session.document());
    }

    // A stranger's project may name a private file, which would be saved inside the project.
    void reloadModel_projectOfStranger_asksFirst() {
        SessionHost host(recovery());
        Project project = boxProject();
        project.modelOrigin.source = writeModel(*folder_, 80);
        const QString file = folder_->filePath("stranger.dipw");
        saveProject(project, file);
        Document document(loadProject(file), file);
        const auto before = document.project().model;
        QStringList asked;
        std::function<void()> allow;
        connect(&host.messages, &Messages::askedToRead, this,
                [&](const QString&, const QString&, const QStringList& files,
                    const std::function<void()>& allowed) {
                    asked += files;
                    allow = allowed;
                });
        reloadModel(document, host.jobs, host.messages);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(asked, QStringList(project.modelOrigin.source));
        QVERIFY(document.project().model == before);
        allow();
        QVERIFY(host.waitUntilIdle());
        QVERIFY(document.project().model != before);
        reloadModel(document, host.jobs, host.messages);
        QVERIFY(host.waitUntilIdle());
        QCOMPARE(asked.size(), 1); // not asked again
    }

    void liveRun_changesAfterResult_runOnce() {
        Document document(boxProject());
        LiveRun live;
        live.setDocument(&document);
        live.setWanted(true);
        QSignalSpy asked(&live, &LiveRun::runAsked);
        setWidth(document, 200); // no result yet, so nothing runs
        document.setResult(resultOf(document.project()));
        setWidth(document, 190);
        setWidth(document, 180);
        QVERIFY(asked.wait(patience()));
        QCOMPARE(asked.count(), 1); // one run for both changes
        setWidth(document, 185);
        live.begin(); // the requested run
        live.setWanted(false);
        setWidth(document, 170);
        QVERIFY(!asked.wait(800));
    }

    void liveRun_afterCancel_waitsForSheetChange() {
        Document document(boxProject());
        LiveRun live;
        live.setDocument(&document);
        live.setWanted(true);
        document.setResult(resultOf(document.project()));
        QSignalSpy asked(&live, &LiveRun::runAsked);
        setWidth(document, 190);
        live.cancel();
        takeSnapshot(document, QStringLiteral("Before lunch"));
        live.setHeld(true);
        live.setHeld(false); // held, but not turned
        QVERIFY(!asked.wait(800));
        setWidth(document, 180);
        QVERIFY(asked.wait(patience()));
    }

    void liveRun_bodyHeld_asksForDraftsThenForRun() {
        Document document(boxProject());
        document.setResult(resultOf(document.project()));
        LiveRun live;
        live.setDocument(&document);
        live.setWanted(true);
        QSignalSpy asked(&live, &LiveRun::runAsked);
        live.setHeld(true);
        setWidth(document, 190);
        QVERIFY(asked.wait(patience()));
        QVERIFY(live.isHeld());
        live.setHeld(false); // released without a further change
        QVERIFY(asked.wait(patience()));
        QVERIFY(!live.isHeld());
    }

    void liveRun_firstRunCancelled_followsNextChange() {
        Document document(boxProject());
        LiveRun live;
        live.setDocument(&document);
        live.setWanted(true);
        QSignalSpy asked(&live, &LiveRun::runAsked);
        live.begin();
        live.cancel(); // there is no result yet
        setWidth(document, 190);
        QVERIFY(asked.wait(patience()));
    }

    void dipSession_dipRemoved_showsFirstDip() {
        const SolverRegistry registry;
        JobRunner jobs;
        DipSession session(jobs, registry);
        Project project = boxProject();
        project.immersions.resize(2);
        Document document(project);
        session.setDocument(&document);
        QSignalSpy changed(&session, &DipSession::immersionChanged);
        session.lookAt(5);
        QCOMPARE(session.immersion(), std::size_t(0));
        session.lookAt(1);
        session.lookAt(1);
        QCOMPARE(changed.count(), 1);
        document.edit({}, {}, [](Project& edited) { edited.immersions.pop_back(); });
        QCOMPARE(session.immersion(), std::size_t(0));
        session.setDocument(nullptr);
    }

    void writeFiles_doneOrFailed_isReported() {
        Messages messages;
        JobRunner jobs;
        QSignalSpy said(&messages, &Messages::said);
        QSignalSpy failed(&messages, &Messages::failed);
        const QString path = folder_->filePath(QStringLiteral("note.txt"));
        writeFiles(jobs, messages, QStringLiteral("Write"), QStringLiteral("Wrote %1"), path,
                   [](const QString& target, const Progress&) {
                       QFile file(target);
                       QVERIFY(file.open(QIODevice::WriteOnly));
                   });
        writeFiles(jobs, messages, QStringLiteral("Fail"), QStringLiteral("Wrote %1"), path,
                   [](const QString& target, const Progress&) {
                       throw Error(QStringLiteral("The disk is full"), target);
                   });
        QVERIFY(QTest::qWaitFor([&] { return !jobs.isBusy(); }, patience()));
        QVERIFY(QFile::exists(path));
        QCOMPARE(said.count(), 1);
        QVERIFY(said[0][0].toString().contains(QStringLiteral("note.txt")));
        QCOMPARE(failed.count(), 1);
        QCOMPARE(failed[0][0].toString(), QStringLiteral("Fail"));
    }

private:
    QString recovery() const { return folder_->filePath(QStringLiteral("recovery")); }

    std::unique_ptr<QTemporaryDir> folder_;
    QString project_;
};

QTEST_GUILESS_MAIN(SessionTest)
#include "SessionTest.moc"

// Tests the document without a window: undo, freshness, file, lock and recovery.
#include "workbench/document/Document.h"
#include "BoxProject.h"
#include "SaveNow.h"
#include "disk/FileLock.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "project/Schema.h"
#include "workbench/document/ImmersionEdits.h"
#include "workbench/document/MarkEdits.h"
#include "workbench/document/ModelEdits.h"
#include "workbench/document/ProjectValue.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/document/Recovery.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright;

namespace {

void setWidth(Document& document, const char* key, double width) {
    document.edit(QStringLiteral("Width"), QLatin1String(key),
                  [width](Project& project) { project.film.width = Millimetres(width); });
}

void dragWidth(Document& document, double width) {
    document.drag(QStringLiteral("Drag"),
                  [width](Project& project) { project.film.width = Millimetres(width); });
}

double width(const Document& document) {
    return document.project().film.width.value();
}

// Returns the result of a run on the solver that "auto" chose, with only the data for freshness.
std::shared_ptr<const JobResult> resultOf(const Project& project) {
    auto result = std::make_shared<JobResult>();
    result->project = project;
    result->wantedSolver = project.process.solver;
    result->chosenSolver = QStringLiteral("pbd-cpu");
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        result->immersions.emplace_back().inputs =
            sheetInputs(project, {}, number, result->chosenSolver);
    }
    return result;
}

QByteArray contentsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Saves the document and overwrites changes by others, like the window after "Overwrite".
void saveAnyway(Document& document, const QString& path) {
    try {
        saveNow(document);
    } catch (const ChangedFile&) {
        saveNow(document, path);
    }
}

} // namespace

class DocumentTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QStandardPaths::setTestModeEnabled(true); }

    void addMark_fullProject_isRefused() {
        Project project = boxProject();
        project.masks.resize(mostMaskMarks);
        Document document(project);
        QVERIFY_EXCEPTION_THROWN(addMark(document, MaskMark(), {}), Error);
        QVERIFY_EXCEPTION_THROWN(addStrokes(document, MaskMark(), {BrushPath(3)}), Error);
        QCOMPARE(document.project().masks.size(), mostMaskMarks);
        QCOMPARE(document.undoStack().count(), 0);
        removeLastMark<MaskMark>(document);
        addMark(document, MaskMark(), {});
        QCOMPARE(document.project().masks.size(), mostMaskMarks);
    }

    void undoRedo_edit_restoresValues() {
        Document document(boxProject());
        setWidth(document, "", 100);
        document.undoStack().undo();
        QCOMPARE(width(document), 210);
        document.undoStack().redo();
        QCOMPARE(width(document), 100);
    }

    void edit_draggedSlider_isOneUndoStep() {
        Document document(boxProject());
        for (const double value : {200.0, 190.0, 180.0}) {
            setWidth(document, "width", value);
        }
        QCOMPARE(document.undoStack().count(), 1);
        document.endMerge();
        setWidth(document, "width", 170);
        QCOMPARE(document.undoStack().count(), 2);
        document.undoStack().undo();
        QCOMPARE(width(document), 180);
        document.undoStack().undo();
        QCOMPARE(width(document), 210);
    }

    void edit_sameValue_isNoUndoStep() {
        Document document(boxProject());
        QSignalSpy changed(&document, &Document::projectChanged);
        setWidth(document, "", 210);
        QCOMPARE(document.undoStack().count(), 0);
        QCOMPARE(changed.count(), 0);
    }

    void edit_dragBackToStart_isNoUndoStep() {
        Document document(boxProject());
        setWidth(document, "width", 200);
        setWidth(document, "width", 210);
        QCOMPARE(document.undoStack().count(), 0);
        QCOMPARE(width(document), 210);
    }

    void drag_toAnotherValue_isOneUndoStep() {
        Document document(boxProject());
        QSignalSpy changed(&document, &Document::projectChanged);
        for (const double width : {100, 110, 120}) {
            dragWidth(document, width);
        }
        QCOMPARE(changed.count(), 3);
        document.endDrag();
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Drag"));
        document.undoStack().undo();
        QCOMPARE(width(document), 210.0);
        document.undoStack().redo();
        QCOMPARE(width(document), 120.0);
    }

    void drag_backToStart_keepsUndoAndRedo() {
        const QTemporaryDir folder;
        Document document(boxProject());
        saveNow(document, folder.filePath(QStringLiteral("box.dipw")));
        setWidth(document, "", 100);
        document.undoStack().undo();
        dragWidth(document, 120);
        QVERIFY(document.isModified());
        dragWidth(document, 210);
        QSignalSpy fileChanged(&document, &Document::fileChanged); // a recovery copy is discarded
        document.endDrag();
        QCOMPARE(fileChanged.count(), 1);
        QVERIFY(!document.isModified());
        QCOMPARE(document.undoStack().count(), 1);
        document.undoStack().redo();
        QCOMPARE(width(document), 100.0);
    }

    void drag_otherEditMeanwhile_keepsBothSteps() {
        Document document(boxProject());
        dragWidth(document, 120);
        document.edit({}, {}, [](Project& project) { project.name = QStringLiteral("Other"); });
        document.undoStack().undo();
        QCOMPARE(width(document), 120.0);
        document.undoStack().undo();
        QCOMPARE(width(document), 210.0);
    }

    void edit_refusedValue_leavesProjectUnchanged() {
        Document document(boxProject());
        const Project before = document.project();
        QVERIFY_EXCEPTION_THROWN(document.edit({}, {},
                                               [](Project& project) {
                                                   setValueAt(project, QStringLiteral("film.swell"),
                                                              QJsonValue(9));
                                               }),
                                 std::exception);
        QVERIFY(document.project() == before);
        QCOMPARE(document.undoStack().count(), 0);
    }

    void projectValue_everySchemaField_canBeReadAndWritten() {
        Project project = boxProject();
        for (const auto& field : projectFields()) {
            const QJsonValue value = valueAt(project, field.path);
            QVERIFY2(!value.isUndefined(), qPrintable(field.path));
            setValueAt(project, field.path, value);
        }
        setValueAt(project, QStringLiteral("immersions[0].name"), QStringLiteral("Bow"));
        QCOMPARE(project.immersions[0].name, QStringLiteral("Bow"));
        QVERIFY(valueAt(project, QStringLiteral("immersions[1].name")).isUndefined());
    }

    void isFresh_changedValue_onlyDependentStepsAreStale_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("value");
        QTest::addColumn<bool>("dip");
        QTest::addColumn<bool>("texture");
        QTest::addColumn<bool>("sheet");
        QTest::newRow("rotation") << "immersions[0].rotation_deg"
                                  << "0;10;0" << true << true << true;
        QTest::newRow("swell") << "film.swell"
                               << "1.1x1.1" << true << true << true;
        QTest::newRow("ink limit") << "ink.limit"
                                   << "1.5" << false << true << true;
        QTest::newRow("bleed") << "sheet.bleed_mm"
                               << "4" << false << true << true;
        QTest::newRow("marks") << "sheet.marks"
                               << "false" << false << false << true;
        QTest::newRow("name") << "immersions[0].name"
                              << "Bow" << false << false << true;
        // The job number counts the verdict's limits, and the verdict depends on them.
        QTest::newRow("limit of the verdict") << "verdict.pale"
                                              << "0.01" << false << false << true;
        QTest::newRow("the solver that auto chose") << "process.solver"
                                                    << "pbd-cpu" << false << false << false;
        QTest::newRow("another solver") << "process.solver"
                                        << "pbd-cuda" << true << true << true;
        QTest::newRow("distance field") << "body.sdf_resolution"
                                        << "256" << true << true << true;
        QTest::newRow("resolution") << "sheet.dpi"
                                    << "200" << false << true << true;
        QTest::newRow("other dip") << "immersions[1].offset_mm"
                                   << "3;4" << false << true << true;
        QTest::newRow("overlap") << "share.overlap_mm"
                                 << "3" << false << true << true;
    }
    void isFresh_changedValue_onlyDependentStepsAreStale() {
        QFETCH(QString, path);
        QFETCH(QString, value);
        Project before = boxProject();
        before.immersions.push_back(Immersion{});
        Project now = before;
        setByPath(now, path, value);
        Document document(now);
        document.setResult(resultOf(before));
        QTEST(!document.isFresh(JobStep::Dip, 0), "dip");
        QTEST(!document.isFresh(JobStep::Texture, 0), "texture");
        QTEST(!document.isFresh(JobStep::Sheet, 0), "sheet");
    }

    void addImmersion_secondDip_comesFromOtherSide() {
        Document document(boxProject());
        document.edit({}, {}, [](Project& project) {
            project.immersions[0].rotation = {Degrees(30), Degrees(10), Degrees(0)};
        });
        addImmersion(document);
        QCOMPARE(document.project().immersions.size(), std::size_t(2));
        QCOMPARE(document.project().immersions[1].rotation[0].value(), -150);
        QCOMPARE(document.project().immersions[1].rotation[1].value(), 10);
        removeImmersion(document, 0);
        QCOMPARE(document.project().immersions.size(), std::size_t(1));
        QCOMPARE(document.project().immersions[0].rotation[0].value(), -150);
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.project().immersions.size(), std::size_t(1));
        QCOMPARE(document.project().immersions[0].rotation[0].value(), 30);
    }

    void resizeModel_withMarks_scalesMarks() {
        Project project = boxProject();
        ShareMark mark;
        mark.place = {Millimetres(1), Millimetres(-2), Millimetres(3)};
        project.share.marks = {mark};
        MaskMark mask;
        mask.path = {{mark.place, {0, 0, 1}}};
        project.masks = {mask};
        const double edge = longestEdgeOf(project.model->mesh);
        const double unit = project.modelOrigin.unitMillimetres;
        Document document(project);
        resizeModel(document, Millimetres(1.5 * edge));
        resizeModel(document, Millimetres(2 * edge)); // merges with the change before
        QVERIFY(std::abs(longestEdgeOf(document.project().model->mesh) - 2 * edge) < 1e-4 * edge);
        QVERIFY(std::abs(document.project().modelOrigin.unitMillimetres - 2 * unit) < 1e-6);
        QVERIFY(std::abs(document.project().share.marks[0].place[1].value() + 4) < 1e-6);
        QVERIFY(std::abs(document.project().masks[0].path[0].place[1].value() + 4) < 1e-6);
        QVERIFY(std::abs(document.project().masks[0].radius.value() - 10) < 1e-6);
        document.undoStack().undo();
        QCOMPARE(document.project(), project);
    }

    void resizeModel_ofACadFile_scalesTheTolerance() {
        Project project = boxProject();
        project.cad.name = QStringLiteral("box.step");
        project.modelOrigin.tessellation = Millimetres(0.02);
        const double edge = longestEdgeOf(project.model->mesh);
        Document document(project);
        resizeModel(document, Millimetres(2 * edge));
        QVERIFY(std::abs(document.project().modelOrigin.tessellation.value() - 0.04) < 1e-6);
        document.undoStack().undo();
        QCOMPARE(document.project(), project);
    }

    void freshness_inkChanged_onlyDipStaysFresh() {
        Document document(boxProject());
        QVERIFY(document.freshness(0) == Freshness({false, false, false}));
        document.setResult(resultOf(document.project()));
        QVERIFY(document.freshness(0) == Freshness({true, true, true}));
        document.edit({}, {}, [](Project& project) { project.ink.limit = 1.5; });
        QVERIFY(document.freshness(0) == Freshness({true, false, false}));
        document.undoStack().undo();
        QVERIFY(document.freshness(0) == Freshness({true, true, true}));
        QVERIFY(document.freshness(1) == Freshness({false, false, false})); // no second dip
    }

    void isFresh_dipRemoved_resultIsStale() {
        Project project = boxProject();
        project.immersions.resize(2);
        project.share.enabled = false; // so the dips are independent
        Document document(project);
        document.setResult(resultOf(project));
        QVERIFY(document.isFresh());
        removeImmersion(document, 1);
        QVERIFY(document.freshness(0) == Freshness({true, true, true}));
        QVERIFY(!document.isFresh()); // its verdict is also about the removed dip
        document.undoStack().undo();
        QVERIFY(document.isFresh());
    }

    void saveAs_newFile_documentIsUnmodified() {
        const QTemporaryDir folder;
        Document document(boxProject());
        QVERIFY(document.isModified()); // it has no file
        saveNow(document, folder.filePath(QStringLiteral("box.dipw")));
        QVERIFY(!document.isModified());
        QCOMPARE(document.title(), QStringLiteral("box"));
        setWidth(document, "", 100);
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(!document.isModified());
    }

    void checkFile_fileDeleted_documentIsModifiedUntilSaved() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("box.dipw"));
        Document document(boxProject());
        document.checkFile();
        QVERIFY(!document.isFileMissing()); // it has none yet
        saveNow(document, file);
        QVERIFY(QFile::remove(file));
        QSignalSpy changed(&document, &Document::fileChanged);
        document.checkFile();
        document.checkFile();
        QCOMPARE(changed.count(), 1);
        QVERIFY(document.isFileMissing() && document.isModified());
        saveNow(document);
        QVERIFY(QFile::exists(file));
        QVERIFY(!document.isFileMissing() && !document.isModified());
    }

    void saveAs_folderMissing_documentStaysModified() {
        Document document(boxProject());
        QVERIFY_EXCEPTION_THROWN(saveNow(document, QStringLiteral("/no/such/folder/box.dipw")),
                                 std::exception);
        QVERIFY(document.isModified());
        QVERIFY(document.path().isEmpty());
    }

    void dropSave_cancelledWhilePacking_keepsFileAndChanges() {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("box.dipw"));
        Document document(boxProject());
        saveNow(document, file);
        const QByteArray saved = contentsOf(file);
        setWidth(document, "", 123);
        const DocumentSnapshot snapshot = document.beginSave();
        Progress progress;
        progress.report = [&](double, const QString&) { progress.cancelToken.cancel(); };
        QVERIFY_EXCEPTION_THROWN(snapshot.write(progress), Cancelled);
        document.dropSave(snapshot);
        QCOMPARE(contentsOf(file), saved);
        QVERIFY(document.isModified());
        saveNow(document);
        QVERIFY(!document.isModified());
        QCOMPARE(loadProject(file).film.width.value(), 123);
    }

    // A network folder vanishes and comes back, unchanged or empty.
    void save_folderVanished_losesNothing() {
        const QTemporaryDir folder;
        const QString place = folder.filePath(QStringLiteral("server"));
        const QString away = folder.filePath(QStringLiteral("away"));
        const QString file = place + QStringLiteral("/job.dipw");
        QVERIFY(QDir().mkpath(place));
        Document document(boxProject());
        saveNow(document, file);
        AutoSaver saver(document, folder.filePath(QStringLiteral("recovery")));
        setWidth(document, "", 123);
        QVERIFY(QDir().rename(place, away));
        QVERIFY_EXCEPTION_THROWN(saveNow(document), Error);
        QVERIFY(document.isModified());
        saver.keepNow();
        QVERIFY(saver.waitForCopy());
        QCOMPARE(
            QDir(folder.filePath(QStringLiteral("recovery")), QStringLiteral("*.dipw")).count(),
            1u);
        QVERIFY(QDir().rename(away, place));
        QCOMPARE(loadProject(file).film.width.value(), 210);
        saveNow(document);
        QVERIFY(!document.isModified());
        QCOMPARE(loadProject(file).film.width.value(), 123);

        setWidth(document, "", 150);
        QVERIFY(QDir(place).removeRecursively());
        QVERIFY(QDir().mkpath(place));
        saveAnyway(document, file);
        QCOMPARE(loadProject(file).film.width.value(), 150);
    }

    // Clocks may be wrong, so recovery copies are found by their names alone.
    void findRecoveredDocuments_anyClock_findsCopy_data() {
        QTest::addColumn<QDate>("day");
        QTest::newRow("in 1970") << QDate(1970, 1, 2);
        QTest::newRow("before the project was saved") << QDate(2001, 2, 3);
        QTest::newRow("in the future") << QDate(2099, 12, 31);
    }
    void findRecoveredDocuments_anyClock_findsCopy() {
        QFETCH(QDate, day);
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("job.dipw"));
        const QString kept = folder.filePath(QStringLiteral("recovery"));
        Document document(boxProject());
        saveNow(document, file);
        const QByteArray saved = contentsOf(file);
        auto saver = std::make_unique<AutoSaver>(document, kept);
        setWidth(document, "", 123);
        saver->keepNow();
        QVERIFY(saver->waitForCopy());
        // A crash leaves the recovery files without their lock. Imitates this by copying them.
        const QString left = folder.filePath(QStringLiteral("left"));
        QVERIFY(QDir().mkpath(left));
        for (const QFileInfo& each : QDir(kept).entryInfoList(QDir::Files)) {
            QVERIFY(QFile::copy(each.filePath(), left + QLatin1Char('/') + each.fileName()));
            QFile copy(left + QLatin1Char('/') + each.fileName());
            QVERIFY(copy.open(QIODevice::ReadWrite));
            QVERIFY(copy.setFileTime(day.startOfDay(), QFileDevice::FileModificationTime));
        }
        const auto found = findRecoveredDocuments(left);
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found.front().original, file);
        QCOMPARE(loadProject(found.front().copy).film.width.value(), 123);
        QCOMPARE(contentsOf(file), saved);
    }

    void fileLock_projectOpen_refusesOthers() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("box.dipw"));
        FileLock mine, other;
        QVERIFY(mine.acquire(path).acquired);
        const LockState state = other.acquire(path);
        QVERIFY(!state.acquired);
        QCOMPARE(state.process, QCoreApplication::applicationPid());
        QVERIFY(mine.acquire({}).acquired); // releases the lock
        QVERIFY(other.acquire(path).acquired);
    }

    void save_changedByOther_isRefused() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("box.dipw"));
        Document document(boxProject());
        saveNow(document, path);
        setWidth(document, "", 123);
        saveNow(document); // may overwrite the file, because only this document has changed it
        Project theirs = boxProject();
        theirs.name = QStringLiteral("Theirs");
        saveProject(theirs, path);
        setWidth(document, "", 124);
        QVERIFY_EXCEPTION_THROWN(saveNow(document), ChangedFile);
        QVERIFY(document.isModified());
        QCOMPARE(loadProject(path).name, QStringLiteral("Theirs"));
        saveNow(document, path); // the user chose to overwrite
        QCOMPARE(loadProject(path).film.width.value(), 124.0);
        setWidth(document, "", 125);
        saveNow(document);
        Document other(boxProject());
        QVERIFY_EXCEPTION_THROWN(saveNow(other, path), Error); // the other document has it open
    }

    void fileLock_leftByCrash_isTakenOver() {
        const QTemporaryDir folder;
        QFile stale(folder.filePath(QStringLiteral(".~lock.box.dipw")));
        QVERIFY(stale.open(QIODevice::WriteOnly));
        // The content of a lock of QLockFile: process, program and machine.
        stale.write("2147483000\ndipwright\n" + QSysInfo::machineHostName().toLocal8Bit() + "\n");
        stale.close();
        FileLock lock;
        QVERIFY(lock.acquire(folder.filePath(QStringLiteral("box.dipw"))).acquired);
    }

    void findRecoveredDocuments_afterCrashOnly_findsCopy() {
        const QTemporaryDir folder;
        Document document(boxProject());
        {
            AutoSaver saver(document, folder.path());
            setWidth(document, "", 123);
            saver.keepNow();
            QVERIFY(saver.waitForCopy());
            QVERIFY(
                findRecoveredDocuments(folder.path()).empty()); // this process still has it open
        }
        const auto found = findRecoveredDocuments(folder.path()); // as after a crash
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].name, QStringLiteral("Box"));
        QVERIFY(found[0].original.isEmpty());
        QCOMPARE(loadProject(found[0].copy).film.width.value(), 123);
        discardRecovered(found[0]);
        QVERIFY(findRecoveredDocuments(folder.path()).empty());
    }

    void saveAs_recoveryCopy_isRemoved() {
        const QTemporaryDir folder;
        Document document(boxProject());
        {
            AutoSaver saver(document, folder.filePath(QStringLiteral("recovery")));
            saver.keepNow();
            QVERIFY(saver.waitForCopy());
            saveNow(document, folder.filePath(QStringLiteral("box.dipw")));
        }
        QVERIFY(findRecoveredDocuments(folder.filePath(QStringLiteral("recovery"))).empty());
    }

    void recentProjects_openedAgain_comesFirst() {
        addRecentProject(QStringLiteral("/a/one.dipw"));
        addRecentProject(QStringLiteral("/a/two.dipw"));
        addRecentProject(QStringLiteral("/a/one.dipw"));
        QCOMPARE(recentProjects().mid(0, 2),
                 QStringList({QStringLiteral("/a/one.dipw"), QStringLiteral("/a/two.dipw")}));
        forgetRecentProject(QStringLiteral("/a/one.dipw"));
        QVERIFY(!recentProjects().contains(QStringLiteral("/a/one.dipw")));
    }
};

QTEST_GUILESS_MAIN(DocumentTest)
#include "DocumentTest.moc"

// Kills the program while a project is edited. The next start must restore the work.
//
// With --edit FOLDER MODEL, this program is the one that is killed. It edits an untitled project
// and prints "kept" when its recovery copy is on the disk.
#include "BoxProject.h"
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "project/ProjectStore.h"
#include "workbench/document/Recovery.h"

#include <QApplication>
#include <QDir>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <cstdio>

using namespace dipwright;

namespace {

constexpr double editedSwell = 1.125;

bool isKept(const QString& folder) {
    const QDir copies(folder, QStringLiteral("*.dipw"));
    return copies.count() == 1 &&
           loadProject(copies.filePath(copies[0])).film.swellX == editedSwell;
}

QList<MainWindow*> windows() {
    QList<MainWindow*> found;
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* window = qobject_cast<MainWindow*>(widget)) {
            found << window;
        }
    }
    return found;
}

// Answers every question with Restore.
void restoreAll(Workbench& workbench) {
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [] {
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            auto* box = qobject_cast<QMessageBox*>(widget);
            if (box && box->objectName() == QLatin1String("recoveryQuestion")) {
                box->defaultButton()->click();
            }
        }
    });
    answer.start(20);
    workbench.offerRecovery();
}

int editUntilKilled(const QString& folder, const QString& model) {
    Workbench workbench(folder);
    Preferences preferences = workbench.preferences();
    preferences.autosaveSeconds = 1;
    workbench.setPreferences(preferences);
    MainWindow window(workbench);
    window.show();
    WindowDriver driver(window);
    if (!driver.create(model, {}, 90, {})) {
        return 1;
    }
    window.document()->edit(QStringLiteral("Width"), {},
                            [](Project& project) { project.film.swellX = editedSwell; });
    while (!isKept(folder)) {
        QTest::qWait(50);
    }
    std::puts("kept");
    std::fflush(stdout);
    return QApplication::exec();
}

} // namespace

class CrashTest : public QObject {
    Q_OBJECT

private slots:
    void recovery_programKilled_restoresWork() {
        const QTemporaryDir folder;
        const QString model = sampleFolder("/models/turtle.obj");
        QProcess editor;
        editor.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        editor.start(QApplication::applicationFilePath(),
                     {QStringLiteral("--edit"), folder.path(), model});
        QVERIFY(editor.waitForStarted());
        QByteArray said;
        while (!said.contains("kept") && editor.waitForReadyRead(patience())) {
            said += editor.readAllStandardOutput();
        }
        QVERIFY(said.contains("kept"));
        // While the process lives, nobody else may recover its copy.
        QVERIFY(findRecoveredDocuments(folder.path()).empty());
        editor.kill();
        QVERIFY(editor.waitForFinished(patience()));
        QCOMPARE(editor.exitStatus(), QProcess::CrashExit);

        Workbench workbench(folder.path());
        restoreAll(workbench);
        QCOMPARE(windows().size(), 1);
        MainWindow* restored = windows().front();
        QTRY_VERIFY(restored->document() != nullptr);
        QCOMPARE(restored->document()->project().film.swellX, editedSwell);
        QVERIFY(restored->document()->isModified());
        QVERIFY(restored->document()->path().isEmpty());
        // The restored document has taken over the recovery copy.
        QCOMPARE(QDir(folder.path()).entryList({QStringLiteral("*.dipw")}).size(), 1);
        QVERIFY(findRecoveredDocuments(folder.path()).empty());
        delete restored;
    }

    // As after a start with the project's file, while or after it is read.
    void recovery_fileIsOpen_restoresIntoItsWindow_data() {
        QTest::addColumn<bool>("waits");
        QTest::newRow("opened") << true;
        QTest::newRow("being opened") << false;
    }
    void recovery_fileIsOpen_restoresIntoItsWindow() {
        QFETCH(const bool, waits);
        const QTemporaryDir folder, recovery;
        const QString file = folder.filePath(QStringLiteral("box.dipw"));
        saveProject(boxProject(), file);
        {
            Document document(loadProject(file), file);
            AutoSaver saver(document, recovery.path());
            document.edit(QStringLiteral("Swell"), {},
                          [](Project& project) { project.film.swellX = editedSwell; });
            saver.keepNow();
        }
        Workbench workbench(recovery.path());
        const std::unique_ptr<MainWindow> window(workbench.openWindow());
        window->documents().openProject(file);
        if (waits) {
            QTRY_VERIFY_WITH_TIMEOUT(window->document(), patience());
        }
        restoreAll(workbench);
        QTRY_VERIFY_WITH_TIMEOUT(window->document() &&
                                     window->document()->project().film.swellX == editedSwell,
                                 patience());
        QCOMPARE(windows().size(), 1);
        Document& document = *window->document();
        QCOMPARE(document.path(), file);
        QVERIFY(document.isModified());
        QVERIFY(!FileLock().acquire(file).acquired);              // it holds the lock
        QVERIFY(findRecoveredDocuments(recovery.path()).empty()); // the document keeps the copy
        document.undoStack().undo();
        QCOMPARE(document.project().film.swellX, loadProject(file).film.swellX);
    }
};

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == QLatin1String("--edit")) {
        return editUntilKilled(arguments.value(2), arguments.value(3));
    }
    CrashTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "CrashTest.moc"

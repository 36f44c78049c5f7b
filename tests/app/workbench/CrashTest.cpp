// Kills the program while a project is edited. The next start must restore the work.
//
// With --edit FOLDER MODEL, this program is the one that is killed. It edits an untitled project
// and prints "kept" when its recovery copy is on the disk.
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
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [] {
            for (QWidget* widget : QApplication::topLevelWidgets()) {
                auto* box = qobject_cast<QMessageBox*>(widget);
                if (box && box->objectName() == QLatin1String("recoveryQuestion")) {
                    box->defaultButton()->click();
                }
            }
        });
        answer.start(20);
        workbench.offerRecovery();
        answer.stop();
        MainWindow* restored = nullptr;
        for (QWidget* widget : QApplication::topLevelWidgets()) {
            if (auto* window = qobject_cast<MainWindow*>(widget)) {
                restored = window;
            }
        }
        QVERIFY(restored != nullptr);
        QTRY_VERIFY(restored->document() != nullptr);
        QCOMPARE(restored->document()->project().film.swellX, editedSwell);
        QVERIFY(restored->document()->isModified());
        QVERIFY(restored->document()->path().isEmpty());
        // The restored document has taken over the recovery copy.
        QCOMPARE(QDir(folder.path()).entryList({QStringLiteral("*.dipw")}).size(), 1);
        QVERIFY(findRecoveredDocuments(folder.path()).empty());
        delete restored;
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

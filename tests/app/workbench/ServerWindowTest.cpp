// Sends the open project to `dipwright-cli serve` from a real window. The results must be those of
// a run on this computer.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "base/Error.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"
#include "workbench/serving/ServerDialog.h"
#include "workbench/widgets/NoticeBar.h"

#include <QLineEdit>
#include <QProcess>

using namespace dipwright;

class ServerWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        socket_ = folder_.filePath(QStringLiteral("serve.sock"));
        server_.start(binaryFolder("/dipwright-cli"),
                      {"serve", folder_.filePath("jobs"), "--listen", socket_});
        QVERIFY(server_.waitForReadyRead(patience()));
        QVERIFY(server_.readAllStandardOutput().contains("Listening"));
    }
    void cleanupTestCase() {
        server_.terminate();
        QVERIFY(server_.waitForFinished(patience()));
        QCOMPARE(server_.exitCode(), 0);
        QVERIFY(!QFile::exists(socket_));
    }

    void sendToServer_openProject_showsTheResultsOfARun() {
        const QString path = folder_.filePath(QStringLiteral("job.dipw"));
        Project project = loadProject(sampleFolder("/sphere.dipw"));
        makeCoarse(project);
        saveProject(project, path);
        Workbench workbench(folder_.filePath(QStringLiteral("recovery")));
        QPointer<MainWindow> window = workbench.openWindow();
        WindowDriver driver(*window);
        QVERIFY(!driver.action("sendToServer")->isEnabled());
        QVERIFY(driver.open(path));
        driver.trigger("sendToServer");
        QPointer<ServerDialog> dialog = window->findChild<ServerDialog*>();
        QVERIFY(dialog);
        auto* address = dialog->findChild<QLineEdit*>(QStringLiteral("serverAddress"));
        auto* token = dialog->findChild<QLineEdit*>(QStringLiteral("serverToken"));
        auto* notice = dialog->findChild<NoticeBar*>();
        address->setText(QStringLiteral("192.168.1.5:8137"));
        token->setText(folder_.filePath(QStringLiteral("jobs/token")));
        dialog->accept();
        QVERIFY(dialog->isVisible() && notice->text().contains("SSH"));
        address->setText(socket_);
        dialog->accept();
        Document& document = *window->document();
        QTRY_VERIFY_WITH_TIMEOUT(document.result() && document.isFresh(), patience());
        QVERIFY(!dialog);

        const SolverRegistry registry;
        JobOptions options;
        options.estimatesNumericalError = options.refines = true;
        const JobResult here = runJob(document.project(), registry, options, nullptr, {});
        const JobResult& sent = *document.result();
        QCOMPARE(sent.immersions[0].sheet.job.hash, here.immersions[0].sheet.job.hash);
        QCOMPARE(sent.immersions[0].sheet.image, here.immersions[0].sheet.image);
        // Nothing stays on the server.
        QCOMPARE(
            QDir(folder_.filePath("jobs/results")).entryList(QDir::NoDotAndDotDot | QDir::Dirs),
            QStringList());
    }

    void remoteDips_wrongToken_failsWithTheServersSentence() {
        try {
            remoteDips(loadProject(sampleFolder("/sphere.dipw")), {serverAddress(socket_), "wrong"},
                       {});
            QFAIL("was served");
        } catch (const Error& error) {
            QVERIFY(error.message().contains("token"));
        }
    }

private:
    QTemporaryDir folder_;
    QProcess server_;
    QString socket_;
};

int main(int argc, char** argv) {
    return runWindowTest<ServerWindowTest>(argc, argv);
}
#include "ServerWindowTest.moc"

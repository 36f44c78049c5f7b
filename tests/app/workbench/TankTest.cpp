// Works the tank-side page from the main window. The times must be stored with the job.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "project/ProjectStore.h"
#include "workbench/tank/TankPage.h"

using namespace dipwright;

namespace {

TankPage* shownPage() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (auto* page = qobject_cast<TankPage*>(widget); page && page->isVisible()) {
            return page;
        }
    }
    return nullptr;
}

} // namespace

class TankTest : public QObject {
    Q_OBJECT

private slots:
    // First the project is open in a window, then only its file is there.
    void tankAction_doneJob_storesItsTimes() {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        Project project = loadProject(sampleFolder("/sphere.dipw"));
        makeCoarse(project);
        saveProject(project, path);
        Workbench workbench(folder.filePath(QStringLiteral("recovery")));
        QPointer<MainWindow> window = workbench.openWindow();
        WindowDriver driver(*window);
        QVERIFY(driver.open(path));
        QVERIFY(!driver.action("tank")->isEnabled());
        QVERIFY(driver.run());
        driver.trigger("tank");
        QPointer<TankPage> page = shownPage();
        QVERIFY(page);
        const TankJob job = page->work().job();
        const std::size_t steps = job.tasks.size();
        QCOMPARE(steps % 8, std::size_t(0));
        for (std::size_t step = 0; step < steps; ++step) {
            QTest::keyClick(page, Qt::Key_Space);
        }
        Document& document = *window->document();
        QCOMPARE(document.project().asBuilt.times.size(), steps);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Keep times at the tank"));
        QVERIFY(document.isFresh()); // the sheet is the same
        QTest::keyClick(page, Qt::Key_Escape);
        QTRY_VERIFY(!page);
        document.undoStack().undo();
        QVERIFY(document.project().asBuilt.times.empty());

        // Now no window has the file open.
        window->close();
        QTRY_VERIFY(!window);
        workbench.showTank({job}, nullptr);
        page = shownPage();
        QVERIFY(page);
        for (std::size_t step = 0; step < steps; ++step) {
            QTest::keyClick(page, Qt::Key_Space);
        }
        QTRY_COMPARE_WITH_TIMEOUT(loadProject(path).asBuilt.times.size(), steps, patience());
        page->close();
    }
};

int main(int argc, char** argv) {
    return runWindowTest<TankTest>(argc, argv);
}
#include "TankTest.moc"

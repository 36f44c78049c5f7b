// Tests a project's network folder that vanishes while the window has the project open. The window
// must report it, continue to work, keep the unsaved work, and save all of it when the folder is
// back. Run with tests/breaking/BreakFiles.c preloaded.
#include "Patience.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "project/ProjectStore.h"

#include <QDir>
#include <QMessageBox>

using namespace dipwright;

class VanishedFolderTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void save_folderVanished_losesNothing_data();
    void save_folderVanished_losesNothing();

private:
    void vanish(bool isGone) const;
    QString path(const QString& name) const { return folder_->filePath(name); }
    double savedSwell() const { return loadProject(job_).film.swellX; }
    void change(double swell) const {
        window_->document()->edit({}, {}, [&](Project& project) { project.film.swellX = swell; });
    }
    QMessageBox* failure() const {
        return window_->findChild<QMessageBox*>(QStringLiteral("failure"));
    }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
    QString job_;
};

void VanishedFolderTest::initTestCase() {
    qputenv("DIPWRIGHT_BREAK_HOW", "ESTALE");
}

void VanishedFolderTest::init() {
    folder_ = std::make_unique<QTemporaryDir>();
    job_ = path(QStringLiteral("server/job.dipw"));
    QVERIFY(QDir().mkpath(path(QStringLiteral("server"))));
    QVERIFY(QFile::copy(sampleFolder("/tetrahedron.dipw"), job_));
    QVERIFY(QFile::setPermissions(job_, QFile::ReadOwner | QFile::WriteOwner));
    qputenv("DIPWRIGHT_BREAK_BELOW", QFile::encodeName(path(QStringLiteral("server"))));
    workbench_ = std::make_unique<Workbench>(path(QStringLiteral("recovery")));
    window_ = std::make_unique<MainWindow>(*workbench_);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QVERIFY(WindowDriver(*window_).open(job_));
}

void VanishedFolderTest::cleanup() {
    vanish(false);
    window_.reset();
    workbench_.reset();
}

// Moves the folder away, or makes operations in the folder fail with ESTALE.
void VanishedFolderTest::vanish(bool isGone) const {
    QFETCH(bool, isStale);
    const QString server = path(QStringLiteral("server")), away = path(QStringLiteral("away"));
    if (isStale) {
        qputenv("DIPWRIGHT_BREAK_AT", isGone ? "1" : "0");
    } else if (isGone) {
        QVERIFY(QDir().rename(server, away));
    } else if (QFileInfo::exists(away)) {
        QVERIFY(QDir().rename(away, server));
    }
}

void VanishedFolderTest::save_folderVanished_losesNothing_data() {
    QTest::addColumn<bool>("isStale");
    QTest::newRow("it cannot be reached") << true;
    QTest::newRow("it is not there") << false;
}

void VanishedFolderTest::save_folderVanished_losesNothing() {
    const double before = savedSwell();
    change(1.25);
    vanish(true);
    QVERIFY(!QFile(job_).open(QIODevice::ReadOnly)); // checks that the preloaded library works
    WindowDriver(*window_).trigger("save");
    QVERIFY(QTest::qWaitFor([&] { return failure() != nullptr; }, patience()));
    qInfo("%s", qPrintable(failure()->text()));
    QVERIFY2(failure()->text().contains(job_), qPrintable(failure()->text()));
    failure()->close();
    QVERIFY(window_->document()->isModified());

    // Changes are still possible, and a recovery copy is kept in another folder.
    change(1.125);
    const QDir recovery(path(QStringLiteral("recovery")));
    window_->documents().setAutosaveInterval(1);
    change(1.0625);
    QVERIFY(QTest::qWaitFor(
        [&] { return !recovery.entryList({QStringLiteral("*.dipw")}).isEmpty(); }, patience()));

    vanish(false);
    QCOMPARE(savedSwell(), before);
    QVERIFY(WindowDriver(*window_).save());
    QCOMPARE(savedSwell(), 1.0625);
    QCOMPARE(QDir(path(QStringLiteral("server")))
                 .entryList(QDir::Files | QDir::Hidden | QDir::NoDotAndDotDot)
                 .filter(QStringLiteral("new")),
             QStringList());
}

int main(int argc, char* argv[]) {
    const WindowApplication application(argc, argv);
    VanishedFolderTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "VanishedFolderTest.moc"

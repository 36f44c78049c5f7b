// The page on which a film on the water is measured by photos, used as a user would.
#include "inspect/FilmPage.h"
#include "Patience.h"
#include "TankPhoto.h"
#include "WindowDriver.h"
#include "panels/NumberBox.h"
#include "panels/PicturePanel.h"
#include "project/ProfileLibrary.h"
#include "project/ProjectStore.h"

#include <QDockWidget>
#include <QDragEnterEvent>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr double swellX = 1.12, swellY = 1.05, rate = 0.004, limit = 0.1, begin = 70;

// The film so many seconds after it was laid, grown as the film model has it.
QImage photoAt(double seconds) {
    const double grown = 1 + limit * (1 - std::exp(-rate * (seconds - begin) / limit));
    FloatingPage film = filmPage(), card = cardPage();
    film.turn = turned(-3, swellX * grown, swellY * grown);
    film.middle = {-90, 0};
    card.turn = turned(12);
    card.middle = {125, -10};
    TankCamera camera;
    camera.size = {1600, 1200};
    camera.k1 = -0.05;
    camera.tiltDegrees = 5;
    return tankPhoto({card, film}, camera, {.seed = unsigned(seconds)});
}

} // namespace

class FilmPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("DIPWRIGHT_PROFILE_PATH", home_.filePath(QStringLiteral("profiles")).toLocal8Bit());
        for (const int seconds : times_) {
            files_ << home_.filePath(QStringLiteral("tank-%1.png").arg(seconds));
            QVERIFY(photoAt(seconds).save(files_.last()));
        }
        workbench_ = std::make_unique<Workbench>(home_.path());
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->resize(1280, 800);
        window_->show();
        WindowDriver driver(*window_);
        saveProject(loadProject(QStringLiteral(DIPWRIGHT_SAMPLE_FOLDER "/sphere.dipw")), project());
        QVERIFY(driver.open(project()));
        driver.find<QDockWidget>("inspectionDock")->show();
        driver.find<QDockWidget>("inspectionDock")->raise();
        driver.find<QTabWidget>("inspection")->setCurrentWidget(window_->findChild<FilmPage*>());
    }

    void photosAreDroppedOnThePage() {
        drop(files_);
        QTRY_COMPARE_WITH_TIMEOUT(film().photos.size(), files_.size(), patience());
        QCOMPARE(film().photos[0].sha256.size(), 64);
        drop(files_.mid(0, 1)); // there already
        waitForJobs();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
        QCOMPARE(table()->rowCount(), int(files_.size()));
    }

    void aPictureThatIsNoneGetsASentence() {
        const QString bad = home_.filePath(QStringLiteral("bad.jpg"));
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("once upon a time") > 0);
        file.close();
        drop({bad});
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>(), patience());
        window_->findChild<QMessageBox*>()->close();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
    }

    void whatIsToldGoesIntoTheProjectStepByStep() {
        WindowDriver driver(*window_);
        for (int row = 0; row < table()->rowCount(); ++row) {
            qobject_cast<NumberBox*>(table()->cellWidget(row, 1))->setValue(times_[row]);
        }
        QCOMPARE(film().photos[3].seconds, std::optional<double>(times_[3]));
        driver.find<QToolButton>("filmRulers")->click();
        QVERIFY(driver.find<NumberBox>("cardAcross")->isVisible());
        driver.find<NumberBox>("cardAcross")->setValue(100.2);
        QCOMPARE(film().cardRulers[0], Millimetres(100.2));
        QCOMPARE(film().cardRulers[1], Millimetres(100));
        driver.trigger("undo");
        QCOMPARE(film().cardRulers[0], Millimetres(100));
        QCOMPARE(driver.find<NumberBox>("cardAcross")->value(), 100.0);
        // Nothing is told of the lens and the water until somebody does.
        QVERIFY(!film().lensK1 && !film().focalAs35 && !film().waterTemperature);
        driver.find<NumberBox>("focalLength")->setValue(35);
        QCOMPARE(film().focalAs35, std::optional(Millimetres(35)));
        driver.find<NumberBox>("focalLength")->setValue(-1);
        QVERIFY(!film().focalAs35);
        driver.find<NumberBox>("dipBegins")->setValue(begin + 5);
        driver.find<NumberBox>("dipBegins")->setValue(begin);
        auto* lot = driver.find<QLineEdit>("filmLot");
        lot->setFocus();
        QTest::keyClicks(lot, QStringLiteral("L7"));
        QCOMPARE(film().lot, QStringLiteral("L7"));
        driver.trigger("undo"); // both letters are one step
        QCOMPARE(film().lot, QString());
        driver.trigger("redo");
        driver.find<NumberBox>("waterTemperature")->setValue(28);
    }

    void theFilmIsMeasured() {
        WindowDriver driver(*window_);
        driver.find<QPushButton>("measureFilm")->click();
        auto* save = driver.find<QPushButton>("saveFilmProfile");
        QTRY_VERIFY_WITH_TIMEOUT(save->isEnabled(), patience());
        qInfo("%s", qPrintable(words()));
        QVERIFY(words().contains(QStringLiteral("1.12")));
        QVERIFY(words().contains(QStringLiteral("Growth")));
        for (const PicturePanel* panel :
             driver.find<QTabWidget>("filmPictures")->findChildren<PicturePanel*>()) {
            QVERIFY(!const_cast<PicturePanel*>(panel)->view().isEmpty());
        }
        photograph();
    }

    void howRulersWereReadWidensTheInterval() {
        WindowDriver driver(*window_);
        const QString without = words();
        driver.find<NumberBox>("rulerError")->setValue(0.1);
        QVERIFY(!driver.find<QPushButton>("saveFilmProfile")->isEnabled()); // no longer that film
        driver.find<QPushButton>("measureFilm")->click();
        QTRY_VERIFY_WITH_TIMEOUT(driver.find<QPushButton>("saveFilmProfile")->isEnabled(),
                                 patience());
        QVERIFY(words() != without);
        QVERIFY(words().contains(QStringLiteral("0.0016"))); // √2 · 0.1 % of 1.12
        QCOMPARE(words().section(u'\n', 1, 1), without.section(u'\n', 1, 1)); // growth is as it was
    }

    void theProfileTakesWhatWasMeasured() {
        WindowDriver driver(*window_);
        driver.find<QPushButton>("saveFilmProfile")->click();
        auto* dialog = window_->findChild<QInputDialog*>(QStringLiteral("filmProfileName"));
        QVERIFY(dialog);
        dialog->setTextValue(QStringLiteral("Lot 7"));
        dialog->accept();
        const auto known = ProfileLibrary().found(ProfileKind::Film, QStringLiteral("Lot 7"));
        QVERIFY(known);
        const auto& profile = std::get<FilmProfile>(*known);
        QVERIFY(std::abs(profile.swellX / swellX - 1) < 0.001);
        QVERIFY(std::abs(profile.growthRate / rate - 1) < 0.05);
        QCOMPARE(profile.lot, QStringLiteral("L7"));
        QCOMPARE(profile.measured.waterTemperature, std::optional<double>(28));
        QCOMPARE(profile.measured.photos.split(u' ').size(), files_.size());
    }

    void aFilmWithoutACardGetsASentence() {
        WindowDriver driver(*window_);
        const QString bare = home_.filePath(QStringLiteral("bare.png"));
        QImage(800, 600, QImage::Format_Grayscale8).save(bare);
        drop({bare});
        QTRY_COMPARE_WITH_TIMEOUT(film().photos.size(), std::size_t(files_.size()) + 1, patience());
        driver.find<QPushButton>("measureFilm")->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>(), patience());
        window_->findChild<QMessageBox*>()->close();
        table()->selectRow(table()->rowCount() - 1);
        driver.find<QPushButton>("removeFilmPhotos")->click();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
    }

    // And a project from elsewhere has its photos read only when its user allows it.
    void theProjectKeepsThePhotos() {
        const QString copy = home_.filePath(QStringLiteral("copy.dipw"));
        saveProject(window_->document()->project(), copy);
        const Document read(loadProject(copy), copy);
        QCOMPARE(read.project().filmOnWater, film());
        QVERIFY(!read.isTrusted(film().photos[0].file));
    }

    void cleanupTestCase() {
        window_.reset();
        workbench_.reset();
    }

private:
    const FilmOnWater& film() const { return window_->document()->project().filmOnWater; }
    QString words() const { return WindowDriver(*window_).find<QLabel>("filmWords")->text(); }
    QTableWidget* table() const { return WindowDriver(*window_).find<QTableWidget>("filmPhotos"); }
    QString project() const { return home_.filePath(QStringLiteral("ball.dipw")); }

    void waitForJobs() const {
        QTRY_VERIFY_WITH_TIMEOUT(
            WindowDriver(*window_).find<QPushButton>("measureFilm")->isEnabled(), patience());
    }

    void drop(const QStringList& files) const {
        auto* page = window_->findChild<FilmPage*>();
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files) {
            urls << QUrl::fromLocalFile(file);
        }
        data.setUrls(urls);
        QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton,
                              Qt::NoModifier);
        QApplication::sendEvent(page, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(page, &event);
    }

    // For whom wants to look at it: every size, light and dark, both pictures.
    void photograph() {
        const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
        if (folder.isEmpty()) {
            return;
        }
        WindowDriver driver(*window_);
        for (const bool dark : {false, true}) {
            Preferences preferences = workbench_->preferences();
            preferences.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
            workbench_->setPreferences(preferences);
            for (const QSize size : {QSize(1280, 800), QSize(2560, 1440)}) {
                window_->resize(size);
                for (int tab = 0; tab < 2; ++tab) {
                    driver.find<QTabWidget>("filmPictures")->setCurrentIndex(tab);
                    driver.find<QToolButton>("filmRulers")->setChecked(tab == 0);
                    QTest::qWait(500);
                    window_->grab().save(
                        QStringLiteral("%1/film-%2-%3-%4.png")
                            .arg(folder, dark ? QStringLiteral("dark") : QStringLiteral("light"))
                            .arg(size.width())
                            .arg(tab));
                }
            }
        }
    }

    const QList<int> times_{40, 70, 110, 190};
    QStringList files_;
    QTemporaryDir home_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
};

int main(int argc, char** argv) {
    const WindowApplication application(argc, argv);
    FilmPageTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "FilmPageTest.moc"

// The page on which a dipped part is held against its photos, used as a user would.
#include "PartPhoto.h"
#include "Patience.h"
#include "WindowDriver.h"
#include "geometry/Shapes.h"
#include "inspect/BuiltPage.h"
#include "inspect/PartPage.h"
#include "panels/NumberBox.h"
#include "panels/PicturePanel.h"
#include "panels/Timeline.h"
#include "project/ProjectStore.h"
#include "texture/Chessboard.h"

#include <QCheckBox>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>

using namespace dipwright;
using namespace dipwright::test;

namespace {

PhotoCamera camera() {
    PhotoCamera camera = cameraFrom({40, 60, 190}, {0, 0, 5}, {0, 1, 0});
    camera.size = {900, 900};
    return camera;
}

// Of a film that has come to lie on a body, with the chessboard on its sheet.
QImage photoOf(const LaidFilm& laid, const TriangleMesh& mesh) {
    return partPhoto(mesh,
                     [&](const SurfacePoint& point) {
                         const auto place = laid.place(point);
                         if (!place) {
                             return 0.6;
                         }
                         const Eigen::Vector2d squares = place->rest.cast<double>() / chessSquare;
                         return (int(std::floor(squares.x())) + int(std::floor(squares.y()))) % 2 ==
                                        0
                                    ? 0.05
                                    : 0.85;
                     },
                     camera(), {});
}

void drop(QWidget& widget, const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(10, 10), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

} // namespace

class InspectionPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        workbench_ = std::make_unique<Workbench>(home_.path());
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->resize(1280, 800);
        window_->show();
        WindowDriver driver(*window_);
        Project sphere = loadProject(QStringLiteral(DIPWRIGHT_SAMPLE_FOLDER "/sphere.dipw"));
        makeCoarse(sphere);
        saveProject(sphere, home_.filePath(QStringLiteral("ball.dipw")));
        QVERIFY(driver.open(home_.filePath(QStringLiteral("ball.dipw"))));
        QVERIFY(driver.run());
        const JobResult& job = *window_->document()->result();
        const QImage photo =
            photoOf(*job.immersions[0].laid, window_->document()->project().model->mesh);
        QVERIFY(photo.save(photo_));
        driver.find<QDockWidget>("inspectionDock")->show();
        driver.find<QDockWidget>("inspectionDock")->raise();
    }

    void photosAreDroppedOnThePage() {
        WindowDriver driver(*window_);
        drop(*page(), photo_);
        QTRY_COMPARE_WITH_TIMEOUT(part().photos.size(), std::size_t(1), patience());
        QCOMPARE(part().photos[0].sha256.size(), 64);
        QVERIFY(!driver.find<PhotoView>("partPhoto")->isEmpty());
        QVERIFY(hint().contains(QStringLiteral("0 of 6")));
    }

    void aPictureThatIsNoneGetsASentence() {
        const QString bad = home_.filePath(QStringLiteral("bad.jpg"));
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("once upon a time") > 0);
        file.close();
        drop(*page(), bad);
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>(), patience());
        window_->findChild<QMessageBox*>()->close();
        QCOMPARE(part().photos.size(), std::size_t(1));
    }

    void aPairIsClickedInThePhotoAndOnTheBody() {
        WindowDriver driver(*window_);
        auto* view = driver.find<PhotoView>("partPhoto");
        QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
        QVERIFY(page()->pending());
        QVERIFY(hint().contains(QStringLiteral("3D view")));
        clickBody();
        QCOMPARE(part().pairs.size(), std::size_t(1));
        QVERIFY(!page()->pending());
        const Eigen::Vector3d place(part().pairs[0].place[0].value(),
                                    part().pairs[0].place[1].value(),
                                    part().pairs[0].place[2].value());
        QVERIFY(std::abs(place.norm() - 35) < 0.5); // on the ball
        // Dragged elsewhere, as one step.
        const auto before = part().pairs[0].pixel;
        driver.drag(*view, {0.5, 0.5}, {0.6, 0.55});
        QVERIFY(part().pairs[0].pixel[0] > before[0] + 20);
        driver.trigger("undo");
        QCOMPARE(part().pairs[0].pixel, before);
        QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center());
        QTest::keyClick(view, Qt::Key_Delete);
        QVERIFY(part().pairs.empty());
        driver.trigger("undo");
        driver.trigger("undo");
        QVERIFY(part().pairs.empty());
    }

    void tooFewPairsAreRefused() {
        WindowDriver driver(*window_);
        driver.find<QPushButton>("measurePairs")->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>(), patience());
        QVERIFY(window_->findChild<QMessageBox*>()->text().contains(QStringLiteral("pairs")) ||
                window_->findChild<QMessageBox*>()->informativeText().contains(
                    QStringLiteral("pairs")));
        window_->findChild<QMessageBox*>()->close();
    }

    void cornersAreFoundAndShown() {
        WindowDriver driver(*window_);
        window_->document()->edit(QStringLiteral("pairs"), {}, [](Project& project) {
            for (int i = 0; i < 10; ++i) {
                const double around = 0.7 + 0.18 * i, up = 0.5 * std::sin(3.0 * i) + 0.2;
                const Eigen::Vector3d place =
                    35 * Eigen::Vector3d(std::cos(around) * std::cos(up), std::sin(up),
                                         std::sin(around) * std::cos(up));
                const Eigen::Vector2d pixel = camera().seen(place);
                project.inspection.pairs.push_back(
                    {0,
                     {pixel.x(), pixel.y()},
                     {Millimetres(place.x()), Millimetres(place.y()), Millimetres(place.z())}});
            }
        });
        driver.find<QCheckBox>("partChessboard")->click();
        QVERIFY(part().chessboard);
        driver.find<QCheckBox>("partKeepsCamera")->click();
        driver.find<QPushButton>("findCorners")->click();
        auto* figures = driver.find<QTableWidget>("partFigures");
        QTRY_VERIFY_WITH_TIMEOUT(figures->rowCount() == 1, patience());
        qInfo("%s px, %s, of the diagonal %s; %s", qPrintable(figures->item(0, 1)->text()),
              qPrintable(figures->item(0, 0)->text()), qPrintable(figures->item(0, 2)->text()),
              qPrintable(hint()));
        QVERIFY(figures->item(0, 0)->text().toInt() >= 9);
        QVERIFY(hint().contains(QStringLiteral("corners found")));
        QVERIFY(driver.find<QPushButton>("exportPart")->isEnabled());
    }

    void aPartIsKeptAndTheCorrectionSeenBeforeItIsUsed() {
        WindowDriver driver(*window_);
        auto* keep = driver.find<QPushButton>("keepPart");
        QVERIFY(!keep->isEnabled()); // nobody has accepted it
        driver.find<QLineEdit>("acceptedBy")->setText(QStringLiteral("Ada"));
        QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), patience());
        keep->click();
        QTRY_COMPARE_WITH_TIMEOUT(built().parts.size(), std::size_t(1), patience());
        QCOMPARE(built().parts[0].acceptedBy, QStringLiteral("Ada"));
        QCOMPARE(built().parts[0].photos, part().photos[0].sha256);
        QVERIFY(built().parts[0].residual < 0.5); // the photo is of the job itself
        QCOMPARE(driver.find<QTableWidget>("builtParts")->rowCount(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(
            driver.find<QLabel>("builtWords")->text().contains(QStringLiteral("repeat")),
            patience());
        PicturePanel* picture = window_->findChild<BuiltPage*>()->findChild<PicturePanel*>();
        QVERIFY(!picture->view().isEmpty());
        QVERIFY(!built().corrects); // seen, not used
        driver.find<NumberBox>("correctionStrength")->setValue(50);
        QCOMPARE(built().strength, 0.5);
        driver.trigger("undo");
        QCOMPARE(built().strength, 1.0);
        QCOMPARE(driver.find<NumberBox>("correctionStrength")->value(), 100.0);
        // The same photos twice would count as two parts that agree.
        QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), patience());
        keep->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>(), patience());
        window_->findChild<QMessageBox*>()->close();
        QCOMPARE(built().parts.size(), std::size_t(1));
    }

    // A film so coarse makes no fit that comes to rest, which is said where the fit would stand.
    void aFitThatIsRefusedSaysWhy() {
        WindowDriver driver(*window_);
        auto* fit = driver.find<QPushButton>("fitFilm");
        QTRY_VERIFY_WITH_TIMEOUT(fit->isEnabled(), patience());
        fit->click();
        auto* quantities = driver.find<QTableWidget>("fitQuantities");
        auto* words = driver.find<QLabel>("fitWords");
        QTRY_VERIFY_WITH_TIMEOUT(quantities->rowCount() > 0 || !words->text().isEmpty(),
                                 3 * patience());
        qInfo("%s", qPrintable(words->text()));
        QCOMPARE(quantities->rowCount(), 0);
        QVERIFY(words->text().contains(QStringLiteral("does not come to rest")));
        QVERIFY(!driver.find<QPushButton>("useFit")->isEnabled());
        photograph();
    }

    void whatWasMeasuredIsNotShownForAnotherProject() {
        WindowDriver driver(*window_);
        driver.find<QCheckBox>("partKeepsCamera")->click();
        QCOMPARE(driver.find<QTableWidget>("partFigures")->rowCount(), 0);
        QVERIFY(!driver.find<QPushButton>("fitFilm")->isEnabled());
        QVERIFY(!driver.find<QPushButton>("keepPart")->isEnabled());
        driver.find<QCheckBox>("corrects")->click();
        QVERIFY(built().corrects);
        driver.trigger("undo");
        QVERIFY(!built().corrects && !driver.find<QCheckBox>("corrects")->isChecked());
    }

    void theProjectKeepsPhotosAndPairs() {
        const QString copy = home_.filePath(QStringLiteral("copy.dipw"));
        saveProject(window_->document()->project(), copy);
        const Project read = loadProject(copy);
        QCOMPARE(read.inspection, part());
        QCOMPARE(read.inspection.pairs.size(), std::size_t(10));
    }

    void cleanupTestCase() {
        window_.reset();
        workbench_.reset();
    }

private:
    PartPage* page() const { return window_->findChild<PartPage*>(); }
    const AsBuilt& built() const { return window_->document()->project().asBuilt; }
    const InspectedPart& part() const { return window_->document()->project().inspection; }
    QString hint() const { return WindowDriver(*window_).find<QLabel>("partHint")->text(); }

    void clickBody() {
        window_->findChild<Timeline*>()->setPosition(0); // the body stands over the film
        DipView& view = window_->view();
        view.picture();
        const auto box = boundingBox(window_->document()->project().model->mesh);
        QTest::mouseClick(&view, Qt::LeftButton, {},
                          view.positionOf(Eigen::Vector3f(0, box.sizes().y() / 2, 0)).toPoint());
    }

    // For whom wants to look at it: every size, light and dark.
    void photograph() {
        const QString folder = qEnvironmentVariable("DIPWRIGHT_PICTURES");
        if (folder.isEmpty()) {
            return;
        }
        for (const bool dark : {false, true}) {
            Preferences preferences = workbench_->preferences();
            preferences.theme = dark ? ThemeChoice::Dark : ThemeChoice::Light;
            workbench_->setPreferences(preferences);
            for (const QSize size : {QSize(1280, 800), QSize(2560, 1440)}) {
                window_->resize(size);
                for (int tab = 0; tab < 4; ++tab) {
                    window_->findChild<QTabWidget*>(QStringLiteral("inspection"))
                        ->setCurrentIndex(tab);
                    QTest::qWait(500);
                    window_->view().picture();
                    window_->grab().save(
                        QStringLiteral("%1/inspection-%2-%3-%4.png")
                            .arg(folder, dark ? QStringLiteral("dark") : QStringLiteral("light"))
                            .arg(size.width())
                            .arg(tab));
                }
            }
        }
        window_->findChild<QTabWidget*>(QStringLiteral("inspection"))->setCurrentIndex(0);
    }

    QTemporaryDir home_;
    const QString photo_ = home_.filePath(QStringLiteral("ball.png"));
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
};

int main(int argc, char** argv) {
    const WindowApplication application(argc, argv);
    InspectionPageTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "InspectionPageTest.moc"

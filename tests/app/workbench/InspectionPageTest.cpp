// Uses the pages that compare a dipped part with its photos, like a user.
#include "InspectionWindow.h"
#include "PartPhoto.h"
#include "Patience.h"
#include "TestFolders.h"
#include "project/ProjectStore.h"
#include "texture/Chessboard.h"
#include "workbench/inspection/BuiltPage.h"
#include "workbench/inspection/PartPage.h"
#include "workbench/results/Timeline.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

using namespace dipwright;
using namespace dipwright::test;

namespace {

PhotoCamera camera() {
    PhotoCamera camera = cameraFrom({40, 60, 190}, {0, 0, 5}, {0, 1, 0});
    camera.size = {900, 900};
    return camera;
}

} // namespace

class InspectionPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        window_ = std::make_unique<InspectionWindow>(home_.path());
        Project sphere = loadProject(sampleFolder("/sphere.dipw"));
        sphere.film.width = Millimetres(210);
        sphere.film.height = Millimetres(297);
        makeCoarse(sphere);
        // With the longer steps of new projects, the fit of this film converges.
        sphere.process.contactTravel = 0.25;
        QVERIFY(window_->open(sphere));
        QVERIFY(window_->driver().run());
        const LaidFilm& laid = *window_->window().document()->result()->immersions[0].laid;
        const QSizeF sheet(sphere.film.width.value(), sphere.film.height.value());
        QVERIFY(
            partPhoto(sphere.model->mesh, chessboardPrint(laid, sheet, chessSquare), camera(), {})
                .save(photo_));
    }

    void partPage_droppedPhoto_isAdded() {
        WindowDriver& driver = window_->driver();
        InspectionWindow::drop(*page(), {photo_});
        QTRY_COMPARE_WITH_TIMEOUT(part().photos.size(), std::size_t(1), patience());
        QCOMPARE(part().photos[0].sha256.size(), 64);
        QVERIFY(!driver.find<PhotoView>("partPhoto")->isEmpty());
        QVERIFY(hint().contains(QStringLiteral("0 of 6")));
    }

    void partPage_droppedFileNoPicture_showsFailure() {
        const QString bad = home_.filePath(QStringLiteral("bad.jpg"));
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("once upon a time") > 0);
        file.close();
        InspectionWindow::drop(*page(), {bad});
        QTRY_VERIFY_WITH_TIMEOUT(window_->window().findChild<QMessageBox*>(), patience());
        window_->window().findChild<QMessageBox*>()->close();
        QCOMPARE(part().photos.size(), std::size_t(1));
    }

    void partPage_clickPhotoAndBody_makesPair() {
        WindowDriver& driver = window_->driver();
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
        // A drag of the place is one undo step.
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

    void partPage_tooFewPairs_areRefused() {
        WindowDriver& driver = window_->driver();
        driver.find<QPushButton>("measurePairs")->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->window().findChild<QMessageBox*>(), patience());
        QVERIFY(
            window_->window().findChild<QMessageBox*>()->text().contains(QStringLiteral("pairs")) ||
            window_->window().findChild<QMessageBox*>()->informativeText().contains(
                QStringLiteral("pairs")));
        window_->window().findChild<QMessageBox*>()->close();
    }

    void partPage_findCorners_showsFigures() {
        WindowDriver& driver = window_->driver();
        window_->window().document()->edit(QStringLiteral("pairs"), {}, [](Project& project) {
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

    void builtPage_keepPart_previewsCorrection() {
        WindowDriver& driver = window_->driver();
        auto* keep = driver.find<QPushButton>("keepPart");
        QVERIFY(!keep->isEnabled()); // nobody has accepted it
        driver.find<QLineEdit>("acceptedBy")->setText(QStringLiteral("Ada"));
        QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), patience());
        keep->click();
        driver.find<NumberBox>("correctionStrength")->setValue(90); // while the part is measured
        QTRY_COMPARE_WITH_TIMEOUT(built().parts.size(), std::size_t(1), patience());
        QCOMPARE(built().strength, 0.9);
        QCOMPARE(built().parts[0].acceptedBy, QStringLiteral("Ada"));
        QCOMPARE(built().parts[0].photos, part().photos[0].sha256);
        QVERIFY(built().parts[0].residual < 0.5); // the photo shows the computed result
        auto* parts = driver.find<QTableWidget>("builtParts");
        QCOMPARE(parts->rowCount(), 1);
        QCOMPARE(parts->item(0, 4)->text(), QStringLiteral("yes")); // dipped as the job dips now
        QTRY_VERIFY_WITH_TIMEOUT(
            driver.find<QLabel>("builtWords")->text().contains(QStringLiteral("repeat")),
            patience());
        PicturePanel* picture = window_->page<BuiltPage>()->findChild<PicturePanel*>();
        QVERIFY(!picture->view().isEmpty());
        QVERIFY(!built().corrects); // shown, but not used
        driver.find<NumberBox>("correctionStrength")->setValue(50);
        QCOMPARE(built().strength, 0.5);
        driver.trigger("undo");
        QCOMPARE(built().strength, 0.9);
        QCOMPARE(driver.find<NumberBox>("correctionStrength")->value(), 90.0);
        // The same photos must not count as a second part.
        QTRY_VERIFY_WITH_TIMEOUT(keep->isEnabled(), patience());
        keep->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->window().findChild<QMessageBox*>(), patience());
        window_->window().findChild<QMessageBox*>()->close();
        QCOMPARE(built().parts.size(), std::size_t(1));
        window_->window().document()->edit(QStringLiteral("depth"), {}, [](Project& project) {
            project.process.depth = Millimetres(20);
        });
        QCOMPARE(parts->item(0, 4)->text(), QStringLiteral("no"));
        driver.trigger("undo");
        QCOMPARE(parts->item(0, 4)->text(), QStringLiteral("yes"));
    }

    // The film is too coarse for the fit to converge. The page says so instead of showing a result.
    void fitPage_fitDoesNotConverge_saysWhy() {
        WindowDriver& driver = window_->driver();
        auto* fit = driver.find<QPushButton>("fitFilm");
        QTRY_VERIFY_WITH_TIMEOUT(fit->isEnabled(), patience());
        fit->click();
        auto* quantities = driver.find<QTableWidget>("fitQuantities");
        auto* words = driver.find<QLabel>("fitWords");
        QTRY_VERIFY_WITH_TIMEOUT(quantities->rowCount() > 0 || !words->text().isEmpty(),
                                 3 * patience());
        qInfo("%s", qPrintable(words->text()));
        QCOMPARE(quantities->rowCount(), 0);
        QVERIFY(words->text().contains(QStringLiteral("did not converge")));
        QVERIFY(!driver.find<QPushButton>("useFit")->isEnabled());
    }

    void inspection_picturesWanted_takesScreenshots() {
        auto* pages = window_->find<QTabWidget>("inspection");
        window_->photograph(QStringLiteral("inspection"), pages->count(),
                            [pages](int number) { pages->setCurrentIndex(number); });
        pages->setCurrentIndex(0);
    }

    void inspection_settingChanged_clearsResults() {
        WindowDriver& driver = window_->driver();
        driver.find<QCheckBox>("partKeepsCamera")->click();
        QCOMPARE(driver.find<QTableWidget>("partFigures")->rowCount(), 0);
        QVERIFY(!driver.find<QPushButton>("fitFilm")->isEnabled());
        QVERIFY(!driver.find<QPushButton>("keepPart")->isEnabled());
        driver.find<QCheckBox>("corrects")->click();
        QVERIFY(built().corrects);
        driver.trigger("undo");
        QVERIFY(!built().corrects && !driver.find<QCheckBox>("corrects")->isChecked());
    }

    void inspection_savedProject_keepsPhotosAndPairs() {
        const QString copy = home_.filePath(QStringLiteral("copy.dipw"));
        saveProject(window_->project(), copy);
        const Project read = loadProject(copy);
        QCOMPARE(read.inspection, part());
        QCOMPARE(read.inspection.pairs.size(), std::size_t(10));
    }

    void cleanupTestCase() { window_.reset(); }

private:
    PartPage* page() const { return window_->page<PartPage>(); }
    const AsBuilt& built() const { return window_->project().asBuilt; }
    const InspectedPart& part() const { return window_->project().inspection; }
    QString hint() const { return window_->find<QLabel>("partHint")->text(); }

    void clickBody() {
        window_->page<Timeline>()->setPosition(0); // the body stands over the film
        DipView& view = window_->window().view();
        view.picture();
        const auto box = boundingBox(window_->project().model->mesh);
        QTest::mouseClick(&view, Qt::LeftButton, {},
                          view.positionOf(Eigen::Vector3f(0, box.sizes().y() / 2, 0)).toPoint());
    }

    QTemporaryDir home_;
    const QString photo_ = home_.filePath(QStringLiteral("ball.png"));
    std::unique_ptr<InspectionWindow> window_;
};

int main(int argc, char** argv) {
    return runWindowTest<InspectionPageTest>(argc, argv);
}
#include "InspectionPageTest.moc"

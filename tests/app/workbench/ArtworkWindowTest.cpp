// Tests artwork in the real window: from a model without a texture to a sheet as PDF, and a decal
// moved, turned and sized in the view.
#include "FileAnswer.h"
#include "Patience.h"
#include "WindowDriver.h"
#include "artwork/EditArtwork.h"
#include "base/WideGamut.h"
#include "geometry/Shapes.h"
#include "workbench/artwork/ArtworkPage.h"
#include "workbench/artwork/LayerFrame.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QToolButton>

using namespace dipwright;

namespace {

// Writes a ball of 60 mm as a text STL, which has no texture.
void writeBall(const QString& path) {
    const TriangleMesh ball = sphereMesh(30, 24, 48);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QTextStream out(&file);
    out << "solid ball\n";
    for (std::size_t triangle = 0; triangle < ball.triangles.size(); ++triangle) {
        out << "facet normal 0 0 0\nouter loop\n";
        for (const Eigen::Vector3f& corner : cornersOf(ball, triangle)) {
            out << "vertex " << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
        }
        out << "endloop\nendfacet\n";
    }
    out << "endsolid ball\n";
}

void dropOn(QWidget& widget, const QString& path, const QPointF& position) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(position.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&widget, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(position, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&widget, &drop);
}

double shareOfRed(const QImage& picture) {
    const QImage image = inSrgb(picture);
    qint64 red = 0;
    for (int row = 0; row < image.height(); ++row) {
        for (int column = 0; column < image.width(); ++column) {
            const QColor colour = image.pixelColor(column, row);
            red += colour.alpha() > 0 && colour.red() > colour.green() + 70 ? 1 : 0;
        }
    }
    return double(red) / (double(image.width()) * image.height());
}

} // namespace

class ArtworkWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        Preferences preferences = workbench_->preferences();
        preferences.liveUpdate = false;
        workbench_->setPreferences(preferences);
        writeBall(ball_);
        QImage logo(60, 60, QImage::Format_RGBA8888);
        logo.fill(QColor(220, 20, 30));
        QVERIFY(logo.save(logo_));
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->resize(1280, 800);
        window_->show();
        driver_ = std::make_unique<WindowDriver>(*window_);
    }
    void cleanupTestCase() {
        driver_.reset();
        window_.reset();
        workbench_.reset();
    }

    void artwork_logoAndPattern_makeSheetInTenActions() {
        int actions = 0;
        actions += 2; // drop the file on the window, accept its questions
        QVERIFY(driver_->create(ball_, {}, 60, [](Project& project) {
            makeCoarse(project);
            project.immersions[0].rotation[0] = Degrees(90); // dips the front first
        }));
        QVERIFY(document().project().model->textures.empty());
        ++actions; // open the page
        driver_->trigger("artwork");
        QVERIFY(driver_->find<QDockWidget>("artworkDock")->isVisible());
        actions += 2; // open the menu of patterns, choose one
        driver_->find<QPushButton>("addPattern");
        driver_->action("addCarbon")->trigger();
        QCOMPARE(artwork().layers.size(), std::size_t(1));
        QCOMPARE(artwork().base, std::optional(QColor(255, 255, 255)));
        ++actions; // drop the logo on the body
        dropOn(view(), logo_, positionOf({0, 0, 0}));
        QTRY_COMPARE_WITH_TIMEOUT(artwork().layers.size(), std::size_t(2), patience());
        ++actions;
        QVERIFY(driver_->run());
        actions += 2; // export the sheet as PDF, choose the file
        const QString pdf = folder_.filePath(QStringLiteral("sheet.pdf"));
        answerWithFile(pdf);
        driver_->trigger("exportPdf");
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(pdf).size() > 1000, patience());
        QVERIFY2(actions <= 10,
                 qPrintable(
                     QStringLiteral("it took %1 user actions, expected at most 10").arg(actions)));

        const ImmersionResult& result = window_->session().outcome().result->immersions[0];
        const double red = shareOfRed(result.texture->image);
        QVERIFY2(
            red > 0.003 && red < 0.05,
            qPrintable(
                QStringLiteral("red share of the sheet is %1, expected 0.003 to 0.05").arg(red)));
        QVERIFY(!window_->session().outcome().result->painted->textures.empty());
    }

    void artworkPage_pictureInSquare_saysPrintedSize() {
        ArtworkPage page;
        Artwork shown;
        shown.layers.push_back(newLayer(LayerKind::Picture, QStringLiteral("Logo")));
        QImage picture(30, 20, QImage::Format_RGBA8888);
        picture.fill(Qt::red);
        shown.layers[0].picture = artworkPicture(picture);
        shown.layers[0].size = {Millimetres(32), Millimetres(32)};
        page.show(shown, 0);
        const auto* size = page.findChild<QLabel*>(QStringLiteral("layerShownSize"));
        QCOMPARE(size->text(), QStringLiteral("32.0 × 21.3 mm"));
        QVERIFY(!size->isHidden());
        shown.layers[0].repeat = Millimetres(10);
        page.show(shown, 0);
        QVERIFY(size->isHidden());
    }

    void artwork_everyChange_isOneUndoStep() {
        const Artwork before = artwork();
        driver_->find<QDoubleSpinBox>("layerTurn")->setValue(30);
        QCOMPARE(artwork().layers[1].turn, Degrees(30));
        driver_->find<QToolButton>("layerDown")->click();
        QCOMPARE(artwork().layers[0].turn, Degrees(30));
        driver_->find<QToolButton>("removeLayer")->click();
        QCOMPARE(artwork().layers.size(), std::size_t(1));
        for (int k = 0; k < 3; ++k) {
            driver_->trigger("undo");
        }
        QCOMPARE(artwork(), before);
    }

    // A place on the surface would be a bad axis to wrap a picture around.
    void artwork_decalBecomesCylinder_axisGoesThroughTheMiddle() {
        driver_->find<QListWidget>("artworkLayers")->setCurrentRow(0); // the logo
        const Artwork before = artwork();
        auto* placement = driver_->find<QComboBox>("layerPlacement");
        placement->setCurrentIndex(int(LayerPlacement::Cylinder));
        emit placement->activated(placement->currentIndex());
        QCOMPARE(artwork().layers[1].placement, LayerPlacement::Cylinder);
        const Eigen::Vector3f middle = boundingBox(document().project().model->mesh).center();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            QVERIFY(std::abs(artwork().layers[1].place[axis].value() - double(middle[axis])) <
                    0.01);
        }
        QCOMPARE(artwork().layers[1].size, before.layers[1].size);
        driver_->trigger("undo");
        QCOMPARE(artwork(), before);
    }

    void artwork_layerWithSpotInk_makesPlate() {
        driver_->find<QListWidget>("artworkLayers")->setCurrentRow(0); // the logo
        const Artwork before = artwork();
        auto* name = driver_->find<QLineEdit>("layerSpot");
        auto* isFirst = driver_->find<QCheckBox>("layerSpotFirst");
        QVERIFY(!isFirst->isVisibleTo(isFirst->parentWidget()));
        name->setText(QStringLiteral("Cyan")); // one of the four process inks
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(artwork(), before);
        name->setText(QStringLiteral("Gloss varnish"));
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(artwork().layers[1].spot, QStringLiteral("Gloss varnish"));
        QVERIFY(isFirst->isVisibleTo(isFirst->parentWidget()));
        isFirst->click();
        QVERIFY(artwork().layers[1].spotFirst);
        QVERIFY(driver_->run());
        const Sheet& sheet = window_->session().outcome().result->immersions[0].sheet;
        QCOMPARE(sheet.plates.size(), std::size_t(1));
        QCOMPARE(sheet.plates[0].name, QStringLiteral("Gloss varnish"));
        QVERIFY(shareOfRed(sheet.image) < 0.001);
        driver_->trigger("undo");
        driver_->trigger("undo");
        QCOMPARE(artwork(), before);
    }

    void artwork_spotNamedAsTheWhiteInk_isRefused() {
        driver_->find<QListWidget>("artworkLayers")->setCurrentRow(0); // the logo
        const Artwork before = artwork();
        window_->session().document()->edit(
            "White", {}, [](Project& project) { project.sheet.white = WhiteLayer::Last; });
        auto* name = driver_->find<QLineEdit>("layerSpot");
        name->setText(QStringLiteral("white"));
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(artwork(), before);
        QVERIFY(name->text() != QLatin1String("white")); // the field shows what is stored
        auto* reason = driver_->find<QMessageBox>("failure");
        QVERIFY(reason && reason->text().contains("rename the white ink"));
        reason->close();
        driver_->trigger("undo");
    }

    void layerList_keys_hideMoveAndRemoveLayers() {
        const Artwork before = artwork();
        auto* list = driver_->find<QListWidget>("artworkLayers");
        list->setCurrentRow(0); // the logo
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(artwork().layers[0], before.layers[1]);
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(artwork().layers.size(), std::size_t(1));
        driver_->trigger("undo");
        driver_->trigger("undo");
        list->item(0)->setCheckState(Qt::Unchecked);
        QVERIFY(!artwork().layers[1].visible);
        driver_->trigger("undo");
        QCOMPARE(artwork(), before);
        list->setCurrentRow(0);
        QTest::keyClick(list, Qt::Key_Escape);
        QCOMPARE(list->currentRow(), -1);
    }

    void decal_dragInView_movesTurnsAndSizes() {
        driver_->find<QListWidget>("artworkLayers")->setCurrentRow(0);
        driver_->action("front")->trigger();
        driver_->action("rings")->setChecked(false); // the rings would get the mouse first
        document().edit(QStringLiteral("Front"), {}, [](Project& changed) {
            changed.immersions[0].rotation[0] = Degrees(0); // the front faces the camera
            changed.artwork.layers[1].place = {Millimetres(0), Millimetres(0), Millimetres(30)};
        });
        const Artwork before = artwork();
        view().picture();
        const auto middle = positionOf(placeOf(artwork().layers[1]));
        drag(middle, middle + QPointF(40, 0));
        const Eigen::Vector3f moved = placeOf(artwork().layers[1]) - placeOf(before.layers[1]);
        QVERIFY2(
            moved.x() > 2 && std::abs(moved.y()) < 1.5F,
            qPrintable(
                QStringLiteral("the decal moved by x = %1, y = %2 mm, expected x > 2 and |y| < 1.5")
                    .arg(moved.x())
                    .arg(moved.y())));
        QCOMPARE(document().undoStack().undoText(), QStringLiteral("Move layer"));
        driver_->trigger("undo");
        QCOMPARE(artwork(), before);

        view().picture();
        const auto handle = [&](double right, double up) {
            const auto size = shownSize(artwork().layers[1]);
            const Eigen::Vector3f place = placeOf(artwork().layers[1]);
            const Eigen::Vector3f at = place + Eigen::Vector3f(float(right * size[0].value() / 2),
                                                               float(up * size[1].value() / 2), 0);
            return positionOf(30 * at.normalized()); // on the ball
        };
        drag(handle(1, 1), middle + 1.5 * (handle(1, 1) - middle));
        QVERIFY(artwork().layers[1].size[0].value() > 1.25 * before.layers[1].size[0].value());
        QCOMPARE(artwork().layers[1].size[0], artwork().layers[1].size[1]);
        driver_->trigger("undo");
        view().picture();
        drag(handle(0, 1.25), middle + QPointF(-60, 0)); // from above to the left
        QVERIFY(std::abs(artwork().layers[1].turn.value() - 90) < 15);
        driver_->trigger("undo");
        QCOMPARE(artwork(), before);
    }

    void droppedPicture_besideBody_addsNoLayer() {
        const std::size_t layers = artwork().layers.size();
        dropOn(view(), logo_, QPointF(5, 5));
        QTest::qWait(100);
        QCOMPARE(artwork().layers.size(), layers);
        for (QWidget* widget : QApplication::topLevelWidgets()) { // close the failure message
            if (widget != window_.get() && widget->isVisible() && widget->isModal()) {
                widget->close();
            }
        }
    }

private:
    Document& document() { return *window_->document(); }
    const Artwork& artwork() { return document().project().artwork; }
    DipView& view() { return window_->view(); }
    static Eigen::Vector3f placeOf(const ArtworkLayer& layer) {
        return {float(layer.place[0].value()), float(layer.place[1].value()),
                float(layer.place[2].value())};
    }
    QPointF positionOf(const Eigen::Vector3f& place) {
        view().picture();
        const Project& project = document().project();
        const Eigen::Isometry3d pose = Eigen::Translation3d(poseToWorld(project.immersions[0], 0)) *
                                       poseTransform(project.model->mesh, project.immersions[0]);
        return view().positionOf((pose * place.cast<double>()).cast<float>());
    }
    void drag(const QPointF& from, const QPointF& to) {
        const auto share = [this](const QPointF& place) {
            return QPointF(place.x() / view().width(), place.y() / view().height());
        };
        WindowDriver::drag(view(), share(from), share(to));
    }

    QTemporaryDir folder_;
    QString ball_ = folder_.filePath(QStringLiteral("ball.stl"));
    QString logo_ = folder_.filePath(QStringLiteral("logo.png"));
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
    std::unique_ptr<WindowDriver> driver_;
};

int main(int argc, char** argv) {
    return runWindowTest<ArtworkWindowTest>(argc, argv);
}
#include "ArtworkWindowTest.moc"

// Uses the page that fits film and dip to photos of a dipped part, like a user.
#include "workbench/inspection/FitPage.h"
#include "InspectionWindow.h"
#include "Patience.h"
#include "PhotographedPart.h"
#include "project/ProfileLibrary.h"
#include "solver/SolverRegistry.h"
#include "texture/Chessboard.h"
#include "workbench/inspection/PartPage.h"

#include <QCheckBox>
#include <QDir>
#include <QInputDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTimer>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const Hidden hidden{1.055, 1.04, 5, 1.1, -0.7, 1.2};

} // namespace

class FitPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("DIPWRIGHT_PROFILE_PATH", home_.filePath(QStringLiteral("profiles")).toLocal8Bit());
        const SolverRegistry registry;
        const PhotographedPart part(eggToFit(1.3, 2.2), hidden, 2,
                                    registry.module(QStringLiteral("pbd-cpu")));
        std::vector<PhotoCamera> cameras =
            camerasAround({{20, -40}, {140, -35}, {260, -45}}, 210, 3, 1344);
        QStringList photos;
        for (const PhotoCamera& camera : cameras) {
            photos << home_.filePath(QStringLiteral("egg-%1.png").arg(photos.size() + 1));
            QVERIFY(partPhoto(part.project().model->mesh,
                              chessboardPrint(*part.filmInTank(), {210, 210}, chessSquare), camera,
                              {.seed = unsigned(photos.size())})
                        .save(photos.last()));
        }
        window_ = std::make_unique<InspectionWindow>(home_.path());
        QVERIFY(window_->open(part.project()));
        InspectionWindow::drop(*window_->page<PartPage>(), photos);
        QTRY_COMPARE_WITH_TIMEOUT(window_->project().inspection.photos.size(), std::size_t(3),
                                  patience());
        // Places on the body's surface, with errors as in a user's clicks.
        const FitPairs pairs = part.pairs(cameras, 0, 16, 0.7, 1);
        window_->window().document()->edit(QStringLiteral("pairs"), {}, [&](Project& project) {
            for (const PlacePair& pair : pairs.body) {
                project.inspection.pairs.push_back(
                    {pair.photo,
                     {pair.pixel.x(), pair.pixel.y()},
                     {Millimetres(pair.model.x()), Millimetres(pair.model.y()),
                      Millimetres(pair.model.z())}});
            }
        });
        window_->find<QCheckBox>("partChessboard")->click();
        window_->find<QCheckBox>("partKeepsCamera")->click();
        window_->find<QPushButton>("findCorners")->click();
        window_->show(window_->page<FitPage>());
        QTRY_VERIFY_WITH_TIMEOUT(button("fitFilm")->isEnabled(), 3 * patience());
    }

    void fitPage_fit_findsHiddenValues() {
        QVERIFY(!button("useFit")->isEnabled() && !button("saveFit")->isEnabled());
        button("fitFilm")->click();
        QTRY_VERIFY_WITH_TIMEOUT(button("useFit")->isEnabled(), 6 * patience());
        QTableWidget& quantities = table("fitQuantities");
        for (int row = 0; row < quantities.rowCount(); ++row) {
            qInfo("%s: %s -> %s, %s", qPrintable(quantities.item(row, 0)->text()),
                  qPrintable(quantities.item(row, 1)->text()),
                  qPrintable(quantities.item(row, 2)->text()),
                  qPrintable(quantities.item(row, 3)->text()));
        }
        qInfo("%s", qPrintable(window_->find<QLabel>("fitWords")->text()));
        QCOMPARE(quantities.rowCount(), 6);
        QVERIFY(quantities.isVisible());
        const std::array<double, 6> before{0, 0, 0, 1.03, 1.03, INFINITY};
        const std::array<double, 6> truth{hidden.shiftX, hidden.shiftZ, hidden.turn,
                                          hidden.swellX, hidden.swellY, hidden.relaxation};
        const std::array<double, 6> allowed{0.2, 0.2, 0.3, 0.004, 0.004, 1};
        for (int row = 0; row < quantities.rowCount(); ++row) {
            const auto at = std::size_t(row);
            QCOMPARE(quantities.item(row, 1)->text(),
                     std::isfinite(before[at]) ? QString::number(before[at], 'f', row < 3 ? 2 : 4)
                                               : QStringLiteral("∞"));
            const double found = number(quantities.item(row, 2)->text());
            QVERIFY2(std::abs(found - truth[at]) < allowed[at],
                     qPrintable(QStringLiteral("%1 is %2, expected %3 ± %4")
                                    .arg(quantities.item(row, 0)->text())
                                    .arg(found)
                                    .arg(truth[at])
                                    .arg(allowed[at])));
            const QStringList interval =
                quantities.item(row, 3)->text().split(QStringLiteral(" to "));
            QCOMPARE(interval.size(), 2);
            QVERIFY(number(interval[0]) < found && found < number(interval[1]));
        }
        QTableWidget& correlations = table("fitCorrelations");
        QCOMPARE(correlations.rowCount(), 6);
        for (int row = 0; row < 6; ++row) {
            for (int column = 0; column < row; ++column) {
                QVERIFY(std::abs(number(correlations.item(row, column + 1)->text())) <= 1);
            }
        }
    }

    void fitPage_picturesWanted_takesScreenshots() {
        auto* pages = window_->find<QTabWidget>("inspection");
        window_->photograph(QStringLiteral("fit"), 2,
                            [pages](int number) { pages->setCurrentIndex(1 - number); });
        window_->show(window_->page<FitPage>());
    }

    void fitPage_useFit_canBeUndone() {
        const Project before = window_->project();
        button("useFit")->click();
        const Project& used = window_->project();
        QVERIFY(std::abs(used.film.swellX / hidden.swellX - 1) < 0.004);
        QVERIFY(std::abs(used.immersions[0].offset[0].value() - hidden.shiftX) < 0.2);
        QVERIFY(std::abs(used.immersions[0].rotation[1].value() - hidden.turn) < 0.3);
        QVERIFY(used.profiles.film && used.profiles.film->measured.relaxationTime);
        QCOMPARE(used.profiles.film->measured.photos.split(u' ').size(), 3);
        // The fit is in use. It can still be read and saved.
        QCOMPARE(table("fitQuantities").rowCount(), 6);
        QVERIFY(!button("useFit")->isEnabled() && button("saveFit")->isEnabled());
        QVERIFY(!button("fitFilm")->isEnabled()); // the corners were found with the old film
        window_->driver().trigger("undo");
        QCOMPARE(window_->project(), before);
        QVERIFY(button("useFit")->isEnabled() && button("fitFilm")->isEnabled());
        QCOMPARE(table("fitQuantities").rowCount(), 6);
    }

    void fitPage_saveProfile_storesFit() {
        button("saveFit")->click();
        auto* dialog =
            window_->window().findChild<QInputDialog*>(QStringLiteral("filmProfileName"));
        QVERIFY(dialog);
        dialog->setTextValue(QStringLiteral("Lot 9"));
        dialog->accept();
        const auto known = ProfileLibrary().found(ProfileKind::Film, QStringLiteral("Lot 9"));
        QVERIFY(known);
        const auto& profile = std::get<FilmProfile>(*known);
        QVERIFY(std::abs(profile.swellX / hidden.swellX - 1) < 0.004);
        QVERIFY(std::abs(profile.relaxationTime.value() - hidden.relaxation) < 1);
    }

    void fitPage_export_writesJson() {
        const QString folder = home_.filePath(QStringLiteral("fit"));
        QVERIFY(QDir().mkpath(folder));
        QTimer::singleShot(0, [&folder] {
            auto* name = QApplication::activeModalWidget()->findChild<QLineEdit*>();
            QVERIFY(name);
            name->setText(folder);
            QTest::keyClick(name, Qt::Key_Return);
        });
        button("exportFit")->click();
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(folder + QStringLiteral("/fit.json")),
                                 patience());
        QFile file(folder + QStringLiteral("/fit.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject written = QJsonDocument::fromJson(file.readAll()).object();
        QCOMPARE(written.value("quantities").toArray().size(), 6);
        QCOMPARE(written.value("photos").toArray().size(), 3);
    }

    void fitPage_filmChanged_clearsFit() {
        window_->window().document()->edit(QStringLiteral("film"), {},
                                           [](Project& project) { project.film.swellX = 1.01; });
        QCOMPARE(table("fitQuantities").rowCount(), 0);
        QVERIFY(!button("saveFit")->isEnabled());
    }

    void cleanupTestCase() { window_.reset(); }

private:
    QPushButton* button(const char* name) const { return window_->find<QPushButton>(name); }
    QTableWidget& table(const char* name) const { return *window_->find<QTableWidget>(name); }
    static double number(const QString& text) { return text.section(u' ', 0, 0).toDouble(); }

    QTemporaryDir home_;
    std::unique_ptr<InspectionWindow> window_;
};

int main(int argc, char** argv) {
    return runWindowTest<FitPageTest>(argc, argv);
}
#include "FitPageTest.moc"

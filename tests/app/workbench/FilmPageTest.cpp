// Uses the page that measures a floating film by photos, like a user.
#include "workbench/inspection/FilmPage.h"
#include "FileAnswer.h"
#include "InspectionWindow.h"
#include "Patience.h"
#include "TankPhoto.h"
#include "TestFolders.h"
#include "project/ProfileLibrary.h"
#include "project/ProjectStore.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"

#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolButton>

using namespace dipwright;
using namespace dipwright::test;

namespace {

const GrowingFilm truth;

} // namespace

class FilmPageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        qputenv("DIPWRIGHT_PROFILE_PATH", home_.filePath(QStringLiteral("profiles")).toLocal8Bit());
        for (const int seconds : times_) {
            files_ << home_.filePath(QStringLiteral("tank-%1.png").arg(seconds));
            QVERIFY(tankPhoto(truth, seconds, 85).save(files_.last()));
        }
        window_ = std::make_unique<InspectionWindow>(home_.path());
        QVERIFY(window_->open(loadProject(sampleFolder("/sphere.dipw"))));
        window_->show(window_->page<FilmPage>());
    }

    void filmPage_pagesToPrint_areSaved() {
        answerWithFile(home_.path());
        window_->page<FilmPage>()->findChild<QPushButton*>(QStringLiteral("filmPages"))->click();
        for (const QString& name : {QStringLiteral("film.pdf"), QStringLiteral("card.pdf")}) {
            QFile file(home_.filePath(name));
            QTRY_VERIFY_WITH_TIMEOUT(file.exists(), patience());
            QVERIFY(file.open(QIODevice::ReadOnly) && file.read(5) == "%PDF-");
        }
        auto* pages =
            window_->page<FilmPage>()->findChild<QPushButton*>(QStringLiteral("filmPages"));
        QTRY_VERIFY_WITH_TIMEOUT(pages->isEnabled(), patience());
    }

    void filmPage_pagesExist_asksBeforeReplacing() {
        const QString film = home_.filePath(QStringLiteral("film.pdf"));
        QFile file(film);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        file.close();
        answerWithFile(home_.path());
        QTimer question;
        bool isAsked = false;
        connect(&question, &QTimer::timeout, this, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                isAsked = true;
                box->reject();
            }
        });
        question.start(50);
        window_->page<FilmPage>()->findChild<QPushButton*>(QStringLiteral("filmPages"))->click();
        QVERIFY(isAsked);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
    }

    void filmPage_droppedPhotos_areAdded() {
        drop(files_);
        QTRY_COMPARE_WITH_TIMEOUT(film().photos.size(), files_.size(), patience());
        QCOMPARE(film().photos[0].sha256.size(), 64);
        drop(files_.mid(0, 1)); // already on the page
        waitForJobs();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
        QCOMPARE(table()->rowCount(), int(files_.size()));
    }

    void filmPage_droppedFileNoPicture_showsFailure() {
        const QString bad = home_.filePath(QStringLiteral("bad.jpg"));
        QFile file(bad);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("once upon a time") > 0);
        file.close();
        drop({bad});
        QTRY_VERIFY_WITH_TIMEOUT(window_->window().findChild<QMessageBox*>(), patience());
        window_->window().findChild<QMessageBox*>()->close();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
    }

    void filmPage_typedValues_areUndoSteps() {
        WindowDriver& driver = window_->driver();
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
        // Lens and water stay unset until the user enters them.
        QVERIFY(!film().lensK1 && !film().focalAs35 && !film().waterTemperature);
        driver.find<NumberBox>("focalLength")->setValue(35);
        QCOMPARE(film().focalAs35, std::optional(Millimetres(35)));
        driver.find<NumberBox>("focalLength")->setValue(-1);
        QVERIFY(!film().focalAs35);
        driver.find<NumberBox>("dipBegins")->setValue(truth.begin + 5);
        driver.find<NumberBox>("dipBegins")->setValue(truth.begin);
        auto* lot = driver.find<QLineEdit>("filmLot");
        lot->setFocus();
        QTest::keyClicks(lot, QStringLiteral("L7"));
        QCOMPARE(film().lot, QStringLiteral("L7"));
        driver.trigger("undo"); // both letters are one step
        QCOMPARE(film().lot, QString());
        driver.trigger("redo");
        driver.find<NumberBox>("waterTemperature")->setValue(28);
    }

    void filmPage_measure_showsSwellAndGrowth() {
        WindowDriver& driver = window_->driver();
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
    }

    void filmPage_picturesWanted_takesScreenshots() {
        window_->photograph(QStringLiteral("film"), 2, [this](int number) {
            window_->find<QTabWidget>("filmPictures")->setCurrentIndex(number);
            window_->find<QToolButton>("filmRulers")->setChecked(number == 0);
        });
    }

    void filmPage_rulerError_widensInterval() {
        WindowDriver& driver = window_->driver();
        const QString without = words();
        driver.find<NumberBox>("rulerError")->setValue(0.1);
        QVERIFY(!driver.find<QPushButton>("saveFilmProfile")
                     ->isEnabled()); // the measured film is outdated
        driver.find<QPushButton>("measureFilm")->click();
        QTRY_VERIFY_WITH_TIMEOUT(driver.find<QPushButton>("saveFilmProfile")->isEnabled(),
                                 patience());
        QVERIFY(words() != without);
        QVERIFY(words().contains(QStringLiteral("0.0016"))); // √2 · 0.1 % of 1.12
        QCOMPARE(words().section(u'\n', 1, 1), without.section(u'\n', 1, 1)); // growth is unchanged
    }

    void filmPage_saveProfile_storesMeasuredFilm() {
        WindowDriver& driver = window_->driver();
        driver.find<QPushButton>("saveFilmProfile")->click();
        auto* dialog =
            window_->window().findChild<QInputDialog*>(QStringLiteral("filmProfileName"));
        QVERIFY(dialog);
        dialog->setTextValue(QStringLiteral("Lot 7"));
        dialog->accept();
        const auto known = ProfileLibrary().found(ProfileKind::Film, QStringLiteral("Lot 7"));
        QVERIFY(known);
        const auto& profile = std::get<FilmProfile>(*known);
        QVERIFY(std::abs(profile.swellX / truth.swellX - 1) < 0.001);
        QVERIFY(std::abs(profile.growthRate / truth.rate - 1) < 0.05);
        QCOMPARE(profile.lot, QStringLiteral("L7"));
        QCOMPARE(profile.measured.waterTemperature, std::optional<double>(28));
        QCOMPARE(profile.measured.photos.split(u' ').size(), files_.size());
    }

    void filmPage_photoWithoutCard_showsFailure() {
        WindowDriver& driver = window_->driver();
        const QString bare = home_.filePath(QStringLiteral("bare.png"));
        QImage(800, 600, QImage::Format_Grayscale8).save(bare);
        drop({bare});
        QTRY_COMPARE_WITH_TIMEOUT(film().photos.size(), std::size_t(files_.size()) + 1, patience());
        driver.find<QPushButton>("measureFilm")->click();
        QTRY_VERIFY_WITH_TIMEOUT(window_->window().findChild<QMessageBox*>(), patience());
        window_->window().findChild<QMessageBox*>()->close();
        table()->selectRow(table()->rowCount() - 1);
        driver.find<QPushButton>("removeFilmPhotos")->click();
        QCOMPARE(film().photos.size(), std::size_t(files_.size()));
    }

    // Photos of a project from elsewhere are read only if the user allows it.
    void filmPage_savedProject_keepsPhotos() {
        const QString copy = home_.filePath(QStringLiteral("copy.dipw"));
        saveProject(window_->project(), copy);
        const Document read(loadProject(copy), copy);
        QCOMPARE(read.project().filmOnWater, film());
        QVERIFY(!read.isTrusted(film().photos[0].file));
    }

    void cleanupTestCase() { window_.reset(); }

private:
    const FilmOnWater& film() const { return window_->project().filmOnWater; }
    QString words() const { return window_->find<QLabel>("filmWords")->text(); }
    QTableWidget* table() const { return window_->find<QTableWidget>("filmPhotos"); }

    void waitForJobs() const {
        QTRY_VERIFY_WITH_TIMEOUT(window_->find<QPushButton>("measureFilm")->isEnabled(),
                                 patience());
    }

    void drop(const QStringList& files) const {
        InspectionWindow::drop(*window_->page<FilmPage>(), files);
    }

    const QList<int> times_{40, 70, 110, 190};
    QStringList files_;
    QTemporaryDir home_;
    std::unique_ptr<InspectionWindow> window_;
};

int main(int argc, char** argv) {
    return runWindowTest<FilmPageTest>(argc, argv);
}
#include "FilmPageTest.moc"

// Uses the dialog that packs several jobs on one film, like a user.
#include "workbench/printing/PackDialog.h"
#include "FileAnswer.h"
#include "PaperMeasure.h"
#include "Patience.h"
#include "PrivateCups.h"
#include "TestFolders.h"

#include "project/ProjectStore.h"
#include "workbench/widgets/NumberBox.h"
#include "workbench/widgets/PicturePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

class PackDialogTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    SolverRegistry registry_;

    // Saves the sample ball, small and coarse, under a name. Returns its path.
    QString ball(const QString& name) {
        Project project = loadProject(sampleFolder("/sphere.dipw"));
        project.name = name;
        setByPath(project, QStringLiteral("film.size_mm"), QStringLiteral("120x120"));
        setByPath(project, QStringLiteral("film.points"), QStringLiteral("31x31"));
        setByPath(project, QStringLiteral("body.sdf_resolution"), QStringLiteral("64"));
        setByPath(project, QStringLiteral("sheet.dpi"), QStringLiteral("72"));
        const QString path = folder_.filePath(name + QStringLiteral(".dipw"));
        saveProject(project, path);
        return path;
    }

    template <typename Widget>
    static Widget* part(const QDialog& dialog, const char* name) {
        return dialog.findChild<Widget*>(QLatin1String(name));
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QSettings().clear();
    }

    void packDialog_layOut_showsFilmsAndCopies() {
        PackDialog dialog(registry_);
        auto* layOut = part<QPushButton>(dialog, "packLayOut");
        auto* write = part<QPushButton>(dialog, "packExport");
        auto* films = part<QComboBox>(dialog, "packShown");
        auto* preview = dialog.findChild<PicturePanel*>();
        QVERIFY(!layOut->isEnabled() && !write->isEnabled());
        dialog.add({ball(QStringLiteral("One"))});
        // The second project is dropped from a file manager.
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(ball(QStringLiteral("Two")))});
        QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&dialog, &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&dialog, &drop);
        auto* table = dialog.findChild<QTableWidget*>();
        QCOMPARE(table->rowCount(), 2);
        QVERIFY(layOut->isEnabled() && !write->isEnabled());
        part<QComboBox>(dialog, "packFilm")->setCurrentText(QStringLiteral("A3"));
        layOut->click();
        QTRY_VERIFY_WITH_TIMEOUT(write->isEnabled(), patience());
        const QString judged = table->item(0, 2)->toolTip(); // of dips that were not cached
        QVERIFY2(judged.contains(QStringLiteral("Numerical error:")), qPrintable(judged));
        QCOMPARE(films->count(), 1);
        QVERIFY2(films->currentText().contains(QStringLiteral("297 × 420")),
                 qPrintable(films->currentText()));
        QVERIFY(films->currentText().contains(QStringLiteral("2")));
        const QImage two = preview->grab().toImage();

        // More copies are laid out at once, because the dips are cached.
        qobject_cast<NumberBox*>(table->cellWidget(0, 1))->setValue(3);
        QTRY_VERIFY_WITH_TIMEOUT(write->isEnabled(), patience());
        QVERIFY(films->itemText(0).contains(QStringLiteral("4")));
        QVERIFY(preview->grab().toImage() != two);

        qobject_cast<NumberBox*>(table->cellWidget(0, 1))->setValue(20);
        QTRY_VERIFY_WITH_TIMEOUT(films->count() > 1, patience());
    }

    void packDialog_wholeSheets_becomeASeriesOnTheRoll() {
        PackDialog dialog(registry_);
        dialog.add({ball(QStringLiteral("Series"))});
        part<QComboBox>(dialog, "packFilm")->setCurrentText(QStringLiteral("Roll"));
        part<QDoubleSpinBox>(dialog, "packWidth")->setValue(140);
        part<QDoubleSpinBox>(dialog, "packSpacing")->setValue(10);
        part<QCheckBox>(dialog, "packWhole")->click();
        QVERIFY(!part<QDoubleSpinBox>(dialog, "packMargin")->isEnabled());
        qobject_cast<NumberBox*>(dialog.findChild<QTableWidget*>()->cellWidget(0, 1))->setValue(2);
        part<QPushButton>(dialog, "packLayOut")->click();
        QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>(dialog, "packExport")->isEnabled(), patience());
        auto* films = part<QComboBox>(dialog, "packShown");
        QCOMPARE(films->count(), 1);
        // Two films of 120 mm, the gap between them, and the roll's edges of 5 and 10 mm: 265 mm,
        // and a little more because of the coarse pixels.
        QVERIFY2(films->currentText().contains(QStringLiteral("140 × 266")),
                 qPrintable(films->currentText()));
    }

    void packDialog_exportAndPrint_deliversFilm() {
        PrivateCups cups;
        QVERIFY2(cups.problem().isEmpty(), qPrintable(cups.problem()));
        QVERIFY(cups.add({"pigment"}));
        PackDialog dialog(registry_);
        dialog.show();
        dialog.add({ball(QStringLiteral("Printed"))});
        auto* film = part<QComboBox>(dialog, "packFilm");
        film->setCurrentText(QStringLiteral("A4"));
        part<QPushButton>(dialog, "packLayOut")->click();
        auto* write = part<QPushButton>(dialog, "packExport");
        QTRY_VERIFY_WITH_TIMEOUT(write->isEnabled(), patience());

        const QTemporaryDir films;
        answerWithFile(films.path());
        write->click();
        auto* message = part<QLabel>(dialog, "packTold");
        QTRY_VERIFY_WITH_TIMEOUT(message->text().contains(films.path()), patience());
        const QStringList files = QDir(films.path()).entryList(QDir::Files);
        QCOMPARE(files.filter(QStringLiteral(".pdf")).size(), 1);
        const QString pdf = films.filePath(files.filter(QStringLiteral(".pdf")).front());
        QVERIFY(std::abs(pdfPage(pdf).width() - 210) < 0.1);

        QFile kept(pdf);
        QVERIFY(kept.open(QIODevice::WriteOnly) && kept.write("kept") == 4);
        kept.close();
        answerWithFile(films.path());
        QTimer waiting;
        bool isAsked = false;
        connect(&waiting, &QTimer::timeout, this, [&isAsked] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                isAsked = box->objectName() == QLatin1String("replaceQuestion");
                box->reject();
            }
        });
        waiting.start(50);
        write->click();
        waiting.stop();
        QVERIFY(isAsked);
        QVERIFY(write->isEnabled()); // no job has started
        QCOMPARE(QFileInfo(pdf).size(), qint64(4));

        part<QPushButton>(dialog, "packPrint")->click();
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        auto* question = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        QVERIFY(question != nullptr && question != &dialog);
        QPushButton* print = nullptr;
        for (auto* candidate : question->findChildren<QPushButton*>()) {
            print = candidate->text().contains(QStringLiteral("Print")) ? candidate : print;
        }
        QVERIFY(print != nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(print->isEnabled(), patience());
        print->click();
        QTRY_COMPARE_WITH_TIMEOUT(cups.received(QStringLiteral("pigment")).size(), 1, patience());
        const QSizeF page = pdfPage(cups.received(QStringLiteral("pigment")).front());
        QVERIFY(std::abs(page.width() - 210) < 0.1 && std::abs(page.height() - 297) < 0.1);
    }

    void packDialog_filmTooSmall_saysSo() {
        PackDialog dialog(registry_);
        dialog.add({ball(QStringLiteral("Large"))});
        auto* film = part<QComboBox>(dialog, "packFilm");
        film->setCurrentIndex(film->findData(QStringLiteral("custom")));
        part<QDoubleSpinBox>(dialog, "packWidth")->setValue(60);
        part<QDoubleSpinBox>(dialog, "packLength")->setValue(60);
        part<QPushButton>(dialog, "packLayOut")->click();
        auto* message = part<QLabel>(dialog, "packTold");
        QTRY_VERIFY_WITH_TIMEOUT(message->text().contains(QStringLiteral("larger film")),
                                 patience());
        QVERIFY(!part<QPushButton>(dialog, "packExport")->isEnabled());
        QVERIFY(!part<QPushButton>(dialog, "packPrint")->isEnabled());
    }
};

QTEST_MAIN(PackDialogTest)
#include "PackDialogTest.moc"

// Makes a job with two dips in the real window: adds a second dip, runs, moves the seam and undoes
// that, writes the cradles, and prints both sheets with a real CUPS.
#include "FileAnswer.h"
#include "PaperMeasure.h"
#include "Patience.h"
#include "PrivateCups.h"
#include "TestFolders.h"
#include "WindowDriver.h"
#include "model/TexturedMesh.h"
#include "results/Results.h"
#include "workbench/project/ProjectTree.h"
#include "workbench/results/ResultsPanel.h"
#include "workbench/results/Timeline.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QToolButton>

using namespace dipwright;

namespace {

const QString model = sampleFolder("/models/turtle.obj");
const QString texture = sampleFolder("/models/turtle.png");

// The window adds the second dip.
void makeCoarseDip(Project& project) {
    makeCoarse(project);
    project.share.registrationError = Millimetres(0.1); // narrow overlap, so the seam can move
}

int count(const QImage& picture, const QColor& colour) {
    int found = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            found += picture.pixelColor(x, y) == colour;
        }
    }
    return found;
}

template <typename Widget>
Widget* labelled(const QWidget& parent, const QString& text) {
    for (auto* candidate : parent.findChildren<Widget*>()) {
        if (candidate->text().contains(text)) {
            return candidate;
        }
    }
    return nullptr;
}

// Works with the mouse and counts the clicks.
class Mouse {
public:
    void click(QWidget* widget) {
        QVERIFY(widget && widget->isVisible() && widget->isEnabled());
        ++clicks_;
        QTest::mouseClick(widget, Qt::LeftButton);
    }
    // Opens the box and clicks on an entry.
    void choose(QComboBox* box, const QString& entry) {
        clicks_ += 2;
        box->setCurrentIndex(box->findText(entry));
    }
    // Clicks on the button, and double-clicks on a file in the dialog that it opens.
    void chooseFile(QWidget* button, const QString& path) {
        answerWithFile(path);
        click(button);
        ++clicks_;
    }
    int clicks() const { return clicks_; }

private:
    int clicks_ = 0;
};

QWidget* toolButton(const QWidget& window, const QAction* action) {
    for (auto* button : window.findChildren<QToolButton*>()) {
        if (button->defaultAction() == action && button->isVisible()) {
            return button;
        }
    }
    return nullptr;
}

} // namespace

class TwoDipsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        QVERIFY2(cups_.problem().isEmpty(), qPrintable(cups_.problem()));
        QVERIFY(cups_.add({"pigment"}));
        workbench_ = std::make_unique<Workbench>(folder_.filePath(QStringLiteral("recovery")));
        Preferences preferences = workbench_->preferences();
        preferences.liveUpdate = false;
        workbench_->setPreferences(preferences);
        window_ = std::make_unique<MainWindow>(*workbench_);
        window_->show();
    }
    void cleanupTestCase() {
        window_.reset();
        workbench_.reset();
    }

    void run_twoDips_sharesBody() {
        QVERIFY(driver().create(model, texture, 90, makeCoarseDip));
        driver().trigger("addImmersion");
        QCOMPARE(project().immersions.size(), std::size_t(2));
        QVERIFY(driver().run());
        QVERIFY(result().share != nullptr);
        QVERIFY(!result().coverage.isNull());
        second_ = result().share->areas.second;
        sheets_ = {result().immersions[0].sheet.image, result().immersions[1].sheet.image};
    }

    void sheetPage_shares_showsPainterColours() {
        auto* results = driver().find<ResultsPanel>("results");
        results->setCurrentIndex(4);
        auto* shares = results->findChild<QAction*>(QStringLiteral("sheetShares"));
        QVERIFY(shares && shares->isVisible());
        const QImage plain = results->grab().toImage();
        shares->trigger();
        const QImage shared = results->grab().toImage();
        QVERIFY(count(shared, painterColour(Painter::First)) >
                count(plain, painterColour(Painter::First)) + 50); // at least the legend
        shares->trigger();
        QTRY_COMPARE(results->grab().toImage(), plain);
    }

    void seamBrush_drag_movesSeamUntilUndo() {
        driver().find<ProjectTree>("projectTree")->select({ProjectPart::Share, 0});
        driver().find<QDoubleSpinBox>("joinBrushRadius")->setValue(15);
        auto* brush = driver().find<QComboBox>("joinBrush");
        brush->setCurrentIndex(brush->findData(int(ShareMarkKind::Second)));
        driver().trigger("coverage");
        auto* timeline = window_->findChild<Timeline*>();
        timeline->setPosition(timeline->frames());
        driver().trigger("right"); // shows where both dips reach
        window_->view().picture();
        WindowDriver::drag(window_->view(), {0.35, 0.5}, {0.65, 0.5});
        QVERIFY(!project().share.marks.empty());
        QVERIFY(driver().run());
        QVERIFY2(
            result().share->areas.second > second_ + 5,
            qPrintable(QStringLiteral("dip 2 paints %1 mm², expected over 5 mm² more than %2 mm²")
                           .arg(result().share->areas.second)
                           .arg(second_)));
        QVERIFY(result().immersions[0].sheet.image != sheets_[0]);
        driver().trigger("undo");
        QVERIFY(project().share.marks.empty());
        QVERIFY(driver().run());
        QCOMPARE(result().immersions[0].sheet.image, sheets_[0]);
        QCOMPARE(result().immersions[1].sheet.image, sheets_[1]);
        driver().trigger("coverage");
    }

    void exportCradles_chosenFolder_isWritten() {
        answerWithFile(folder_.path());
        driver().trigger("exportCradles");
        QTRY_VERIFY_WITH_TIMEOUT(
            QFileInfo::exists(folder_.filePath(QStringLiteral("cradle-1.stl"))), patience());
        QTRY_VERIFY_WITH_TIMEOUT(
            !window_->isEmpty() && driver().action("exportCradles")->isEnabled(), patience());
    }

    void print_bothSheets_arrive() {
        driver().trigger("print");
        QTRY_VERIFY(QApplication::activeModalWidget() != nullptr);
        QWidget& dialog = *QApplication::activeModalWidget();
        for (const Immersion& immersion : project().immersions) {
            auto* tick = labelled<QCheckBox>(dialog, immersion.name);
            QVERIFY2(tick && tick->isChecked(), qPrintable(immersion.name));
        }
        QTRY_VERIFY_WITH_TIMEOUT(labelled<QLabel>(dialog, QStringLiteral("Pages: 2")) != nullptr,
                                 patience());
        QPushButton* print = labelled<QPushButton>(dialog, QStringLiteral("Print"));
        QVERIFY(print->isEnabled());
        print->click();
        QTRY_COMPARE_WITH_TIMEOUT(cups_.received(QStringLiteral("pigment")).size(), 2, patience());
        for (const QString& file : cups_.received(QStringLiteral("pigment"))) {
            QVERIFY(std::abs(pdfPage(file).width() - 210) < 0.1);
            QVERIFY(std::abs(pdfPage(file).height() - 297) < 0.1);
        }
    }

    // From a textured model to two printed sheets: docs/files-and-commands.md, "From a model to two
    // printed sheets", lists the clicks.
    void newModel_nineClicks_printTwoSheets() {
        const QTemporaryDir folder; // with a model that does not name its texture
        QVERIFY(QFile::copy(model, folder.filePath(QStringLiteral("jaguar.obj"))));
        QVERIFY(QFile::copy(texture, folder.filePath(QStringLiteral("jaguar.png"))));
        const qsizetype printed = cups_.received(QStringLiteral("pigment")).size();
        MainWindow window(*workbench_);
        window.show();
        const WindowDriver own(window);
        connect(&window.documents(), &DocumentSession::documentChanged, &window, [&window] {
            if (Document* document = window.document()) {
                document->edit({}, {}, makeCoarse); // so that the test is quick
            }
        });
        Mouse mouse;
        mouse.click(toolButton(window, own.action("new")));
        QTRY_VERIFY(own.find<QDialog>("newProjectDialog") != nullptr);
        auto& dialog = *own.find<QDialog>("newProjectDialog");
        QTRY_VERIFY(dialog.isVisible());
        mouse.chooseFile(dialog.findChild<QToolButton*>(),
                         folder.filePath(QStringLiteral("jaguar.obj")));
        const QList<QLineEdit*> files = dialog.findChildren<QLineEdit*>();
        QTRY_VERIFY_WITH_TIMEOUT(files[1]->text().endsWith(QStringLiteral("jaguar.png")),
                                 patience());
        mouse.click(labelled<QRadioButton>(dialog, QStringLiteral("largest dimension")));
        auto* size = dialog.findChild<QDoubleSpinBox*>();
        QTest::keyClicks(size, QStringLiteral("95")); // the only entry; replaces the 90
        QCOMPARE(size->value(), 95.0);
        for (auto* box : dialog.findChildren<QComboBox*>()) {
            if (box->findText(QStringLiteral("Two dips: bottom and top")) >= 0) {
                mouse.choose(box, QStringLiteral("Two dips: bottom and top"));
            }
        }
        QSignalSpy finished(&window.session(), &DipSession::finished);
        mouse.click(dialog.findChild<QPushButton*>("createAndRun"));
        QTRY_VERIFY_WITH_TIMEOUT(!finished.isEmpty(), patience());
        QVERIFY(!window.document()->project().model->textures.empty());
        QCOMPARE(window.document()->project().immersions.size(), std::size_t(2));
        QTRY_VERIFY_WITH_TIMEOUT(own.action("print")->isEnabled(), patience());
        mouse.click(toolButton(window, own.action("print")));
        QTRY_VERIFY(own.find<QDialog>("printDialog") != nullptr);
        auto& printing = *own.find<QDialog>("printDialog");
        QTRY_VERIFY_WITH_TIMEOUT(labelled<QLabel>(printing, QStringLiteral("Pages: 2")) != nullptr,
                                 patience());
        mouse.click(labelled<QPushButton>(printing, QStringLiteral("Print")));
        QTRY_COMPARE_WITH_TIMEOUT(cups_.received(QStringLiteral("pigment")).size(), printed + 2,
                                  patience());
        QVERIFY2(mouse.clicks() <= 9, qPrintable(QString::number(mouse.clicks())));
    }

private:
    WindowDriver driver() { return WindowDriver(*window_); }
    const Project& project() const { return window_->document()->project(); }
    const JobResult& result() const { return *window_->document()->result(); }

    PrivateCups cups_;
    QTemporaryDir folder_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<MainWindow> window_;
    double second_ = 0; // mm² painted by dip 2 alone
    std::array<QImage, 2> sheets_;
};

int main(int argc, char** argv) {
    return runWindowTest<TwoDipsTest>(argc, argv);
}
#include "TwoDipsTest.moc"

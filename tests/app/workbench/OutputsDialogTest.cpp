// Makes outputs in the dialog and on the command line, and compares the files.
#include "workbench/outputs/OutputsDialog.h"
#include "CliProcess.h"
#include "Patience.h"
#include "SaveNow.h"
#include "TestFolders.h"
#include "base/InkPicture.h"
#include "outputs/MakeOutputs.h"
#include "pipeline/Pipeline.h"
#include "project/ProjectStore.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTreeWidget>
#include <QtTest>
#include <map>

using namespace dipwright;

namespace {

// Returns all files below the folder by name. The report has the times of the run.
std::map<QString, QByteArray> filesIn(const QString& folder) {
    std::map<QString, QByteArray> files;
    QDirIterator all(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        QFile file(all.next());
        const QString name = QDir(folder).relativeFilePath(file.fileName());
        if (name != QLatin1String("report.json") && name != QLatin1String("outputs.json") &&
            file.open(QIODevice::ReadOnly)) {
            files[name] = file.readAll();
        }
    }
    return files;
}

QStringList namesOf(const std::map<QString, QByteArray>& files) {
    QStringList names;
    for (const auto& [name, bytes] : files) {
        names << name;
    }
    return names;
}

} // namespace

class OutputsDialogTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString job_ = folder_.filePath(QStringLiteral("turtle.dipw"));
    std::unique_ptr<Document> document_;
    std::shared_ptr<const JobResult> result_;

    QString target(const char* name) const { return folder_.filePath(QLatin1String(name)); }

    // Chooses set and folder, makes the outputs and waits. Returns the text that it then shows.
    static QString make(OutputsDialog& dialog, const QString& set, const QString& target) {
        auto* box = dialog.findChild<QComboBox*>("outputSet");
        box->setCurrentIndex(box->findText(set));
        emit box->activated(box->findText(set));
        dialog.findChild<QLineEdit*>("outputsFolder")->setText(target);
        QSignalSpy made(&dialog, &OutputsDialog::made);
        dialog.findChild<QPushButton*>("makeOutputsNow")->click();
        [&] { QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, patience()); }();
        return dialog.findChild<QLabel*>("outputsWords")->text();
    }

    static QString stateOf(const OutputsDialog& dialog, Output output) {
        const auto number =
            std::find(allOutputs.begin(), allOutputs.end(), output) - allOutputs.begin();
        return dialog.findChild<QTreeWidget*>("outputs")->topLevelItem(int(number))->text(1);
    }

private slots:
    void initTestCase() {
        QStandardPaths::setTestModeEnabled(true);
        QLocale::setDefault(QLocale(QStringLiteral("en"))); // as in the window
        QSettings().clear();
        qputenv("DIPWRIGHT_PRINT_HISTORY", folder_.filePath(QStringLiteral("history")).toUtf8());
        Project project = loadProject(sampleFolder("/turtle.dipw"));
        project.film.resolution = FilmResolution::Points;
        project.film.columns = 40;
        project.film.rows = 56;
        project.fieldResolution = 64;
        project.sheet.resolution = DotsPerInch(50);
        project.cradle.cell = Millimetres(2);
        saveProject(project, job_);
        document_ = std::make_unique<Document>(loadProject(job_), job_);
        const SolverRegistry registry{QStringList{pluginFolder()}};
        JobOptions options;
        options.estimatesNumericalError = false; // so that the test is quick
        result_ = std::make_shared<const JobResult>(
            runJob(document_->project(), registry, options, nullptr, {}));
        document_->setResult(result_);
    }

    void everything_dialogAndCommandLine_giveTheSameFiles() {
        OutputsDialog dialog(*document_, result_);
        const QString words = make(dialog, QStringLiteral("Everything"), target("window"));
        QVERIFY2(words.startsWith(QStringLiteral("Made the outputs")), qPrintable(words));
        QCOMPARE(stateOf(dialog, Output::SheetPdf), QStringLiteral("Done"));
        const test::Outcome run =
            test::cli({"run", job_, "--out", target("cli"), "--outputs", "everything", "--quiet",
                       "--no-certainty", "--language", "en"});
        QVERIFY2(run.exitCode == 0, run.err + run.out);
        const auto fromWindow = filesIn(target("window")), fromCli = filesIn(target("cli"));
        QCOMPARE(namesOf(fromWindow), namesOf(fromCli));
        for (const auto& [name, bytes] : fromWindow) {
            QVERIFY2(bytes == fromCli.at(name), qPrintable(name + QStringLiteral(" differs")));
        }
        for (const char* name : {"immersion-1/sheet.pdf", "immersion-2/print.tiff", "cradle-1.stl",
                                 "traveller.pdf", "motion-2.gcode", "proof.png"}) {
            QVERIFY2(fromWindow.contains(QLatin1String(name)), name);
        }
    }

    void ownSet_savedInTheProject_isKnownToTheCommandLine() {
        {
            OutputsDialog dialog(*document_, result_);
            auto* list = dialog.findChild<QTreeWidget*>("outputs");
            for (int row = 0; row < list->topLevelItemCount(); ++row) {
                list->topLevelItem(row)->setCheckState(0, row == 0 ? Qt::Checked : Qt::Unchecked);
            }
            dialog.findChild<QComboBox*>("outputSet")->setEditText(QStringLiteral("For Ana"));
            dialog.findChild<QPushButton*>("saveOutputSet")->click();
        }
        QVERIFY(document_->undoStack().canUndo());
        saveNow(*document_, job_);
        QVERIFY(document_->isFresh()); // a set changes no result
        const test::Outcome run = test::cli({"run", job_, "--out", target("ana"), "--outputs",
                                             "for ana", "--no-certainty", "--quiet"});
        QVERIFY2(run.exitCode == 0, run.err);
        QCOMPARE(namesOf(filesIn(target("ana"))),
                 QStringList({QStringLiteral("immersion-1/sheet.pdf"),
                              QStringLiteral("immersion-2/sheet.pdf")}));
        const test::Outcome unknown =
            test::cli({"run", job_, "--out", target("bob"), "--outputs", "for bob"});
        QVERIFY(unknown.exitCode != 0 && unknown.err.contains("For Ana"));
        QVERIFY(!QFileInfo::exists(target("bob")));
    }

    void foreignFile_isKeptUntilOverwritingIsAllowed() {
        QVERIFY(QDir().mkpath(target("own")));
        QFile mine(target("own/traveller.pdf"));
        QVERIFY(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
        mine.close();
        OutputsDialog dialog(*document_, result_);
        const QString words = make(dialog, QStringLiteral("Tank"), target("own"));
        QVERIFY2(words.contains(QStringLiteral("traveller.pdf")), qPrintable(words));
        QCOMPARE(stateOf(dialog, Output::Traveller), QStringLiteral("Failed"));
        QCOMPARE(stateOf(dialog, Output::Motion), QStringLiteral("Done")); // the others are made
        QCOMPARE(filesIn(target("own"))[QStringLiteral("traveller.pdf")], QByteArray("mine"));
        dialog.findChild<QCheckBox*>("overwrite")->setChecked(true);
        make(dialog, QStringLiteral("Tank"), target("own"));
        QCOMPARE(stateOf(dialog, Output::Traveller), QStringLiteral("Done"));
        QVERIFY(filesIn(target("own"))[QStringLiteral("traveller.pdf")].startsWith("%PDF"));
    }

    void changedProject_outputsAreOutOfDate() {
        const auto stateInNewDialog = [this](const QString& expected) {
            OutputsDialog dialog(*document_, result_);
            auto* folder = dialog.findChild<QLineEdit*>("outputsFolder");
            folder->setText(target("changed"));
            emit folder->editingFinished();
            QTRY_COMPARE_WITH_TIMEOUT(stateOf(dialog, Output::Motion), expected, patience());
            QCOMPARE(stateOf(dialog, Output::Film), QStringLiteral("Not made"));
        };
        OutputsDialog dialog(*document_, result_);
        make(dialog, QStringLiteral("Tank"), target("changed"));
        stateInNewDialog(QStringLiteral("Done"));
        document_->edit(QStringLiteral("faster"), {}, [](Project& project) {
            project.process.dipSpeed = MillimetresPerSecond(6);
        });
        stateInNewDialog(QStringLiteral("Out of date"));
        document_->undoStack().undo();
    }

    // The printer reaches nothing of the sheet.
    void printFileThatFails_leavesNoEmptyFolder() {
        OutputRequest request;
        request.folder = target("unreached");
        request.outputs = {Output::PrintPdf};
        JobResult result = *result_;
        result.project.profiles.printer = PrinterProfile{};
        result.project.profiles.printer->margins.fill(Millimetres(140));
        QVERIFY(QDir().mkpath(request.folder));
        QCOMPARE(makeOutputs(result, request, {}).front().state, OutputState::Failed);
        QVERIFY(QDir(request.folder).isEmpty());
    }

    // The project has no hash of its model until it is saved, and then only one of the mesh.
    void changedTexture_outputsAreOutOfDate() {
        OutputRequest request;
        request.folder = target("texture");
        request.outputs = {Output::Motion};
        JobResult result = *result_;
        const auto stateFor = [&](const Project& project) {
            return outputStates(request.folder, request.outputs, project).front().state;
        };
        const auto withPictures = [&](QRgb colour, const QImage& inks) {
            Project project = result_->project;
            TexturedMesh model = *project.model;
            for (QImage& texture : model.textures) {
                texture = QImage(inks.size(), QImage::Format_RGBA8888);
                texture.fill(colour);
            }
            model.inks.assign(model.textures.size(), inks);
            project.model = std::make_shared<const TexturedMesh>(std::move(model));
            project.modelOrigin.sha256.clear();
            return project;
        };
        QImage inks = inkPicture(QSize(1, 1), QString(32, QLatin1Char('a')));
        inks.fill(0);
        result.project = withPictures(qRgb(255, 0, 0), inks);
        QVERIFY(QDir().mkpath(request.folder));
        QCOMPARE(makeOutputs(result, request, {}).front().state, OutputState::Done);
        QCOMPARE(stateFor(result_->project), OutputState::OutOfDate);
        QCOMPARE(stateFor(withPictures(qRgb(254, 0, 0), inks)), OutputState::OutOfDate);
        QImage more = inks;
        more.fill(1);
        QCOMPARE(stateFor(withPictures(qRgb(255, 0, 0), more)), OutputState::OutOfDate);
        QCOMPARE(stateFor(withPictures(qRgb(255, 0, 0), inks)), OutputState::Done);
        const QString saved = folder_.filePath(QStringLiteral("texture.dipw"));
        saveProject(result.project, saved);
        QCOMPARE(stateFor(loadProject(saved)), OutputState::Done);
    }
};

QTEST_MAIN(OutputsDialogTest)
#include "OutputsDialogTest.moc"

#include "workbench/main/ExportController.h"

#include "base/Png.h"
#include "cost/CostText.h"
#include "disk/AtomicFile.h"
#include "pipeline/JobCost.h"
#include "pipeline/WriteResults.h"
#include "results/Results.h"
#include "sheet/prepress/SheetFiles.h"
#include "workbench/accuracy/NumericalErrorDialog.h"
#include "workbench/actions/WindowActions.h"
#include "workbench/dip/FilmTable.h"
#include "workbench/jobs/StartJob.h"
#include "workbench/jobs/WriteFiles.h"
#include "workbench/outputs/OutputsDialog.h"
#include "workbench/printing/PlatesDialog.h"
#include "workbench/printing/PrintDialog.h"
#include "workbench/results/StretchPanel.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>

namespace dipwright {

ExportController::ExportController(const WindowActions& actions, const StretchPanel& stretch,
                                   const DipSession& session, JobRunner& jobs, Messages& messages,
                                   QWidget& window)
    : stretch_(stretch), session_(session), jobs_(jobs), messages_(messages), window_(window) {
    const auto on = [this](const QAction* action, auto what) {
        connect(action, &QAction::triggered, this, what);
    };
    on(actions.exportResults, &ExportController::exportResults);
    on(actions.exportPdf, &ExportController::exportSheetPdf);
    on(actions.exportPng, &ExportController::exportSheetPng);
    on(actions.exportCradles, &ExportController::exportCradles);
    on(actions.makeOutputs, &ExportController::makeOutputs);
    on(actions.print, &ExportController::print);
    on(actions.plates, &ExportController::showPlates);
    connect(&stretch, &StretchPanel::exportAsked, this, &ExportController::exportStretch);
}

void ExportController::exportResults() {
    // A reloaded model may drop the result while the user chooses a folder.
    const JobResult result =
        withCostsOf(*session_.outcome().result, session_.document()->project());
    const QString folder =
        QFileDialog::getExistingDirectory(&window_, tr("Export results to a folder"));
    if (folder.isEmpty()) {
        return;
    }
    writeFiles(jobs_, messages_, tr("Export results"), tr("Wrote the results to %1"), folder,
               [result](const QString& target, const Progress& progress) {
                   writeResults(result.project, result, target, progress);
               });
}

void ExportController::exportFile(const QString& title, const QString& name, const QString& suffix,
                                  const Write& write) {
    QFileDialog dialog(&window_, title, {}, QStringLiteral("*.") + suffix);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(name + QLatin1Char('.') + suffix);
    if (dialog.exec() == QDialog::Accepted) {
        writeFiles(jobs_, messages_, title, tr("Wrote %1"), dialog.selectedFiles().first(),
                   [write](const QString& path, const Progress&) { write(path); });
    }
}

QString ExportController::sheetName() const {
    const ImmersionResult& result = session_.outcome().result->immersions[session_.immersion()];
    return QStringLiteral("%1 %2").arg(session_.document()->title(), result.immersion.name);
}

void ExportController::exportSheetPdf() {
    exportFile(tr("Save sheet"), sheetName(), QStringLiteral("pdf"),
               [sheet = session_.outcome().result->immersions[session_.immersion()].sheet](
                   const QString& path) {
                   writeAtomically(path, [&](QIODevice& device) { writeSheetPdf(sheet, device); });
               });
}

void ExportController::exportSheetPng() {
    exportFile(tr("Save sheet"), sheetName(), QStringLiteral("png"),
               [sheet = session_.outcome().result->immersions[session_.immersion()].sheet](
                   const QString& path) {
                   writeAtomically(path, [&](QIODevice& device) { writeSheetPng(sheet, device); });
               });
}

void ExportController::exportCosts() {
    const Project& project = session_.document()->project();
    const QByteArray csv = costCsv({{project.name, jobCosts(*session_.outcome().result, project)}});
    exportFile(tr("Save costs"), tr("%1 costs").arg(session_.document()->title()),
               QStringLiteral("csv"), [csv](const QString& path) {
                   writeAtomically(path, [&](QIODevice& device) { device.write(csv); });
               });
}

void ExportController::exportCradles() {
    const std::shared_ptr<const JobResult> result = session_.outcome().result; // as above
    const QString title = tr("Export cradles");
    const QString folder =
        QFileDialog::getExistingDirectory(&window_, tr("Export cradles to a folder"));
    if (folder.isEmpty()) {
        return;
    }
    startJob(
        jobs_, messages_, title, title,
        [result, folder](const Progress& progress) {
            return writeCradles(*result, folder, progress);
        },
        [this, folder](const std::vector<Cradle>& cradles) {
            for (const Cradle& cradle : cradles) {
                for (const QString& note : cradle.notes) {
                    messages_.log(note);
                }
            }
            messages_.logAndSay(
                tr("Wrote the cradles to %1").arg(QDir::toNativeSeparators(folder)));
        });
}

void ExportController::exportStretch(const QString& suffix) {
    exportFile(tr("Export stretch"), tr("stretch"), suffix, stretchWriter(suffix));
}

ExportController::Write ExportController::stretchWriter(const QString& suffix) const {
    if (suffix == QLatin1String("vtp")) {
        return [result = session_.outcome().result,
                number = session_.immersion()](const QString& path) {
            writeAtomically(path, [&](QIODevice& device) {
                const ImmersionResult& dip = result->immersions[number];
                device.write(filmVtp(*dip.laid, *dip.appearance));
            });
        };
    }
    if (suffix == QLatin1String("csv")) {
        return
            [reading = session_.reading()](const QString& path) { writeFilmTable(*reading, path); };
    }
    return [picture = stretch_.picture()](const QString& path) {
        writeAtomically(path, [&](QIODevice& device) { writePng(picture, device, path); });
    };
}

void ExportController::makeOutputs() {
    auto* dialog = new OutputsDialog(*session_.document(), session_.outcome().result, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &OutputsDialog::made, &messages_, &Messages::logAndSay);
    dialog->open();
}

void ExportController::print() {
    auto* dialog = new PrintDialog(session_.outcome(), session_.immersion(),
                                   session_.document()->path(), &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!session_.document()->isFresh()) {
        dialog->warn(tr("These sheets were made before the last changes to the project. Run the "
                        "dip again to print the current state."));
    }
    connect(dialog, &PrintDialog::printed, &messages_, &Messages::logAndSay);
    dialog->open();
}

void ExportController::showPlates() {
    auto* dialog =
        new PlatesDialog(session_.outcome().result, session_.immersion(), unit_, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!session_.document()->isFresh()) {
        dialog->warn(tr("These sheets were made before the last changes to the project. Run the "
                        "dip again to see the current state."));
    }
    dialog->show(); // modeless: the user can continue to work
}

void ExportController::showNumericalError(const std::vector<DipNumericalError>& numericalError,
                                          bool outdated, LengthUnit unit) {
    for (const DipNumericalError& one : numericalError) {
        messages_.log(numericalErrorSentence(one, unit));
        for (const QString& note : one.notes) {
            messages_.log(note);
        }
    }
    auto* dialog = new NumericalErrorDialog(numericalError, outdated, unit, &window_);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &NumericalErrorDialog::saveAsked, this,
            [this, numericalError](const QString& folder) {
                writeFiles(jobs_, messages_, tr("Save maps"), tr("Wrote the maps to %1"), folder,
                           [numericalError](const QString& target, const Progress&) {
                               writeNumericalErrorMaps(numericalError, target);
                           });
            });
    dialog->show(); // modeless: the user can continue to work
}

} // namespace dipwright

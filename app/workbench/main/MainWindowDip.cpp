// The dip of a window's document, its results and what is read off them under the cursor.
#include "base/Bytes.h"
#include "base/Error.h"
#include "base/Png.h"
#include "dialogs/CalibrationDialog.h"
#include "dialogs/CertaintyDialog.h"
#include "dialogs/NewProjectDialog.h"
#include "dialogs/PrintDialog.h"
#include "dialogs/ProfilesDialog.h"
#include "jobs/FilmTable.h"
#include "main/MainWindow.h"
#include "main/MainWindowActions.h"
#include "main/Workbench.h"
#include "panels/PropertyPanel.h"
#include "panels/ResultsPanel.h"
#include "panels/ShippedNames.h"
#include "panels/StretchPanel.h"
#include "panels/Timeline.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImageReader>
#include <QLabel>
#include <QStatusBar>

namespace dipwright {

namespace {

constexpr std::size_t coarsePoints = 6000; // of the moving film, without a GPU
constexpr std::size_t finePoints = 60000;

} // namespace

void MainWindow::selectImmersion(std::size_t number) {
    if (number == immersion_ || number >= document_->project().immersions.size()) {
        return;
    }
    immersion_ = number;
    tree_->select({ProjectPart::Immersion, number});
    scene_->setProject(document_->project(), immersion_);
    showResults();
}

void MainWindow::projectChanged() {
    const Project& project = document_->project();
    if (immersion_ >= project.immersions.size()) {
        immersion_ = 0;
    }
    scene_->setProject(project, immersion_);
    showMeasure();
    if (!document_->isFresh(Stage::Dip, immersion_) && !session_.isRunning()) {
        timeline_->setPosition(0); // the body as it is set up now
    }
    updateFreshness();
    updateActions();
    const bool again = actions_->live->isChecked() && document_->result() && !document_->isFresh();
    if (again && !dragged_) {
        updateTimer_.start();
    }
}

void MainWindow::startDip() {
    updateTimer_.stop();
    certaintyCheck_.cancel();
    const bool fine = view_->isUsable() && !view_->isSoftwareRendered();
    session_.run(fine ? finePoints : coarsePoints);
}

void MainWindow::cancelJobs() {
    updateTimer_.stop();
    session_.cancel();
    jobLabel_->setText(tr("Cancelling …"));
}

void MainWindow::showLiveFrame() {
    const auto recording = session_.liveRecording();
    const auto frame = recording ? recording->latest() : nullptr;
    if (frame && frame.get() != shownFrame_) {
        shownFrame_ = frame.get();
        // Where drawing is slow, most of the time stays free for what the user does.
        liveTimer_.setInterval(std::max(liveInterval, 2 * view_->pictureTime()));
        scene_->showFrame(*recording, *frame);
        showMeasure();
        timeline_->setDepth(std::max(0.0, scene_->depth()), workbench_.preferences().unit);
    }
}

void MainWindow::showResults() {
    const auto reading = session_.reading(immersion_);
    const auto recording = session_.recording(immersion_);
    scene_->setResult(reading ? session_.outcome().result : nullptr, reading);
    results_->setOutcome(session_.outcome(), immersion_);
    const QSignalBlocker quiet(timeline_);
    timeline_->setFrames(recording ? int(recording->size()) : 0);
    timeline_->setPosition(document_->isFresh(Stage::Dip, immersion_) ? timeline_->frames() : 0);
    showMoment(timeline_->position());
    updateActions();
}

// Position 0 is before the dip, the last one its end with the whole film.
void MainWindow::showMoment(int position) {
    const auto recording = session_.recording(immersion_);
    if (position > 0 && position < timeline_->frames()) {
        scene_->showFrame(*recording, *recording->frame(std::size_t(position) - 1));
    } else if (position > 0) {
        scene_->showEnd();
    } else {
        scene_->showSetup();
    }
    showMeasure();
    timeline_->setDepth(std::max(0.0, scene_->depth()), workbench_.preferences().unit);
    updateFreshness();
}

void MainWindow::updateFreshness() {
    if (!document_->result() || session_.isRunning()) {
        staleBanner_->hide();
        return;
    }
    const Freshness fresh{document_->isFresh(Stage::Dip, immersion_),
                          document_->isFresh(Stage::Texture, immersion_),
                          document_->isFresh(Stage::Sheet, immersion_)};
    results_->setFreshness(fresh);
    staleBanner_->setText(fresh.dip
                              ? tr("The sheet is out of date: it was made before the last changes.")
                              : tr("The results are out of date: they were made before the last "
                                   "changes."));
    staleBanner_->setVisible(!fresh.sheet);
}

void MainWindow::setFilmLook(FilmLook look) {
    scene_->setHeat(results_->stretch().quantity(), results_->stretch().scale());
    if (look != FilmLook::Picture) {
        scene_->setFilmLook(look);
        return;
    }
    const QString path =
        QFileDialog::getOpenFileName(this, tr("Picture on the Film"), {}, pictureFileFilter());
    if (!path.isEmpty()) {
        wearPicture(path);
    }
}

void MainWindow::wearPicture(const QString& path) {
    jobs_.start(std::make_unique<ValueJob<QImage>>(
        tr("Reading the picture"),
        [path](const Progress&) {
            QImageReader reader(path);
            QImage picture = reader.read();
            if (picture.isNull()) {
                throw Error(tr("The picture cannot be read: %1").arg(reader.errorString()), path);
            }
            return picture;
        },
        [this](const QImage& picture) { scene_->setFilmLook(FilmLook::Picture, picture); },
        [this](std::exception_ptr failure) { reportFailure(tr("Picture on the Film"), failure); }));
    updateActions();
}

void MainWindow::printSheets() {
    auto* dialog = new PrintDialog(session_.outcome(), immersion_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    if (!document_->isFresh()) {
        dialog->warn(tr("These sheets were made before the last changes. Run the dip first to "
                        "print what the project now says."));
    }
    connect(dialog, &PrintDialog::printed, this, [this](const QString& sentence) {
        report(sentence);
        statusBar()->showMessage(sentence, 8000);
    });
    dialog->open();
}

void MainWindow::calibratePrinter() {
    auto* dialog = new CalibrationDialog(ProfileLibrary(), this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CalibrationDialog::calibrated, this, [this](const PrinterProfile& profile) {
        properties_->refresh();
        report(tr("Calibrated %1").arg(shownName(profile.name)));
    });
    dialog->open();
}

void MainWindow::showProfiles() {
    auto* dialog = new ProfilesDialog(ProfileLibrary(), workbench_.preferences().unit, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->allowUse(document_ != nullptr);
    connect(dialog, &ProfilesDialog::useAsked, this, [this](const Profile& profile) {
        document_->edit(tr("Use Profile %1").arg(shownName(nameOf(profile))), {},
                        [&](Project& project) { applyProfile(project, profile); });
    });
    connect(dialog, &QDialog::finished, properties_, &PropertyPanel::refresh);
    dialog->open();
}

// On the project as it is now, run or not. A dip that is wanted meanwhile does not wait for it.
void MainWindow::checkCertainty() {
    using Certainty = std::vector<ImmersionCertainty>;
    const Project project = document_->project();
    certaintyCheck_ = jobs_.start(std::make_unique<ValueJob<Certainty>>(
        tr("Checking the certainty"),
        [project, &registry = workbench_.registry()](const Progress& progress) {
            return sheetCertainty(project, registry, progress);
        },
        [this, project](const Certainty& certainty) {
            const bool outdated = !document_ || document_->project() != project;
            showCertainty(certainty, outdated);
        },
        [this](std::exception_ptr failure) { reportFailure(tr("Check Certainty"), failure); }));
    updateActions();
}

void MainWindow::showCertainty(const std::vector<ImmersionCertainty>& certainty, bool outdated) {
    const LengthUnit unit = workbench_.preferences().unit;
    for (const ImmersionCertainty& one : certainty) {
        report(certaintyVerdict(one, unit));
    }
    auto* dialog = new CertaintyDialog(certainty, outdated, unit, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &CertaintyDialog::saveAsked, this, [this, certainty](const QString& folder) {
        writeAsJob(tr("Save Maps"), tr("Wrote the maps to %1"), folder,
                   [certainty](const QString& target, const Progress&) {
                       writeCertaintyMaps(certainty, target);
                   });
    });
    dialog->show(); // beside what the user does by now
}

void MainWindow::exportResults() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Export Results to a Folder"));
    if (folder.isEmpty()) {
        return;
    }
    writeAsJob(tr("Export Results"), tr("Wrote the results to %1"), folder,
               [result = document_->result()](const QString& target, const Progress& progress) {
                   writeResults(result->project, *result, target, progress);
               });
}

void MainWindow::writeAsJob(
    const QString& title, const QString& done, const QString& path,
    const std::function<void(const QString& path, const Progress& progress)>& write) {
    jobs_.start(std::make_unique<ValueJob<bool>>(
        title,
        [write, path](const Progress& progress) {
            write(path, progress);
            return true;
        },
        [this, sentence = done.arg(QDir::toNativeSeparators(path))](bool) {
            report(sentence);
            statusBar()->showMessage(sentence, 8000);
        },
        [this, title](std::exception_ptr failure) { reportFailure(title, failure); }));
    updateActions();
}

void MainWindow::exportFile(const QString& title, const QString& name, const QString& suffix,
                            const std::function<void(const QString& path)>& write) {
    QFileDialog dialog(this, title, {}, QStringLiteral("*.") + suffix);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(name + QLatin1Char('.') + suffix);
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    writeAsJob(title, tr("Wrote %1"), dialog.selectedFiles().first(),
               [write](const QString& path, const Progress&) { write(path); });
}

void MainWindow::exportSheet(bool pdf) {
    const ImmersionResult& result = document_->result()->immersions[immersion_];
    const QString name = QStringLiteral("%1 %2").arg(document_->title(), result.immersion.name);
    const auto write = [pdf, sheet = result.sheet](const QString& path) {
        writeWhole(path, [&](QIODevice& device) {
            pdf ? writeSheetPdf(sheet, device) : writeSheetPng(sheet, device);
        });
    };
    exportFile(tr("Save Sheet"), name, pdf ? QStringLiteral("pdf") : QStringLiteral("png"), write);
}

void MainWindow::exportStretch(const QString& kind) {
    const auto result = session_.outcome().result;
    const auto reading = session_.reading(immersion_);
    const std::size_t number = immersion_;
    std::function<void(const QString&)> write;
    if (kind == QLatin1String("vtp")) {
        write = [result, number](const QString& path) {
            const ImmersionResult& immersion = result->immersions[number];
            writeWhole(path, [&](QIODevice& device) {
                device.write(filmVtp(*immersion.film, *immersion.contact, *immersion.body));
            });
        };
    } else if (kind == QLatin1String("csv")) {
        write = [reading](const QString& path) { writeFilmTable(*reading, path); };
    } else {
        write = [picture = results_->stretch().picture()](const QString& path) {
            writeWhole(path, [&](QIODevice& device) { writePng(picture, device, path); });
        };
    }
    exportFile(tr("Export Stretch"), tr("stretch"), kind, write);
}

void MainWindow::hoverRay(const ViewRay& ray) {
    const auto worldToEnd = scene_->worldToEnd();
    if (worldToEnd) {
        const Eigen::Isometry3f toPose = worldToEnd->cast<float>();
        showReading(
            session_.reading(immersion_)->at(toPose * ray.origin, toPose.linear() * ray.direction));
        return;
    }
    const auto point = document_ ? scene_->modelPoint(ray) : std::nullopt;
    readingLabel_->setText(
        point ? tr("Body at %1, %2, %3")
                    .arg(shownLength(double(point->x()), workbench_.preferences().unit),
                         shownLength(double(point->y()), workbench_.preferences().unit),
                         shownLength(double(point->z()), workbench_.preferences().unit))
              : QString());
}

void MainWindow::showReading(const std::optional<FilmReadingPoint>& point) {
    results_->showReading(point);
    if (!point) {
        readingLabel_->clear();
        view_->setMarker({});
        return;
    }
    if (const auto worldToEnd = scene_->worldToEnd()) {
        view_->setMarker(Eigen::Vector3f(worldToEnd->inverse().cast<float>() * point->place));
    }
    const solver::FilmGrid& grid = session_.reading(immersion_)->film().grid;
    const FilmSettings& film = session_.outcome().result->project.film;
    const LengthUnit unit = workbench_.preferences().unit;
    const auto number = [this, &point](FilmQuantity quantity) {
        return locale().toString(double(point->values[std::size_t(quantity)]), 'f', 3);
    };
    readingLabel_->setText(
        tr("Sheet %1, %2 · %3 · stretch %4 · area %5 · %6 to %7")
            .arg(shownLength((double(point->rest.x()) / grid.width + 0.5) * film.width.value(),
                             unit),
                 shownLength((double(point->rest.y()) / grid.depth + 0.5) * film.height.value(),
                             unit),
                 point->adhered ? tr("on the body") : tr("on the water"),
                 number(FilmQuantity::Length), number(FilmQuantity::Area),
                 number(FilmQuantity::Smaller), number(FilmQuantity::Larger)));
}

void MainWindow::measureAt(const ViewRay& ray) {
    if (!measuring_) {
        return;
    }
    const auto point = scene_->modelPoint(ray);
    if (!point) {
        return;
    }
    if (measured_.size() == 2) {
        measured_.clear();
    }
    measured_.push_back(*point);
    measuredModel_ = document_->project().model;
    showMeasure();
    statusBar()->showMessage(measured_.size() < 2 ? tr("Click the second place on the body")
                                                  : tr("Distance %1").arg(measuredDistance()));
}

QString MainWindow::measuredDistance() const {
    return measured_.size() < 2 ? QString()
                                : shownLength(double((measured_[1] - measured_[0]).norm()),
                                              workbench_.preferences().unit);
}

// The marks stay on the body wherever it goes, and go with it.
void MainWindow::showMeasure() {
    if (document_ && document_->project().model != measuredModel_) {
        measured_.clear();
    }
    std::vector<Eigen::Vector3f> shown;
    for (const Eigen::Vector3f& place : measured_) {
        shown.push_back(scene_->toWorld(place));
    }
    view_->setMeasure(shown, measuredDistance());
}

void MainWindow::dragRotation(int axis, double degrees) {
    if (!dragged_) {
        dragged_ = document_->project().immersions[immersion_];
    }
    const auto angle = [this](int part) { return radians(dragged_->rotation[std::size_t(part)]); };
    using Eigen::AngleAxisd, Eigen::Vector3d;
    const Eigen::Matrix3d before =
        (AngleAxisd(angle(2), Vector3d::UnitZ()) * AngleAxisd(angle(1), Vector3d::UnitY()) *
         AngleAxisd(angle(0), Vector3d::UnitX()))
            .toRotationMatrix();
    const Eigen::Matrix3d after =
        AngleAxisd(radians(Degrees(degrees)), Vector3d::Unit(axis)).toRotationMatrix() * before;
    const Vector3d angles = after.eulerAngles(2, 1, 0) * 180 / pi; // about Z, Y, X
    document_->edit(tr("Turn Body"), QStringLiteral("turn"), [&](Project& project) {
        auto& rotation = project.immersions[immersion_].rotation;
        for (int part = 0; part < 3; ++part) {
            rotation[std::size_t(part)] = Degrees(std::round(angles[2 - part] * 10) / 10);
        }
    });
}

void MainWindow::finishRotation() {
    dragged_.reset();
    document_->endMerge();
    projectChanged();
}

} // namespace dipwright

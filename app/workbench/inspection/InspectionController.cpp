#include "workbench/inspection/InspectionController.h"

#include "base/Error.h"
#include "import/trusted/ReadPhotos.h"
#include "pipeline/Pipeline.h"
#include "pipeline/SameSheets.h"
#include "viewport/DipView.h"
#include "workbench/inspection/InspectionEdits.h"
#include "workbench/jobs/StartJob.h"
#include "workbench/jobs/WriteFiles.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace dipwright {

namespace {

PartPhoto readPart(const QString& file, const Progress& progress) {
    Photo photo = readPhotoFile(file, progress);
    return {file, photo.sha256, std::move(photo.picture)};
}

// Reads the part's photos, except those that are known.
std::vector<PartPhoto> photosOf(const InspectedPart& part,
                                const std::map<QString, PartPhoto>& known,
                                const Progress& progress) {
    std::vector<PartPhoto> photos;
    for (const InspectedPhoto& photo : part.photos) {
        const auto found = known.find(photo.file);
        addPartPhoto(photos, found == known.end() ? readPart(photo.file, progress) : found->second);
    }
    return photos;
}

MeasuredPart ofPairs(std::vector<PartPhoto> photos, const Project& project) {
    MeasuredPart measured;
    measured.project = project;
    measured.pairs = clickedPairs(project.inspection);
    measured.view =
        fitPartCamera(measured.pairs, int(photos.size()), photos[0].picture.size(), project.name);
    measured.photos = std::move(photos);
    return measured;
}

MeasuredPart ofCorners(std::vector<PartPhoto> photos, const Project& project,
                       const JobResult* earlier, const SolverRegistry& registry,
                       const Progress& progress) {
    JobOptions options;
    options.chessboard = project.inspection.chessboard;
    options.estimatesNumericalError = false;
    options.refines = !(earlier && makeSameSheets(earlier->project, project)); // as printed
    const JobResult job = runJob(project, registry, options, earlier, progress.part(0.1, 0.6));
    std::vector<std::shared_ptr<const LaidFilm>> dips;
    for (const ImmersionResult& immersion : job.immersions) {
        dips.push_back(immersion.laid);
    }
    const auto corners = printedCorners(
        project, dips, options.chessboard ? PartPrint::Chessboard : PartPrint::Texture);
    if (corners.empty()) {
        throw Error(
            InspectionController::tr(
                "The model's texture contains no chessboard squares, so there are no corners to "
                "find; dip the part with the chessboard film, or measure only the pairs"),
            project.name);
    }
    std::vector<QImage> pictures;
    for (const PartPhoto& photo : photos) {
        pictures.push_back(photo.picture);
    }
    const FoundPrint print =
        findPrint(pictures, project.model->mesh, corners, clickedPairs(project.inspection),
                  {project.inspection.keepsCamera, {}}, progress.part(0.6, 1), project.name);
    return {project,
            std::move(photos),
            pairsOf(print.places),
            print.places,
            print.expected,
            print.doubt,
            print.followsPrint,
            print.view,
            dips};
}

// Returns whether both projects give the same measurement of a part. Ignores the film measurement,
// and the measured parts while the correction is off.
bool measuresAlike(Project first, const Project& second) {
    first.filmOnWater = second.filmOnWater;
    if (!first.asBuilt.corrects && !second.asBuilt.corrects) {
        first.asBuilt = second.asBuilt;
    }
    return first == second;
}

} // namespace

InspectionController::InspectionController(DipView& view, const DipScene& scene,
                                           const DipSession& session, JobRunner& jobs,
                                           const SolverRegistry& registry, Messages& messages,
                                           QWidget& window)
    : view_(view), scene_(scene), session_(session), jobs_(jobs), registry_(registry),
      messages_(messages), window_(window), pages_(new QTabWidget), part_(new PartPage),
      film_(new FilmWatchController(session, jobs, messages, window)),
      fit_(new FitController(session, jobs, registry, messages, window)),
      built_(new BuiltController(session, jobs, messages)) {
    for (QObject* other : std::initializer_list<QObject*>{film_, fit_, built_}) {
        other->setParent(this);
    }
    pages_->setObjectName(QStringLiteral("inspection"));
    pages_->setDocumentMode(true);
    pages_->addTab(part_, tr("Dipped part"));
    pages_->addTab(fit_->page(), tr("Fit"));
    pages_->addTab(built_->page(), tr("As built"));
    pages_->addTab(film_->page(), tr("Film on the water"));
    connect(&jobs, &JobRunner::busy, this, [this] { part_->setBusy(true); });
    connect(&jobs, &JobRunner::idle, this, [this] { part_->setBusy(false); });
    connect(&view, &DipView::clicked, this, &InspectionController::click);
    connectPart();
}

void InspectionController::connectPart() {
    connect(part_, &PartPage::photosChosen, this, &InspectionController::readPhotos);
    connect(part_, &PartPage::photoLookedAt, this, &InspectionController::lookAt);
    connect(part_, &PartPage::removePhotoAsked, this,
            [this](int photo) { removeInspectedPhoto(*session_.document(), std::size_t(photo)); });
    connect(part_, &PartPage::pairMoved, this, [this](int pair, QPointF pixel) {
        moveClickedPair(*session_.document(), std::size_t(pair), pixel);
    });
    connect(part_, &PartPage::pairDropped, this, [this] { session_.document()->endMerge(); });
    connect(part_, &PartPage::pairChosen, this, [this](int pair) {
        const auto& place =
            session_.document()->project().inspection.pairs[std::size_t(pair)].place;
        view_.setMarker(scene_.toWorld(
            Eigen::Vector3d(place[0].value(), place[1].value(), place[2].value()).cast<float>()));
    });
    connect(part_, &PartPage::removePairAsked, this,
            [this](int pair) { removeClickedPair(*session_.document(), std::size_t(pair)); });
    connect(part_, &PartPage::chessboardChosen, this, [this](bool chessboard) {
        session_.document()->edit(tr("Choose dipped image"), {}, [&](Project& project) {
            project.inspection.chessboard = chessboard;
        });
    });
    connect(part_, &PartPage::keepsCameraChosen, this, [this](bool keeps) {
        session_.document()->edit(tr("Choose kind of pairs"), {}, [&](Project& project) {
            project.inspection.keepsCamera = keeps;
        });
    });
    connect(part_, &PartPage::cameraAsked, this, [this] { measurePart(false); });
    connect(part_, &PartPage::cornersAsked, this, [this] { measurePart(true); });
    connect(part_, &PartPage::exportAsked, this, &InspectionController::exportPart);
}

void InspectionController::showDocument() {
    photos_.clear();
    measured_ = nullptr;
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &InspectionController::showProject);
    }
    showProject();
    film_->showDocument();
    built_->showDocument();
}

void InspectionController::showProject() {
    const Document* document = session_.document();
    const bool holds =
        measured_ && document && measuresAlike(measured_->project, document->project());
    const auto measured = holds ? measured_ : nullptr; // undo can make measured_ valid again
    part_->setPart(document ? document->project().inspection : InspectedPart{});
    part_->setMeasured(measured);
    fit_->setMeasured(measured);
    built_->setMeasured(measured);
}

void InspectionController::readPhotos(const QStringList& files) {
    std::vector<PartPhoto> known;
    if (const Document* document = session_.document()) {
        for (const InspectedPhoto& photo : document->project().inspection.photos) {
            if (const auto read = photos_.find(photo.file); read != photos_.end()) {
                known.push_back(read->second);
            }
        }
    }
    startJob(
        jobs_, messages_, tr("Reading photos"), tr("Photos"),
        [files, known](const Progress& progress) {
            std::vector<PartPhoto> photos = known;
            for (qsizetype i = 0; i < files.size(); ++i) {
                progress(double(i) / double(files.size()), files[i]);
                const bool isKnown =
                    std::any_of(photos.begin(), photos.end(),
                                [&](const PartPhoto& photo) { return photo.where == files[i]; });
                if (!isKnown) {
                    addPartPhoto(photos, readPart(files[i], progress));
                }
            }
            return photos;
        },
        [this](const std::vector<PartPhoto>& photos) {
            std::vector<InspectedPhoto> added;
            for (const PartPhoto& photo : photos) {
                photos_[photo.where] = photo;
                added.push_back({photo.where, photo.sha256});
            }
            if (Document* document = session_.document()) {
                addInspectedPhotos(*document, added);
            }
        });
}

void InspectionController::lookAt(int photo) {
    Document* document = session_.document();
    if (!document || photo < 0) {
        part_->setPicture({}, tr("No photos yet"));
        return;
    }
    const InspectedPhoto& looked = document->project().inspection.photos[std::size_t(photo)];
    if (const auto known = photos_.find(looked.file); known != photos_.end()) {
        part_->setPicture(known->second.picture, {});
        return;
    }
    part_->setPicture({}, tr("Reading %1").arg(QFileInfo(looked.file).fileName()));
    if (document->isTrusted(looked.file)) {
        readAgain(looked);
        return;
    }
    messages_.askToRead(tr("Photos"), tr("The project refers to this photo:"), {looked.file},
                        [this, looked] {
                            if (Document* allowed = session_.document()) {
                                allowed->trust(looked.file);
                                readAgain(looked);
                            }
                        });
}

void InspectionController::readAgain(const InspectedPhoto& photo) {
    startJob(
        jobs_, messages_, tr("Reading photos"), tr("Photos"),
        [photo](const Progress& progress) { return readPart(photo.file, progress); },
        [this, photo](const PartPhoto& read) {
            if (!photo.sha256.isEmpty() && photo.sha256 != read.sha256) {
                messages_.notice(tr("The photo %1 has changed since its places were clicked.")
                                     .arg(QFileInfo(photo.file).fileName()));
            }
            photos_[photo.file] = read;
            const Document* document = session_.document();
            const auto number = std::size_t(std::max(0, part_->photo()));
            if (document && number < document->project().inspection.photos.size() &&
                document->project().inspection.photos[number].file == photo.file) {
                part_->setPicture(read.picture, {});
            }
        });
}

void InspectionController::click(const ViewRay& ray) {
    const auto pending = part_->isVisible() ? part_->pending() : std::nullopt;
    const auto place = pending ? scene_.modelPoint(ray) : std::nullopt;
    if (!place || !session_.document()) {
        return;
    }
    ClickedPair pair{part_->photo(), {pending->x(), pending->y()}, {}};
    for (int axis = 0; axis < 3; ++axis) {
        pair.place[std::size_t(axis)] = Millimetres(double((*place)[axis]));
    }
    part_->setPending({});
    view_.setMarker(scene_.toWorld(*place));
    addClickedPair(*session_.document(), pair);
}

void InspectionController::measurePart(bool findsCorners) {
    const Project project = session_.document()->project();
    startJob(
        jobs_, messages_, findsCorners ? tr("Finding corners") : tr("Measuring pairs"),
        tr("Dipped part"),
        [project, findsCorners, known = photos_, earlier = session_.document()->result(),
         &registry = registry_](const Progress& progress) {
            std::vector<PartPhoto> photos = photosOf(project.inspection, known, progress);
            return std::make_shared<const MeasuredPart>(
                findsCorners
                    ? ofCorners(std::move(photos), project, earlier.get(), registry, progress)
                    : ofPairs(std::move(photos), project));
        },
        [this](const std::shared_ptr<const MeasuredPart>& measured) {
            measured_ = measured;
            showProject();
        });
}

void InspectionController::exportPart() {
    const QString folder =
        QFileDialog::getExistingDirectory(&window_, tr("Export residuals to a folder"));
    if (!folder.isEmpty()) {
        writeFiles(jobs_, messages_, tr("Export residuals"), tr("Wrote the residuals to %1"),
                   folder, [measured = measured_](const QString& target, const Progress&) {
                       writePartView(measured->photos, measured->pairs, measured->view,
                                     measured->places, target);
                   });
    }
}

} // namespace dipwright

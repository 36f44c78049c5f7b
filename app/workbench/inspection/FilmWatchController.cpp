#include "workbench/inspection/FilmWatchController.h"

#include "disk/AtomicFile.h"
#include "import/trusted/ReadPhotos.h"
#include "inspection/FilmWatchFiles.h"
#include "sheet/page/WatchPage.h"
#include "workbench/inspection/InspectionEdits.h"
#include "workbench/inspection/ProfileName.h"
#include "workbench/jobs/StartJob.h"
#include "workbench/jobs/WriteFiles.h"
#include "workbench/widgets/ReplaceQuestion.h"

#include <QDate>
#include <QDir>
#include <QFileDialog>

#include <algorithm>
#include <array>

namespace dipwright {

namespace {

constexpr int longestPicture = 1600; // pixels

WatchedFilm watched(const FilmOnWater& film, double begin, const Progress& progress) {
    std::vector<WatchedPhoto> photos;
    std::map<QString, QImage> boards;
    for (std::size_t i = 0; i < film.photos.size(); ++i) {
        const FloatingPhoto& one = film.photos[i];
        progress(double(i) / double(film.photos.size()), one.file);
        const Photo photo = readPhotoFile(one.file, progress); // one at a time, to save memory
        photos.push_back(
            {one.file, photo.sha256, one.seconds, photo.picture.size(),
             measureFlatFilm(photo.picture, flatSettings(film, photo.focalLength, one.file),
                             one.file)});
        boards[one.file] = boardsPicture(photo.picture, photos.back().film, longestPicture);
    }
    WatchedFilm result{evaluatedFilmWatch(std::move(photos), begin, film.rulerError.value()), {}};
    for (const WatchedPhoto& photo : result.watch.photos) {
        result.boards.push_back(boards[photo.where]);
    }
    return result;
}

const std::array pageFiles{std::pair(BoardKind::Film, QStringLiteral("film.pdf")),
                           std::pair(BoardKind::Card, QStringLiteral("card.pdf"))};

// Writes the pages for the film and the card. `page` gives their lot and scale.
void writePages(WatchPage page, const QString& folder) {
    for (const auto& [kind, file] : pageFiles) {
        page.kind = kind;
        page.paper = usualPaper(kind);
        writeAtomically(QDir(folder).filePath(file),
                        [&page](QIODevice& device) { writeWatchPdf(page, device); });
    }
}

} // namespace

FilmWatchController::FilmWatchController(const DipSession& session, JobRunner& jobs,
                                         Messages& messages, QWidget& window)
    : session_(session), jobs_(jobs), messages_(messages), window_(window), page_(new FilmPage) {
    connect(&jobs, &JobRunner::busy, page_, [this] { page_->setBusy(true); });
    connect(&jobs, &JobRunner::idle, page_, [this] { page_->setBusy(false); });
    connect(page_, &FilmPage::photosChosen, this, &FilmWatchController::addPhotos);
    connect(page_, &FilmPage::filmChanged, this,
            [this](const FilmOnWater& film, const QString& what) {
                changeFilmOnWater(*session_.document(), film, what);
            });
    connect(page_, &FilmPage::pagesAsked, this, &FilmWatchController::savePages);
    connect(page_, &FilmPage::measureAsked, this, &FilmWatchController::measure);
    connect(page_, &FilmPage::saveAsked, this, &FilmWatchController::askProfile);
    connect(page_, &FilmPage::exportAsked, this, &FilmWatchController::exportFilm);
}

void FilmWatchController::showDocument() {
    measured_ = nullptr;
    if (const Document* document = session_.document()) {
        connect(document, &Document::projectChanged, this, &FilmWatchController::showProject);
    }
    showProject();
}

double FilmWatchController::profileBegin() const {
    const Document* document = session_.document();
    const FilmProfile film =
        document ? document->project().profiles.film.value_or(FilmProfile{}) : FilmProfile{};
    return film.soakTime.value() + film.activatorTime.value();
}

void FilmWatchController::showProject() {
    const Document* document = session_.document();
    const FilmOnWater film = document ? document->project().filmOnWater : FilmOnWater{};
    FilmOnWater known = film; // without the two fields that do not affect the measurement
    known.lot = measuredFilm_.lot;
    known.waterTemperature = measuredFilm_.waterTemperature;
    if (known != measuredFilm_ ||
        film.dipBegins.value_or(Seconds(profileBegin())).value() != measuredBegin_) {
        measured_ = nullptr;
    }
    page_->setFilm(film, profileBegin());
    page_->setMeasured(measured_);
}

void FilmWatchController::addPhotos(const QStringList& files) {
    startJob(
        jobs_, messages_, tr("Reading photos"), tr("Photos"),
        [files](const Progress& progress) {
            std::vector<FloatingPhoto> photos;
            for (qsizetype i = 0; i < files.size(); ++i) {
                progress(double(i) / double(files.size()), files[i]);
                photos.push_back({files[i], readPhotoFile(files[i], progress).sha256, {}});
            }
            return photos;
        },
        [this](const std::vector<FloatingPhoto>& photos) {
            if (Document* document = session_.document()) {
                addFloatingPhotos(*document, photos);
            }
        });
}

void FilmWatchController::measure() {
    const Document& document = *session_.document();
    QStringList strange;
    for (const FloatingPhoto& photo : document.project().filmOnWater.photos) {
        if (!document.isTrusted(photo.file)) {
            strange << photo.file;
        }
    }
    if (strange.isEmpty()) {
        measureTrusted();
        return;
    }
    messages_.askToRead(tr("Photos"), tr("The project refers to these photos:"), strange,
                        [this, strange] {
                            if (Document* allowed = session_.document()) {
                                for (const QString& file : strange) {
                                    allowed->trust(file);
                                }
                                measureTrusted();
                            }
                        });
}

void FilmWatchController::measureTrusted() {
    const FilmOnWater film = session_.document()->project().filmOnWater;
    const double begin = film.dipBegins.value_or(Seconds(profileBegin())).value();
    startJob(
        jobs_, messages_, tr("Measuring the film"), tr("Film on the water"),
        [film, begin](const Progress& progress) {
            return std::make_shared<const WatchedFilm>(watched(film, begin, progress));
        },
        [this, film, begin](const std::shared_ptr<const WatchedFilm>& measured) {
            measured_ = measured;
            measuredFilm_ = film;
            measuredBegin_ = begin;
            showProject();
            reportChangedPhotos(film, measured->watch);
        });
}

// Reports photos whose file has changed since it was added.
void FilmWatchController::reportChangedPhotos(const FilmOnWater& film, const FilmWatch& watch) {
    for (const FloatingPhoto& photo : film.photos) {
        const bool isOther = std::any_of(
            watch.photos.begin(), watch.photos.end(), [&](const WatchedPhoto& measured) {
                return measured.where == photo.file && measured.sha256 != photo.sha256;
            });
        if (isOther && !photo.sha256.isEmpty()) {
            messages_.notice(tr("The photo %1 has changed since it was added.")
                                 .arg(QFileInfo(photo.file).fileName()));
        }
    }
}

WatchNotes FilmWatchController::notes() const {
    const FilmOnWater& film = session_.document()->project().filmOnWater;
    return {QDate::currentDate().toString(Qt::ISODate), film.lot, film.waterTemperature};
}

void FilmWatchController::askProfile() {
    askProfileName(window_, [this](const QString& name) { save(name); });
}

void FilmWatchController::save(const QString& name) {
    if (measured_ && session_.document()) {
        saveToProfile(messages_, name, {}, [this](const FilmProfile& profile) {
            return withMeasurement(profile, measured_->watch, notes());
        });
    }
}

void FilmWatchController::savePages() {
    const QString folder = QFileDialog::getExistingDirectory(
        &window_, tr("Save the pages for the film and the card to a folder"));
    QStringList files;
    for (const auto& [kind, file] : pageFiles) {
        files << file;
    }
    if (folder.isEmpty() || !mayReplace(folder, files, tr("Save pages to print"), &window_)) {
        return;
    }
    const Document* document = session_.document();
    WatchPage page;
    page.lot = document ? document->project().filmOnWater.lot : QString();
    if (const auto printer = document ? document->project().profiles.printer : std::nullopt) {
        page.scaleX = printer->scaleX;
        page.scaleY = printer->scaleY;
    }
    writeFiles(jobs_, messages_, tr("Save pages to print"),
               tr("Wrote film.pdf and card.pdf to %1. Print them at 100 %; the rulers must measure "
                  "100 mm."),
               folder,
               [page](const QString& target, const Progress&) { writePages(page, target); });
}

void FilmWatchController::exportFilm() {
    const QString folder =
        QFileDialog::getExistingDirectory(&window_, tr("Export film measurement to a folder"));
    if (!folder.isEmpty() && measured_) {
        writeFiles(jobs_, messages_, tr("Export film measurement"),
                   tr("Wrote the film measurement to %1"), folder,
                   [measured = measured_, notes = notes()](const QString& target, const Progress&) {
                       writeFilmWatch(measured->watch, notes, target);
                   });
    }
}

} // namespace dipwright

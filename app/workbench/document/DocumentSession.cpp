#include "workbench/document/DocumentSession.h"

#include "base/Error.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"
#include "workbench/document/ModelImport.h"
#include "workbench/document/RecentProjects.h"
#include "workbench/jobs/StartJob.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>

namespace dipwright {

namespace {

// A project, and the version of the file to which it will be saved.
struct ReadProject {
    Project project;
    FileVersion version;
};

// Reads the project at `path`. Takes the version of `file` now if it is not `known`. Throws
// Cancelled if the job was cancelled during the read.
ReadProject projectFrom(const QString& path, const QString& file,
                        const std::optional<FileVersion>& known, const Progress& progress) {
    const FileVersion version = known ? *known : FileVersion::of(file); // before it is read
    ReadProject read{loadProject(path), version};
    progress.cancelToken.throwIfCancelled();
    return read;
}

// Writes a snapshot of a document.
class SaveJob : public Job {
public:
    // `version`: of the written file; none: not written. `failure`: null if the job succeeded or
    // was cancelled.
    using Ended = std::function<void(const DocumentSnapshot& snapshot,
                                     const std::optional<FileVersion>& version,
                                     const std::exception_ptr& failure)>;

    SaveJob(DocumentSnapshot snapshot, Ended ended)
        : snapshot_(std::move(snapshot)), ended_(std::move(ended)) {}

    QString title() const override { return DocumentSession::tr("Saving the project"); }
    void process(const Progress& progress) override { version_ = snapshot_.write(progress); }
    // A file that was written before the user cancelled counts as saved.
    void finalize(bool, std::exception_ptr failure) override {
        ended_(snapshot_, version_, failure);
    }

private:
    DocumentSnapshot snapshot_;
    Ended ended_;
    std::optional<FileVersion> version_;
};

} // namespace

DocumentSession::DocumentSession(JobRunner& jobs, Messages& messages, const QString& recovery,
                                 Window window, QObject* parent)
    : QObject(parent), jobs_(jobs), messages_(messages), recovery_(recovery),
      window_(std::move(window)) {}

DocumentSession::~DocumentSession() = default;

void DocumentSession::setAutosaveInterval(int seconds) {
    autosaveSeconds_ = seconds;
    if (autoSaver_) {
        autoSaver_->setInterval(seconds);
    }
}

void DocumentSession::take(std::unique_ptr<Document> document) {
    autoSaver_.reset();
    const std::unique_ptr<Document> earlier = std::move(document_);
    document_ = std::move(document);
    autoSaver_ = std::make_unique<AutoSaver>(*document_, recovery_);
    autoSaver_->setInterval(autosaveSeconds_);
    connect(autoSaver_.get(), &AutoSaver::failed, this, [this](const QString& why) {
        messages_.notice(tr("Unsaved changes would be lost in a crash, because the recovery copy "
                            "cannot be written. Save often. %1")
                             .arg(why));
    });
    emit documentChanged();
}

DocumentSession& DocumentSession::emptySession() {
    return document_ ? window_.another() : *this;
}

void DocumentSession::openProject(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (window_.bringForward(absolute)) {
        return;
    }
    if (document_ || jobs_.isBusy()) { // perhaps opening another document
        DocumentSession& other = window_.another();
        other.readProject(absolute, messages_, other.window_.giveUp);
        return;
    }
    readProject(absolute, messages_, [] {});
}

void DocumentSession::readProject(const QString& file, Messages& teller,
                                  const std::function<void()>& failed) {
    opening_ = file;
    const auto take = [this, file, failed](const ReadProject& read) {
        if (window_.bringForward(file)) { // another window has opened it meanwhile
            failed();
            return;
        }
        auto document = std::make_unique<Document>(read.project, file, read.version);
        if (!lockOrAsk(*document)) {
            failed();
            return;
        }
        addRecentProject(file);
        messages_.log(tr("Opened %1").arg(QDir::toNativeSeparators(file)));
        this->take(std::move(document));
    };
    const auto tell = [teller = QPointer(&teller), failed](const std::exception_ptr& failure) {
        if (teller) { // else its window is closed
            teller->fail(tr("Open project"), failure);
        }
        failed();
    };
    jobs_.start(std::make_unique<ValueJob<ReadProject>>(
        tr("Opening the project"),
        [file](const Progress& progress) { return projectFrom(file, file, {}, progress); }, take,
        tell));
}

void DocumentSession::openCopy(const QString& path) {
    startJob(
        jobs_, messages_, tr("Opening the project"), tr("Open project"),
        [path](const Progress& progress) { return projectFrom(path, {}, {}, progress); },
        [this](const ReadProject& read) {
            auto document = std::make_unique<Document>(read.project);
            document->markUnmodified();
            emptySession().take(std::move(document));
        });
}

void DocumentSession::importModel(const QString& path, const ImportOptions& options,
                                  const std::function<void(Project&)>& complete, bool runs) {
    startImport(path, options, tr("New project"), jobs_, messages_,
                [this, path, options, complete, runs](const ImportedModel& imported) {
                    logImport(imported, messages_);
                    Project project = newProject(imported, path, options);
                    if (complete) {
                        complete(project);
                    }
                    DocumentSession& shown = emptySession();
                    shown.take(std::make_unique<Document>(project));
                    if (const auto length = implausibleLength(project.model->mesh)) {
                        emit shown.implausibleLengthFound(*length);
                    }
                    if (runs) {
                        emit shown.runAsked();
                    }
                });
}

bool DocumentSession::has(const QString& path) const {
    const QString own = document_ ? document_->path() : jobs_.isBusy() ? opening_ : QString();
    return !own.isEmpty() && QFileInfo(own) == QFileInfo(path);
}

bool DocumentSession::lockOrAsk(Document& document) {
    const LockState state = document.lock();
    if (state.acquired) {
        return true;
    }
    return window_.opensLocked(document, state);
}

void DocumentSession::restore(const RecoveredDocument& recovered) {
    if (has(recovered.original) && document_) {
        jobs_.cancelAll(); // the results of the file's state are not wanted
    }
    startJob(
        jobs_, messages_, tr("Restoring the project"), tr("Restore project"),
        [recovered](const Progress& progress) {
            return projectFrom(recovered.copy, recovered.original, recovered.version, progress);
        },
        [this, recovered](const ReadProject& read) {
            takeRestored(recovered, read.project, read.version);
        });
}

void DocumentSession::takeRestored(const RecoveredDocument& recovered, const Project& project,
                                   const FileVersion& version) {
    DocumentSession* shown = this;
    if (document_ && has(recovered.original) && !document_->isModified()) {
        document_->restore(tr("Restore project"), project, version);
    } else {
        auto document = std::make_unique<Document>(project, recovered.original, version);
        if (!lockOrAsk(*document)) {
            return;
        }
        document->setRecovered();
        shown = &emptySession();
        shown->take(std::move(document));
    }
    shown->autoSaver_->continueCopy(recovered);
    messages_.log(tr("Restored unsaved changes of %1").arg(recovered.name));
}

void DocumentSession::save() {
    startSave([this] { return document_->beginSave(); });
}

void DocumentSession::saveAs(const QString& path) {
    startSave([this, path] { return document_->beginSaveAs(path); });
}

void DocumentSession::startSave(const std::function<DocumentSnapshot()>& begin) {
    if (isSaving()) {
        nextSave_ = [this, begin] { startSave(begin); };
        return;
    }
    try {
        saves_.start(std::make_unique<SaveJob>(
            begin(), [this](const auto& snapshot, const auto& written, const auto& failure) {
                endSave(snapshot, written, failure);
            }));
    } catch (const Error&) {
        messages_.fail(tr("Save"), std::current_exception());
    }
}

void DocumentSession::cancelSave() {
    nextSave_ = {};
    saves_.cancelAll();
}

void DocumentSession::endSave(const DocumentSnapshot& snapshot,
                              const std::optional<FileVersion>& written,
                              const std::exception_ptr& failure) {
    const std::function<void()> next = std::exchange(nextSave_, {});
    if (!written) {
        document_->dropSave(snapshot);
        reportNotSaved(snapshot.path, failure);
        return;
    }
    document_->endSave(snapshot, *written);
    if (document_->isModified()) {
        autoSaver_->keepNow(); // the last copy may be older than the file
    }
    reportSaved(snapshot.path);
    if (next) {
        next();
    }
}

void DocumentSession::reportNotSaved(const QString& path, const std::exception_ptr& failure) {
    try {
        if (failure) {
            std::rethrow_exception(failure);
        }
    } catch (const ChangedFile&) {
        emit fileWasChanged(path);
    } catch (...) {
        messages_.fail(tr("Save"), failure);
    }
}

void DocumentSession::reportSaved(const QString& path) {
    addRecentProject(path);
    emit saved(path);
    messages_.log(tr("Saved %1").arg(QDir::toNativeSeparators(path)));
}

void DocumentSession::discardChanges() {
    autoSaver_->discard();
}

} // namespace dipwright

#include "workbench/document/Document.h"

#include "base/OneLine.h"
#include "project/ProjectFile.h"
#include "project/ProjectStore.h"

#include <QFileInfo>
#include <QUndoCommand>

#include <utility>

namespace dipwright {

namespace {

// Each step keeps two versions of the project. They take only some kilobytes, because they share
// the model.
constexpr int undoLimit = 500;

} // namespace

// One undo step. It holds the whole project before and after, so that undo cannot miss a value.
class ProjectEdit : public QUndoCommand {
public:
    ProjectEdit(Document& document, const QString& text, const QString& mergeKey, Project before,
                Project after)
        : QUndoCommand(text), document_(document), mergeKey_(mergeKey),
          mergeRound_(document.mergeRound_), before_(std::move(before)), after_(std::move(after)) {}

    void undo() override { document_.goTo(before_); }
    void redo() override { document_.goTo(after_); }
    int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }

    bool mergeWith(const QUndoCommand* next) override {
        const auto& other = static_cast<const ProjectEdit&>(*next);
        if (other.mergeKey_ != mergeKey_ || other.mergeRound_ != mergeRound_) {
            return false;
        }
        after_ = other.after_;
        setObsolete(after_ == before_);
        return true;
    }

private:
    Document& document_;
    QString mergeKey_;
    int mergeRound_;
    Project before_, after_;
};

Document::Document(Project project, const QString& path, const FileVersion& version,
                   QObject* parent)
    : QObject(parent), project_(std::move(project)), path_(path), version_(version) {
    undoStack_.setUndoLimit(undoLimit);
    if (!path_.isEmpty()) {
        untrusted_ = {project_.modelOrigin.source, project_.modelOrigin.texture};
        for (const InspectedPhoto& photo : project_.inspection.photos) {
            untrusted_.append(photo.file);
        }
        for (const FloatingPhoto& photo : project_.filmOnWater.photos) {
            untrusted_.append(photo.file);
        }
    }
    connect(&undoStack_, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

Document::~Document() = default;

void Document::edit(const QString& text, const QString& mergeKey,
                    const std::function<void(Project&)>& change) {
    endDrag();
    Project changed = project_;
    change(changed);
    if (changed != project_) {
        undoStack_.push(new ProjectEdit(*this, text, mergeKey, project_, std::move(changed)));
    }
}

void Document::restore(const QString& text, const Project& project, const FileVersion& version) {
    edit(text, {}, [&](Project& changed) { changed = project; });
    version_ = version;
    setRecovered();
}

void Document::drag(const QString& text, const std::function<void(Project&)>& change) {
    Project changed = project_;
    change(changed);
    if (changed == project_) {
        return;
    }
    const bool begins = !drag_;
    drag_ = Drag{text, begins ? project_ : std::move(drag_->before)};
    showProject(changed);
    if (begins) {
        emit fileChanged();
    }
}

void Document::endDrag() {
    std::optional<Drag> ended = std::exchange(drag_, {});
    if (ended && ended->before != project_) {
        undoStack_.push(
            new ProjectEdit(*this, ended->text, {}, std::move(ended->before), project_));
    } else if (ended) {
        emit fileChanged();
    }
}

void Document::goTo(const Project& project) {
    drag_.reset();
    showProject(project);
}

void Document::showProject(const Project& project) {
    project_ = project;
    emit projectChanged();
}

QString Document::title() const {
    return path_.isEmpty() ? project_.name : oneLine(QFileInfo(path_).completeBaseName());
}

FileVersion DocumentSnapshot::write(const Progress& progress) const {
    if (!replaced) {
        return saveProject(project, path, {}, progress);
    }
    FileVersion version = *replaced;
    replaceProject(project, path, version, progress);
    return version;
}

// Marks the state as saved at once, because the undo stack can only mark its current state, and
// must not merge later edits into it. isModified() stays true until the save has ended.
DocumentSnapshot Document::snapshotForSave(const QString& path) {
    endDrag();
    const bool wasSaved = undoStack_.isClean();
    isSaving_ = true;
    undoStack_.setClean();
    emit fileChanged();
    return {project_, path, {}, nullptr, wasSaved};
}

DocumentSnapshot Document::beginSave() {
    DocumentSnapshot snapshot = snapshotForSave(path_);
    snapshot.replaced = version_;
    return snapshot;
}

DocumentSnapshot Document::beginSaveAs(const QString& path) {
    if (path == path_) {
        return snapshotForSave(path);
    }
    auto lock = std::make_shared<FileLock>();
    const LockState state = lock->acquire(path);
    if (!state.acquired) {
        throw Error(
            tr("The project is open elsewhere (%1); choose another name").arg(holderText(state)),
            path);
    }
    DocumentSnapshot snapshot = snapshotForSave(path);
    snapshot.lock = std::move(lock);
    return snapshot;
}

void Document::endSave(const DocumentSnapshot& saved, const FileVersion& version) {
    version_ = version;
    path_ = saved.path;
    if (saved.lock) {
        lock_ = saved.lock;
    }
    isSaving_ = recovered_ = isFileMissing_ = false;
    emit fileChanged();
}

void Document::dropSave(const DocumentSnapshot& dropped) {
    isSaving_ = false;
    if (!dropped.wasSaved) {
        undoStack_.resetClean();
    }
    emit fileChanged();
}

void Document::checkFile() {
    const bool isMissing = !path_.isEmpty() && !QFileInfo::exists(path_);
    if (std::exchange(isFileMissing_, isMissing) != isMissing) {
        emit fileChanged();
    }
}

void Document::setResult(std::shared_ptr<const JobResult> result) {
    result_ = std::move(result);
    emit resultChanged();
}

Freshness freshness(const SheetInputs& then, const SheetInputs& now) {
    return {now.texture.dip == then.texture.dip, now.texture == then.texture, now == then};
}

bool Document::isFresh(JobStep step, std::size_t number) const {
    const Freshness fresh = freshness(number);
    return step == JobStep::Dip       ? fresh.dip
           : step == JobStep::Texture ? fresh.texture
                                      : fresh.sheet;
}

Freshness Document::freshness(std::size_t number) const {
    if (!result_ || number >= result_->immersions.size() || number >= project_.immersions.size()) {
        return {false, false, false};
    }
    return dipwright::freshness(
        result_->immersions[number].inputs,
        sheetInputs(project_, {}, number, solverFor(project_.process.solver, *result_)));
}

bool Document::isFresh() const {
    if (!result_ || result_->immersions.size() != project_.immersions.size()) {
        return false;
    }
    for (std::size_t number = 0; number < project_.immersions.size(); ++number) {
        if (!isFresh(JobStep::Sheet, number)) {
            return false;
        }
    }
    return true;
}

} // namespace dipwright

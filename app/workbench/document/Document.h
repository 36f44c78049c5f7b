// One open document: its project, undo steps and file, its last result, and which results are out
// of date. No widgets. UI thread only, except DocumentSnapshot::write().
#pragma once

#include "base/Progress.h"
#include "disk/FileLock.h"
#include "disk/FileVersion.h"
#include "pipeline/JobResult.h"

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <functional>
#include <optional>

namespace dipwright {

// The steps of a job whose results can be out of date. Each step includes the inputs of the steps
// before it (pipeline/StepInputs.h).
enum class JobStep { Dip, Texture, Sheet };

// Which results of a dip fit the current project.
struct Freshness {
    bool dip = true, texture = true, sheet = true;
    bool operator==(const Freshness&) const = default;
};

// Returns which steps have the same inputs now as then.
Freshness freshness(const SheetInputs& then, const SheetInputs& now);

// The state of a document that is being saved. Changes of the document do not affect it.
struct DocumentSnapshot {
    Project project;
    QString path;
    std::optional<FileVersion> replaced; // only this version is replaced; none: any version
    std::shared_ptr<FileLock> lock;      // of a new path; null: the document holds the lock
    bool wasSaved = false;               // also before this save

    // Writes the file and returns its version. Any thread. Throws ChangedFile if the file has
    // another version than `replaced`. Throws Error if it cannot be written, and Cancelled. After
    // an exception, the file is unchanged.
    FileVersion write(const Progress& progress) const;
};

class Document : public QObject {
    Q_OBJECT

public:
    // `path`: empty for a new document without a file. `version`: the file's version before it was
    // read.
    explicit Document(Project project, const QString& path = {}, const FileVersion& version = {},
                      QObject* parent = nullptr);
    ~Document() override;

    const Project& project() const { return project_; }

    // Applies `change` to the project as one undo step named `text`. Adds no step if nothing
    // changes. Steps in a row with the same `mergeKey` become one, until endMerge(); an empty key
    // never merges. If `change` throws, the project stays unchanged and the exception is passed on.
    void edit(const QString& text, const QString& mergeKey,
              const std::function<void(Project&)>& change);
    void endMerge() { ++mergeRound_; }
    // Applies `change` as part of a drag. The drag becomes one undo step named `text` at endDrag()
    // or at the next edit(). A drag back to its start leaves undo and redo as they were.
    void drag(const QString& text, const std::function<void(Project&)>& change);
    void endDrag();
    QUndoStack& undoStack() { return undoStack_; }

    const QString& path() const { return path_; }           // empty: never saved
    const FileVersion& version() const { return version_; } // last known version of the file
    QString title() const; // the file's name, else the project's name
    bool isModified() const {
        return (path_.isEmpty() && !markedUnmodified_) || recovered_ || isFileMissing_ || drag_ ||
               isSaving_ || !undoStack_.isClean();
    }
    // Looks whether the file still exists. A document whose file is missing counts as modified.
    void checkFile();
    bool isFileMissing() const { return isFileMissing_; } // at the last checkFile()
    // Marks a document without a file as unmodified until it is edited, such as a copy of a sample.
    void markUnmodified() { markedUnmodified_ = true; }
    // Marks a document that was restored after a crash as modified.
    void setRecovered() {
        recovered_ = true;
        emit fileChanged();
    }
    // Shows the project that was restored after a crash, as one undo step named `text`. `version`:
    // of the file before the lost edits.
    void restore(const QString& text, const Project& project, const FileVersion& version);
    // Takes the lock of the file if it is free. Returns the state in which it found the lock.
    LockState lock() { return lock_->acquire(path_); }
    // A save has three steps: beginSave() or beginSaveAs(), DocumentSnapshot::write(), and
    // endSave() or dropSave(). Only one save at a time. The document may be edited meanwhile, and
    // counts as modified. beginSave() ends a drag. A dropped save changes nothing, except that the
    // document then stays modified even if the user goes back to the state in the file.
    DocumentSnapshot beginSave(); // to the document's own path
    // To `path`, which replaces an existing file. With the document's own path, overwrites even
    // what another program has written. Throws Error if the file is open elsewhere.
    DocumentSnapshot beginSaveAs(const QString& path);
    // `version`: of the written file.
    void endSave(const DocumentSnapshot& saved, const FileVersion& version);
    void dropSave(const DocumentSnapshot& dropped);

    // Returns whether the user chose this file or allowed to read it. False for paths that came
    // with the project file, because a stranger may have written that file.
    bool isTrusted(const QString& file) const { return !untrusted_.contains(file); }
    void trust(const QString& file) { untrusted_.removeAll(file); }

    // The result of the last run, with its project; null before the first.
    std::shared_ptr<const JobResult> result() const { return result_; }
    void setResult(std::shared_ptr<const JobResult> result);
    // Returns whether the result of `step` for dip `number` fits the current project. A run
    // then reuses it.
    bool isFresh(JobStep step, std::size_t number) const;
    Freshness freshness(std::size_t number) const; // for each step of dip `number`
    bool isFresh() const;                          // for all steps of all dips

signals:
    void projectChanged();
    void resultChanged();
    void fileChanged(); // path, title or modified

private:
    friend class ProjectEdit;
    struct Drag {
        QString text;
        Project before;
    };
    void goTo(const Project& project); // by an undo step; a drag that has not ended is dropped
    void showProject(const Project& project);
    DocumentSnapshot snapshotForSave(const QString& path);

    Project project_;
    QString path_;
    QUndoStack undoStack_;
    int mergeRound_ = 0;
    std::optional<Drag> drag_; // none: nothing is dragged
    bool recovered_ = false, markedUnmodified_ = false, isFileMissing_ = false, isSaving_ = false;
    FileVersion version_;
    QStringList untrusted_; // paths of files
    std::shared_ptr<FileLock> lock_ = std::make_shared<FileLock>();
    std::shared_ptr<const JobResult> result_;
};

} // namespace dipwright

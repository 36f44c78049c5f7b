// One open document: a project as a value, every change to it undoable, its file, and the result
// of the last run with what of it is out of date. No widgets. UI thread only.
#pragma once

#include "disk/FileLock.h"
#include "disk/FileVersion.h"
#include "pipeline/JobResult.h"

#include <QObject>
#include <QStringList>
#include <QUndoStack>
#include <functional>

namespace dipwright {

// The steps of the job whose results can be out of date, each later one including what it depends
// on (pipeline/StepInputs.h).
enum class JobStep { Dip, Texture, Sheet };

// What of an immersion's results fits the project as it is.
struct Freshness {
    bool dip = true, texture = true, sheet = true;
    bool operator==(const Freshness&) const = default;
};

class Document : public QObject {
    Q_OBJECT

public:
    // `path` empty: a new document without a file. `version`: of the file, taken before it was
    // read.
    explicit Document(Project project, const QString& path = {}, const FileVersion& version = {},
                      QObject* parent = nullptr);
    ~Document() override;

    const Project& project() const { return project_; }

    // Applies `change` to a copy of the project and makes it the project, as one step to undo that
    // is called `text`. Nothing happens when it changes nothing. Steps with the same `mergeKey` in
    // a row become one, until endMerge(); an empty key never merges. What `change` throws passes
    // through, and nothing has changed.
    void edit(const QString& text, const QString& mergeKey,
              const std::function<void(Project&)>& change);
    void endMerge() { ++mergeRound_; }
    QUndoStack& undoStack() { return undoStack_; }

    // The file. `path` is empty for a document that was never saved.
    const QString& path() const { return path_; }
    const FileVersion& version() const { return version_; } // of the file, as it was last known
    QString title() const;                                  // the file's name, or the project's
    bool isModified() const {
        return (path_.isEmpty() && !keptElsewhere_) || recovered_ || !undoStack_.isClean();
    }
    // Without a file, but of something that is kept anyway, such as a sample: unmodified until it
    // is edited.
    void setKeptElsewhere() { keptElsewhere_ = true; }
    // Restored after a crash: differs from its file though nothing was edited since.
    void setRecovered() {
        recovered_ = true;
        emit fileChanged();
    }
    // Takes the file's lock; what it found is returned and nothing is taken unless it was free.
    LockState lock() { return lock_->acquire(path_); }
    // Throws ChangedFile where another program has written the file since, and Error; then file and
    // document are as they were.
    void save();
    // The same into another file, which is replaced; Error, too, where another has that open. Into
    // its own: whatever another program has written.
    void saveAs(const QString& path);

    // Whether a file that the project names was chosen here, or allowed to be read: false of those
    // that came with the file it was opened from, which may be a stranger's.
    bool isTrusted(const QString& file) const { return !untrusted_.contains(file); }
    void trust(const QString& file) { untrusted_.removeAll(file); }

    // The last run's result, which names the project it belongs to; null before the first.
    std::shared_ptr<const JobResult> result() const { return result_; }
    void setResult(std::shared_ptr<const JobResult> result);
    // Whether there is a result of `step` for immersion `number` that fits the project as it is: a
    // run would take it over.
    bool isFresh(JobStep step, std::size_t number) const;
    Freshness freshness(std::size_t number) const; // of each step
    bool isFresh() const;                          // everything of every immersion

signals:
    void projectChanged();
    void resultChanged();
    void fileChanged(); // path, title or modified

private:
    friend class ProjectEdit;
    void showProject(const Project& project);
    void setSaved();

    Project project_;
    QString path_;
    QUndoStack undoStack_;
    int mergeRound_ = 0;
    bool recovered_ = false, keptElsewhere_ = false;
    FileVersion version_;
    QStringList untrusted_; // files
    std::unique_ptr<FileLock> lock_ = std::make_unique<FileLock>();
    std::shared_ptr<const JobResult> result_;
};

} // namespace dipwright

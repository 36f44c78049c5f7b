// Manages the document of one window: opens, imports, restores and saves it, and keeps copies of
// its unsaved changes. Reads on the worker thread. Saves on a thread of its own, because a run may
// keep the worker thread busy for hours. Reports success by signals and failure by messages. UI
// thread only.
#pragma once

#include "import/trusted/ImportModel.h"
#include "workbench/document/Document.h"
#include "workbench/document/Recovery.h"
#include "workbench/jobs/JobRunner.h"
#include "workbench/jobs/Messages.h"

namespace dipwright {

class DocumentSession : public QObject {
    Q_OBJECT

public:
    // Callbacks for decisions that need the window.
    struct Window {
        // Asks whether to open a file that is open elsewhere.
        std::function<bool(const Document& document, const LockState& holder)> opensLocked;
        // Brings the window with this file to the front. Returns false if there is none.
        std::function<bool(const QString& path)> bringForward;
        // Opens a new window and returns its session.
        std::function<DocumentSession&()> another;
        // Closes a window that was opened for a document that could not be read.
        std::function<void()> giveUp;
    };

    // `recovery`: the folder for copies of unsaved work.
    DocumentSession(JobRunner& jobs, Messages& messages, const QString& recovery, Window window,
                    QObject* parent = nullptr);
    ~DocumentSession() override;

    Document* document() const { return document_.get(); } // null: none
    // Tells whether it shows this file or is opening it.
    bool has(const QString& path) const;
    void setAutosaveInterval(int seconds);

    // Opens a project in this window if it has no document, else in another window. If the project
    // is already open, brings its window to the front.
    void openProject(const QString& path);
    // Opens an untitled copy of a sample, in this window if it has no document, else in another.
    void openCopy(const QString& path);
    // Creates a project from a model and opens it, in this window if it has no document, else in
    // another. `complete` may change the new project before it is shown. If `runs`, that window's
    // session then emits runAsked().
    void importModel(const QString& path, const ImportOptions& options,
                     const std::function<void(Project&)>& complete = {}, bool runs = false);
    // Restores a document. If this window shows or is opening its file, and the document has no
    // unsaved changes, the restored state becomes an undo step there. Otherwise the document is
    // opened in this window if it has none, else in another.
    void restore(const RecoveredDocument& recovered);

    // Begin to save the current state of the document, which may be edited meanwhile. During a
    // save, the next one waits until the first has succeeded, and then saves the state of that
    // time.
    void save();
    void saveAs(const QString& path); // overwrites a file, even one that others have changed
    bool isSaving() const { return saves_.isBusy(); }
    void cancelSave();
    const JobRunner& saves() const { return saves_; } // idle when the last save has ended
    void discardChanges();                            // deletes the copy of unsaved changes

signals:
    void documentChanged(); // the old document is deleted after this signal
    void saved(const QString& path);
    // Another program has changed the file since it was read, so save() has not replaced it.
    void fileWasChanged(const QString& path);
    void implausibleLengthFound(double millimetres); // the imported body is very long or short
    void runAsked();                                 // for a new project

private:
    // On failure, reports to `teller` and calls `failed`.
    void readProject(const QString& file, Messages& teller, const std::function<void()>& failed);
    bool lockOrAsk(Document& document);
    void takeRestored(const RecoveredDocument& recovered, const Project& project,
                      const FileVersion& version);
    void startSave(const std::function<DocumentSnapshot()>& begin);
    void endSave(const DocumentSnapshot& snapshot, const std::optional<FileVersion>& written,
                 const std::exception_ptr& failure);
    void reportSaved(const QString& path);
    void reportNotSaved(const QString& path, const std::exception_ptr& failure);
    void take(std::unique_ptr<Document> document);
    DocumentSession& emptySession();

    JobRunner& jobs_;
    Messages& messages_;
    QString recovery_;
    Window window_;
    int autosaveSeconds_ = 20;
    QString opening_; // the last file that was to be opened here
    std::unique_ptr<Document> document_;
    std::unique_ptr<AutoSaver> autoSaver_;
    std::function<void()> nextSave_; // waits for the end of a save; empty: none
    JobRunner saves_;                // destroyed first: saves report to the members above
};

} // namespace dipwright

// The document of one window: opened, made of a model, restored after a crash, saved, and its
// unsaved changes kept. Reads on the worker thread and tells when a document is there, or why not.
// UI thread only.
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
    // What it cannot decide by itself.
    struct Window {
        // Another has the file open: whether the user wants it all the same.
        std::function<bool(const Document& document, const LockState& holder)> opensLocked;
        // Brings the window forward that has this file open; false: none has.
        std::function<bool(const QString& path)> bringForward;
        // That of a new window: this one shows one document only.
        std::function<DocumentSession&()> another;
        // Nothing came of what this window was opened for.
        std::function<void()> giveUp;
    };

    // `recovery`: the folder in which copies of unsaved work are kept.
    DocumentSession(JobRunner& jobs, Messages& messages, const QString& recovery, Window window,
                    QObject* parent = nullptr);
    ~DocumentSession() override;

    Document* document() const { return document_.get(); } // null: none
    void setAutosaveInterval(int seconds);

    // Each becomes the document here if there is none, else that of another window. A project that
    // is open in a window already is shown there.
    void openProject(const QString& path);
    // As an untitled copy: a sample, which stays as it is.
    void openCopy(const QString& path);
    // `complete` may set what the user has chosen beside the model.
    void importModel(const QString& path, const ImportOptions& options,
                     const std::function<void(Project&)>& complete = {});
    void restore(const RecoveredDocument& recovered); // only where there is no document

    // Both as the document's, which throw Error.
    void save();
    void saveAs(const QString& path);
    void discardChanges(); // the copy of what is not saved goes

signals:
    void documentChanged(); // it is another one now; the earlier one goes when all have been told
    void saved(const QString& path);
    void lengthDoubted(double millimetres); // of the body that was read

private:
    // What went wrong is told by `teller`, and `failed` called.
    void readProject(const QString& file, Messages& teller, const std::function<void()>& failed);
    bool lockOrAsk(Document& document);
    void tellSaved(const QString& path);
    void take(std::unique_ptr<Document> document);
    DocumentSession& vacant();

    JobRunner& jobs_;
    Messages& messages_;
    QString recovery_;
    Window window_;
    int autosaveSeconds_ = 20;
    std::unique_ptr<Document> document_;
    std::unique_ptr<AutoSaver> autoSaver_;
};

} // namespace dipwright

// Keeps copies of edited documents, to restore unsaved work after a crash.
//
// A copy consists of NAME.dipw, NAME.json (which names the original file) and a lock. The program
// that edits the document holds the lock, so a free lock means a crash. The copy is removed only
// when the document is saved or its changes are discarded.
#pragma once

#include "base/Progress.h"
#include "disk/FileLock.h"
#include "disk/FileVersion.h"

#include <QDateTime>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <optional>
#include <vector>

namespace dipwright {

class Document;
struct Project;

struct RecoveredDocument {
    QString copy;     // the recovery file
    QString original; // the document's own file; empty: the document had none
    QString name;     // the project's name
    QDateTime saved;
    std::optional<FileVersion> version = {}; // version of the original before the edits, if known
};

// Returns the copies in `folder` that a crash has left behind, newest first.
std::vector<RecoveredDocument> findRecoveredDocuments(const QString& folder);
// Removes one copy. Call it after the copy is restored, or if the user discards it.
void discardRecovered(const RecoveredDocument& recovered);
// Returns the default folder for copies.
QString recoveryFolder();

// Writes the copy of one document after changes, at most once per interval. Writes and removes on
// its own thread.
class AutoSaver : public QObject {
    Q_OBJECT

public:
    AutoSaver(Document& document, const QString& folder, QObject* parent = nullptr);
    ~AutoSaver() override; // waits as waitForCopy(); the copy stays if edits are unsaved

    void setInterval(int seconds);
    // Uses the copy of the restored document from now on. It already has the unsaved changes. Call
    // this before the first write.
    void continueCopy(const RecoveredDocument& restored);
    // Begins to write the copy.
    void keepNow();
    // Begins to remove the copy, and cancels a write. Call it when the changes are saved or
    // discarded.
    void discard();
    // Waits until the copy is written or removed. Returns false if it could not be written.
    bool waitForCopy();

signals:
    // The copy cannot be written; `why` is a sentence. Emitted only for the first failure after a
    // successful write.
    void failed(const QString& why);

private:
    void scheduleCopy();
    void lockCopy();
    void writeCopy(const Project& project, const QByteArray& description,
                   const CancelToken& cancelToken);

    Document& document_;
    QString copy_;
    FileLock lock_; // of the copy; used by the writer's thread
    QTimer timer_;
    CancelToken writing_;             // cancels the last write
    std::atomic<bool> isKept_ = true; // also true before the first write
    QThreadPool writer_;
};

} // namespace dipwright

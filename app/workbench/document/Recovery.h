// Keeps copies of edited documents, to restore unsaved work after a crash.
//
// A copy consists of NAME.dipw, NAME.json (which names the original file) and a lock. The program
// that edits the document holds the lock, so a free lock means a crash. The copy is removed only
// when the document is saved or its changes are discarded.
#pragma once

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

// Writes the copy of one document after changes, at most once per interval, on its own thread.
class AutoSaver : public QObject {
    Q_OBJECT

public:
    AutoSaver(Document& document, const QString& folder, QObject* parent = nullptr);
    ~AutoSaver() override; // waits for a write; the copy stays if edits are unsaved

    void setInterval(int seconds);
    // Writes the copy now and waits for it. Returns false if it cannot be written.
    bool keepNow();
    // Removes the copy. Call it when the changes are saved or discarded.
    void discard();

signals:
    // The copy cannot be written; `why` is a sentence. Emitted only for the first failure after a
    // successful write.
    void failed(const QString& why);

private:
    void scheduleCopy();
    void write();
    QString file(const char* extension) const;

    Document& document_;
    QString folder_, name_;
    std::unique_ptr<FileLock> lock_;
    QTimer timer_;
    std::atomic<bool> isKept_ = true; // also true before the first write
    QThreadPool writer_;
};

} // namespace dipwright

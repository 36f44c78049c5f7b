// Copies of edited documents, kept while they are open, from which work is restored after a crash.
//
// A document's copy is NAME.dipw with NAME.json beside it (which file it belongs to) and a lock,
// held by the program that edits it. A copy whose lock nobody holds was left behind by a crash. The
// copy goes when the document is saved or its user has let it go; nothing else removes it.
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
    QString original; // the document's own file; empty: it had none
    QString name;     // of the project
    QDateTime saved;
    std::optional<FileVersion> version = {}; // of the original, before it was edited; if known
};

// The copies in `folder` that a crash has left behind, the newest first.
std::vector<RecoveredDocument> findRecoveredDocuments(const QString& folder);
// Removes one copy, once it is restored or the user has let it go.
void discardRecovered(const RecoveredDocument& recovered);
// Where copies are kept by default.
QString recoveryFolder();

// Keeps the copy of one document: after each change, at most once an interval, on another thread.
class AutoSaver : public QObject {
    Q_OBJECT

public:
    AutoSaver(Document& document, const QString& folder, QObject* parent = nullptr);
    ~AutoSaver() override; // waits for a copy being written; the copy stays if edits are not saved

    void setInterval(int seconds);
    // Writes the copy now if there is anything to keep, and waits until it is on the disk. False
    // where it cannot be written.
    bool keepNow();
    // The user has saved, or let the changes go: removes the copy.
    void discard();

signals:
    // No copy can be written, `why` in a sentence; not again until one has been.
    void failed(const QString& why);

private:
    void scheduleCopy();
    void write();
    QString file(const char* extension) const;

    Document& document_;
    QString folder_, name_;
    std::unique_ptr<FileLock> lock_;
    QTimer timer_;
    std::atomic<bool> isKept_ = true; // or nothing is due
    QThreadPool writer_;
};

} // namespace dipwright

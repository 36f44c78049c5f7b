#include "disk/FolderTransaction.h"

#include "base/Bytes.h"
#include "base/Error.h"
#include "disk/AtomicFile.h"
#include "disk/PlainFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

#include <optional>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FolderTransaction)
};

// Names inside the hidden folder.
const QString newFiles = QStringLiteral("new/");
const QString oldFiles = QStringLiteral("old/");
// While it exists, the new files are valid.
const QString journalName = QStringLiteral("journal.json");
// While it exists, the old files are valid.
const QString undoName = QStringLiteral("undo.json");
constexpr qint64 longestJournal = 1 << 20;
// Limits for a journal, many times larger than any journal that the program writes.
constexpr qsizetype mostNames = 10'000;
constexpr qsizetype longestName = 1024;
constexpr qsizetype mostFolders = 16; // folders in one name

QString folderOf(const QString& name) {
    return QFileInfo(name).path();
}

// The files that were written, and the files that existed before. Paths are relative to the target.
struct Journal {
    QStringList written;  // new files, which are moved into place
    QStringList existing; // old files: set aside first, and restored if moving fails
};

QByteArray bytesOf(const Journal& journal) {
    return QJsonDocument(QJsonObject{{"written", QJsonArray::fromStringList(journal.written)},
                                     {"there", QJsonArray::fromStringList(journal.existing)}})
        .toJson();
}

QStringList textsOf(const QJsonValue& value) {
    QStringList texts;
    for (const QJsonValue& text : value.toArray()) {
        texts << text.toString();
    }
    return texts;
}

// Returns nothing if the journal cannot be read.
std::optional<Journal> journalOf(const QString& path) {
    QFile file(path);
    if (!openToRead(file).isEmpty()) {
        return {};
    }
    const QJsonDocument json = QJsonDocument::fromJson(file.read(longestJournal));
    return json.isObject() ? std::optional(Journal{textsOf(json[QLatin1String("written")]),
                                                   textsOf(json[QLatin1String("there")])})
                           : std::nullopt;
}

// Whether `name` names a file below the target and outside the hidden folder.
bool isBelow(const QString& name) {
    const qsizetype end = name.indexOf(QLatin1Char('/'));
    const QString first = name.left(end);
    return !name.isEmpty() && name.size() <= longestName &&
           name.count(QLatin1Char('/')) <= mostFolders && QDir::isRelativePath(name) &&
           QDir::cleanPath(name) == name && first != QLatin1String(".") &&
           first != QLatin1String("..") && first != FolderTransaction::workName() &&
           !name.contains(QLatin1Char(':')) && !name.contains(QLatin1Char('\\')) &&
           !name.contains(QChar(0));
}

// Whether one of the folders in a name is a link, which could point anywhere.
bool isLinked(const QDir& target, const QString& name) {
    for (auto end = name.indexOf(u'/'); end >= 0; end = name.indexOf(u'/', end + 1)) {
        if (QFileInfo(target.filePath(name.left(end))).isSymLink()) {
            return true;
        }
    }
    return false;
}

// The hidden folder of a target. Moves files between the hidden folder and the target. Every step
// can be repeated, even if it or a later step was already done.
class Work {
public:
    // `shouldContinue` is called between two operations; the work stops if it returns false.
    explicit Work(const QString& target, std::function<bool()> shouldContinue = {})
        : target_(target), work_(target_.filePath(FolderTransaction::workName())),
          mayGoOn_(std::move(shouldContinue)) {}

    QString path(const QString& name) const { return work_.filePath(name); }
    bool has(const QString& name) const { return work_.exists(name); }
    // Sets aside the existing files, and moves the written ones into place.
    bool forward(const Journal& journal) const {
        const QSet<QString> written(journal.written.begin(), journal.written.end());
        for (const QString& name : journal.existing) {
            const bool isDue = has(newFiles + name) || !written.contains(name);
            if (!shouldContinue() || (isDue && !has(oldFiles + name) && target_.exists(name) &&
                                      !moveOver(target_.filePath(name), path(oldFiles + name)))) {
                return false;
            }
        }
        return std::all_of(journal.written.begin(), journal.written.end(),
                           [&](const QString& name) {
                               return shouldContinue() &&
                                      (!has(newFiles + name) || bring(path(newFiles + name), name));
                           });
    }
    // Restores the files that were set aside, and removes new files that came into place.
    bool backward(const Journal& journal) const {
        const QSet<QString> existing(journal.existing.begin(), journal.existing.end());
        for (const QString& name : journal.written) {
            if (!shouldContinue()) {
                return false;
            }
            if (!existing.contains(name) && !has(newFiles + name)) {
                QFile::remove(target_.filePath(name));
            }
        }
        return std::all_of(journal.existing.begin(), journal.existing.end(),
                           [&](const QString& name) {
                               return shouldContinue() &&
                                      (!has(oldFiles + name) || bring(path(oldFiles + name), name));
                           });
    }
    // Restores the old files after a failure. Returns false if that is not possible now; the
    // journal then stays for the next start.
    bool undo(const Journal& journal) {
        const bool isUndone =
            !has(journalName) || (moveOver(path(journalName), path(undoName)) && backward(journal));
        settle(journal);
        if (isUndone) {
            remove();
        }
        return isUndone;
    }
    // Flushes the folders to disk and removes empty ones.
    void settle(const Journal& journal) const {
        QSet<QString> folders;
        for (const QString& name : journal.written + journal.existing) {
            folders.insert(folderOf(name));
        }
        folders.remove(QStringLiteral("."));
        for (const QString& folder : folders) {
            syncFolder(target_.filePath(folder));
            target_.rmdir(folder);
        }
        syncFolder(target_.path());
    }
    // Removes the journal first: without a journal there is nothing to complete.
    void remove() {
        QFile::remove(path(journalName));
        QFile::remove(path(undoName));
        if (!isUnderWay() && !isLink()) {
            removeEmptyFolders();
            removeAll(work_.path());
        }
    }
    bool isThere() const { return work_.exists(); }
    // Another user of a shared folder may have put a link there. The folder that the link points to
    // must not be emptied.
    bool isLink() const { return QFileInfo(work_.path()).isSymLink(); }
    bool isUnderWay() const { return has(journalName) || has(undoName); }
    // Completes the transaction of a crashed process. If `names` is not empty, the journal may name
    // only these files. Returns false and changes nothing if the journal cannot be read or names
    // other files.
    bool completeTransaction(const QStringList& names = {}) {
        const bool isBack = has(undoName);
        if (isBack || has(journalName)) {
            const auto journal = journalOf(path(isBack ? undoName : journalName));
            if (!journal || !isOurs(*journal, names)) {
                return false;
            }
            const bool done = isBack ? backward(*journal) : forward(*journal);
            if (!shouldContinue()) {
                return false;
            }
            settle(*journal);
            if (!done) {
                return false;
            }
        }
        remove();
        return !isUnderWay();
    }

private:
    bool shouldContinue() const { return !mayGoOn_ || mayGoOn_(); }
    // Removes the hidden folder with everything in it, including files of other programs.
    void removeAll(const QString& folder) const {
        QDirIterator entries(folder,
                             QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
        while (entries.hasNext() && shouldContinue()) {
            const QString entry = entries.next();
            const QFileInfo info(entry);
            info.isDir() && !info.isSymLink() ? removeAll(entry) : void(QFile::remove(entry));
        }
        QDir().rmdir(folder); // fails unless it is empty
    }
    // Removes the folders that were created in the target for files that were then not moved there.
    void removeEmptyFolders() const {
        for (const QString& folder :
             QDir(path(newFiles)).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            target_.rmdir(folder);
        }
    }
    // Moves a file into place. Its folder may be gone because an earlier try emptied it.
    bool bring(const QString& from, const QString& name) const {
        return target_.mkpath(folderOf(name)) && moveOver(from, target_.filePath(name));
    }
    // Whether a journal names only our own results. A folder from an untrusted source may hold a
    // journal that makes the program remove or replace other files.
    bool isOurs(const Journal& journal, const QStringList& names) const {
        const QStringList all = journal.written + journal.existing;
        return all.size() <= 2 * mostNames &&
               std::all_of(all.begin(), all.end(), [&](const QString& file) {
                   return shouldContinue() && isBelow(file) && !isLinked(target_, file) &&
                          !isLinked(work_, newFiles + file) && !isLinked(work_, oldFiles + file) &&
                          (names.isEmpty() || names.contains(file));
               });
    }

    QDir target_, work_;
    std::function<bool()> mayGoOn_;
};

// Returns the folders of `path` that do not exist, the innermost last.
QStringList missingFolders(QString path) {
    QStringList missing;
    while (!QFileInfo::exists(path)) {
        missing.prepend(path);
        const QString parent = QFileInfo(path).absolutePath();
        if (parent == path) {
            break;
        }
        path = parent;
    }
    return missing;
}

QString lockedName(const QString& target) {
    return target + QStringLiteral("/results");
}

} // namespace

QString FolderTransaction::workName() {
    return QStringLiteral(".dipwright-results");
}

FolderTransaction::FolderTransaction(const QString& target, const QStringList& names)
    : target_(QDir::cleanPath(QDir().absoluteFilePath(target))), names_(names) {
    const QStringList missing = missingFolders(target_);
    const QString home = missing.isEmpty() ? target_ : QFileInfo(missing.first()).path();
    if (!QFileInfo(home).isDir()) {
        throw Error(Text::tr("The results cannot be written, because %1 is not a folder").arg(home),
                    target_);
    }
    if (missing.isEmpty()) {
        refuseOthers();
    }
    note_ = std::make_unique<UnfinishedWrite>(target_ + QLatin1Char('/') + workName(), missing);
    made_ = missing;
    try {
        lockTarget();
    } catch (const Error&) {
        if (Work work(target_); lock_.isHeld() && !work.isUnderWay()) {
            work.remove();
        }
        lock_.release();
        for (; !made_.isEmpty(); made_.removeLast()) {
            QDir().rmdir(made_.last());
        }
        throw;
    }
}

// Creates and locks the target, and empties the hidden folder in it.
void FolderTransaction::lockTarget() {
    QDir().mkpath(target_);
    const LockState state = lock_.acquire(lockedName(target_));
    if (!state.acquired) {
        throw Error(Text::tr("Another program is writing results to this folder (%1); wait for it, "
                             "or choose another folder")
                        .arg(holderText(state)),
                    target_);
    }
    Work work(target_);
    if (!work.completeTransaction(names_)) {
        throw Error(Text::tr("Earlier results in this folder are incomplete, and another program "
                             "prevents their completion. Close the programs that use files in the "
                             "folder, or move %1 out of the folder")
                        .arg(workName()),
                    target_);
    }
    QFile trial(work.path(QStringLiteral("trial")));
    if (!lock_.isHeld() || !QDir().mkpath(work.path(newFiles)) ||
        !QDir().mkpath(work.path(oldFiles)) || !trial.open(QIODevice::WriteOnly)) {
        throw Error(Text::tr("The folder cannot be written; choose another folder"), target_);
    }
}

FolderTransaction::~FolderTransaction() {
    if (!lock_.isHeld()) {
        return; // committed
    }
    Work work(target_);
    if (!work.isUnderWay()) {
        work.remove();
    }
    if (work.isThere()) {
        note_->leave();
    }
    lock_.release();
    for (; !made_.isEmpty(); made_.removeLast()) {
        QDir().rmdir(made_.last()); // fails unless they are empty
    }
}

bool FolderTransaction::completeTransaction(const QString& target,
                                            const std::function<bool()>& shouldContinue) {
    FileLock lock;
    const QFileInfo work(target + QLatin1Char('/') + workName());
    if (!work.isDir() || work.isSymLink()) {
        return true; // no transaction
    }
    return lock.acquire(lockedName(target)).acquired && lock.isHeld() &&
           Work(target, shouldContinue).completeTransaction() && !Work(target).isThere();
}

void FolderTransaction::write(const QString& name, const QByteArray& contents) const {
    const Work work(target_);
    QFile file(work.path(newFiles + name));
    // The folder for new files is created only once. If somebody moved it away, a second one would
    // lack the files written before.
    if (!work.has(newFiles) || !QDir().mkpath(QFileInfo(file).path())) {
        throw Error(Text::tr("The results cannot be written: their folder was removed or moved "
                             "meanwhile"),
                    target_);
    }
    if (!file.open(QIODevice::WriteOnly) || !writeAll(file, contents) || !syncToDisk(file)) {
        throw Error(Text::tr("The results cannot be written: %1").arg(file.errorString()), target_);
    }
    const std::lock_guard lock(writing_);
    written_.insert(name);
}

QByteArray FolderTransaction::written(const QString& name) const {
    QFile file(Work(target_).path(newFiles + name));
    if (!file.exists()) {
        return {};
    }
    if (const QString failure = openToRead(file); !failure.isEmpty()) {
        throw Error(Text::tr("Results that were just written cannot be read: %1").arg(failure),
                    target_);
    }
    return file.readAll();
}

// Throws Error if a file or folder is in the way of a result or its folder; never removes it.
void FolderTransaction::refuseOthers() const {
    const auto refuse = [this](const QString& name) {
        throw Error(Text::tr("The results cannot be written, because %1 already exists and cannot "
                             "be replaced; move it, or choose another folder")
                        .arg(name),
                    target_);
    };
    const QFileInfo work(target_ + QLatin1Char('/') + workName());
    if (work.isSymLink() || (work.exists() && !work.isDir())) {
        refuse(workName());
    }
    for (const QString& name : names_) {
        const QFileInfo file(target_ + QLatin1Char('/') + name);
        const QFileInfo folder(file.path());
        if (file.isDir() || isLinked(QDir(target_), name) || (folder.exists() && !folder.isDir())) {
            refuse(file.isDir() ? file.fileName() : folder.fileName());
        }
    }
}

void FolderTransaction::commit() {
    refuseOthers();
    const QDir target(target_);
    Work work(target_);
    Journal journal;
    QSet<QString> folders;
    for (const QString& name : names_) {
        const bool isWritten = work.has(newFiles + name);
        if (isWritten != written_.contains(name)) {
            throw Error(Text::tr("The results are incomplete, because files in %1 were moved or "
                                 "removed during writing; leave that folder alone and try again")
                            .arg(workName()),
                        target_);
        }
        const bool isThere = target.exists(name);
        if (isWritten) {
            journal.written << name;
        }
        if (isThere) {
            journal.existing << name;
        }
        if (isWritten || isThere) {
            folders.insert(folderOf(name));
        }
    }
    bool good = true;
    // before the journal takes effect, because creating folders can fail on a full disk
    for (const QString& folder : folders) {
        good = good && target.mkpath(folder) && QDir().mkpath(work.path(oldFiles + folder));
        syncFolder(work.path(newFiles + folder));
    }
    syncFolder(work.path(newFiles));
    const QString failure = replaceFile(work.path(journalName), bytesOf(journal));
    if (!good || !failure.isEmpty()) {
        work.undo(journal);
        throw Error(Text::tr("The results cannot be written: %1").arg(failure), target_);
    }
    if (!work.forward(journal)) {
        throw Error(
            work.undo(journal)
                ? Text::tr("The results cannot be moved into the folder, perhaps because a file "
                           "there is in use; close it and try again")
                : Text::tr(
                      "Only some of the results were moved into the folder; close the programs "
                      "that have files there open, then start this program again to move the rest"),
            target_);
    }
    work.settle(journal);
    work.remove();
    if (work.isThere()) {
        note_->leave();
    }
    lock_.release();
}

} // namespace dipwright

// Fuzzes the journal of an interrupted write (FolderTransaction). The next start reads the journal
// in the results' hidden folder. Recovery must end, and must not change files outside the folder.
#include "disk/FolderTransaction.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <cstdlib>

namespace {

using dipwright::FolderTransaction;

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size()) {
        std::abort();
    }
}

bool isAsItWas(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.readAll() == "mine";
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const QTemporaryDir place;
    static const bool isReady = qputenv("XDG_DATA_HOME", QFile::encodeName(place.path()));
    const QDir target(place.filePath(QStringLiteral("target")));
    const QDir work(target.filePath(FolderTransaction::workName()));
    if (!isReady || !work.mkpath(QStringLiteral("new/immersion-1")) ||
        !work.mkpath(QStringLiteral("old/immersion-1"))) {
        return 0;
    }
    write(place.filePath(QStringLiteral("mine")), "mine");
    write(target.filePath(QStringLiteral("proof.png")), "old");
    write(work.filePath(QStringLiteral("new/proof.png")), "new");
    write(work.filePath(QStringLiteral("new/immersion-1/sheet.png")), "new");
    write(work.filePath(QStringLiteral("old/report.json")), "old");
    // The first byte selects one of the two journals.
    const bool isBack = size > 0 && data[0] == 'u';
    const std::size_t skipped = isBack ? 1 : 0;
    write(work.filePath(isBack ? QStringLiteral("undo.json") : QStringLiteral("journal.json")),
          {reinterpret_cast<const char*>(data + skipped), qsizetype(size - skipped)});
    FolderTransaction::completeTransaction(target.path());
    if (!isAsItWas(place.filePath(QStringLiteral("mine")))) {
        std::abort();
    }
    QDir(target).removeRecursively();
    return 0;
}

#include "project/ProjectFile.h"

#include "project/Project.h"
#include "project/ProjectStore.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ProjectFile)
};

// Throws if the file has changed. A missing file counts as unchanged: it is written again, and
// nothing is lost.
void requireUnchanged(const QString& path, const FileVersion& known) {
    const FileVersion now = FileVersion::of(path);
    if (now != known && QFileInfo::exists(path)) {
        if (now == FileVersion()) {
            throw Error(Text::tr("The existing file cannot be read, so it is not replaced; try "
                                 "again, or save under another name"),
                        path);
        }
        throw ChangedFile(Text::tr("Another program has changed the project since it was read, so "
                                   "it is not saved; open it again and repeat your change"),
                          path);
    }
}

} // namespace

// Checks the file right before it is replaced, because another program may write while this one
// packs.
void replaceProject(const Project& project, const QString& path, FileVersion& known,
                    const Progress& progress) {
    known = saveProject(
        project, path, [&] { requireUnchanged(path, known); }, progress);
}

ProjectFile::ProjectFile(const QString& path) : path_(path) {
    const LockState state = lock_.acquire(path);
    if (!state.acquired) {
        throw Error(Text::tr("The project is open elsewhere (%1); close it there, or work on a "
                             "copy")
                        .arg(holderText(state)),
                    path);
    }
    known_ = FileVersion::of(path);
}

} // namespace dipwright

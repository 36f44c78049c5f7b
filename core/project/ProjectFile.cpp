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

// One that is gone is written anew: nobody loses by that.
void requireUnchanged(const QString& path, const FileVersion& known) {
    const FileVersion now = FileVersion::of(path);
    if (now != known && QFileInfo::exists(path)) {
        if (now == FileVersion()) {
            throw Error(Text::tr("The file that is there cannot be read, and nothing is saved over "
                                 "it; try again, or save under another name"),
                        path);
        }
        throw ChangedFile(Text::tr("Another program has written the project since it was read, "
                                   "nothing is saved; look at what it holds now and do it again"),
                          path);
    }
}

} // namespace

// Looked at when nobody else can replace it any more: packing takes long enough for others to.
void replaceProject(const Project& project, const QString& path, FileVersion& known) {
    known = saveProject(project, path, [&] { requireUnchanged(path, known); });
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

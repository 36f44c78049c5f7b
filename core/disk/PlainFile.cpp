#include "disk/PlainFile.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(PlainFile)
};

} // namespace

QString openToRead(QFile& file) {
    const QFileInfo info(file.fileName());
    if (info.isDir()) {
        return Text::tr("it is a folder");
    }
    if (info.exists() && !info.isFile()) {
        return Text::tr("it is a pipe or a device; save its data to a file and choose that file");
    }
    return file.open(QIODevice::ReadOnly) ? QString() : file.errorString();
}

} // namespace dipwright

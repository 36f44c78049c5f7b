#include "disk/SmallFile.h"

#include "base/Error.h"

#include <QCoreApplication>
#include <QFile>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SmallFile)
};

} // namespace

QByteArray readSmallFile(const QString& path, qint64 most) {
    QFile file(path);
    QByteArray bytes;
    if (file.open(QIODevice::ReadOnly)) {
        // A pipe hands out a part at a time.
        for (QByteArray more; bytes.size() <= most; bytes += more) {
            more = file.read(most + 1 - bytes.size());
            if (more.isEmpty()) {
                break;
            }
        }
    }
    if (file.error() != QFileDevice::NoError) {
        throw Error(Text::tr("The file cannot be read: %1").arg(file.errorString()), path);
    }
    if (bytes.size() > most) {
        throw Error(Text::tr("The file is larger than %1 MB, more than what is asked for here "
                             "takes; choose another one")
                        .arg(most >> 20),
                    path);
    }
    return bytes;
}

} // namespace dipwright

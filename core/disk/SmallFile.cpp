#include "disk/SmallFile.h"

#include "base/Error.h"
#include "disk/PlainFile.h"

#include <QCoreApplication>
#include <QFile>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(SmallFile)
};

} // namespace

QByteArray readSmallFile(const QString& path, qint64 most) {
    const auto refuse = [&path](const QString& reason) {
        throw Error(Text::tr("The file cannot be read: %1").arg(reason), path);
    };
    QFile file(path);
    if (const QString failure = openToRead(file); !failure.isEmpty()) {
        refuse(failure);
    }
    const QByteArray bytes = file.read(most + 1);
    if (file.error() != QFileDevice::NoError) {
        refuse(file.errorString());
    }
    if (bytes.size() > most) {
        throw Error(
            Text::tr(
                "The file is larger than %1 MB, too large for this purpose; choose another file")
                .arg(most >> 20),
            path);
    }
    return bytes;
}

} // namespace dipwright

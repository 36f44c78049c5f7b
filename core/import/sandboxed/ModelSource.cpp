#include "import/sandboxed/ModelSource.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "model/ModelFormats.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

} // namespace

QImage ModelSource::readPicture(const QString& name, QStringList& warnings) const {
    const auto found = files.read(name);
    if (!found) {
        warnings.push_back(Text::tr("The texture %1 was not found beside the model; its material's "
                                    "colour is used instead")
                               .arg(name));
        return QImage();
    }
    return pictures.read(*found, Text::tr("texture %1 in %2").arg(name, path));
}

void ModelSource::throwDamaged(const QString& reason) const {
    throw Error(Text::tr("The model cannot be read: %1; save it again, or as %2")
                    .arg(reason, anyModelFormat()),
                path);
}

void ModelSource::checkTriangleCount(std::size_t count) const {
    requireWithin(Budget::Triangles, qint64(count), path, files.bytesRead());
}

bool mayBeFurtherRows(QByteArrayView left, qsizetype rowBytes) {
    return left.size() % rowBytes == 0 &&
           std::any_of(left.begin(), left.end(), [](char byte) { return byte != '\0'; });
}

} // namespace dipwright

#include "model/ModelSource.h"

#include "base/Error.h"
#include "model/ModelFormats.h"
#include "model/Texture.h"

#include <QCoreApplication>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

} // namespace

QImage ModelSource::readPicture(const QString& name, QStringList& warnings) const {
    const QString found = folder.find(name);
    const auto bytes = found.isEmpty() ? std::nullopt : readFile(found);
    if (!bytes) {
        warnings.push_back(Text::tr("The texture %1 was not found beside the model; its material's "
                                    "colour is used instead")
                               .arg(name));
        return QImage();
    }
    return readTexture(*bytes, found);
}

void ModelSource::throwDamaged(const QString& reason) const {
    throw Error(Text::tr("The model cannot be read: %1; save it anew, or as %2")
                    .arg(reason, anyModelFormat()),
                path);
}

void ModelSource::checkTriangleCount(std::size_t count) const {
    if (count > maximumModelTriangles) {
        throw Error(Text::tr("The model has more than %1 million triangles; reduce it")
                        .arg(maximumModelTriangles / 1'000'000),
                    path);
    }
}

} // namespace dipwright

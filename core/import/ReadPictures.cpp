#include "import/ReadPictures.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "foreign/PictureReader.h"
#include "import/ModelFolder.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <map>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

} // namespace

std::vector<QImage> readPictures(const std::vector<PackedPicture>& pictures) {
    PictureReader reader;
    std::map<const char*, QImage> unpacked; // by where its bytes are
    std::vector<QImage> images;
    qint64 pixels = 0, packed = 0;
    for (const PackedPicture& picture : pictures) {
        QImage& image = unpacked[picture.bytes.constData()];
        if (image.isNull()) {
            image = reader.read(picture.bytes, picture.where);
        }
        pixels += qint64(image.width()) * image.height();
        packed += picture.bytes.size();
        requireWithin(Budget::Pixels, pixels, picture.where, packed);
        images.push_back(image);
    }
    return images;
}

QImage readPictureFile(const QString& path) {
    requireWithin(Budget::FileBytes, QFileInfo(path).size(), path);
    const auto bytes = readFile(path);
    if (!bytes) {
        throw Error(Text::tr("The texture file cannot be read; check its name and permissions"),
                    path);
    }
    return readPictures({{*bytes, path}}).front();
}

} // namespace dipwright

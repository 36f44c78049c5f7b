#include "import/trusted/ReadPictures.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "base/WideGamut.h"
#include "import/trusted/ModelFolder.h"
#include "import/trusted/ReaderProcess.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// Pictures in memory, found by PackedPicture::where.
class PicturesInMemory : public UntrustedFiles {
public:
    explicit PicturesInMemory(const std::vector<PackedPicture>& pictures) : pictures_(pictures) {}

private:
    std::optional<QByteArray> fetch(const QString& name) override {
        for (const PackedPicture& picture : pictures_) {
            if (picture.where == name) {
                return picture.bytes;
            }
        }
        return std::nullopt;
    }

    const std::vector<PackedPicture>& pictures_;
};

} // namespace

void PictureCount::add(const QImage& picture, qint64 packedBytes, const QString& where) {
    pixels_ += (isWide(picture) ? 2 : 1) * qint64(picture.width()) * picture.height();
    packedBytes_ += packedBytes;
    requireWithin(Budget::Pixels, pixels_, where, packedBytes_);
}

namespace {

std::vector<ReadPicture> readWithInks(const std::vector<PackedPicture>& pictures) {
    QStringList names; // without duplicates
    for (const PackedPicture& picture : pictures) {
        if (!names.contains(picture.where)) {
            names << picture.where;
        }
    }
    PicturesInMemory files(pictures);
    const std::vector<ReadPicture> unpacked = readPicturesInProcess(names, files);
    std::vector<ReadPicture> images;
    PictureCount count;
    for (const PackedPicture& picture : pictures) {
        images.push_back(unpacked[std::size_t(names.indexOf(picture.where))]);
        count.add(images.back().colours, picture.bytes.size(), picture.where);
        if (!images.back().inks.isNull()) {
            count.add(images.back().inks, 0, picture.where);
        }
    }
    return images;
}

} // namespace

std::vector<QImage> readPictures(const std::vector<PackedPicture>& pictures) {
    std::vector<QImage> colours;
    for (ReadPicture& picture : readWithInks(pictures)) {
        colours.push_back(std::move(picture.colours));
    }
    return colours;
}

QImage readPictureFile(const QString& path) {
    return readPictureAndInks(path).colours;
}

ReadPicture readPictureAndInks(const QString& path) {
    requireWithin(Budget::FileBytes, QFileInfo(path).size(), path);
    const auto bytes = readFile(path);
    if (!bytes) {
        throw Error(Text::tr("The picture cannot be read; check its name and permissions"), path);
    }
    return readWithInks({{*bytes, path}}).front();
}

} // namespace dipwright

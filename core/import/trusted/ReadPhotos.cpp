#include "import/trusted/ReadPhotos.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "base/Sha256.h"
#include "import/trusted/ModelFolder.h"
#include "import/trusted/ReaderProcess.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ReadPhotos)
};

// A single file, found by the path that the user chose.
class OneFile : public UntrustedFiles {
public:
    OneFile(QString name, QByteArray bytes) : name_(std::move(name)), bytes_(std::move(bytes)) {}

private:
    std::optional<QByteArray> fetch(const QString& name) override {
        return name == name_ ? std::optional(bytes_) : std::nullopt;
    }

    QString name_;
    QByteArray bytes_;
};

} // namespace

QStringList photoPatterns() {
    QStringList patterns{QStringLiteral("*.jpg"), QStringLiteral("*.jpeg"), QStringLiteral("*.png"),
                         QStringLiteral("*.tif"), QStringLiteral("*.tiff"), QStringLiteral("*.bmp"),
                         QStringLiteral("*.webp")};
    if (QImageReader::supportedImageFormats().contains("heif")) {
        patterns << QStringLiteral("*.heic") << QStringLiteral("*.heif");
    }
    return patterns;
}

Photo readPhotoFile(const QString& path, const Progress& progress) {
    requireWithin(Budget::FileBytes, QFileInfo(path).size(), path);
    const auto bytes = readFile(path);
    if (!bytes) {
        throw Error(Text::tr("The photo cannot be read; check its name and permissions"), path);
    }
    OneFile file(path, *bytes);
    ReadPhoto read = readPhotoInProcess(path, file, progress);
    Photo photo{path, std::move(read.picture), {}, {}, {}};
    photo.sha256 = sha256Hex(*bytes);
    const QDateTime taken =
        QDateTime::fromString(read.facts.taken, QStringLiteral("yyyy:MM:dd HH:mm:ss"));
    if (taken.isValid()) {
        photo.taken = taken;
    }
    if (read.facts.focalLength > 0 && std::isfinite(read.facts.focalLength)) {
        photo.focalLength = read.facts.focalLength / (std::hypot(36.0, 24.0) / 2);
    }
    return photo;
}

} // namespace dipwright

#include "geometry/FieldCache.h"

#include "base/Bytes.h"
#include "base/Sha256.h"
#include "disk/AtomicFile.h"
#include "disk/PlainFile.h"
#include "geometry/FieldFile.h"
#include "geometry/FinerFields.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

namespace dipwright {

namespace {

constexpr qint64 cacheBytes = qint64(1) << 30;

QString cacheFolder() {
    const QString chosen = qEnvironmentVariable("DIPWRIGHT_CACHE");
    return chosen.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::CacheLocation)
                            : chosen;
}

QByteArray contentHash(const TriangleMesh& body, int resolution) {
    Sha256 hash;
    const std::vector<quint64> sizes = {fieldFileVersion, quint64(resolution),
                                        body.positions.size(), body.triangles.size()};
    hash.add(bytesOf(sizes));
    hash.add(bytesOf(body.positions));
    hash.add(bytesOf(body.triangles));
    return hash.result();
}

std::shared_ptr<DistanceField> load(const QString& path) {
    QFile file(path);
    return openToRead(file).isEmpty() ? readField(file) : nullptr;
}

// Removes the least recently used fields until the rest fits.
void makeRoom(const QDir& folder, qint64 bytes) {
    const auto files = folder.entryInfoList({QStringLiteral("*.field")}, QDir::Files, QDir::Time);
    for (const QFileInfo& file : files) { // newest first
        bytes += file.size();
        if (bytes > cacheBytes) {
            QFile::remove(file.absoluteFilePath());
        }
    }
}

void store(const QString& path, const DistanceField& field) {
    const qint64 bytes = bytesOf(field.distance).size();
    const QDir folder = QFileInfo(path).dir();
    if (bytes > mostFieldBytes || !folder.mkpath(QStringLiteral("."))) {
        return;
    }
    makeRoom(folder, bytes);
    AtomicFile file(path);
    if (!file.open().isEmpty()) {
        return;
    }
    if (writeField(field, file.device())) {
        file.commit();
    }
}

// Updates the file's time. The file was read before, so it cannot be a pipe.
void markUsed(const QString& path) {
    QFile file(path);
    if (file.open(QIODevice::ReadWrite)) {
        file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
    }
}

} // namespace

std::shared_ptr<DistanceField> fieldFromCache(const QString& name,
                                              const std::function<DistanceField()>& build) {
    const QString path = QDir(cacheFolder()).filePath(name + QStringLiteral(".field"));
    std::shared_ptr<DistanceField> field = load(path);
    if (field) {
        markUsed(path);
    } else {
        field = std::make_shared<DistanceField>(build());
        store(path, *field);
    }
    return field;
}

std::shared_ptr<const DistanceField> cachedDistanceField(const TriangleMesh& model, int resolution,
                                                         const Progress& progress) {
    TriangleMesh body = inBodyCoordinates(model);
    const QString name = QString::fromLatin1(contentHash(body, resolution).toHex());
    const std::shared_ptr<DistanceField> field = fieldFromCache(name, [&] {
        const SurfaceQuery query(body);
        const FieldGrid grid = fieldGrid(body, resolution, thinParts(body, query).thickness);
        return buildDistanceField(body, query, grid, progress);
    });
    field->finer = std::make_shared<const FinerFields>(std::move(body), *field, name);
    return field;
}

} // namespace dipwright

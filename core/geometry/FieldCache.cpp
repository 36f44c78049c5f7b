#include "geometry/DistanceField.h"

#include "base/Sha256.h"
#include "disk/AtomicFile.h"

#include <QDataStream>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>
#include <span>

namespace dipwright {

namespace {

// Raised when what buildDistanceField computes, or how it is stored, changes.
constexpr quint32 cacheVersion = 2;
constexpr qint64 cacheBytes = qint64(512) << 20;

QString cacheFolder() {
    const QString chosen = qEnvironmentVariable("DIPWRIGHT_CACHE");
    return chosen.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::CacheLocation)
                            : chosen;
}

template <typename Value>
QByteArrayView bytesOf(const std::vector<Value>& values) {
    return {reinterpret_cast<const char*>(values.data()), qsizetype(values.size() * sizeof(Value))};
}

QByteArray contentHash(const TriangleMesh& body, int resolution) {
    Sha256 hash;
    const std::vector<quint64> sizes = {cacheVersion, quint64(resolution), body.positions.size(),
                                        body.triangles.size()};
    hash.add(bytesOf(sizes));
    hash.add(bytesOf(body.positions));
    hash.add(bytesOf(body.triangles));
    return hash.result();
}

// What stands before the samples: their grid, and a hash of everything. The samples are stored as
// this computer holds them: the cache never leaves it.
QByteArray header(const DistanceField& field) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << cacheVersion << qint32(Q_BYTE_ORDER);
    for (int axis = 0; axis < 3; ++axis) {
        stream << qint32(field.size[axis]) << field.origin[axis];
    }
    stream << field.spacing;
    Sha256 hash;
    hash.add(bytes);
    hash.add(bytesOf(field.distance));
    stream << hash.result();
    return bytes;
}

std::shared_ptr<const DistanceField> load(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return nullptr;
    }
    auto field = std::make_shared<DistanceField>();
    QByteArray stored;
    QDataStream stream(&file);
    stream >> stored;
    QDataStream fields(stored);
    quint32 version = 0;
    qint32 byteOrder = 0;
    fields >> version >> byteOrder;
    for (int axis = 0; axis < 3; ++axis) {
        qint32 size = 0;
        fields >> size >> field->origin[axis];
        field->size[axis] = size;
    }
    fields >> field->spacing;
    constexpr int longest = 1 << 20; // so that no count runs over
    const auto [fewest, most] = std::minmax_element(field->size.begin(), field->size.end());
    if (version != cacheVersion || *fewest < 2 || *most > longest ||
        file.size() - file.pos() != qint64(field->sampleCount() * sizeof(float))) {
        return nullptr;
    }
    const qint64 bytes = file.size() - file.pos();
    field->distance.resize(field->sampleCount());
    if (file.read(reinterpret_cast<char*>(field->distance.data()), bytes) != bytes ||
        header(*field) != stored) {
        return nullptr;
    }
    return field;
}

// Throws out the fields that were not used for longest until the rest fits.
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
    if (bytes > cacheBytes || !folder.mkpath(QStringLiteral("."))) {
        return;
    }
    makeRoom(folder, bytes);
    AtomicFile file(path);
    if (!file.open().isEmpty()) {
        return;
    }
    QDataStream stream(&file.device());
    stream << header(field);
    if (file.device().write(bytesOf(field.distance).data(), bytes) == bytes) {
        file.commit();
    }
}

void markUsed(const QString& path) {
    QFile file(path);
    if (file.open(QIODevice::ReadWrite)) {
        file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime);
    }
}

} // namespace

std::shared_ptr<const DistanceField> cachedDistanceField(const TriangleMesh& body, int resolution,
                                                         const Progress& progress) {
    const QString name = QString::fromLatin1(contentHash(body, resolution).toHex());
    const QString path = QDir(cacheFolder()).filePath(name + QStringLiteral(".field"));
    if (auto field = load(path)) {
        markUsed(path);
        return field;
    }
    const SurfaceQuery query(body);
    const FieldGrid grid = fieldGrid(body, resolution, thinnestPart(body, query));
    auto field =
        std::make_shared<const DistanceField>(buildDistanceField(body, query, grid, progress));
    store(path, *field);
    return field;
}

} // namespace dipwright

#include "geometry/FieldFile.h"

#include "base/Sha256.h"

#include <QDataStream>

#include <algorithm>

namespace dipwright {
namespace {

constexpr qint64 mostHeaderBytes = 1024;

QByteArrayView samplesOf(const DistanceField& field) {
    return {reinterpret_cast<const char*>(field.distance.data()),
            qsizetype(field.distance.size() * sizeof(float))};
}

// Returns the file's header: the grid and a hash of everything. The samples follow it in this
// computer's byte order.
QByteArray header(const DistanceField& field) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream << fieldFileVersion << qint32(Q_BYTE_ORDER);
    for (int axis = 0; axis < 3; ++axis) {
        stream << qint32(field.size[axis]) << field.origin[axis];
    }
    stream << field.spacing;
    Sha256 hash;
    hash.add(bytes);
    hash.add(samplesOf(field));
    stream << hash.result();
    return bytes;
}

} // namespace

bool writeField(const DistanceField& field, QIODevice& device) {
    QDataStream stream(&device);
    stream << header(field);
    const QByteArrayView samples = samplesOf(field);
    return stream.status() == QDataStream::Ok &&
           device.write(samples.data(), samples.size()) == samples.size();
}

std::shared_ptr<DistanceField> readField(QIODevice& device) {
    if (device.size() > mostFieldBytes + mostHeaderBytes) {
        return nullptr;
    }
    auto field = std::make_shared<DistanceField>();
    QByteArray stored;
    QDataStream stream(&device);
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
    constexpr int longest = 1 << 20; // so that no sample count overflows
    const auto [fewest, most] = std::minmax_element(field->size.begin(), field->size.end());
    if (version != fieldFileVersion || *fewest < 2 || *most > longest) {
        return nullptr;
    }
    const auto bytes = qint64(field->sampleCount() * sizeof(float));
    if (device.size() - device.pos() != bytes) {
        return nullptr;
    }
    field->distance.resize(field->sampleCount());
    if (device.read(reinterpret_cast<char*>(field->distance.data()), bytes) != bytes ||
        header(*field) != stored) {
        return nullptr;
    }
    return field;
}

} // namespace dipwright

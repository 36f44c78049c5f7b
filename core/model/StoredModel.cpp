// The project's own model file. All numbers little-endian, in this order:
//   "DWMODEL" 0, u32 version, u64 positions, u64 triangles, u32 materials, u32 textures,
//   positions (3 × f32), triangles (3 × u32), texture coordinates (3 × 2 × f32 a triangle),
//   charts (u32), materials of the triangles (u16),
//   materials: name (u32 length, UTF-8), colour (u64, 16 bits each of red, green, blue and alpha),
//   texture (i32), textures: u32 length, PNG.
#include "model/StoredModel.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "base/Png.h"

#include <QCoreApplication>
#include <QDataStream>
#include <QIODevice>
#include <QtEndian>

#include <cmath>

namespace dipwright {

namespace {

constexpr char signature[8] = {'D', 'W', 'M', 'O', 'D', 'E', 'L', '\0'};
constexpr quint32 formatVersion = 1;

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ModelFile)
};

void prepare(QDataStream& stream) {
    stream.setVersion(QDataStream::Qt_6_4);
    stream.setByteOrder(QDataStream::LittleEndian);
}

// Writes an array of numbers, or of arrays of numbers, as one block.
template <typename Number, typename Value>
void writeNumbers(QDataStream& stream, const std::vector<Value>& values) {
    static_assert(sizeof(Value) % sizeof(Number) == 0);
    if (values.empty()) {
        return;
    }
    const auto bytes = qsizetype(values.size()) * qsizetype(sizeof(Value));
    QByteArray swapped(bytes, Qt::Uninitialized);
    qToLittleEndian<Number>(values.data(), bytes / qsizetype(sizeof(Number)), swapped.data());
    stream.writeRawData(swapped.constData(), int(bytes));
}

class ModelReader {
public:
    enum class Numbers { Checked, Unchecked };

    ModelReader(const QByteArray& bytes, const QString& where, Numbers numbers)
        : bytes_(bytes), where_(where), numbers_(numbers), stream_(bytes) {
        prepare(stream_);
    }

    StoredModel read() {
        readSignature();
        const auto positions = readNumber<quint64>(), triangles = readNumber<quint64>();
        const auto materials = readNumber<quint32>(), textures = readNumber<quint32>();
        requireWithin(Budget::Triangles, qint64(std::min(triangles, quint64(1) << 62)), where_,
                      bytes_.size());
        StoredModel stored;
        TexturedMesh& model = stored.model;
        readNumbers<quint32>(model.mesh.positions, positions);
        readNumbers<quint32>(model.mesh.triangles, triangles);
        readNumbers<quint32>(model.textureCoordinates, triangles);
        readNumbers<quint32>(model.chart, triangles);
        readNumbers<quint16>(model.material, triangles);
        for (quint32 material = 0; material < materials; ++material) {
            model.materials.push_back(readMaterial());
        }
        for (quint32 texture = 0; texture < textures; ++texture) {
            stored.pictures.push_back(readBlock());
        }
        require(stream_.atEnd());
        check(stored);
        return stored;
    }

private:
    void require(bool condition) const {
        if (!condition || stream_.status() != QDataStream::Ok) {
            throw Error(Text::tr("The stored model is damaged; import the model again"), where_);
        }
    }

    void readSignature() {
        char found[sizeof(signature)] = {};
        stream_.readRawData(found, sizeof(found));
        require(std::equal(std::begin(found), std::end(found), std::begin(signature)));
        if (const auto version = readNumber<quint32>(); version != formatVersion) {
            throw Error(Text::tr("The stored model has format version %1, but this program reads "
                                 "version %2; use a newer version of this program")
                            .arg(version)
                            .arg(formatVersion),
                        where_);
        }
    }

    template <typename Number>
    Number readNumber() {
        Number number{};
        stream_ >> number;
        require(true);
        return number;
    }

    // Limits allocation to bytes that are really there.
    quint64 bytesLeft() const { return quint64(bytes_.size() - stream_.device()->pos()); }

    template <typename Number, typename Value>
    void readNumbers(std::vector<Value>& values, quint64 count) {
        require(count <= bytesLeft() / sizeof(Value));
        if (count == 0) {
            return;
        }
        values.resize(count);
        qFromLittleEndian<Number>(bytes_.constData() + stream_.device()->pos(),
                                  qsizetype(count * sizeof(Value) / sizeof(Number)), values.data());
        stream_.device()->seek(stream_.device()->pos() + qint64(count * sizeof(Value)));
    }

    QByteArray readBlock() {
        const auto length = readNumber<quint32>();
        require(length <= bytesLeft());
        return stream_.device()->read(length);
    }

    Material readMaterial() {
        Material material;
        material.name = QString::fromUtf8(readBlock());
        material.colour = QColor::fromRgba64(QRgba64::fromRgba64(readNumber<quint64>()));
        material.texture = readNumber<qint32>();
        return material;
    }

    void checkNumbers(const TexturedMesh& model) const {
        require(!model.mesh.triangles.empty() && !model.materials.empty());
        const auto isPlace = [](const Eigen::Vector3f& position) { return position.allFinite(); };
        require(std::all_of(model.mesh.positions.begin(), model.mesh.positions.end(), isPlace));
        for (const auto& corners : model.textureCoordinates) {
            for (const Eigen::Vector2f& uv : corners) {
                require(!std::isinf(uv.x()) && !std::isinf(uv.y()));
            }
        }
    }

    void check(const StoredModel& stored) const {
        const TexturedMesh& model = stored.model;
        if (numbers_ == Numbers::Checked) {
            checkNumbers(model);
        }
        for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
            for (int corner = 0; corner < 3; ++corner) {
                require(model.mesh.triangles[t][corner] < model.mesh.positions.size());
            }
            require(model.chart[t] < model.mesh.triangles.size());
            require(model.material[t] < model.materials.size());
        }
        for (const Material& material : model.materials) {
            require(material.texture >= -1 && material.texture < qint64(stored.pictures.size()));
        }
        require(numbers_ != Numbers::Checked || surfaceArea(model.mesh) > 0);
    }

    const QByteArray& bytes_;
    QString where_;
    Numbers numbers_;
    QDataStream stream_;
};

} // namespace

TexturedMesh withoutPictures(const TexturedMesh& model) {
    TexturedMesh bare = model;
    for (QImage& texture : bare.textures) {
        texture = QImage(1, 1, QImage::Format_RGBA8888);
        texture.fill(Qt::white);
    }
    return bare;
}

QByteArray writeModel(const TexturedMesh& model) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    prepare(stream);
    stream.writeRawData(signature, sizeof(signature));
    stream << formatVersion << quint64(model.mesh.positions.size())
           << quint64(model.mesh.triangles.size()) << quint32(model.materials.size())
           << quint32(model.textures.size());
    writeNumbers<quint32>(stream, model.mesh.positions);
    writeNumbers<quint32>(stream, model.mesh.triangles);
    writeNumbers<quint32>(stream, model.textureCoordinates);
    writeNumbers<quint32>(stream, model.chart);
    writeNumbers<quint16>(stream, model.material);
    for (const Material& material : model.materials) {
        const QByteArray name = material.name.toUtf8();
        stream << quint32(name.size());
        stream.writeRawData(name.constData(), int(name.size()));
        stream << quint64(material.colour.rgba64()) << qint32(material.texture);
    }
    for (const QImage& texture : model.textures) {
        stream << pngBytes(texture, Text::tr("a texture of the model"));
    }
    return bytes;
}

StoredModel readModel(const QByteArray& bytes, const QString& where) {
    return ModelReader(bytes, where, ModelReader::Numbers::Checked).read();
}

StoredModel readUncheckedModel(const QByteArray& bytes, const QString& where) {
    return ModelReader(bytes, where, ModelReader::Numbers::Unchecked).read();
}

} // namespace dipwright

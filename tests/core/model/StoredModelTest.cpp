// The project's own model file: written models are read again, damaged files are refused.
#include "ModelFiles.h"

#include "base/Error.h"
#include "geometry/Shapes.h"
#include "import/trusted/ImportModel.h"
#include "import/trusted/ReadPictures.h"
#include "model/StoredModel.h"

#include <QtTest>

#include <cmath>
#include <cstring>
#include <random>

using namespace dipwright;
using namespace dipwright::test;

namespace {

TexturedMesh sample() {
    TexturedMesh model;
    model.mesh = sphereMesh(35, 10, 20);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> coordinate(-2, 2);
    const std::size_t triangles = model.mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t) {
        auto& corners = model.textureCoordinates.emplace_back();
        for (auto& uv : corners) {
            const float u = coordinate(random), v = coordinate(random);
            uv = Eigen::Vector2f(u, v);
        }
        model.material.push_back(std::uint16_t(t % 3));
    }
    model.textureCoordinates[7].fill(Eigen::Vector2f::Constant(std::nanf("")));
    model.materials.resize(3);
    model.materials[0] = {QStringLiteral("Rücken"), QColor(1, 2, 3), 0};
    model.materials[1] = {QString(), QColor(250, 128, 0), -1};
    model.materials[2] = {QStringLiteral("belly"), QColor(Qt::white), 1};
    QImage transparent = quarters(31);
    transparent.setPixelColor(3, 4, QColor(10, 20, 30, 0));
    transparent.setPixelColor(5, 6, QColor(10, 20, 30, 77));
    model.textures = {quarters(64), transparent};
    model.chart = findCharts(model);
    return model;
}

template <typename Value>
bool sameBytes(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

bool isSame(const Material& a, const Material& b) {
    return a.name == b.name && a.colour == b.colour && a.texture == b.texture;
}

bool isSame(const TexturedMesh& a, const TexturedMesh& b) {
    return sameBytes(a.mesh.positions, b.mesh.positions) &&
           sameBytes(a.mesh.triangles, b.mesh.triangles) &&
           sameBytes(a.textureCoordinates, b.textureCoordinates) &&
           sameBytes(a.material, b.material) && sameBytes(a.chart, b.chart) &&
           std::equal(a.materials.begin(), a.materials.end(), b.materials.begin(),
                      b.materials.end(),
                      [](const Material& x, const Material& y) { return isSame(x, y); }) &&
           a.textures == b.textures;
}

// Reads a model with its pictures.
TexturedMesh unpacked(const QByteArray& bytes) {
    StoredModel stored = readModel(bytes, QStringLiteral("x"));
    std::vector<PackedPicture> pictures;
    for (const QByteArray& picture : stored.pictures) {
        pictures.push_back({picture, QString::number(pictures.size())});
    }
    stored.model.textures = readPictures(pictures);
    return stored.model;
}

bool isRefused(const QByteArray& bytes) {
    try {
        readModel(bytes, QStringLiteral("assets/model"));
        return false;
    } catch (const Error& error) {
        return error.sentence().contains(QStringLiteral("assets/model"));
    }
}

} // namespace

class StoredModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void writeModel_readAgain_keepsEverything();
    void writeModel_importedModelReadAgain_keepsEverything();
    void writeModel_equalModels_giveEqualBytes();
    void readModel_newerVersion_isRefusedByNumber();
    void readModel_truncated_isRefused();
    void readModel_bytesAfterTheEnd_areRefused();
    void readModel_hostileCounts_areRefused();
    void readModel_damaged_isRefusedOrHarmless();
    void readUncheckedModel_emptyModel_isRead();
};

void StoredModelTest::writeModel_readAgain_keepsEverything() {
    const TexturedMesh model = sample();
    const TexturedMesh back = unpacked(writeModel(model));
    QVERIFY(isSame(back, model));
    QCOMPARE(back.textures[1].format(), QImage::Format_RGBA8888);
    QCOMPARE(back.textures[1].pixelColor(3, 4), QColor(10, 20, 30, 0));
}

void StoredModelTest::writeModel_importedModelReadAgain_keepsEverything() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("square.glb"));
    writeFile(path, squareGlb(png(quarters())));
    const TexturedMesh model = importModel(path, ImportOptions(), Progress()).model;
    QVERIFY(isSame(unpacked(writeModel(model)), model));
}

void StoredModelTest::writeModel_equalModels_giveEqualBytes() {
    QCOMPARE(writeModel(sample()), writeModel(sample()));
}

void StoredModelTest::readModel_newerVersion_isRefusedByNumber() {
    QByteArray bytes = writeModel(sample());
    bytes[8] = 9;
    try {
        readModel(bytes, QStringLiteral("x"));
        QFAIL("a newer version was read, expected a refusal");
    } catch (const Error& error) {
        QVERIFY(error.message().contains(u'9') && error.message().contains(u'1'));
    }
}

void StoredModelTest::readModel_truncated_isRefused() {
    const QByteArray bytes = writeModel(sample());
    for (qsizetype length = 0; length < bytes.size(); length += length < 200 ? 1 : 101) {
        QVERIFY(isRefused(bytes.left(length)));
    }
}

void StoredModelTest::readModel_bytesAfterTheEnd_areRefused() {
    QVERIFY(isRefused(writeModel(sample()) + "x"));
}

void StoredModelTest::readModel_hostileCounts_areRefused() {
    for (const int place : {12, 20, 28, 32}) { // positions, triangles, materials, textures
        for (const char value : {'\x7f', '\xff'}) {
            QByteArray bytes = writeModel(sample());
            bytes[place + 3] = value;
            QVERIFY(isRefused(bytes));
            bytes.replace(place, 4, QByteArray(4, '\xff'));
            QVERIFY(isRefused(bytes));
        }
    }
    QByteArray bytes = writeModel(sample());
    bytes.replace(12, 16, QByteArray(16, '\xff'));
    QVERIFY(isRefused(bytes));
}

void StoredModelTest::readModel_damaged_isRefusedOrHarmless() {
    const QByteArray whole = writeModel(sample());
    std::mt19937 random(11);
    for (int round = 0; round < 3000; ++round) {
        QByteArray bytes = whole;
        for (int hit = 0; hit < 3; ++hit) {
            bytes[qsizetype(random() % std::size_t(bytes.size()))] = char(random());
        }
        try {
            const TexturedMesh model = readModel(bytes, QStringLiteral("x")).model;
            for (std::uint32_t t = 0; t < model.mesh.triangles.size(); ++t) {
                QVERIFY(position(model.mesh, {t, Eigen::Vector3f(1, 0, 0)}).allFinite());
                QVERIFY(model.material[t] < model.materials.size());
            }
        } catch (const Error&) {
        }
    }
}

// Found by fuzzing: empty lists were copied from a null pointer.
void StoredModelTest::readUncheckedModel_emptyModel_isRead() {
    const QByteArray bytes = writeModel(TexturedMesh());
    QVERIFY(readUncheckedModel(bytes, QStringLiteral("x")).model.mesh.triangles.empty());
    QVERIFY(isRefused(bytes.left(bytes.size() - 1)));
    QVERIFY_EXCEPTION_THROWN(readModel(bytes, QStringLiteral("x")), Error);
}

QTEST_GUILESS_MAIN(StoredModelTest)
#include "StoredModelTest.moc"

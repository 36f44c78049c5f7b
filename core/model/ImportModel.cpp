#include "model/ImportModel.h"

#include "base/Error.h"
#include "model/ColladaCheck.h"
#include "model/MeshRepair.h"
#include "model/ModelFolder.h"
#include "model/ModelFormats.h"
#include "model/ModelSource.h"
#include "model/PlyReader.h"
#include "model/SceneConversion.h"
#include "model/Texture.h"
#include "model/ThreeMfReader.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/ProgressHandler.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// A file in memory, as assimp reads it.
class FileStream : public Assimp::MemoryIOStream {
public:
    explicit FileStream(QByteArray bytes)
        : MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                         std::size_t(bytes.size())),
          bytes_(std::move(bytes)) {}

private:
    QByteArray bytes_; // shares its data with the one given
};

// Lets assimp read through Qt, so that paths of every language work on every system, finds the
// files that the model names as ModelFolder does, and remembers those that are missing.
class ModelFileSystem : public Assimp::IOSystem {
public:
    explicit ModelFileSystem(const QString& path, const ModelFolder& folder)
        : path_(path), folder_(folder) {}

    bool Exists(const char* name) const override { return !resolve(name).isEmpty(); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* /*mode*/) override {
        const QString path = resolve(name);
        auto bytes = path.isEmpty() ? std::nullopt : readFile(path);
        if (!bytes) {
            remember(QFileInfo(QString::fromUtf8(name)).fileName());
            return nullptr;
        }
        return new FileStream(std::move(*bytes));
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

    const QStringList& missing() const { return missing_; }

private:
    void remember(const QString& missing) {
        // Having failed with the name in the model, readers also try the model's own name.
        const bool isSecondTry = !missing_.isEmpty() && QFileInfo(missing).completeBaseName() ==
                                                            QFileInfo(path_).completeBaseName();
        if (!missing_.contains(missing) && !isSecondTry) {
            missing_.push_back(missing);
        }
    }

    QString resolve(const char* name) const {
        const QString file = QString::fromUtf8(name);
        return file == path_ ? path_ : folder_.find(file);
    }

    QString path_;
    const ModelFolder& folder_;
    QStringList missing_;
};

class ReadingProgress : public Assimp::ProgressHandler {
public:
    explicit ReadingProgress(const Progress& progress) : progress_(progress) {}
    bool Update(float share) override {
        progress_(std::clamp(double(share), 0.0, 1.0), Text::tr("Reading the model"));
        return true;
    }

private:
    const Progress& progress_;
};

// A zip file, which assimp would read past our check of what is in it.
const QString packedCollada = QStringLiteral("zae");

// mm; larger than any dip tank by far.
constexpr double maximumEdge = 1e5;
constexpr float maximumTextureCoordinate = 1e5F; // past it a float holds no place in a picture

void checkOptions(const ImportOptions& options) {
    const double edge = options.longestEdge.value_or(Millimetres(1)).value();
    if (!(edge > 0) || edge > maximumEdge) {
        throw Error(
            Text::tr("The model's size must be more than 0 and at most %1 mm").arg(maximumEdge),
            QString::number(edge));
    }
    if (!(options.unitMillimetres > 0) || !std::isfinite(options.unitMillimetres)) {
        throw Error(Text::tr("The model's unit must be a positive number of millimetres"),
                    QString::number(options.unitMillimetres));
    }
}

void checkFile(const QString& path) {
    const QFileInfo file(path);
    if (!file.exists()) {
        throw Error(Text::tr("The model file does not exist; check its name"), path);
    }
    if (file.isDir()) {
        throw Error(Text::tr("This is a folder; choose a model file in it"), path);
    }
    if (!file.isReadable()) {
        throw Error(Text::tr("The model file cannot be read; check its permissions"), path);
    }
    if (file.size() == 0) {
        throw Error(Text::tr("The model file is empty; save it anew"), path);
    }
}

QImage replacementTexture(const QString& path) {
    if (path.isEmpty()) {
        return QImage();
    }
    const auto bytes = readFile(path);
    if (!bytes) {
        throw Error(Text::tr("The texture file cannot be read; check its name and permissions"),
                    path);
    }
    return readTexture(*bytes, path);
}

void checkPositions(const TriangleMesh& mesh, const QString& path) {
    std::size_t bad = 0;
    for (const auto& triangle : mesh.triangles) {
        for (const auto corner : triangle) {
            bad += !mesh.positions[corner].allFinite();
        }
    }
    if (bad > 0) {
        throw Error(
            Text::tr("%1 corners of the model's triangles are not numbers (NaN or infinite); "
                     "repair the model and save it anew")
                .arg(bad),
            path);
    }
}

void repair(TexturedMesh& model, QStringList& repairs, const QString& path) {
    weldPositions(model.mesh);
    if (const std::size_t count = removeDegenerateTriangles(model); count > 0) {
        repairs.push_back(Text::tr("Removed %n triangle(s) without area", nullptr, int(count)));
    }
    if (model.mesh.triangles.empty()) {
        throw Error(Text::tr("None of the model's triangles has an area; choose another model"),
                    path);
    }
    if (const std::size_t count = orientTriangles(model); count > 0) {
        repairs.push_back(Text::tr("Turned %n triangle(s) that faced the other way than their "
                                   "neighbours",
                                   nullptr, int(count)));
    }
    if (const std::size_t count = turnInsideOutParts(model); count > 0) {
        repairs.push_back(
            Text::tr("Turned %n part(s) of the surface that were inside out", nullptr, int(count)));
    }
}

void scale(TriangleMesh& mesh, const ImportOptions& options, const QString& path) {
    const BoundingBox box = boundingBox(mesh);
    const double edge = (box.max().cast<double>() - box.min().cast<double>()).maxCoeff();
    if (edge == 0) {
        throw Error(Text::tr("The model has no extent; choose another model"), path);
    }
    const double factor =
        options.longestEdge ? options.longestEdge->value() / edge : options.unitMillimetres;
    if (edge * factor > maximumEdge) {
        throw Error(Text::tr("The model's longest edge would be %1 mm; give the size it is to have")
                        .arg(edge * factor),
                    path);
    }
    for (auto& position : mesh.positions) {
        position = (position.cast<double>() * factor).cast<float>();
    }
    if (!boundingBox(mesh).sizes().allFinite()) {
        throw Error(
            Text::tr("The model lies too far from its origin; move it there and save it anew"),
            path);
    }
}

void describe(const TexturedMesh& model, ImportReport& report) {
    report.triangles = model.mesh.triangles.size();
    report.closed = isClosed(model.mesh);
    report.volume = volume(model.mesh);
    report.box = boundingBox(model.mesh);
    if (!report.closed) {
        report.warnings.push_back(
            Text::tr("The mesh is not closed: what is inside is judged by most of "
                     "the directions from which it is seen"));
    }
    if (const float edge = report.box.sizes().maxCoeff(); edge < 1) {
        report.warnings.push_back(
            Text::tr("The model's longest edge is only %1 mm; if its file is not "
                     "in millimetres, give the size it is to have")
                .arg(double(edge)));
    }
}

bool hasAnyTextureCoordinates(const TexturedMesh& model) {
    for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
        if (model.hasTextureCoordinates(t)) {
            return true;
        }
    }
    return false;
}

void dropUselessTextures(TexturedMesh& model, QStringList& warnings) {
    if (model.textures.empty() || hasAnyTextureCoordinates(model)) {
        return;
    }
    warnings.push_back(
        Text::tr("The model has no texture coordinates, so its texture cannot be placed "
                 "and is not used; its materials' colours are"));
    model.textures.clear();
    for (Material& material : model.materials) {
        material.texture = -1;
    }
}

TexturedMesh readByAssimp(const ModelSource& source, QStringList& warnings,
                          const Progress& progress) {
    const QString absolutePath = QFileInfo(source.path).absoluteFilePath();
    const Progress readingPart = progress.part(0, 0.8);
    ReadingProgress reading(readingPart);
    Assimp::Importer importer;
    for (const char* format : {"ply", "3mf"}) { // which it would try on files of other names too
        const std::unique_ptr<Assimp::BaseImporter> unused(importer.GetImporter(format));
        importer.UnregisterLoader(unused.get());
    }
    auto* files = new ModelFileSystem(absolutePath, source.folder);
    importer.SetIOHandler(files); // takes it over
    importer.SetProgressHandler(&reading);
    const aiScene* scene = importer.ReadFile(absolutePath.toUtf8().constData(),
                                             aiProcess_Triangulate | aiProcess_TransformUVCoords);
    importer.SetProgressHandler(nullptr);
    progress.cancelSwitch.throwIfCancelled();
    if (!scene) {
        source.throwDamaged(QString::fromUtf8(importer.GetErrorString()).simplified());
    }
    for (const QString& name : files->missing()) {
        warnings.push_back(Text::tr("The file %1, which the model names, was not found").arg(name));
    }
    const QString suffix = QFileInfo(source.path).suffix().toLower();
    const bool isGltf = suffix == QStringLiteral("gltf") || suffix == QStringLiteral("glb");
    return convertScene(*scene, source, isGltf, warnings, progress.part(0.8, 1));
}

// The format of a file is known by how it begins where that says enough, else by its name.
TexturedMesh readTriangles(const ModelSource& source, QStringList& warnings,
                           const Progress& progress) {
    constexpr qint64 longestPrologue = 4096;
    QFile file(source.path);
    const QByteArray begin =
        file.open(QIODevice::ReadOnly) ? file.read(longestPrologue) : QByteArray();
    const QString suffix = QFileInfo(source.path).suffix().toLower();
    const bool isPly =
        suffix == QStringLiteral("ply") || begin.startsWith("ply\n") || begin.startsWith("ply\r");
    if (suffix == packedCollada) {
        source.throwDamaged(Text::tr("packed Collada is not read, unpack it"));
    }
    const bool isDae = suffix == QStringLiteral("dae") || isCollada(begin);
    if (!isPly && !isDae && suffix != QStringLiteral("3mf")) {
        return readByAssimp(source, warnings, progress);
    }
    progress(0, Text::tr("Reading the model"));
    const auto bytes = readFile(source.path);
    if (!bytes) {
        source.throwDamaged(file.errorString());
    }
    if (isDae) {
        checkCollada(*bytes, source);
        return readByAssimp(source, warnings, progress);
    }
    return isPly ? readPly(*bytes, source, warnings, progress.cancelSwitch)
                 : readThreeMf(*bytes, source, warnings, progress.cancelSwitch);
}

void dropUnusableCoordinates(TexturedMesh& model, QStringList& warnings) {
    std::size_t dropped = 0;
    for (auto& corners : model.textureCoordinates) {
        for (auto& uv : corners) {
            const bool isUnusable = uv.cwiseAbs().maxCoeff() > maximumTextureCoordinate;
            dropped += isUnusable;
            if (isUnusable) {
                corners = noCoordinates();
            }
        }
    }
    if (dropped > 0) {
        warnings.push_back(
            Text::tr("%1 texture coordinates are too large to be used; their triangles "
                     "show the material's colour")
                .arg(dropped));
    }
}

void replaceTextures(TexturedMesh& model, const QImage& texture) {
    model.textures = {texture};
    for (Material& material : model.materials) {
        material.texture = 0;
    }
}

ImportedModel import(const QString& path, const ImportOptions& options, const Progress& progress) {
    checkOptions(options);
    checkFile(path);
    const QImage texture = replacementTexture(options.texture);
    const ModelSource source{path, ModelFolder(path), texture.isNull()};
    ImportedModel result;
    TexturedMesh& model = result.model;
    ImportReport& report = result.report;

    model = readTriangles(source, report.warnings, progress.part(0, 0.7));
    if (model.mesh.triangles.empty()) {
        throw Error(Text::tr("The model has no triangles; save it with its surface"), path);
    }
    if (!texture.isNull()) {
        replaceTextures(model, texture);
    }
    progress(0.7, Text::tr("Checking the model"));
    checkPositions(model.mesh, path);
    dropUnusableCoordinates(model, report.warnings);
    repair(model, report.repairs, path);
    scale(model.mesh, options, path);
    dropUselessTextures(model, report.warnings);
    progress(0.9, Text::tr("Finding the texture's charts"));
    model.chart = findCharts(model);
    describe(model, report);
    progress(1, Text::tr("Checking the model"));
    return result;
}

} // namespace

TexturedMesh withTexture(const TexturedMesh& model, const QString& path) {
    if (!hasAnyTextureCoordinates(model)) {
        throw Error(Text::tr("The model has no texture coordinates, so no picture can be placed on "
                             "it; unwrap it in a modelling program first"),
                    path);
    }
    TexturedMesh other = model;
    replaceTextures(other, replacementTexture(path));
    return other;
}

ImportedModel importModel(const QString& path, const ImportOptions& options,
                          const Progress& progress) {
    try {
        return import(path, options, progress);
    } catch (const std::bad_alloc&) {
        throw Error(Text::tr("The model needs more memory than there is; reduce it"), path);
    }
}

QStringList modelFilePatterns() {
    QStringList patterns;
    for (const ModelFormat& format : modelFormats()) {
        for (const QString& suffix : format.suffixes) {
            patterns.push_back(QStringLiteral("*.%1").arg(suffix));
        }
    }
    aiString others;
    Assimp::Importer().GetExtensionList(others);
    for (const QString& pattern : QString::fromUtf8(others.C_Str()).split(u';')) {
        if (!patterns.contains(pattern) && !pattern.endsWith(packedCollada)) {
            patterns.push_back(pattern);
        }
    }
    return patterns;
}

} // namespace dipwright

#include "import/sandboxed/AssimpReader.h"

#include "base/Budgets.h"
#include "import/sandboxed/ColladaTextureSets.h"
#include "import/sandboxed/FbxCheck.h"
#include "import/sandboxed/FbxFrame.h"
#include "import/sandboxed/FbxTextureSets.h"
#include "import/sandboxed/GltfCheck.h"
#include "import/sandboxed/MaterialFileCheck.h"
#include "import/sandboxed/ObjText.h"
#include "import/sandboxed/SceneConversion.h"
#include "import/sandboxed/StlBytes.h"
#include "import/sandboxed/ThreeDsCheck.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>
#include <QtEndian>

#include <assimp/BaseImporter.h>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/ProgressHandler.hpp>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <map>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::ImportModel)
};

// A file in memory, for assimp.
class FileStream : public Assimp::MemoryIOStream {
public:
    explicit FileStream(QByteArray bytes)
        : MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                         std::size_t(bytes.size())),
          bytes_(std::move(bytes)) {}

private:
    QByteArray bytes_; // shares its data with the constructor's argument
};

// Returns the file names in a line "mtllib a.mtl b.mtl" of an OBJ file. Names may contain spaces
// or be in quotes.
QStringList materialFileNames(const QString& line) {
    static const QRegularExpression between(QStringLiteral("(?<=\\.mtl|\\.mtl\")\\s+"),
                                            QRegularExpression::CaseInsensitiveOption);
    return line.split(between, Qt::SkipEmptyParts);
}

// The only files that assimp can see: the model file and the files that it names. Records which are
// missing and what is wrong with them.
class ModelFileSystem : public Assimp::IOSystem {
public:
    ModelFileSystem(const ModelSource& source, std::string modelName, QByteArray modelBytes)
        : source_(source), modelName_(std::move(modelName)), modelBytes_(std::move(modelBytes)) {}

    bool Exists(const char* name) const override { return modelName_ == name || find(name); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* /*mode*/) override {
        const bool isModel = modelName_ == name;
        if (isModel && !model_) {
            return model_ = new FileStream(modelBytes_);
        }
        const auto bytes = isModel ? std::optional(modelBytes_) : find(name);
        // An OBJ file may list several material files as one name.
        if (modelName_.ends_with(".obj")) {
            return openMaterials(QString::fromUtf8(name), bytes);
        }
        if (!bytes) {
            rememberMissing(QString::fromUtf8(name));
        }
        return bytes ? new FileStream(*bytes) : nullptr;
    }
    void Close(Assimp::IOStream* stream) override {
        model_ = stream == model_ ? nullptr : model_;
        delete stream;
    }

    const QStringList& missing() const { return missing_; }
    const QString& fault() const { return fault_; } // empty if there is none
    const QStringList& warnings() const { return warnings_; }
    const PicturePlacements& placements() const { return placements_; }

private:
    // Opens one material file, or all files that the name lists.
    Assimp::IOStream* openMaterials(const QString& name, const std::optional<QByteArray>& whole) {
        QByteArray materials;
        const QByteArray between(8, '\n'); // keeps files above the minimum size that assimp accepts
        bool isThere = false;
        for (const QString& part : whole ? QStringList{name} : materialFileNames(name)) {
            const auto bytes = whole ? whole : find(part.toUtf8().constData());
            if (!bytes) {
                rememberMissing(part);
                continue;
            }
            isThere = true;
            const MaterialFile file = materialFile(*bytes, QFileInfo(part).fileName());
            materials += file.bytes + between;
            fault_ = fault_.isEmpty() ? file.fault : fault_;
            for (const auto& [material, placement] : file.placements) {
                placements_[material] = placement;
            }
            warnings_ += file.warnings;
            warnings_.removeDuplicates(); // a file may be named several times
        }
        return isThere && fault_.isEmpty() ? new FileStream(materials) : nullptr;
    }

    void rememberMissing(const QString& name) {
        const QString missing = QFileInfo(name).fileName();
        // If the name in the model fails, loaders also try the model's own name.
        const bool isSecondTry =
            !missing_.isEmpty() &&
            QFileInfo(missing).completeBaseName() == QFileInfo(source_.path).completeBaseName();
        if (!missing_.contains(missing) && !isSecondTry) {
            missing_.push_back(missing);
        }
    }

    // Cached, because loaders check whether a file exists and then open it.
    std::optional<QByteArray> find(const char* name) const {
        const auto known = found_.find(name);
        return known != found_.end()
                   ? known->second
                   : found_.emplace(name, source_.files.read(QString::fromUtf8(name)))
                         .first->second;
    }

    const ModelSource& source_;
    std::string modelName_;
    QByteArray modelBytes_;
    mutable std::map<std::string, std::optional<QByteArray>> found_;
    QStringList missing_, warnings_;
    PicturePlacements placements_;
    QString fault_;
    // The model file's stream while it is open; a model may name itself as another file.
    Assimp::IOStream* model_ = nullptr;
};

QByteArray bytesForAssimp(const QString& format, const ModelSource& source, QStringList& warnings) {
    if (format == QStringLiteral("stl")) {
        return stlForAssimp(source);
    }
    if (format == QStringLiteral("gltf") || format == QStringLiteral("glb")) {
        return gltfForAssimp(source, warnings);
    }
    if (format == QStringLiteral("dae")) {
        return withTextureSets(source, warnings);
    }
    if (format == QStringLiteral("3ds")) {
        return threeDsForAssimp(source, warnings);
    }
    return format == QStringLiteral("obj") ? objForAssimp(source) : source.bytes;
}

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

// Returns assimp's name for the loader of a format; null if the format is not allowed.
const char* loaderOf(const QString& format) {
    static const std::map<QString, const char*> loaders{
        {QStringLiteral("obj"), "Wavefront Object Importer"},
        {QStringLiteral("stl"), "Stereolithography (STL) Importer"},
        {QStringLiteral("gltf"), "glTF2 Importer"},
        {QStringLiteral("glb"), "glTF2 Importer"},
        {QStringLiteral("dae"), "Collada Importer"},
        {QStringLiteral("fbx"), "Autodesk FBX Importer"},
        {QStringLiteral("3ds"), "Discreet 3DS Importer"}};
    const auto found = loaders.find(format);
    return found == loaders.end() ? nullptr : found->second;
}

void keepOnly(const char* loader, Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        if (qstrcmp(importer.GetImporterInfo(i)->mName, loader) != 0) {
            const std::unique_ptr<Assimp::BaseImporter> unused(importer.GetImporter(i));
            importer.UnregisterLoader(unused.get());
        }
    }
}

// Checks limits before assimp triangulates polygons and before anything recurses through the nodes.
void checkScene(const aiScene& scene, const ModelSource& source) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            requireWithin(Budget::PolygonCorners, mesh.mFaces[f].mNumIndices, source.path);
        }
    }
    std::vector<std::pair<const aiNode*, qint64>> open{{scene.mRootNode, 0}};
    while (!open.empty()) {
        const auto [node, depth] = open.back();
        open.pop_back();
        requireWithin(Budget::Nesting, depth, source.path);
        for (unsigned child = 0; node && child < node->mNumChildren; ++child) {
            open.emplace_back(node->mChildren[child], depth + 1);
        }
    }
}

// Whether a material in use scales or rotates its texture. assimp 5.2.5 does this about the wrong
// point, and forgets the transform. Offsets in 3DS count too: assimp negates only that of u, and
// programs differ on their sign.
bool movesTexture(const aiScene& scene, bool is3ds) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const unsigned index = scene.mMeshes[m]->mMaterialIndex;
        aiUVTransform transform;
        if (index < scene.mNumMaterials &&
            scene.mMaterials[index]->Get(AI_MATKEY_UVTRANSFORM_DIFFUSE(0), transform) ==
                aiReturn_SUCCESS &&
            (transform.mScaling != aiVector2D(1, 1) || transform.mRotation != 0 ||
             (is3ds && transform.mTranslation != aiVector2D(0, 0)))) {
            return true;
        }
    }
    return false;
}

// Whether a texture of an FBX file exchanges u and v, which assimp 5.2.5 ignores. Looks for the
// property as the FBX SDK writes it, in text and in binary files.
bool swapsTexture(const QByteArray& fbx) {
    return fbx.contains(R"("UVSwap", "bool", "", "",1)") ||
           fbx.contains(QByteArray("UVSwapS\4\0\0\0boolS\0\0\0\0S\0\0\0\0I\1\0\0\0", 30));
}

// Returns the number of a property of an FBX file; 0 if there is none. `bytes` begins after the
// property's name. In binary files, texts come before the number: S, their length, and the text.
double fbxNumber(QByteArray bytes) {
    constexpr qsizetype head = 5;
    while (bytes.startsWith('S') && bytes.size() >= head) {
        bytes.remove(0, head + qFromLittleEndian<quint32>(bytes.constData() + 1));
    }
    if (bytes.startsWith('D') && bytes.size() > qsizetype(sizeof(double))) {
        return qFromLittleEndian<double>(bytes.constData() + 1);
    }
    if (bytes.startsWith('F') && bytes.size() > qsizetype(sizeof(float))) {
        return double(qFromLittleEndian<float>(bytes.constData() + 1));
    }
    const QByteArray line = bytes.left(bytes.indexOf('\n'));
    return line.mid(std::max(line.lastIndexOf(':'), line.lastIndexOf(',')) + 1)
        .trimmed()
        .toDouble();
}

// Whether a blend shape of an FBX file moves points. assimp 5.2.5 does not pass on the weights of
// most blend shapes.
bool usesBlendShapes(const QByteArray& fbx) {
    constexpr QByteArrayView name = "DeformPercent";
    constexpr qsizetype longest = 80; // bytes between the name and the number's end
    for (qsizetype at = fbx.indexOf(name, 1); at > 0; at = fbx.indexOf(name, at + 1)) {
        const bool isAnimation = fbx[at - 1] == '|';
        if (!isAnimation && fbxNumber(fbx.mid(at + name.size(), longest)) != 0) {
            return true;
        }
    }
    return false;
}

// Returns SceneMeaning::frame.
Eigen::Matrix3f frameOf(const QString& format, const aiScene& scene, const ModelSource& source) {
    if (format == QStringLiteral("fbx")) {
        return fbxFrame(scene, source);
    }
    // assimp converts Collada, whose files state their unit, to metres.
    return (format == QStringLiteral("dae") ? 1000 : 1) * Eigen::Matrix3f::Identity();
}

} // namespace

TexturedMesh readByAssimp(const QString& format, const ModelSource& source, QStringList& warnings,
                          const Progress& progress) {
    const char* loader = loaderOf(format);
    if (!loader) {
        source.throwDamaged(Text::tr("its format is not supported"));
    }
    const bool isGltf = format.startsWith(QStringLiteral("gl"));
    const Progress readingPart = progress.part(0, 0.8);
    Assimp::Importer importer;
    keepOnly(loader, importer);
    // The name has no folder. From the name assimp finds the loader, and the name of a material
    // file beside the model.
    const std::string name =
        (QFileInfo(source.path).completeBaseName() + u'.' + format).toStdString();
    auto* files = new ModelFileSystem(source, name, bytesForAssimp(format, source, warnings));
    importer.SetIOHandler(files);                                  // takes ownership
    importer.SetProgressHandler(new ReadingProgress(readingPart)); // takes ownership, too
    // Embedded pictures are then named by numbers, not by names that several may have.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_EMBEDDED_TEXTURES_LEGACY_NAMING, true);
    const aiScene* scene = importer.ReadFile(name, 0);
    bool isMisplaced = false; // GltfCheck.h reports this for glTF
    if (scene) {
        checkScene(*scene, source);
        if (format == QStringLiteral("fbx") && source.withTextures) {
            alignFbxTextureSets(*scene, source, warnings);
        }
        isMisplaced = (!isGltf && movesTexture(*scene, format == QStringLiteral("3ds"))) ||
                      (format == QStringLiteral("fbx") && swapsTexture(source.bytes));
        scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_TransformUVCoords);
    }
    progress.cancelToken.throwIfCancelled();
    if (!scene && std::string(importer.GetErrorString()) == std::bad_alloc().what()) {
        throw std::bad_alloc(); // assimp reports it only as text
    }
    if (!files->fault().isEmpty() || !scene) {
        source.throwDamaged(files->fault().isEmpty()
                                ? QString::fromUtf8(importer.GetErrorString()).simplified()
                                : files->fault());
    }
    for (const QString& missing : files->missing()) {
        warnings.push_back(
            Text::tr("The file %1, which the model names, was not found").arg(missing));
    }
    if (source.withTextures) {
        warnings += files->warnings();
    }
    const SceneMeaning meaning{isGltf, files->placements(), frameOf(format, *scene, source),
                               format == QStringLiteral("dae") && hasTextureThatEnds(source.bytes)};
    TexturedMesh model = convertScene(*scene, source, meaning, warnings, progress.part(0.8, 1));
    if (isMisplaced && !model.textures.empty()) {
        warnings.push_back(Text::tr(
            "The model moves, scales or rotates a texture, which is not shown correctly; apply "
            "the transform to the texture coordinates in a modelling program"));
    }
    if (format == QStringLiteral("fbx")) {
        checkFbx(source, warnings);
        if (usesBlendShapes(source.bytes)) {
            warnings.push_back(Text::tr(
                "The model's blend shapes are not applied, so it has its shape without them; "
                "apply them in a modelling program"));
        }
    }
    warnings.removeDuplicates(); // several materials may have the same fault
    return model;
}

} // namespace dipwright

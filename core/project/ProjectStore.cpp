#include "project/ProjectStore.h"

#include "base/Budgets.h"
#include "base/Error.h"
#include "base/InkPicture.h"
#include "base/JsonText.h"
#include "base/Png.h"
#include "base/Sha256.h"
#include "disk/AtomicFile.h"
#include "disk/ZipWriter.h"
#include "import/trusted/ReadPictures.h"
#include "model/StoredModel.h"
#include "project/Project.h"
#include "project/Snapshots.h"
#include "project/ZipReader.h"
#include "settings/Artwork.h"
#include "settings/ProcessSettings.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <QJsonObject>
#include <algorithm>
#include <map>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(ProjectStore)
};

const QString mimeEntry = QStringLiteral("mimetype");
const QByteArray mimeType = QByteArrayLiteral("application/vnd.dipwright.project");
const QString documentEntry = QStringLiteral("project.json");
const QString meshEntry = QStringLiteral("assets/model.dwmodel");

QString textureEntry(std::size_t index) {
    return QStringLiteral("assets/texture-%1.png").arg(index + 1);
}

QString inksEntry(std::size_t index) {
    return QStringLiteral("assets/inks-%1.png").arg(index + 1);
}
const QString cadEntry = QStringLiteral("assets/model.cad");

QString layerEntry(const QString& pictureId) {
    return QStringLiteral("assets/artwork-%1.png").arg(pictureId);
}

QJsonArray textureEntries(const TexturedMesh& model) {
    QJsonArray entries;
    for (std::size_t index = 0; index < model.textures.size(); ++index) {
        entries.append(textureEntry(index));
    }
    return entries;
}

// Returns the entries of the textures' amounts of ink, in the order of the textures; null for
// textures without. Empty if no texture has any.
QJsonArray inksEntries(const TexturedMesh& model) {
    QJsonArray entries;
    for (std::size_t index = 0; index < model.inks.size(); ++index) {
        entries.append(model.inks[index].isNull() ? QJsonValue() : inksEntry(index));
    }
    return entries;
}

// Reports how much of a project's data is packed. The last part of the progress is left for writing
// the file.
class PackingProgress {
public:
    PackingProgress(const Project& project, qint64 meshBytes, const Progress& progress)
        : progress_(progress), total_(meshBytes + project.cad.bytes.size()) {
        const TexturedMesh& model = *project.model;
        for (const std::vector<QImage>* pictures : {&model.textures, &model.inks}) {
            for (const QImage& picture : *pictures) {
                total_ += picture.sizeInBytes();
            }
        }
        for (const ArtworkLayer& layer : project.artwork.layers) {
            total_ += layer.picture.image.sizeInBytes();
        }
        for (const auto& [name, contents] : project.unknownEntries) {
            total_ += contents.size();
        }
    }

    void add(qint64 bytes) {
        constexpr double packingShare = 0.9;
        packed_ = std::min(packed_ + bytes, total_);
        progress_(packingShare * double(packed_) / double(total_), Text::tr("Saving the project"));
    }

private:
    const Progress& progress_;
    qint64 total_ = 0, packed_ = 0;
};

// Writes each picture of a project into its file once. Throws Error if there are too many to be
// read again.
class SavedPictures {
public:
    SavedPictures(ZipWriter& archive, PackingProgress& progress)
        : archive_(archive), progress_(progress) {}

    void add(const QString& entry, const QImage& picture) {
        const auto [size, isNew] = sizes_.try_emplace(entry, 0);
        if (isNew) {
            const QByteArray bytes = pngBytes(picture, entry);
            archive_.add(entry, bytes, ZipWriter::Packing::Stored);
            size->second = bytes.size();
        }
        progress_.add(picture.sizeInBytes());
        count_.add(picture, size->second, entry);
    }
    bool contains(const QString& entry) const { return sizes_.contains(entry); }

private:
    ZipWriter& archive_;
    PackingProgress& progress_;
    std::map<QString, qint64> sizes_; // bytes of the pictures written so far, by entry
    PictureCount count_;
};

void requireModestModel(const TexturedMesh& model, const QString& path) {
    requireWithin(Budget::NamedFiles, qint64(model.textures.size()), path);
    requireWithin(Budget::Materials, qint64(model.materials.size()), path);
}

// Refuses a project that could not be opened again, so that it does not replace one that can.
void requireOpenable(const TexturedMesh& model, const ZipWriter& archive,
                     const QByteArray& document, const QByteArray& packed, const QString& path) {
    try {
        requireModestModel(model, path);
        requireJsonWithinLimits(document, path);
        requireWithin(Budget::DocumentBytes, document.size(), path);
        requireWithin(Budget::UnpackedBytes, archive.unpackedBytes(), path, packed.size());
    } catch (const Error& error) {
        throw Error(
            Text::tr("The project was not saved, because its file would be refused when opened: %1")
                .arg(error.message()),
            path);
    }
}

QByteArray projectBytes(const Project& project, const QString& path, const Progress& progress) {
    const QByteArray mesh = writeModel(withoutPictures(*project.model));
    QJsonObject json = toJson(project);
    QJsonObject model = json.value(QLatin1String("model")).toObject();
    const QJsonArray textures = textureEntries(*project.model);
    model.insert(QStringLiteral("mesh"), meshEntry);
    model.insert(QStringLiteral("texture"), textures.isEmpty() ? QJsonValue() : textures.first());
    model.insert(QStringLiteral("textures"), textures);
    if (const QJsonArray inks = inksEntries(*project.model); !inks.isEmpty()) {
        model.insert(QStringLiteral("inks"), inks);
    }
    model.insert(QStringLiteral("sha256"), sha256Hex(mesh));
    json.insert(QStringLiteral("model"), model);

    ZipWriter archive;
    archive.add(mimeEntry, mimeType, ZipWriter::Packing::Stored);
    const QByteArray document = QJsonDocument(json).toJson();
    archive.add(documentEntry, document, ZipWriter::Packing::Deflated);
    PackingProgress packing(project, mesh.size(), progress);
    const auto packed = [&packing](qint64 bytes) { packing.add(bytes); };
    archive.add(meshEntry, mesh, ZipWriter::Packing::Deflated, packed);
    SavedPictures pictures(archive, packing);
    for (std::size_t index = 0; index < project.model->textures.size(); ++index) {
        pictures.add(textureEntry(index), project.model->textures[index]);
    }
    for (std::size_t index = 0; index < project.model->inks.size(); ++index) {
        if (!project.model->inks[index].isNull()) {
            pictures.add(inksEntry(index), project.model->inks[index]);
        }
    }
    for (const ArtworkLayer& layer : project.artwork.layers) {
        if (!layer.picture.image.isNull()) {
            pictures.add(layerEntry(layer.picture.id), layer.picture.image);
        }
    }
    QSet<QString> own{mimeEntry, documentEntry, meshEntry};
    if (!project.cad.bytes.isEmpty()) {
        archive.add(cadEntry, project.cad.bytes, ZipWriter::Packing::Deflated, packed);
        own.insert(cadEntry);
    }
    for (const auto& [name, contents] : project.unknownEntries) {
        if (!own.contains(name) && !pictures.contains(name)) {
            archive.add(name, contents, ZipWriter::Packing::Deflated, packed);
        }
    }
    QByteArray bytes = archive.finish();
    requireOpenable(*project.model, archive, document, bytes, path);
    return bytes;
}

QJsonObject readDocument(ZipReader& archive, const QString& path) {
    if (!archive.contains(documentEntry)) {
        throw Error(Text::tr("This is not a Dipwright project: it has no project.json"), path);
    }
    const QByteArray bytes = archive.read(documentEntry);
    requireWithin(Budget::DocumentBytes, bytes.size(), path);
    requireJsonWithinLimits(bytes, path);
    QJsonParseError error;
    const auto document = QJsonDocument::fromJson(bytes, &error);
    if (document.isArray()) {
        throw Error(Text::tr("project.json contains a list instead of a project"), path);
    }
    if (!document.isObject()) {
        throw Error(Text::tr("project.json is damaged at character %1: %2")
                        .arg(error.offset)
                        .arg(error.errorString()),
                    path);
    }
    if (const QString key = repeatedKey(bytes); !key.isEmpty()) {
        throw Error(Text::tr("project.json holds the key %1 twice; remove one of them").arg(key),
                    path);
    }
    return document.object();
}

// "texture" holds the first texture; "textures" holds all textures of a model with several.
QJsonArray textureNames(const QJsonObject& model) {
    QJsonArray names = model.value(QLatin1String("textures")).toArray();
    const QJsonValue first = model.value(QLatin1String("texture"));
    if (first.isString()) {
        if (names.isEmpty()) {
            names.append(first);
        } else {
            names.replace(0, first);
        }
    }
    return names;
}

// Returns the names of the entries with amounts of ink, in the order of the textures; empty names
// for textures without.
QStringList inksNames(const QJsonObject& model) {
    QStringList names;
    for (const QJsonValue& name : model.value(QLatin1String("inks")).toArray()) {
        names.append(name.toString());
    }
    return names;
}

// Unpacks each entry only once, even if several textures share it.
std::vector<PackedPicture> packedPictures(ZipReader& archive, const QJsonArray& names,
                                          const QString& path) {
    std::map<QString, QByteArray> unpacked;
    std::vector<PackedPicture> pictures;
    for (const auto& entry : names) {
        const QString name = entry.toString();
        if (!unpacked.contains(name)) {
            unpacked.emplace(name, archive.read(name));
        }
        pictures.push_back({unpacked.at(name), Text::tr("%1 in %2").arg(name, path)});
    }
    return pictures;
}

// Reads the mesh. Its textures are null pictures, one for each texture that `entries` names.
TexturedMesh readMesh(ZipReader& archive, const QJsonObject& entries, const QString& path) {
    const QString meshName = entries.value(QLatin1String("mesh")).toString();
    if (meshName.isEmpty()) {
        throw Error(Text::tr("The project names no model: model.mesh is missing"), path);
    }
    const QByteArray mesh = archive.read(meshName);
    if (entries.value(QLatin1String("sha256")).toString() != sha256Hex(mesh)) {
        throw Error(Text::tr("The model in the project was changed after saving: its sha256 "
                             "differs"),
                    path);
    }
    StoredModel stored = readModel(mesh, path);
    const QJsonArray textures = textureNames(entries);
    if (std::size_t(textures.size()) != stored.pictures.size()) {
        throw Error(Text::tr("The project lists %1 textures, but its model needs %2")
                        .arg(textures.size())
                        .arg(stored.pictures.size()),
                    path);
    }
    stored.model.textures.resize(stored.pictures.size());
    requireModestModel(stored.model, path);
    return std::move(stored.model);
}

// Reads the model, its textures and the pictures of the artwork's layers. All pictures are read
// together, because one budget limits them all.
void readAssets(ZipReader& archive, const QJsonObject& json, Project& project,
                const QString& path) {
    const QJsonObject entries = json.value(QLatin1String("model")).toObject();
    TexturedMesh model = readMesh(archive, entries, path);
    QJsonArray names = textureNames(entries);
    for (const ArtworkLayer& layer : project.artwork.layers) {
        if (!layer.picture.id.isEmpty()) {
            names.append(layerEntry(layer.picture.id));
        }
    }
    const QStringList inks = inksNames(entries).mid(0, qsizetype(model.textures.size()));
    for (const QString& name : inks) {
        if (!name.isEmpty()) {
            names.append(name);
        }
    }
    const std::vector<QImage> pictures = readPictures(packedPictures(archive, names, path));
    auto picture = pictures.begin();
    for (QImage& texture : model.textures) {
        texture = *picture++;
    }
    for (ArtworkLayer& layer : project.artwork.layers) {
        if (!layer.picture.id.isEmpty()) {
            layer.picture = artworkPicture(*picture++);
        }
    }
    for (const QString& name : inks) {
        const QImage read = name.isEmpty() ? QImage() : *picture++;
        const bool fits =
            !inkSpace(read).isEmpty() && read.size() == model.textures[model.inks.size()].size();
        model.inks.push_back(fits ? read : QImage());
    }
    model.inks.resize(inks.isEmpty() ? 0 : model.textures.size());
    project.model = std::make_shared<TexturedMesh>(std::move(model));
    if (!project.cad.name.isEmpty()) {
        project.cad.bytes = archive.read(cadEntry);
    }
}

// Reads all entries except the document and the assets that it names.
std::map<QString, QByteArray> readOthers(ZipReader& archive, const QJsonObject& json,
                                         const QStringList& layers, const QString& path) {
    const QJsonObject model = json.value(QLatin1String("model")).toObject();
    QSet<QString> others = archive.names();
    others -= {mimeEntry, documentEntry, model.value(QLatin1String("mesh")).toString()};
    for (const auto& texture : textureNames(model)) {
        others.remove(texture.toString());
    }
    for (const QString& named : layers + inksNames(model)) {
        others.remove(named);
    }
    if (!model.value(QLatin1String("cad_file")).toString().isEmpty()) {
        others.remove(cadEntry);
    }
    std::map<QString, QByteArray> entries;
    qint64 total = 0;
    for (const QString& name : others) {
        if (!name.endsWith(QLatin1Char('/'))) { // skip folders
            total += entries.emplace(name, archive.read(name)).first->second.size();
            requireWithin(Budget::OtherBytes, total, path);
        }
    }
    return entries;
}

} // namespace

Project loadProject(const QString& path) {
    ZipReader archive(path);
    const QJsonObject json = readDocument(archive, path);
    Project project = fromJson(json, path);
    QStringList layers; // entries by the picture ids in the file
    for (const ArtworkLayer& layer : project.artwork.layers) {
        layers.append(layerEntry(layer.picture.id));
    }
    readAssets(archive, json, project, path);
    project.unknownEntries = readOthers(archive, json, layers, path);
    return project;
}

QString solverOfProject(const QString& path) {
    ZipReader archive(path);
    const QJsonValue process = readDocument(archive, path).value(QLatin1String("process"));
    return process[QLatin1String("solver")].toString(ProcessSettings().solver);
}

FileVersion saveProject(const Project& project, const QString& path,
                        const std::function<void()>& beforeReplacing, const Progress& progress) {
    const QByteArray bytes = projectBytes(withinSnapshotLimits(project), path, progress);
    const QString failure = replaceFile(path, bytes, [&] {
        progress.cancelToken.throwIfCancelled();
        if (beforeReplacing) {
            beforeReplacing();
        }
    });
    if (!failure.isEmpty()) {
        throw Error(Text::tr("The project cannot be saved: %1").arg(failure), path);
    }
    return FileVersion::ofBytes(bytes);
}

} // namespace dipwright

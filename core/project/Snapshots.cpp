#include "project/Snapshots.h"

#include "base/Error.h"
#include "base/JsonText.h"
#include "base/Png.h"
#include "import/trusted/ReadPictures.h"
#include "project/Project.h"
#include "settings/Artwork.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <QJsonObject>
#include <algorithm>
#include <map>
#include <set>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Snapshots)
};

const QString folder = QStringLiteral("snapshots/");
const QString endOfFolder = QStringLiteral("snapshots0"); // sorts right after the folder's names
const QString artworkKey = QStringLiteral("artwork");
constexpr int longestName = 200;
constexpr qint64 mostBytes = 64 << 20; // of all snapshots; well below Budget::OtherBytes

// Returns the name of a snapshot's entry. Sorted by name, snapshots are in the order of their
// numbers, and the pictures follow them.
QString entryName(std::size_t number) {
    return folder + QStringLiteral("%1.json").arg(number, 4, 10, QLatin1Char('0'));
}

QByteArray bytesOf(const Snapshot& snapshot) {
    return QJsonDocument(QJsonObject{{QStringLiteral("name"), snapshot.name},
                                     {QStringLiteral("taken"), snapshot.taken},
                                     {QStringLiteral("state"), snapshot.state},
                                     {QStringLiteral("measures"), snapshot.measures}})
        .toJson();
}

// Returns an empty object if the entry is not a snapshot. Real snapshots are far below the limits
// for JSON.
QJsonObject jsonOf(const QByteArray& entry) {
    try {
        requireJsonWithinLimits(entry, {});
        return QJsonDocument::fromJson(entry).object();
    } catch (const Error&) {
        return {};
    }
}

QString pictureEntry(const QString& id) {
    return folder + QStringLiteral("artwork-%1.png").arg(id);
}

std::set<QString> picturesOf(const Snapshot& snapshot) {
    std::set<QString> ids;
    const QJsonObject artwork = snapshot.state.value(artworkKey).toObject();
    for (const QJsonValue& layer : artwork.value(QLatin1String("layers")).toArray()) {
        ids.insert(layer[QLatin1String("picture")].toString());
    }
    ids.erase(QString());
    return ids;
}

// Returns a snapshot's picture; empty if neither the project's snapshots nor its artwork have it.
QByteArray pictureBytes(const Project& project, const QString& id) {
    const QString entry = pictureEntry(id);
    if (const auto kept = project.unknownEntries.find(entry);
        kept != project.unknownEntries.end()) {
        return kept->second;
    }
    for (const ArtworkLayer& layer : project.artwork.layers) {
        if (layer.picture.id == id && !layer.picture.image.isNull()) {
            return pngBytes(layer.picture.image, entry);
        }
    }
    return {};
}

// Fills in the pictures of layers that only have ids. Pictures are read together, because one
// budget limits them all.
void findPictures(Artwork& artwork, const Project& project, const QString& snapshot) {
    std::map<QString, ArtworkPicture> found{{QString(), {}}};
    for (const ArtworkLayer& layer : project.artwork.layers) {
        found.emplace(layer.picture.id, layer.picture);
    }
    std::vector<PackedPicture> packed;
    std::vector<ArtworkLayer*> toRead;
    for (ArtworkLayer& layer : artwork.layers) {
        const QString id = layer.picture.id;
        if (const auto known = found.find(id); known != found.end()) {
            layer.picture = known->second;
            continue;
        }
        const QByteArray bytes = pictureBytes(project, id);
        if (bytes.isEmpty()) {
            throw Error(Text::tr("The picture of layer “%1” is no longer in the project's file")
                            .arg(layer.name),
                        snapshot);
        }
        packed.push_back({bytes, pictureEntry(id)});
        toRead.push_back(&layer);
    }
    const std::vector<QImage> pictures = readPictures(packed);
    for (std::size_t i = 0; i < toRead.size(); ++i) {
        const auto [read, isNew] = found.try_emplace(toRead[i]->picture.id);
        if (isNew) {
            read->second = artworkPicture(pictures[i]);
        }
        toRead[i]->picture = read->second;
    }
}

} // namespace

std::vector<Snapshot> snapshots(const Project& project) {
    std::vector<Snapshot> found; // the newest first
    for (auto entry = project.unknownEntries.lower_bound(endOfFolder);
         entry != project.unknownEntries.begin() && found.size() < mostSnapshots;) {
        --entry;
        if (!entry->first.startsWith(folder)) {
            break;
        }
        const QJsonObject json = jsonOf(entry->second);
        const QJsonObject state = json.value(QLatin1String("state")).toObject();
        if (!state.isEmpty()) {
            const auto line = [&json](const char* key) {
                return json.value(QLatin1String(key)).toString().left(longestName).simplified();
            };
            found.push_back({line("name"), line("taken"), state,
                             json.value(QLatin1String("measures")).toObject()});
        }
    }
    std::reverse(found.begin(), found.end());
    return found;
}

Project withinSnapshotLimits(Project project) {
    std::size_t count = 0;
    qint64 total = 0;
    for (auto entry = project.unknownEntries.lower_bound(folder);
         entry != project.unknownEntries.end() && entry->first.startsWith(folder); ++entry) {
        count += entry->first.endsWith(QLatin1String(".json")) ? 1 : 0;
        total += entry->second.size();
    }
    if (count <= mostSnapshots && total <= mostBytes) {
        return project;
    }
    const std::vector<Snapshot> kept = snapshots(project);
    return withSnapshots(std::move(project), kept);
}

Project withSnapshots(Project project, const std::vector<Snapshot>& kept) {
    std::vector<QByteArray> entries; // the newest first
    std::map<QString, QByteArray> pictures;
    qint64 total = 0;
    for (auto snapshot = kept.rbegin(); snapshot != kept.rend(); ++snapshot) {
        std::map<QString, QByteArray> more = pictures;
        const QByteArray bytes = bytesOf(*snapshot);
        total += bytes.size();
        for (const QString& id : picturesOf(*snapshot)) {
            if (!more.contains(id)) {
                total += more.emplace(id, pictureBytes(project, id)).first->second.size();
            }
        }
        if (entries.size() == mostSnapshots || total > mostBytes) {
            break;
        }
        entries.push_back(bytes);
        pictures = std::move(more);
    }
    std::erase_if(project.unknownEntries,
                  [](const auto& entry) { return entry.first.startsWith(folder); });
    for (std::size_t number = 0; number < entries.size(); ++number) {
        project.unknownEntries.emplace(entryName(number + 1), entries[entries.size() - 1 - number]);
    }
    for (const auto& [id, bytes] : pictures) {
        if (!bytes.isEmpty()) {
            project.unknownEntries.emplace(pictureEntry(id), bytes);
        }
    }
    return project;
}

Snapshot snapshotOf(const Project& project, const QString& name, const QString& taken,
                    const QJsonObject& measures) {
    Project settings = project;
    settings.asBuilt.parts.clear();
    settings.asBuilt.places.clear();
    settings.asBuilt.times.clear();
    settings.inspection = {};
    settings.filmOnWater = {};
    QJsonObject state = toJson(settings);
    if (!state.contains(artworkKey)) {
        state.insert(artworkKey, QJsonObject()); // records that there was no artwork
    }
    return {name.left(longestName).simplified(), taken, state, measures};
}

Project atSnapshot(const Project& project, const Snapshot& snapshot) {
    Project then = fromJson(snapshot.state, snapshot.name);
    then.model = project.model;
    then.modelOrigin = project.modelOrigin;
    then.cad = project.cad;
    if (snapshot.state.contains(artworkKey)) {
        findPictures(then.artwork, project, snapshot.name);
    } else {
        then.artwork = project.artwork;
    }
    then.asBuilt.parts = project.asBuilt.parts;
    then.asBuilt.places = project.asBuilt.places;
    then.asBuilt.times = project.asBuilt.times;
    then.inspection = project.inspection;
    then.filmOnWater = project.filmOnWater;
    then.unknown = project.unknown;
    then.unknownEntries = project.unknownEntries;
    return then;
}

} // namespace dipwright

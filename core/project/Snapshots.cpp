#include "project/Snapshots.h"

#include <QJsonDocument>

namespace dipwright {
namespace {

const QString folder = QStringLiteral("snapshots/");
constexpr int longestName = 200;
constexpr qint64 mostBytes = 64 << 20; // of all, well below what a project may hold beside its own

// Sorted as they are numbered.
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

} // namespace

std::vector<Snapshot> snapshots(const Project& project) {
    std::vector<Snapshot> found;
    for (auto entry = project.unknownEntries.lower_bound(folder);
         entry != project.unknownEntries.end() && entry->first.startsWith(folder) &&
         found.size() < mostSnapshots;
         ++entry) {
        const QJsonObject json = QJsonDocument::fromJson(entry->second).object();
        const QJsonObject state = json.value(QLatin1String("state")).toObject();
        if (!state.isEmpty()) {
            const auto line = [&json](const char* key) {
                return json.value(QLatin1String(key)).toString().left(longestName).simplified();
            };
            found.push_back({line("name"), line("taken"), state,
                             json.value(QLatin1String("measures")).toObject()});
        }
    }
    return found;
}

Project withSnapshots(Project project, const std::vector<Snapshot>& kept) {
    std::erase_if(project.unknownEntries,
                  [](const auto& entry) { return entry.first.startsWith(folder); });
    std::vector<QByteArray> entries; // the newest first
    qint64 total = 0;
    for (auto snapshot = kept.rbegin(); snapshot != kept.rend(); ++snapshot) {
        entries.push_back(bytesOf(*snapshot));
        total += entries.back().size();
        if (entries.size() > mostSnapshots || total > mostBytes) {
            entries.pop_back();
            break;
        }
    }
    for (std::size_t number = 0; number < entries.size(); ++number) {
        project.unknownEntries.emplace(entryName(number + 1), entries[entries.size() - 1 - number]);
    }
    return project;
}

Snapshot snapshotOf(const Project& project, const QString& name, const QString& taken,
                    const QJsonObject& measures) {
    Project settings = project;
    settings.artwork = {};
    settings.asBuilt.parts.clear();
    settings.asBuilt.places.clear();
    settings.inspection = {};
    settings.filmOnWater = {};
    return {name.left(longestName).simplified(), taken, toJson(settings), measures};
}

Project atSnapshot(const Project& project, const Snapshot& snapshot) {
    Project then = fromJson(snapshot.state, snapshot.name);
    then.model = project.model;
    then.modelOrigin = project.modelOrigin;
    then.artwork = project.artwork;
    then.asBuilt.parts = project.asBuilt.parts;
    then.asBuilt.places = project.asBuilt.places;
    then.inspection = project.inspection;
    then.filmOnWater = project.filmOnWater;
    then.unknown = project.unknown;
    then.unknownEntries = project.unknownEntries;
    return then;
}

} // namespace dipwright

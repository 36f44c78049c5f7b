// Keeps named states of a project in its file beside project.json, as entries snapshots/N.json.
//
// A snapshot holds the settings and the artwork. Each picture is stored once beside the snapshots
// as snapshots/artwork-ID.png. Restoring a snapshot does not change the model, the measurements
// (parts as built, photos) or the snapshots.
#pragma once

#include <QJsonObject>
#include <QString>
#include <vector>

namespace dipwright {

struct Project;

// One snapshot.
struct Snapshot {
    QString name;
    QString taken;        // ISO date and time, local
    QJsonObject state;    // as in project.json
    QJsonObject measures; // numbers of the result at that time, by name; empty: no result
    bool operator==(const Snapshot&) const = default;
};

inline constexpr std::size_t mostSnapshots = 50;

// Returns the newest mostSnapshots snapshots, the oldest first. Skips entries that are not
// snapshots.
std::vector<Snapshot> snapshots(const Project& project);
// Replaces the project's snapshots. Drops the oldest ones if there are more than mostSnapshots, or
// more than 64 MiB with their pictures. Pictures come from the present snapshots and the project's
// artwork.
Project withSnapshots(Project project, const std::vector<Snapshot>& kept);
// Drops the project's oldest snapshots as withSnapshots() does.
Project withinSnapshotLimits(Project project);
// Takes a snapshot of the project's present state.
Snapshot snapshotOf(const Project& project, const QString& name, const QString& taken,
                    const QJsonObject& measures);
// Restores a snapshot. Old snapshots contain no artwork; restoring one leaves the artwork
// unchanged. Throws Error if a value is out of range or a picture is missing.
Project atSnapshot(const Project& project, const Snapshot& snapshot);

} // namespace dipwright

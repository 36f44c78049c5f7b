// Named states of a project, kept in its file beside project.json: entries snapshots/N.json.
//
// A snapshot has the settings and the artwork, whose pictures lie beside the snapshots as
// snapshots/artwork-ID.png, each once. What was found out since (parts as built, photos), the model
// and the snapshots themselves are the project's and stay as they are when it goes back to one.
#pragma once

#include <QJsonObject>
#include <QString>
#include <vector>

namespace dipwright {

struct Project;

struct Snapshot {
    QString name;
    QString taken;        // ISO date and time, local
    QJsonObject state;    // as project.json
    QJsonObject measures; // of the result that fitted then: numbers by name; empty: there was none
    bool operator==(const Snapshot&) const = default;
};

inline constexpr std::size_t mostSnapshots = 50;

// The newest mostSnapshots of them, the oldest first. Entries that are no snapshots are passed
// over.
std::vector<Snapshot> snapshots(const Project& project);
// The project with these, in place of those it has; where they are more than mostSnapshots, or
// than 64 MiB with their pictures, without the oldest. Pictures come from those snapshots and from
// the project's artwork.
Project withSnapshots(Project project, const std::vector<Snapshot>& kept);
// The project as it is, or, where it has more snapshots than that, without the oldest.
Project withinSnapshotLimits(Project project);
// Of the project as it is.
Snapshot snapshotOf(const Project& project, const QString& name, const QString& taken,
                    const QJsonObject& measures);
// The project as it was, as far as a snapshot has it; snapshots from before they had artwork leave
// that as it is. Throws Error where its values are out of range or a picture is not there.
Project atSnapshot(const Project& project, const Snapshot& snapshot);

} // namespace dipwright

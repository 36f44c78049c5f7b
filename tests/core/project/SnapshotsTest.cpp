// Named states of a project, as they are kept in its file.
#include "project/Snapshots.h"

#include "SampleProject.h"
#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

Snapshot named(const Project& project, const QString& name) {
    return snapshotOf(project, name, QStringLiteral("2026-01-02T03:04:05"), {{"painted", 0.5}});
}

} // namespace

class SnapshotsTest : public QObject {
    Q_OBJECT

private slots:
    void theyComeBackFromTheFile() {
        Project project = test::sampleProject();
        const std::vector<Snapshot> kept{named(project, "before"), named(project, "after")};
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        saveProject(withSnapshots(project, kept), path);
        QVERIFY(snapshots(loadProject(path)) == kept);
    }

    void theProjectGoesBackToItsSettings() {
        const Project before = test::sampleProject();
        const Snapshot snapshot = named(before, "before");
        Project project = withSnapshots(before, {snapshot});
        project.film.width = project.film.width + Millimetres(10);
        project.immersions.pop_back();
        const Project back = atSnapshot(project, snapshot);
        QCOMPARE(back.film.width.value(), before.film.width.value());
        QVERIFY(back.immersions == before.immersions);
        QVERIFY(back.model == before.model);
        QVERIFY(snapshots(back) == std::vector{snapshot}); // they are the project's
    }

    void theOldestGoWhereThereAreTooMany() {
        const Project project = test::sampleProject();
        std::vector<Snapshot> many;
        for (std::size_t number = 0; number < mostSnapshots + 2; ++number) {
            many.push_back(named(project, QString::number(number)));
        }
        const std::vector<Snapshot> kept = snapshots(withSnapshots(project, many));
        QCOMPARE(kept.size(), mostSnapshots);
        QCOMPARE(kept.front().name, QStringLiteral("2"));
        QCOMPARE(kept.back().name, many.back().name);
    }

    void whatIsDamagedIsPassedOver() {
        Project project = test::sampleProject();
        project = withSnapshots(project, {named(project, "whole")});
        for (const char* bytes : {"", "no JSON", "[]", "{}", "{\"state\": 3}", "{\"state\": {}}"}) {
            project.unknownEntries[QStringLiteral("snapshots/0000.json")] = bytes;
            const std::vector<Snapshot> found = snapshots(project);
            QCOMPARE(found.size(), 1U);
            QCOMPARE(found.front().name, QStringLiteral("whole"));
        }
    }

    void valuesOutOfRangeAreRefused() {
        const Project project = test::sampleProject();
        Snapshot snapshot = named(project, "strange");
        QJsonObject film = snapshot.state["film"].toObject();
        film["size_mm"] = QJsonArray{-5, 1e300};
        snapshot.state["film"] = film;
        QVERIFY_EXCEPTION_THROWN(atSnapshot(project, snapshot), Error);
    }
};

QTEST_GUILESS_MAIN(SnapshotsTest)
#include "SnapshotsTest.moc"

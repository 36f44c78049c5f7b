// Named states of a project in its file.
#include "project/Snapshots.h"
#include "artwork/EditArtwork.h"

#include "SampleProject.h"
#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QBuffer>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>

using namespace dipwright;

namespace {

Snapshot named(const Project& project, const QString& name) {
    return snapshotOf(project, name, QStringLiteral("2026-01-02T03:04:05"), {{"painted", 0.5}});
}

ArtworkLayer layer(const QColor& colour) {
    QImage image(8, 6, QImage::Format_RGBA8888);
    image.fill(colour);
    ArtworkLayer made = newLayer(LayerKind::Picture, colour.name());
    made.picture = artworkPicture(image);
    return made;
}

} // namespace

class SnapshotsTest : public QObject {
    Q_OBJECT

private slots:
    void snapshots_savedProject_areReadAgain() {
        Project project = test::sampleProject();
        const std::vector<Snapshot> kept{named(project, "before"), named(project, "after")};
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        saveProject(withSnapshots(project, kept), path);
        QVERIFY(snapshots(loadProject(path)) == kept);
    }

    void atSnapshot_restoresTheSettings() {
        const Project before = test::sampleProject();
        const Snapshot snapshot = named(before, "before");
        Project project = withSnapshots(before, {snapshot});
        project.film.width = project.film.width + Millimetres(10);
        project.immersions.pop_back();
        const Project back = atSnapshot(project, snapshot);
        QCOMPARE(back.film.width.value(), before.film.width.value());
        QVERIFY(back.immersions == before.immersions);
        QVERIFY(back.model == before.model);
        QVERIFY(snapshots(back) ==
                std::vector{snapshot}); // snapshots belong to the project, not to its state
    }

    void atSnapshot_restoresArtworkAndPictures() {
        Project before = test::sampleProject();
        before.artwork.base = Qt::white;
        before.artwork.layers = {layer(Qt::red), layer(Qt::blue)};
        const Snapshot snapshot = named(before, "before");
        Project project = withSnapshots(before, {snapshot});
        // No layer shows the two earlier pictures any more.
        project.artwork.layers = {layer(Qt::green)};
        project = withSnapshots(project, {snapshot, named(project, "after")});
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("job.dipw"));
        saveProject(project, path);
        const Project read = loadProject(path);
        const Project back = atSnapshot(read, snapshots(read).front());
        QVERIFY(back.artwork == before.artwork);
        QCOMPARE(back.artwork.layers[1].picture.image, before.artwork.layers[1].picture.image);
        QVERIFY(atSnapshot(back, snapshots(back).back()).artwork == project.artwork);

        // Snapshots of a body without artwork, and from before snapshots contained artwork.
        before.artwork = {};
        Snapshot bare = named(before, "bare");
        QVERIFY(atSnapshot(project, bare).artwork.isEmpty());
        bare.state.remove(QStringLiteral("artwork"));
        QVERIFY(atSnapshot(project, bare).artwork == project.artwork);

        // A file that has lost a snapshot's picture.
        Project without = read;
        std::erase_if(without.unknownEntries, [](const auto& entry) {
            return entry.first.startsWith(QLatin1String("snapshots/artwork-"));
        });
        QVERIFY_EXCEPTION_THROWN(atSnapshot(without, snapshot), Error);
    }

    void withSnapshots_pictures_countTowardsTheSizeLimit() {
        Project project = test::sampleProject();
        std::vector<Snapshot> many;
        std::mt19937 random(1);
        // Each picture has about 36 MB and cannot be compressed.
        for (int number = 0; number < 3; ++number) {
            QImage image(3000, 3000, QImage::Format_RGBA8888);
            for (int row = 0; row < image.height(); ++row) {
                auto* words = reinterpret_cast<std::uint32_t*>(image.scanLine(row));
                std::generate(words, words + image.width(), std::ref(random));
            }
            ArtworkLayer layer = newLayer(LayerKind::Picture, QString::number(number));
            layer.picture = artworkPicture(image);
            project.artwork.layers = {layer};
            many.push_back(named(project, QString::number(number)));
            project = withSnapshots(project, many);
        }
        QCOMPARE(snapshots(project).size(), 1U);
        QCOMPARE(snapshots(project).front().name, QStringLiteral("2"));
        QVERIFY(atSnapshot(project, snapshots(project).front()).artwork == project.artwork);
    }

    void atSnapshot_pixelLimit_countsAllPicturesTogether() {
        Project project = test::sampleProject();
        project.artwork.layers = {layer(Qt::red), layer(Qt::blue)};
        const Snapshot snapshot = named(project, "before");
        project = withSnapshots(project, {snapshot});
        project.artwork.layers.clear();
        QByteArray large; // the pixel limit allows one of them
        QBuffer buffer(&large);
        QImage picture(6000, 6000, QImage::Format_Mono);
        picture.fill(1);
        QVERIFY(picture.save(&buffer, "PNG"));
        int replaced = 0;
        for (auto& [name, bytes] : project.unknownEntries) {
            if (name.endsWith(QLatin1String(".png"))) {
                QCOMPARE(atSnapshot(project, snapshot).artwork.layers.size(), std::size_t(2));
                bytes = large;
                ++replaced;
            }
        }
        QCOMPARE(replaced, 2);
        QVERIFY_EXCEPTION_THROWN(atSnapshot(project, snapshot), Error);
    }

    void withSnapshots_tooMany_removesTheOldest() {
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

    // The file holds more snapshots than the limit, as another program may write.
    void saveProject_tooManySnapshots_removesTheOldest() {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("many.dipw"));
        Project project = test::sampleProject();
        const Project one = withSnapshots(project, {named(project, "some")});
        const QByteArray bytes = one.unknownEntries.begin()->second;
        for (int number = 1; number <= 200; ++number) {
            const QString digits = QString::number(number);
            project.unknownEntries[QStringLiteral("snapshots/%1.json").arg(digits, 4, u'0')] =
                QByteArray(bytes).replace("\"some\"", '"' + digits.toLatin1() + '"');
        }
        QCOMPARE(snapshots(project).back().name, QStringLiteral("200"));
        saveProject(project, path);
        const Project read = loadProject(path);
        QCOMPARE(std::count_if(read.unknownEntries.begin(), read.unknownEntries.end(),
                               [](const auto& entry) {
                                   return entry.first.startsWith(QLatin1String("snapshots/"));
                               }),
                 std::ptrdiff_t(mostSnapshots));
        QCOMPARE(snapshots(read).front().name, QStringLiteral("151"));
        QCOMPARE(snapshots(read).back().name, QStringLiteral("200"));
    }

    void snapshots_damaged_areSkipped() {
        Project project = test::sampleProject();
        project = withSnapshots(project, {named(project, "whole")});
        for (const char* bytes : {"", "no JSON", "[]", "{}", "{\"state\": 3}", "{\"state\": {}}"}) {
            project.unknownEntries[QStringLiteral("snapshots/0000.json")] = bytes;
            const std::vector<Snapshot> found = snapshots(project);
            QCOMPARE(found.size(), 1U);
            QCOMPARE(found.front().name, QStringLiteral("whole"));
        }
    }

    void atSnapshot_valuesOutOfRange_areRefused() {
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

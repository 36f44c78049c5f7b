// Runs one pose search in several processes, as an array job of a cluster does. One process is
// killed and started again.

#include "CliProcess.h"
#include "TestFolders.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

class ShardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        for (const char* name : {"single.dipw", "parts.dipw"}) {
            QVERIFY(QFile::copy(sampleFolder("/tetrahedron.dipw"), path(QLatin1String(name))));
            QVERIFY(QFile::setPermissions(path(QLatin1String(name)),
                                          QFile::ReadOwner | QFile::WriteOwner));
        }
    }

    void optimizeMerge_shardsOfTwoProcesses_equalsSingleRun() {
        const Outcome single = cli(search(QStringLiteral("single.dipw")));
        QVERIFY2(single.exitCode == 0, single.err);
        QProcess killed;
        killed.start(cliPath(), shard(1));
        QVERIFY(killed.waitForStarted());
        QTest::qWait(100);
        killed.kill();
        QVERIFY(killed.waitForFinished());
        QVERIFY2(!QFile::exists(path(QStringLiteral("part1"))),
                 "the killed process left an incomplete part1");
        QProcess first, second;
        first.start(cliPath(), shard(1));
        second.start(cliPath(), shard(2));
        QVERIFY(first.waitForFinished(-1) && second.waitForFinished(-1));
        QVERIFY2(first.exitCode() == 0, first.readAllStandardError());
        QVERIFY2(second.exitCode() == 0, second.readAllStandardError());
        const Outcome merged =
            cli(search(QStringLiteral("parts.dipw")) << "--merge" << path(QStringLiteral("part2"))
                                                     << "--merge" << path(QStringLiteral("part1")));
        QVERIFY2(merged.exitCode == 0, merged.err);
        QCOMPARE(merged.out, single.out);
        QCOMPARE(poses(QStringLiteral("parts.dipw")), poses(QStringLiteral("single.dipw")));
    }

    void optimizeMerge_missingShard_isRefused() {
        const Outcome merged =
            cli(search(QStringLiteral("parts.dipw")) << "--merge" << path(QStringLiteral("part1")));
        QVERIFY(merged.exitCode != 0);
        QCOMPARE(merged.errorLines().size(), 1);
        QVERIFY2(merged.err.contains("each of the 2 result files"), merged.err);
    }

    void optimizeMerge_changedPart_isRefused_data() {
        QTest::addColumn<qsizetype>("place"); // of the changed byte; negative: from the end
        QTest::addColumn<QByteArray>("sentence");
        QTest::newRow("number in a dip") << qsizetype(-1000) << QByteArray("is damaged");
        QTest::newRow("last byte") << qsizetype(-1) << QByteArray("is damaged");
        QTest::newRow("signature") << qsizetype(0) << QByteArray("no part of a pose search");
        QTest::newRow("version") << qsizetype(7) << QByteArray("another version of the program");
    }
    void optimizeMerge_changedPart_isRefused() {
        QFETCH(const qsizetype, place);
        QFETCH(const QByteArray, sentence);
        QFile part(path(QStringLiteral("part1")));
        QVERIFY(part.open(QIODevice::ReadOnly));
        QByteArray bytes = part.readAll();
        char& changed = bytes.data()[place < 0 ? bytes.size() + place : place];
        changed = char(changed ^ 1);
        QFile copy(path(QStringLiteral("changed")));
        QVERIFY(copy.open(QIODevice::WriteOnly));
        QCOMPARE(copy.write(bytes), bytes.size());
        copy.close();
        const Outcome merged =
            cli(search(QStringLiteral("parts.dipw")) << "--merge" << path(QStringLiteral("changed"))
                                                     << "--merge" << path(QStringLiteral("part2")));
        QCOMPARE(merged.exitCode, 1);
        QCOMPARE(merged.errorLines().size(), 1);
        QVERIFY2(merged.err.contains(sentence), merged.err);
    }

    void optimizeShard_outIsNoPart_isKept() {
        const QString project = path(QStringLiteral("kept.dipw"));
        QVERIFY(QFile::copy(sampleFolder("/tetrahedron.dipw"), project));
        QVERIFY(QFile::setPermissions(project, QFile::ReadOwner | QFile::WriteOwner));
        QStringList arguments = shard(1);
        arguments.back() = project;
        const Outcome refused = cli(arguments);
        QCOMPARE(refused.exitCode, 1);
        QVERIFY2(refused.err.contains("not a part of a search"), refused.err);
        QFile kept(project), original(sampleFolder("/tetrahedron.dipw"));
        QVERIFY(kept.open(QIODevice::ReadOnly) && original.open(QIODevice::ReadOnly));
        QCOMPARE(kept.readAll(), original.readAll());
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QStringList search(const QString& job) const {
        return {"optimize",     path(job), "--immersions", "1",
                "--candidates", "6",       "--directions", "60",
                "--refined",    "0",       "--finer",      "1",
                "--confirmed",  "0",       "--set",        "film.points=40x56"};
    }
    QStringList shard(int number) const {
        return search(QStringLiteral("parts.dipw"))
               << "--shard" << QStringLiteral("%1/2").arg(number) << "--out"
               << path(QStringLiteral("part%1").arg(number));
    }
    QByteArray poses(const QString& job) const {
        const QByteArray all = cli({"info", path(job), "--json"}).out;
        return all.mid(all.indexOf("\"immersions\""));
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ShardsTest)
#include "ShardsTest.moc"

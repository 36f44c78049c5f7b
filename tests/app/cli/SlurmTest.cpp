// Runs a pose search as an array job of a real Slurm with one node, as in docs/pose-search.md, "On
// several machines". One part is killed and requeued. The merged ranking must equal that of a
// single run.

#include "CliProcess.h"
#include "PrivateSlurm.h"
#include "TestFolders.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr int longestJob = 600'000; // ms

const QStringList options{"--immersions", "1",  "--candidates", "6",
                          "--directions", "60", "--refined",    "0",
                          "--finer",      "1",  "--confirmed",  "0",
                          "--threads",    "1",  "--set",        "film.points=60x84"};

} // namespace

class SlurmTest : public QObject {
    Q_OBJECT

private slots:
    void optimizeMerge_slurmArrayJob_equalsSingleRun() {
        if (!PrivateSlurm::isInstalled()) {
            QSKIP("no Slurm here: install slurm-wlm and munge");
        }
        for (const char* name : {"single.dipw", "job.dipw"}) {
            QVERIFY(QFile::copy(sampleFolder("/tetrahedron.dipw"), path(QLatin1String(name))));
            QVERIFY(QFile::setPermissions(path(QLatin1String(name)),
                                          QFile::ReadOwner | QFile::WriteOwner));
        }
        const Outcome single =
            cli(QStringList{"optimize", path(QStringLiteral("single.dipw"))} + options);
        QVERIFY2(single.exitCode == 0, single.err);

        const PrivateSlurm slurm;
        QVERIFY2(slurm.problem().isEmpty(), qPrintable(slurm.problem()));
        QVERIFY(write("array.sh", "#SBATCH --array=1-2 --requeue --cpus-per-task=1\n",
                      "echo $SLURM_ARRAY_TASK_ID.${SLURM_RESTART_COUNT:-0} >> begun\nexec " +
                          search() +
                          " --shard $SLURM_ARRAY_TASK_ID/2 --out part$SLURM_ARRAY_TASK_ID"));
        QVERIFY(write("merge.sh", "#SBATCH --output=merged\n",
                      "exec " + search() + " --merge part1 --merge part2 2> merged.err"));
        const QString array =
            slurm.submit(path(QStringLiteral("array.sh")), {"--chdir", folder_.path()});
        QVERIFY(!array.isEmpty());
        const QString first = array + QStringLiteral("_1");
        QVERIFY(QTest::qWaitFor([&] { return bytesOf("begun").contains("1.0"); }, longestJob));
        QCOMPARE(slurm.command(QStringLiteral("scontrol"), {"requeue", first}).exitCode, 0);
        const QString merge =
            slurm.submit(path(QStringLiteral("merge.sh")),
                         {"--chdir", folder_.path(), "--dependency=afterok:" + array});
        QVERIFY(!merge.isEmpty());
        QVERIFY(QTest::qWaitFor([&] { return slurm.isEmpty(); }, longestJob));

        const QByteArray begun = bytesOf("begun");
        QVERIFY2(begun.contains("1.1") && begun.contains("2.0"),
                 begun); // part 1 was killed and ran again
        QVERIFY2(!bytesOf("merged").isEmpty(), bytesOf("merged.err"));
        QCOMPARE(bytesOf("merged"), single.out);
        QCOMPARE(poses(QStringLiteral("job.dipw")), poses(QStringLiteral("single.dipw")));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    QByteArray bytesOf(const char* name) const {
        QFile file(path(QLatin1String(name)));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    bool write(const char* name, const QByteArray& directives, const QByteArray& command) const {
        const QByteArray text = "#!/bin/sh\n" + directives + command + '\n';
        QFile file(path(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }
    static QByteArray search() {
        return '\'' + cliPath().toUtf8() + "' optimize job.dipw " +
               options.join(QLatin1Char(' ')).toUtf8();
    }
    QByteArray poses(const QString& job) const {
        const QByteArray all = cli({"info", path(job), "--json"}).out;
        return all.mid(all.indexOf("\"immersions\""));
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(SlurmTest)
#include "SlurmTest.moc"

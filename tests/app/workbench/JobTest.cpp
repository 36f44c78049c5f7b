// Tests jobs and recordings of dips without a window.
#include "Patience.h"
#include "base/Error.h"
#include "workbench/dip/DipRecording.h"
#include "workbench/jobs/JobRunner.h"

#include <QProcess>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <cmath>

using namespace dipwright;

namespace {

class ProbeJob : public Job {
public:
    struct Log {
        QThread* processed = nullptr;
        QThread* finalized = nullptr;
        bool cancelled = false;
        QString failure;
        int order = 0;
    };
    ProbeJob(Log& log, std::function<void(const Progress&)> work)
        : log_(log), work_(std::move(work)) {}
    QString title() const override { return QStringLiteral("Probing"); }
    void process(const Progress& progress) override {
        log_.processed = QThread::currentThread();
        work_(progress);
    }
    void finalize(bool cancelled, std::exception_ptr failure) override {
        static int count = 0;
        log_.order = ++count;
        log_.finalized = QThread::currentThread();
        log_.cancelled = cancelled;
        try {
            if (failure) {
                std::rethrow_exception(failure);
            }
        } catch (const Error& error) {
            log_.failure = error.message();
        }
    }

private:
    Log& log_;
    std::function<void(const Progress&)> work_;
};

const char* const hanging = "--hanging"; // option that runs this program with a job that never ends

void endWhileHanging() {
    ProbeJob::Log log;
    QSemaphore started;
    JobRunner runner;
    runner.start(std::make_unique<ProbeJob>(log, [&](const Progress&) {
        started.release();
        QThread::sleep(24 * 60 * 60);
    }));
    started.acquire();
}

const solver::FilmGrid recordedGrid{8, 8, 100, 100};

const std::vector<solver::PointState> freeFilm(64, solver::PointState::Free);
FilmFrame frameAt(std::vector<float>& positions, double descent,
                  std::span<const solver::PointState> states = freeFilm) {
    return {recordedGrid, positions, states, descent, std::int64_t(descent)};
}

} // namespace

class JobTest : public QObject {
    Q_OBJECT

private slots:
    void jobRunner_job_runsOnWorkerEndsOnCaller() {
        ProbeJob::Log log;
        JobRunner runner;
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::make_unique<ProbeJob>(log, [](const Progress&) {}));
        QVERIFY(runner.isBusy());
        QVERIFY(idle.wait(patience()));
        QVERIFY(log.processed != QThread::currentThread());
        QCOMPARE(log.finalized, QThread::currentThread());
        QVERIFY(!log.cancelled);
        QVERIFY(!runner.isBusy());
    }

    void jobRunner_twoJobs_runInOrder() {
        ProbeJob::Log first, second;
        JobRunner runner;
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::make_unique<ProbeJob>(first, [](const Progress&) {}));
        runner.start(std::make_unique<ProbeJob>(second, [](const Progress&) {}));
        QVERIFY(idle.wait(patience()));
        QVERIFY(first.order < second.order);
        QCOMPARE(idle.count(), 1);
    }

    void jobRunner_jobThrows_finalizeGetsError() {
        ProbeJob::Log log;
        JobRunner runner;
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::make_unique<ProbeJob>(log, [](const Progress&) {
            throw Error(QStringLiteral("The tank is empty"), QStringLiteral("tank"));
        }));
        QVERIFY(idle.wait(patience()));
        QCOMPARE(log.failure, QStringLiteral("The tank is empty"));
    }

    void cancelAll_runningAndWaitingJob_areCancelled() {
        ProbeJob::Log running, waiting;
        bool waitingBegan = false;
        QSemaphore begun;
        JobRunner runner;
        QSignalSpy idle(&runner, &JobRunner::idle);
        runner.start(std::make_unique<ProbeJob>(running, [&](const Progress& progress) {
            begun.release();
            while (true) {
                progress(0.5, QStringLiteral("busy"));
            }
        }));
        runner.start(
            std::make_unique<ProbeJob>(waiting, [&](const Progress&) { waitingBegan = true; }));
        begun.acquire();
        runner.cancelAll();
        QVERIFY(idle.wait(patience()));
        QVERIFY(running.cancelled);
        QVERIFY(waiting.cancelled);
        QVERIFY(!waitingBegan);
    }

    void cancelToken_runningJob_leavesWaitingJob() {
        ProbeJob::Log running, waiting;
        JobRunner runner;
        QSignalSpy idle(&runner, &JobRunner::idle);
        CancelToken first =
            runner.start(std::make_unique<ProbeJob>(running, [](const Progress& progress) {
                while (true) {
                    progress(0.5, QStringLiteral("busy"));
                }
            }));
        runner.start(std::make_unique<ProbeJob>(waiting, [](const Progress&) {}));
        first.cancel();
        QVERIFY(idle.wait(patience()));
        QVERIFY(running.cancelled);
        QVERIFY(!waiting.cancelled);
    }

    void jobRunner_destroyed_waitsForJob() {
        ProbeJob::Log log;
        QSemaphore begun;
        {
            JobRunner runner;
            runner.start(std::make_unique<ProbeJob>(log, [&](const Progress& progress) {
                begun.release();
                while (true) {
                    progress.cancelToken.throwIfCancelled();
                }
            }));
            begun.acquire();
        }
        QVERIFY(log.processed != nullptr);
        QVERIFY(log.finalized == nullptr);
    }

    // A hanging solver cannot be stopped, so the runner ends the process. Otherwise a closed window
    // would stay for ever.
    void jobRunner_jobHangs_endsProcess() {
        QProcess program;
        program.start(QCoreApplication::applicationFilePath(), {QLatin1String(hanging)});
        QVERIFY(program.waitForFinished(patience()));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QVERIFY2(program.readAllStandardError().isEmpty(),
                 "the program printed an error, expected a silent end");
        QCOMPARE(program.exitCode(), EXIT_FAILURE);
    }

    void thinFilm_largeFilm_keepsBorder() {
        const solver::FilmGrid grid{280, 396, 210, 297};
        const ThinnedFilm film = thinFilm(grid, 6000);
        QCOMPARE(film.points.size(), std::size_t(film.columns) * std::size_t(film.rows));
        QVERIFY(film.points.size() < 7000);
        QCOMPARE(film.points.front(), 0u);
        QCOMPARE(film.points.back(), std::uint32_t(280 * 396 - 1));
        QCOMPARE(film.points[std::size_t(film.columns) - 1], 279u);
    }

    void thinFilm_smallFilm_isUnchanged() {
        const solver::FilmGrid grid{8, 9, 210, 297};
        QCOMPARE(thinFilm(grid, 6000).points.size(), std::size_t(72));
    }

    void dipRecording_manyFrames_keepsFirstAndLast() {
        std::vector<float> positions(8 * 8 * 3, 0);
        DipRecording recording({}, 1000, 50);
        for (int number = 0; number < 1234; ++number) {
            positions[1] = float(number);
            recording.add(frameAt(positions, number));
        }
        QVERIFY(recording.size() <= 51);
        QVERIFY(recording.size() >= 25);
        QCOMPARE(recording.frame(0)->descent, 0);
        QCOMPARE(recording.latest()->descent, 1233);
        QCOMPARE(recording.latest()->positions[1], 1233.0f);
        for (std::size_t number = 1; number < recording.size(); ++number) {
            QVERIFY(recording.frame(number)->descent > recording.frame(number - 1)->descent);
        }
    }

    void dipRecording_heldPoints_remembersDescent() {
        std::vector<float> positions(8 * 8 * 3, 0);
        std::vector<solver::PointState> states = freeFilm;
        DipRecording recording({}, 1000, 50);
        recording.add(frameAt(positions, 1, states));
        states[5] = solver::PointState::Adhered;
        recording.add(frameAt(positions, 2.5, states));
        states[9] = solver::PointState::Trapped;
        recording.add(frameAt(positions, 4, states));
        QVERIFY(std::isnan(recording.heldAt(0)));
        QCOMPARE(recording.heldAt(5), 2.5f);
        QCOMPARE(recording.heldAt(9), 4.0f);
        QCOMPARE(recording.frameAt(2.5), std::size_t(1));
        QCOMPARE(recording.frameAt(2.6), std::size_t(2));
        QCOMPARE(recording.frameAt(99), std::size_t(2));
    }
};

int main(int argc, char* argv[]) {
    QCoreApplication application(argc, argv);
    if (argc == 2 && qstrcmp(argv[1], hanging) == 0) {
        endWhileHanging();
        return 0;
    }
    JobTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "JobTest.moc"

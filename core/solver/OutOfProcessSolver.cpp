#include "solver/OutOfProcessSolver.h"

#include "base/SanitizerFindings.h"
#include "base/ShippedFolders.h"
#include "base/SuspendAwareTimer.h"
#include "solver/CheckedSolver.h"
#include "solver/CrashSignals.h"
#include "solver/LoadMarker.h"
#include "solver/LoadModule.h"
#include "solver/ModuleText.h"
#include "solver/ProcessGroup.h"
#include "solver/SolverMessages.h"
#include "solver/WatchedSolver.h"

#include <QCoreApplication>
#include <QProcess>
#include <algorithm>
#include <optional>
#include <utility>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(OutOfProcessSolver)
};

struct UnknownException {}; // thrown by the module; CheckedSolver.cpp has the message for it

using IsCancelled = std::function<bool()>;
constexpr int pause = 20; // ms between two checks for cancellation
// Limits for an answer: text and figures, and for each point three coordinates, a state and a mark,
// rounded up.
constexpr std::uint64_t bytesOfAnAnswer = 1 << 20, bytesOfAPoint = 16;

[[noreturn]] void fail(const QString& sentence) {
    throw std::runtime_error(sentence.toStdString());
}

// Throws the module's own message.
[[noreturn]] void failWith(const std::string& said) {
    const QString sentence = moduleText(QString::fromStdString(said));
    if (sentence.isEmpty()) {
        throw UnknownException();
    }
    fail(sentence);
}

// One process, which answers one request after the other. Everything that the module starts in it
// ends with it.
class SolverProcess {
public:
    SolverProcess(const QString& modulePath, int builtFor) : modulePath_(modulePath) {
        silence(process_);
        leadGroup(process_);
        // Called directly, in the thread that uses the process at that time.
        QObject::connect(
            &process_, &QProcess::finished, &process_, [this] { endStarted(); },
            Qt::DirectConnection);
        process_.start(shippedProgram(QStringLiteral("dipwright-solver")),
                       {modulePath, QString::number(builtFor)});
        if (!process_.waitForStarted()) {
            fail(Text::tr("its process cannot be started: %1").arg(process_.errorString()));
        }
        leader_ = process_.processId();
    }
    ~SolverProcess() {
        end();
        endOnFinding(process_);
    }
    SolverProcess(const SolverProcess&) = delete;
    SolverProcess& operator=(const SolverProcess&) = delete;

    // From now on answers contain `points` points.
    void expect(std::size_t points) { mostBytes_ = bytesOfAnAnswer + points * bytesOfAPoint; }

    // Sends a request and returns the answer. Throws Cancelled, or std::runtime_error with the
    // module's message or with what happened to the process. If the process gives no sign of life
    // for `seconds`, stops it and throws.
    MessageReader ask(const MessageWriter& request, const IsCancelled& isCancelled,
                      int seconds = callTimeoutSeconds()) {
        const auto length = std::uint64_t(request.bytes().size());
        process_.write(reinterpret_cast<const char*>(&length), sizeof length);
        process_.write(request.bytes());
        SuspendAwareTimer sinceLife;
        while (true) {
            waitForFrame(isCancelled, sinceLife, seconds);
            MessageReader answer(takeFrame());
            switch (answer.take<SolverAnswer>()) {
            case SolverAnswer::Done:
                return answer;
            case SolverAnswer::Working:
                sinceLife = SuspendAwareTimer();
                break;
            case SolverAnswer::Refused: {
                const auto fault = answer.take<LoadFault>();
                throw LoadFailure(fault, QString::fromStdString(answer.takeText()));
            }
            case SolverAnswer::Threw:
                failWith(answer.takeText());
            case SolverAnswer::ThrewUnknown:
                throw UnknownException();
            case SolverAnswer::GaveNoFilm:
                requireFilm(nullptr);
            }
        }
    }

private:
    void waitForFrame(const IsCancelled& isCancelled, SuspendAwareTimer& sinceLife, int seconds) {
        while (!hasFrame()) {
            if (isCancelled && isCancelled()) {
                end();
                throw Cancelled();
            }
            if (sinceLife.look() > std::chrono::seconds(seconds)) {
                end();
                rememberCrash(modulePath_);
                fail(Text::tr("it did not respond for %1 s and was stopped").arg(seconds));
            }
            process_.waitForReadyRead(pause);
            received_ += process_.readAllStandardOutput();
            refuseEndless();
            if (!hasFrame() && process_.state() == QProcess::NotRunning) {
                tellEnd();
            }
        }
    }
    // Length of the next frame; nothing if it has not arrived yet.
    std::optional<std::uint64_t> frameLength() const {
        std::uint64_t length = 0;
        if (received_.size() < qsizetype(sizeof length)) {
            return std::nullopt;
        }
        std::memcpy(&length, received_.constData(), sizeof length);
        return length;
    }
    bool hasFrame() const {
        const auto length = frameLength();
        return length && std::uint64_t(received_.size()) - sizeof *length >= *length;
    }
    // Stops the process if its answer is too long. An endless answer would fill the memory.
    void refuseEndless() {
        if (frameLength().value_or(0) > mostBytes_) {
            end();
            fail(Text::tr("its answer was impossibly long, so its process was stopped"));
        }
    }
    QByteArray takeFrame() {
        const std::uint64_t length = *frameLength();
        const QByteArray frame = received_.mid(sizeof length, qsizetype(length));
        received_.remove(0, qsizetype(sizeof length + length));
        return frame;
    }
    [[noreturn]] void tellEnd() const {
        if (process_.exitStatus() == QProcess::CrashExit && !isCrash(process_.exitCode())) {
            fail(Text::tr("its process was killed, perhaps because the memory was full"));
        }
        rememberCrash(modulePath_);
        fail(process_.exitStatus() == QProcess::CrashExit
                 ? Text::tr("it crashed (code %1)").arg(process_.exitCode())
                 : Text::tr("its process ended unexpectedly (exit code %1)")
                       .arg(process_.exitCode()));
    }
    void end() {
        endStarted();
        process_.kill();
        process_.waitForFinished(1000);
    }
    // Ends the group only once: after the process's end is known, its number may belong to another
    // process.
    void endStarted() { endGroup(std::exchange(leader_, 0)); }

    QString modulePath_;
    qint64 leader_ = 0;
    QProcess process_;
    QByteArray received_;
    std::uint64_t mostBytes_ = bytesOfAnAnswer;
};

MessageWriter message(SolverRequest request) {
    MessageWriter writer;
    writer.put(request);
    return writer;
}

class ContainedFilm : public StoppableFilm {
public:
    ContainedFilm(const QString& modulePath, int builtFor) : process_(modulePath, builtFor) {}

    void stopOn(std::function<bool()> isCancelled) override {
        isCancelled_ = std::move(isCancelled);
    }
    void begin(const solver::DipSetup& setup) override {
        MessageWriter request = message(SolverRequest::Begin);
        put(request, setup);
        process_.expect(setup.film.pointCount());
        ask(request);
    }
    solver::DipState advance(int maximumSteps) override {
        MessageWriter request = message(SolverRequest::Advance);
        request.put(maximumSteps);
        return ask(request).take<solver::DipState>();
    }
    void read(std::span<float> positions, std::span<solver::PointState> states) const override {
        MessageReader answer = ask(message(SolverRequest::Read));
        takeFilm(answer, positions, states);
    }
    void readMarks(std::span<std::uint8_t> marks) const override {
        ask(message(SolverRequest::ReadMarks)).takeInto(marks);
    }
    bool peek(std::span<float> positions, std::span<solver::PointState> states,
              solver::DipState& shown) override {
        MessageWriter request = message(SolverRequest::Peek);
        request.put(shown);
        MessageReader answer = ask(request);
        const bool isThere = answer.take<std::uint8_t>() != 0;
        takeFilm(answer, positions, states);
        shown = answer.take<solver::DipState>();
        return isThere;
    }

private:
    MessageReader ask(const MessageWriter& request) const {
        return process_.ask(request, isCancelled_);
    }
    static void takeFilm(MessageReader& answer, std::span<float> positions,
                         std::span<solver::PointState> states) {
        answer.takeInto(positions);
        const auto all = answer.takeAll<solver::PointState>();
        if (!states.empty()) {
            std::copy_n(all.begin(), std::min(all.size(), states.size()), states.begin());
        }
    }

    mutable SolverProcess process_; // a film is used by one thread at a time
    IsCancelled isCancelled_;
};

class ContainedModule : public solver::SolverModule {
public:
    ContainedModule(const QString& modulePath, int builtFor, const CancelToken& cancelToken)
        : modulePath_(modulePath), builtFor_(builtFor) {
        try {
            SolverProcess process(modulePath_, builtFor_);
            MessageReader answer = process.ask(
                message(SolverRequest::Describe), [&] { return cancelToken.isCancelled(); },
                descriptionTimeoutSeconds());
            device_ = answer.takeText();
            followsPaths_ = answer.take<std::uint8_t>() != 0;
        } catch (const Refusal&) {
            throw;
        } catch (const Cancelled&) {
            throw;
        } catch (const std::exception& failure) {
            throw Refusal(QString::fromUtf8(failure.what()));
        } catch (const UnknownException&) {
            throw LoadFailure(LoadFault::FailedUnknown);
        }
    }

    const char* unavailableReason() const override { return nullptr; }
    const char* device() const override { return device_.c_str(); }
    std::unique_ptr<solver::FilmSolver> create() const override {
        return std::make_unique<ContainedFilm>(modulePath_, builtFor_);
    }
    bool runBatch(std::span<solver::BatchItem> items, solver::CancelFunction isCancelled,
                  void* context) const override {
        MessageWriter request = message(SolverRequest::RunBatch);
        request.put(std::uint64_t(items.size()));
        std::size_t points = 0;
        for (const solver::BatchItem& item : items) {
            put(request, item.setup);
            points += item.setup.film.pointCount();
        }
        try {
            SolverProcess process(modulePath_, builtFor_);
            process.expect(points);
            MessageReader answer = process.ask(
                request, [&] { return isCancelled != nullptr && isCancelled(context); });
            const bool isDone = answer.take<std::uint8_t>() != 0;
            for (solver::BatchItem& item : items) {
                item.positions = answer.takeAll<float>();
                item.states = answer.takeAll<solver::PointState>();
                item.marks = answer.takeAll<std::uint8_t>();
                item.steps = answer.take<std::int64_t>();
                item.equilibrium = answer.take<solver::EquilibriumAccount>();
            }
            return isDone;
        } catch (const Cancelled&) {
            return false;
        }
    }
    bool followsPaths() const override { return followsPaths_; }
    std::optional<solver::Ceiling> measuredCeiling() const override {
        SolverProcess process(modulePath_, builtFor_);
        const auto ceiling =
            process.ask(message(SolverRequest::Ceiling), {}).take<solver::Ceiling>();
        return ceiling.flopsPerSecond > 0 ? std::optional(ceiling) : std::nullopt;
    }

private:
    QString modulePath_;
    int builtFor_;
    std::string device_;
    bool followsPaths_ = false;
};

} // namespace

std::unique_ptr<solver::SolverModule> outOfProcessSolver(const QString& modulePath, int builtFor,
                                                         const CancelToken& cancelToken) {
    return std::make_unique<ContainedModule>(modulePath, builtFor, cancelToken);
}

} // namespace dipwright

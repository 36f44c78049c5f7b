#include "solver/SolverServer.h"

#include "solver/LoadModule.h"
#include "solver/ModuleText.h"
#include "solver/ProcessGroup.h"
#include "solver/SolverMessages.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <thread>

namespace dipwright {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto heartbeatInterval = std::chrono::milliseconds(200);

// Reads requests in parallel with the work. Ends the process when the client is gone.
class Requests {
public:
    explicit Requests(std::FILE* file) {
        std::thread([this, file] { readAll(file); }).detach();
    }
    QByteArray next() {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, [this] { return !waiting_.empty(); });
        QByteArray request = waiting_.front();
        waiting_.pop_front();
        return request;
    }

private:
    [[noreturn]] void readAll(std::FILE* file) {
        while (true) {
            std::uint64_t length = 0;
            if (std::fread(&length, sizeof length, 1, file) != 1) {
                leave(file);
            }
            QByteArray request(qsizetype(length), Qt::Uninitialized);
            if (std::fread(request.data(), 1, length, file) != length) {
                leave(file);
            }
            const std::lock_guard lock(mutex_);
            waiting_.push_back(request);
            wake_.notify_one();
        }
    }

    // Ends this process. If the client is gone, it also ends everything that the module has
    // started. If instead the module has closed the file, this process only exits, so that the
    // client sees that it was not killed. The client then ends the rest.
    [[noreturn]] static void leave(std::FILE* file) {
        if (std::feof(file) != 0) {
            endOwnGroup();
        }
        std::_Exit(0);
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::deque<QByteArray> waiting_;
};

// Answers requests with the module's results and messages. The client checks them and translates
// messages into the user's language.
class Server {
public:
    Server(const QString& modulePath, int builtFor, std::FILE* answers)
        : modulePath_(modulePath), builtFor_(builtFor), answers_(answers) {}

    void answer(const QByteArray& request) {
        MessageReader reader(request);
        MessageWriter writer;
        try {
            writer.put(SolverAnswer::Done);
            respond(reader.take<SolverRequest>(), reader, writer);
        } catch (const LoadFailure& failure) {
            writer = MessageWriter();
            writer.put(SolverAnswer::Refused);
            writer.put(failure.fault());
            writer.putText(failure.detail().toStdString());
        } catch (const NoFilm&) {
            writer = MessageWriter();
            writer.put(SolverAnswer::GaveNoFilm);
        } catch (const std::exception& error) {
            writer = MessageWriter();
            writer.put(SolverAnswer::Threw);
            writer.putText(moduleText(QString::fromUtf8(error.what())).toStdString());
        } catch (...) {
            writer = MessageWriter();
            writer.put(SolverAnswer::ThrewUnknown);
        }
        send(writer);
    }

private:
    struct NoFilm {};

    void send(const MessageWriter& writer) {
        const auto length = std::uint64_t(writer.bytes().size());
        std::fwrite(&length, sizeof length, 1, answers_);
        std::fwrite(writer.bytes().constData(), 1, length, answers_);
        std::fflush(answers_);
    }

    void respond(SolverRequest request, MessageReader& reader, MessageWriter& writer) {
        switch (request) {
        case SolverRequest::Describe:
            writer.putText(loaded().device.toStdString());
            return writer.put(std::uint8_t(loaded().module->followsPaths()));
        case SolverRequest::Begin:
            return begin(reader);
        case SolverRequest::Advance:
            return writer.put(film().advance(reader.take<int>()));
        case SolverRequest::Read:
            film().read(positions_, states_);
            writer.putAll(positions_);
            return writer.putAll(states_);
        case SolverRequest::ReadMarks:
            film().readMarks(marks_);
            return writer.putAll(marks_);
        case SolverRequest::Peek:
            return peek(reader, writer);
        case SolverRequest::RunBatch:
            return runBatch(reader, writer);
        case SolverRequest::Ceiling:
            writer.put(module().measuredCeiling().value_or(solver::Ceiling{}));
        }
    }

    const LoadedModule& loaded() {
        if (!loaded_.module) {
            loaded_ = loadModule(modulePath_, builtFor_);
        }
        return loaded_;
    }
    const solver::SolverModule& module() { return *loaded().module; }
    solver::FilmSolver& film() {
        if (!film_) {
            film_ = module().create();
        }
        if (!film_) {
            throw NoFilm();
        }
        return *film_;
    }

    void begin(MessageReader& reader) {
        setup_ = takeSetup(reader);
        const std::size_t points = setup_.setup.film.pointCount();
        positions_.assign(3 * points, 0);
        states_.assign(points, solver::PointState::Free);
        marks_.assign(points, 0);
        film().begin(setup_.setup);
    }
    void peek(MessageReader& reader, MessageWriter& writer) {
        auto shown = reader.take<solver::DipState>();
        writer.put(std::uint8_t(film().peek(positions_, states_, shown)));
        writer.putAll(positions_);
        writer.putAll(states_);
        writer.put(shown);
    }

    void runBatch(MessageReader& reader, MessageWriter& writer) {
        const auto count = reader.take<std::uint64_t>();
        std::vector<OwnedSetup> setups;
        std::vector<solver::BatchItem> items;
        for (std::uint64_t number = 0; number < count; ++number) {
            setups.push_back(takeSetup(reader));
            items.emplace_back().setup = setups.back().setup;
        }
        lastHeartbeat_ = Clock::now();
        const auto isCancelled = [](void* self) {
            static_cast<Server*>(self)->sendHeartbeat();
            return false; // the client cancels by ending this process
        };
        writer.put(std::uint8_t(module().runBatch(items, isCancelled, this)));
        for (const solver::BatchItem& item : items) {
            writer.putAll(item.positions);
            writer.putAll(item.states);
            writer.putAll(item.marks);
            writer.put(item.steps);
            writer.put(item.equilibrium);
        }
    }
    // Several threads of the module may call this.
    void sendHeartbeat() {
        const std::lock_guard lock(mutex_);
        if (Clock::now() - lastHeartbeat_ >= heartbeatInterval) {
            lastHeartbeat_ = Clock::now();
            MessageWriter writer;
            writer.put(SolverAnswer::Working);
            send(writer);
        }
    }

    QString modulePath_;
    int builtFor_;
    std::FILE* answers_;
    LoadedModule loaded_;
    std::unique_ptr<solver::FilmSolver> film_;
    OwnedSetup setup_;
    std::vector<float> positions_;
    std::vector<solver::PointState> states_;
    std::vector<std::uint8_t> marks_;
    std::mutex mutex_;
    Clock::time_point lastHeartbeat_;
};

} // namespace

void serveSolver(const QString& modulePath, int builtFor, std::FILE* requests, std::FILE* answers) {
    Requests incoming(requests);
    Server server(modulePath, builtFor, answers);
    while (true) {
        server.answer(incoming.next());
    }
}

} // namespace dipwright

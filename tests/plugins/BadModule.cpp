// Solver modules that misbehave. The macro DIPWRIGHT_BAD_<WAY> selects the defect of a module.

#include <dipwright/FilmSolver.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <stdexcept>
#include <string>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace dipwright;

// Crashes as a bad pointer does, but without a report of a sanitizer.
[[maybe_unused]] void crash() {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
}

#if defined(DIPWRIGHT_BAD_ADVANCE_GIANT)
// Announces an answer of an exabyte on every stream of its process, and begins to send it.
void announceGiant() {
    constexpr int firstOfItsOwn = 3, last = 15; // the standard streams have lower numbers
    const std::vector<std::uint64_t> words(8192, std::uint64_t(1) << 60);
    for (int stream = firstOfItsOwn; stream <= last; ++stream) {
        [[maybe_unused]] const auto written =
            ::write(stream, words.data(), words.size() * sizeof words.front());
    }
    std::this_thread::sleep_for(std::chrono::hours(1));
}
#endif

#if defined(DIPWRIGHT_BAD_FORK)
// Starts a child process that only holds a lock on the file DIPWRIGHT_BAD_LOCK, for an hour.
void startAnother() {
    const int file = ::open(std::getenv("DIPWRIGHT_BAD_LOCK"), O_RDWR | O_CREAT, 0600);
    ::flock(file, LOCK_EX);
    if (::fork() == 0) {
        ::sleep(3600);
        ::_exit(0);
    }
    ::close(file); // only the child holds the lock
}
#endif

#if defined(DIPWRIGHT_BAD_LONG)
// Returns several lines with an escape character and millions of letters.
std::string longText() {
    return "It said\nfar\r\n  too \x1b much: " + std::string(5'000'000, 'x');
}
#endif

// A film with the selected defect.
class Film : public solver::FilmSolver {
public:
    void begin(const solver::DipSetup&) override {
#if defined(DIPWRIGHT_BAD_BEGIN)
        throw std::runtime_error("out of film");
#endif
    }
    solver::DipState advance(int steps) override {
#if defined(DIPWRIGHT_BAD_FORK)
        startAnother();
#endif
#if defined(DIPWRIGHT_BAD_ADVANCE)
        throw std::runtime_error("out of water");
#elif defined(DIPWRIGHT_BAD_ADVANCE_UNKNOWN)
        throw 42;
#elif defined(DIPWRIGHT_BAD_ADVANCE_CRASH)
        crash();
#elif defined(DIPWRIGHT_BAD_ADVANCE_EXIT)
        std::_Exit(0);
#elif defined(DIPWRIGHT_BAD_ADVANCE_HANG)
        std::this_thread::sleep_for(std::chrono::hours(1));
#elif defined(DIPWRIGHT_BAD_ADVANCE_GIANT)
        announceGiant();
#elif defined(DIPWRIGHT_BAD_ADVANCE_IDLE)
        return {};
#elif defined(DIPWRIGHT_BAD_ADVANCE_NONSENSE)
        return {-5, std::numeric_limits<double>::quiet_NaN(), false};
#elif defined(DIPWRIGHT_BAD_ADVANCE_STEPS)
        return {std::numeric_limits<std::int64_t>::max(), 1, true};
#elif defined(DIPWRIGHT_BAD_ADVANCE_DEEP)
        return {steps, 1e308, true};
#elif defined(DIPWRIGHT_BAD_ADVANCE_CRAWL)
        constexpr std::int64_t atOnce = 1'000'000;
        crawled_ += atOnce;
        return {crawled_, 1e-12 * double(crawled_), false};
#elif defined(DIPWRIGHT_BAD_ADVANCE_STILL)
        constexpr std::int64_t enough = 100'000;
        crawled_ += 1;
        if (crawled_ > enough) {
            throw std::runtime_error("nobody ends it");
        }
        return {crawled_, 0, false};
#elif defined(DIPWRIGHT_BAD_ADVANCE_EQUILIBRIUM)
        return {steps, 1, true, { -5, 0, 0 }};
#elif defined(DIPWRIGHT_BAD_ADVANCE_FORCE)
        return {steps, 1, true, { 1, std::numeric_limits<double>::infinity(), 1 }};
#elif defined(DIPWRIGHT_BAD_ADVANCE_EMPTY)
        throw std::runtime_error("\n");
#elif defined(DIPWRIGHT_BAD_LONG)
        throw std::runtime_error(longText());
#endif
        return {steps, 1, true};
    }
    void read([[maybe_unused]] std::span<float> positions,
              [[maybe_unused]] std::span<solver::PointState> states) const override {
#if defined(DIPWRIGHT_BAD_READ)
        throw std::runtime_error("out of ink");
#elif defined(DIPWRIGHT_BAD_READ_CRASH)
        std::abort();
#elif defined(DIPWRIGHT_BAD_READ_STATES)
        std::fill(states.begin(), states.end(), solver::PointState(77));
#elif defined(DIPWRIGHT_BAD_READ_POSITIONS)
        std::fill(positions.begin(), positions.end(), std::numeric_limits<float>::infinity());
        std::fill(states.begin(), states.end(), solver::PointState::Adhered);
#endif
    }
    void readMarks(std::span<std::uint8_t> marks) const override {
#if defined(DIPWRIGHT_BAD_READ_MARKS)
        std::fill(marks.begin(), marks.end(), std::uint8_t(255));
#else
        std::fill(marks.begin(), marks.end(), std::uint8_t(0));
#endif
    }

#if defined(DIPWRIGHT_BAD_ADVANCE_CRAWL) || defined(DIPWRIGHT_BAD_ADVANCE_STILL)
private:
    std::int64_t crawled_ = 0;
#endif
};

class Module : public solver::SolverModule {
public:
    const char* unavailableReason() const override {
#if defined(DIPWRIGHT_BAD_DEVICE)
        return "There is no such device here";
#elif defined(DIPWRIGHT_BAD_DEVICE_LONG)
        static const std::string reason = longText();
        return reason.c_str();
#elif defined(DIPWRIGHT_BAD_DEVICE_EMPTY)
        return "";
#elif defined(DIPWRIGHT_BAD_QUESTION)
        throw std::runtime_error("do not ask");
#else
        return nullptr;
#endif
    }
    const char* device() const override {
#if defined(DIPWRIGHT_BAD_LONG)
        static const std::string device = longText();
        return device.c_str();
#else
        return "A device";
#endif
    }
    std::unique_ptr<solver::FilmSolver> create() const override {
#if defined(DIPWRIGHT_BAD_CREATE)
        throw std::runtime_error("out of memory");
#elif defined(DIPWRIGHT_BAD_CREATE_NOTHING)
        return nullptr;
#elif defined(DIPWRIGHT_BAD_CREATE_UNKNOWN)
        throw "no";
#endif
        return std::make_unique<Film>();
    }
    bool runBatch([[maybe_unused]] std::span<solver::BatchItem> items, solver::CancelFunction,
                  void*) const override {
#if defined(DIPWRIGHT_BAD_BATCH_UNKNOWN)
        throw 42;
#elif defined(DIPWRIGHT_BAD_BATCH_CRASH)
        crash();
#elif defined(DIPWRIGHT_BAD_BATCH_STOPS)
        return false;
#elif defined(DIPWRIGHT_BAD_BATCH_HANG)
        std::this_thread::sleep_for(std::chrono::hours(1));
#elif defined(DIPWRIGHT_BAD_BATCH_STEPS) || defined(DIPWRIGHT_BAD_BATCH_EQUILIBRIUM)
        solver::DipState end{1, 1, true};
#if defined(DIPWRIGHT_BAD_BATCH_STEPS)
        end.steps = std::numeric_limits<std::int64_t>::max();
#else
        end.equilibrium.stepsWithout = 2; // impossible: only one step was made
#endif
        for (solver::BatchItem& item : items) {
            item.finish(end, [](auto, auto, auto){});
        }
#endif
        return true; // leaves the films empty
    }
    std::optional<solver::Ceiling> measuredCeiling() const override {
#if defined(DIPWRIGHT_BAD_CEILING_CRASH)
        crash();
#elif defined(DIPWRIGHT_BAD_CEILING_ENDLESS)
        constexpr double endless = std::numeric_limits<double>::infinity();
        return solver::Ceiling{endless, endless};
#endif
        return std::nullopt;
    }
};

} // namespace

#if defined(DIPWRIGHT_BAD_LOAD)
namespace {
// Runs when the module is loaded, which the program must not do.
[[maybe_unused]] const int harm = (std::abort(), 0);
} // namespace
#endif

#if !defined(DIPWRIGHT_BAD_NAME)
#define DIPWRIGHT_BAD_NAME dipwrightSolverModule
#endif

extern "C" DIPWRIGHT_EXPORT const solver::SolverModule*
DIPWRIGHT_BAD_NAME([[maybe_unused]] int hostInterfaceVersion) {
#if defined(DIPWRIGHT_BAD_ENTRY)
    throw std::runtime_error("not today");
#elif defined(DIPWRIGHT_BAD_ENTRY_UNKNOWN)
    throw 42;
#elif defined(DIPWRIGHT_BAD_OLD)
    if (hostInterfaceVersion != 2) { // behaves like a module that was built for version 2
        return nullptr;
    }
#elif defined(DIPWRIGHT_BAD_ABORT)
    std::abort();
#elif defined(DIPWRIGHT_BAD_HANG)
    std::this_thread::sleep_for(std::chrono::hours(1));
#elif defined(DIPWRIGHT_BAD_KILLED)
    std::raise(SIGKILL); // the system sends this signal when memory is short
#endif
    static const Module module;
    return &module;
}

// Messages between the program and a solver in a separate process. Both sides come from one build
// and run on one machine, so values are sent in their memory layout.
#pragma once

#include <dipwright/FilmSolver.h>

#include <QByteArray>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace dipwright {

// Each comment says: contents of the request -> contents of the answer.
enum class SolverRequest : std::uint8_t {
    Describe,  // -> device, whether it follows paths
    Begin,     // setup ->
    Advance,   // most steps -> state
    Read,      // -> positions, states
    ReadMarks, // -> marks
    Peek,      // state -> whether available, positions, states, state
    RunBatch,  // setups -> whether done, results of each item
    Ceiling,   // -> whether available, ceiling
};

enum class SolverAnswer : std::uint8_t {
    Done,         // followed by the answer
    Working,      // a sign of life within a batch
    Refused,      // fault and detail of a LoadFailure
    Threw,        // the module's own message
    ThrewUnknown, // not a std::exception
    GaveNoFilm,
};

class MessageWriter {
public:
    template <typename Value>
    void put(const Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        bytes_.append(reinterpret_cast<const char*>(&value), qsizetype(sizeof value));
    }
    template <typename Value>
    void putAll(const Value* values, std::size_t count) {
        static_assert(std::is_trivially_copyable_v<Value>);
        put(std::uint64_t(count));
        bytes_.append(reinterpret_cast<const char*>(values), qsizetype(count * sizeof(Value)));
    }
    template <typename Value>
    void putAll(const std::vector<Value>& values) {
        putAll(values.data(), values.size());
    }
    void putText(const std::string& text) { putAll(text.data(), text.size()); }
    const QByteArray& bytes() const { return bytes_; }

private:
    QByteArray bytes_;
};

// Reads values from a message. Throws std::runtime_error if the message is too short, because a
// module may corrupt the memory of its process.
class MessageReader {
public:
    explicit MessageReader(QByteArray bytes) : bytes_(std::move(bytes)) {}

    template <typename Value>
    Value take() {
        Value value;
        copy(&value, sizeof value);
        return value;
    }
    template <typename Value>
    std::vector<Value> takeAll() {
        std::vector<Value> values(count(sizeof(Value)));
        copy(values.data(), values.size() * sizeof(Value));
        return values;
    }
    // Fills `values`. Throws if the message has another number of values.
    template <typename Value>
    void takeInto(std::span<Value> values) {
        if (count(sizeof(Value)) != values.size()) {
            throw std::runtime_error("its message contains the wrong number of points");
        }
        copy(values.data(), values.size_bytes());
    }
    std::string takeText() {
        const std::vector<char> letters = takeAll<char>();
        return {letters.begin(), letters.end()};
    }

private:
    std::size_t count(std::size_t size) {
        const auto count = take<std::uint64_t>();
        if (count > std::uint64_t(bytes_.size() - place_) / size) {
            throw std::runtime_error("its message is incomplete");
        }
        return std::size_t(count);
    }
    void copy(void* to, std::size_t size) {
        if (std::size_t(bytes_.size() - place_) < size) {
            throw std::runtime_error("its message is incomplete");
        }
        if (size > 0) {
            std::memcpy(to, bytes_.constData() + place_, size);
        }
        place_ += qsizetype(size);
    }

    QByteArray bytes_;
    qsizetype place_ = 0;
};

inline void put(MessageWriter& writer, const solver::DipSetup& setup) {
    const solver::FilmGrid& film = setup.film;
    writer.put(film.columns);
    writer.put(film.rows);
    writer.put(film.width);
    writer.put(film.depth);
    writer.putAll(film.columnPlaces);
    writer.putAll(film.rowPlaces);
    const solver::FieldView& field = setup.field;
    writer.put(field.size);
    writer.put(field.origin);
    writer.put(field.spacing);
    writer.putAll(field.distance, field.distance
                                      ? std::size_t(field.size[0]) * std::size_t(field.size[1]) *
                                            std::size_t(field.size[2])
                                      : 0);
    writer.put(setup.motion);
    writer.put(setup.settings);
    writer.putAll(setup.pinned);
    writer.put(setup.path.pivot);
    writer.putAll(setup.path.poses);
}

// A setup together with the samples that its field refers to.
struct OwnedSetup {
    solver::DipSetup setup;
    std::vector<float> samples;
};

inline OwnedSetup takeSetup(MessageReader& reader) {
    OwnedSetup owned;
    solver::FilmGrid& film = owned.setup.film;
    film.columns = reader.take<int>();
    film.rows = reader.take<int>();
    film.width = reader.take<double>();
    film.depth = reader.take<double>();
    film.columnPlaces = reader.takeAll<double>();
    film.rowPlaces = reader.takeAll<double>();
    solver::FieldView& field = owned.setup.field;
    field.size = reader.take<std::array<int, 3>>();
    field.origin = reader.take<std::array<double, 3>>();
    field.spacing = reader.take<double>();
    owned.samples = reader.takeAll<float>();
    // stays valid when `owned` is moved
    field.distance = owned.samples.empty() ? nullptr : owned.samples.data();
    owned.setup.motion = reader.take<solver::BodyMotion>();
    owned.setup.settings = reader.take<solver::Settings>();
    owned.setup.pinned = reader.takeAll<std::uint8_t>();
    owned.setup.path.pivot = reader.take<std::array<double, 3>>();
    owned.setup.path.poses = reader.takeAll<solver::PathPose>();
    return owned;
}

} // namespace dipwright

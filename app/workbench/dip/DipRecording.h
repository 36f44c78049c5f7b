// Records the film of one dip over time, coarsely, for playing and scrubbing.
#pragma once

#include "dip/FilmFrame.h"
#include "settings/Immersion.h"

#include <memory>
#include <mutex>

namespace dipwright {

// A coarser grid of the film's points: every n-th column and row, and always the last ones.
struct ThinnedFilm {
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> points; // index in the film, row by row
};
// Chooses the smallest n that leaves about `mostPoints` points.
ThinnedFilm thinFilm(const solver::FilmGrid& grid, std::size_t mostPoints);

struct RecordedFrame {
    std::vector<float> positions; // x, y, z of each point of the thinned film; world frame, mm
    double descent = 0;           // mm
};

// The simulating thread writes while the UI thread reads.
class DipRecording {
public:
    // Keeps about `mostFrames` evenly spread frames at most, and always the newest.
    DipRecording(const Immersion& immersion, std::size_t mostPoints, std::size_t mostFrames);

    const Immersion& immersion() const { return immersion_; }
    // The grids of the frames. They are constant once there is a frame.
    const ThinnedFilm& film() const { return film_; }
    const solver::FilmGrid& grid() const { return grid_; }

    void add(const FilmFrame& frame);
    std::size_t size() const;
    std::shared_ptr<const RecordedFrame> frame(std::size_t number) const;
    std::shared_ptr<const RecordedFrame> latest() const; // null: none yet
    // Returns the descent of the first frame in which the film point is held, mm; NaN if none. Do
    // not call it while the dip is recorded.
    float heldAt(std::size_t point) const;
    std::size_t frameAt(double descent) const; // the first frame at or below it, else the last

private:
    void thinOut();

    const Immersion immersion_;
    const std::size_t mostPoints_, mostFrames_;
    solver::FilmGrid grid_;
    ThinnedFilm film_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const RecordedFrame>> frames_;
    std::vector<float> heldAt_; // mm, for each film point
    std::size_t added_ = 0;
    std::size_t keepEvery_ = 1;
};

} // namespace dipwright

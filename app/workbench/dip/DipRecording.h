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
    std::vector<std::uint32_t> points; // indices in the film, row by row
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
    // Keeps at most about `mostFrames` frames, spread evenly over the dip, and always the newest
    // frame.
    DipRecording(const Immersion& immersion, std::size_t mostPoints, std::size_t mostFrames);

    const Immersion& immersion() const { return immersion_; }
    // The points of each frame. Constant once there is a frame.
    const ThinnedFilm& film() const { return film_; }
    // The grid of the whole film. Constant once there is a frame.
    const solver::FilmGrid& grid() const { return grid_; }

    void add(const FilmFrame& frame);
    std::size_t size() const;
    std::shared_ptr<const RecordedFrame> frame(std::size_t number) const;
    std::shared_ptr<const RecordedFrame> latest() const; // null: no frame yet
    // Returns the descent of the first frame in which the body holds the film point, mm; NaN if
    // there is no such frame. Do not call this while the dip is recorded.
    float heldAt(std::size_t point) const;
    // Returns the first frame at `descent` or deeper, else the last frame.
    std::size_t frameAt(double descent) const;

private:
    void thinOut();

    const Immersion immersion_;
    const std::size_t mostPoints_, mostFrames_;
    solver::FilmGrid grid_;
    ThinnedFilm film_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const RecordedFrame>> frames_;
    std::vector<float> heldAt_; // the descent in mm for each film point, see heldAt()
    std::size_t added_ = 0;
    std::size_t keepEvery_ = 1;
};

} // namespace dipwright

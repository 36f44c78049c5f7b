// The film of one dip over time, thinned out so that it can be played and scrubbed.
#pragma once

#include "dip/FilmFrame.h"
#include "settings/Immersion.h"

#include <memory>
#include <mutex>

namespace dipwright {

// A coarser grid out of the film's points: every second, every third … column and row, as few as it
// takes to have about the number of points asked for, and always the last column and row.
struct ThinnedFilm {
    int columns = 0, rows = 0;
    std::vector<std::uint32_t> points; // index in the film, row by row
};
ThinnedFilm thinFilm(const solver::FilmGrid& grid, std::size_t mostPoints);

struct RecordedFrame {
    std::vector<float> positions; // x, y, z a point of the thinned film; world frame
    double descent = 0;           // mm
};

// Written by the thread that simulates, read by the UI thread at the same time.
class DipRecording {
public:
    // Keeps at most about `mostFrames` evenly spread frames, always with the newest.
    DipRecording(const Immersion& immersion, std::size_t mostPoints, std::size_t mostFrames);

    const Immersion& immersion() const { return immersion_; }
    // Of its frames; once there is one, they stay as they are.
    const ThinnedFilm& film() const { return film_; }
    const solver::FilmGrid& grid() const { return grid_; }

    void add(const FilmFrame& frame);
    std::size_t size() const;
    std::shared_ptr<const RecordedFrame> frame(std::size_t number) const;
    std::shared_ptr<const RecordedFrame> latest() const; // null: none yet
    // Of the first frame that showed the film's point held, mm; NaN: none did. Not while it is
    // written.
    float heldAt(std::size_t point) const;
    std::size_t frameAt(double descent) const; // the first one that far down, or the last

private:
    void thinOut();

    const Immersion immersion_;
    const std::size_t mostPoints_, mostFrames_;
    solver::FilmGrid grid_;
    ThinnedFilm film_;
    mutable std::mutex mutex_;
    std::vector<std::shared_ptr<const RecordedFrame>> frames_;
    std::vector<float> heldAt_; // a point of the film each
    std::size_t added_ = 0;
    std::size_t keepEvery_ = 1;
};

} // namespace dipwright

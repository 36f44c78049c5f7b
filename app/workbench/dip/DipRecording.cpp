#include "workbench/dip/DipRecording.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dipwright {

namespace {

std::vector<int> thinned(int count, int stride) {
    std::vector<int> kept;
    for (int entry = 0; entry < count - 1; entry += stride) {
        kept.push_back(entry);
    }
    kept.push_back(count - 1);
    return kept;
}

} // namespace

ThinnedFilm thinFilm(const solver::FilmGrid& grid, std::size_t mostPoints) {
    const double excess = double(grid.pointCount()) / double(mostPoints);
    const int stride = std::max(1, int(std::ceil(std::sqrt(excess))));
    const std::vector<int> columns = thinned(grid.columns, stride);
    const std::vector<int> rows = thinned(grid.rows, stride);
    ThinnedFilm film{int(columns.size()), int(rows.size()), {}};
    film.points.reserve(columns.size() * rows.size());
    for (const int row : rows) {
        for (const int column : columns) {
            film.points.push_back(std::uint32_t(row * grid.columns + column));
        }
    }
    return film;
}

DipRecording::DipRecording(const Immersion& immersion, std::size_t mostPoints,
                           std::size_t mostFrames)
    : immersion_(immersion), mostPoints_(mostPoints), mostFrames_(mostFrames) {}

void DipRecording::add(const FilmFrame& frame) {
    if (added_ == 0) { // no reader uses film_ yet, so no lock
        grid_ = frame.grid;
        film_ = thinFilm(grid_, mostPoints_);
        heldAt_.assign(grid_.pointCount(), std::numeric_limits<float>::quiet_NaN());
    }
    for (std::size_t point = 0; point < heldAt_.size(); ++point) {
        if (std::isnan(heldAt_[point]) && frame.states[point] != solver::PointState::Free) {
            heldAt_[point] = float(frame.descent);
        }
    }
    auto recorded = std::make_shared<RecordedFrame>();
    recorded->descent = frame.descent;
    recorded->positions.reserve(film_.points.size() * 3);
    for (const std::uint32_t point : film_.points) {
        const auto place = frame.positions.subspan(std::size_t(point) * 3, 3);
        recorded->positions.insert(recorded->positions.end(), place.begin(), place.end());
    }
    const std::lock_guard lock(mutex_);
    const bool lastIsKept = frames_.empty() || (added_ - 1) % keepEvery_ == 0;
    if (lastIsKept) {
        frames_.push_back(std::move(recorded));
    } else {
        frames_.back() = std::move(recorded);
    }
    ++added_;
    if (frames_.size() > mostFrames_) {
        thinOut();
    }
}

void DipRecording::thinOut() {
    std::vector<std::shared_ptr<const RecordedFrame>> kept;
    for (std::size_t number = 0; number < frames_.size(); number += 2) {
        kept.push_back(frames_[number]);
    }
    const bool newestIsKept = frames_.size() % 2 == 1;
    if (!newestIsKept) {
        kept.push_back(frames_.back());
    }
    frames_ = std::move(kept);
    keepEvery_ *= 2;
}

std::size_t DipRecording::size() const {
    const std::lock_guard lock(mutex_);
    return frames_.size();
}

std::shared_ptr<const RecordedFrame> DipRecording::frame(std::size_t number) const {
    const std::lock_guard lock(mutex_);
    return number < frames_.size() ? frames_[number] : nullptr;
}

float DipRecording::heldAt(std::size_t point) const {
    return point < heldAt_.size() ? heldAt_[point] : std::numeric_limits<float>::quiet_NaN();
}

std::size_t DipRecording::frameAt(double descent) const {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(frames_.begin(), frames_.end(), [descent](const auto& frame) {
        return frame->descent >= descent;
    });
    return std::size_t(found - frames_.begin()) - (found == frames_.end() && !frames_.empty());
}

std::shared_ptr<const RecordedFrame> DipRecording::latest() const {
    const std::lock_guard lock(mutex_);
    return frames_.empty() ? nullptr : frames_.back();
}

} // namespace dipwright

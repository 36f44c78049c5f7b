#include "workbench/dip/DipMoments.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dipwright {

namespace {

// Returns the smallest descent at which the body held a film point for which `counts` is true, mm.
template <typename Counts>
std::optional<double> firstHeld(const DipRecording& recording, const DippedFilm& film,
                                const Counts& counts) {
    std::optional<double> first;
    for (std::size_t point = 0; point < film.positions.size(); ++point) {
        const float at = recording.heldAt(point);
        if (!std::isnan(at) && counts(point)) {
            first = std::min(first.value_or(at), double(at));
        }
    }
    return first;
}

} // namespace

std::vector<DipMoment> dipMoments(const DipRecording& recording, const ImmersionResult& result) {
    const DippedFilm& film = result.laid->film();
    const std::shared_ptr<const RecordedFrame> last = recording.latest();
    std::vector<DipMoment> moments;
    const auto add = [&](DipEvent event, std::optional<double> descent) {
        if (descent && last && *descent <= last->descent) {
            moments.push_back({event, *descent});
        }
    };
    const auto isMarked = [&film](solver::PointMark mark) {
        return [&film, mark](std::size_t point) {
            return point < film.marks.size() && solver::has(film.marks[point], mark);
        };
    };
    add(DipEvent::FirstContact, firstHeld(recording, film, [](std::size_t) { return true; }));
    add(DipEvent::AirTrapped, result.coverage->trappedAir.travelled);
    add(DipEvent::Torn, firstHeld(recording, film, isMarked(solver::PointMark::Torn)));
    add(DipEvent::LetGo, firstHeld(recording, film, isMarked(solver::PointMark::LetGo)));
    std::stable_sort(
        moments.begin(), moments.end(),
        [](const DipMoment& one, const DipMoment& two) { return one.descent < two.descent; });
    return moments;
}

} // namespace dipwright

#include "pipeline/JobCradles.h"

#include "pipeline/Pipeline.h"

namespace dipwright {

namespace {

constexpr double fieldDone = 0.1;

} // namespace

std::vector<Cradle> jobCradles(const JobResult& result, const Progress& progress) {
    const Project& project = result.project;
    const auto field = distanceFieldOf(result, progress.part(0, fieldDone));
    const DatumPins pins =
        datumPins(result.immersions.front().sheet, project.film, project.cradle.pinSpan);
    std::vector<Cradle> cradles;
    std::vector<const LaidFilm*> earlier;
    const double share = (1 - fieldDone) / double(result.immersions.size());
    for (std::size_t i = 0; i < result.immersions.size(); ++i) {
        const ImmersionResult& immersion = result.immersions[i];
        const double begin = fieldDone + share * double(i);
        cradles.push_back(
            makeCradle({*immersion.laid, earlier, *field, immersion.immersion, project.process,
                        pins, int(i) + 1, immersion.sheet.job.hash, result.mask.get()},
                       project.cradle, progress.part(begin, begin + share)));
        earlier.push_back(immersion.laid.get());
    }
    return cradles;
}

} // namespace dipwright

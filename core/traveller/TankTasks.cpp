#include "traveller/TankTasks.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Traveller)
};

} // namespace

QString tankStepTitle(TankStep step) {
    switch (step) {
    case TankStep::Tape:
        return Text::tr("Tape the masked surface");
    case TankStep::Lay:
        return Text::tr("Lay the film");
    case TankStep::Soak:
        return Text::tr("Soak");
    case TankStep::Activator:
        return Text::tr("Spray the activator");
    case TankStep::Dip:
        return Text::tr("Dip the part");
    case TankStep::Hold:
        return Text::tr("Hold under water");
    case TankStep::Flash:
        return Text::tr("Let it flash off");
    case TankStep::Dry:
        return Text::tr("Rinse and dry");
    case TankStep::RemoveTape:
        return Text::tr("Remove the tape");
    case TankStep::Compare:
        break;
    }
    return Text::tr("Compare the part");
}

std::vector<TankSummary> tankSummaries(const std::vector<TankTime>& times) {
    std::vector<TankSummary> summaries;
    for (const TankTime& time : times) {
        auto summary = std::find_if(summaries.begin(), summaries.end(), [&](const auto& one) {
            return one.dip == time.dip && one.step == time.step;
        });
        if (summary == summaries.end()) {
            summary = summaries.insert(
                summary, {time.dip, time.step, 0, {}, Seconds(0), time.took, time.took});
        }
        const int runs = ++summary->runs;
        summary->planned = time.planned;
        summary->mean = summary->mean + (time.took - summary->mean) / runs;
        summary->shortest = std::min(summary->shortest, time.took);
        summary->longest = std::max(summary->longest, time.took);
    }
    return summaries;
}

} // namespace dipwright

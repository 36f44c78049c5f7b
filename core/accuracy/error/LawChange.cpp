#include "accuracy/error/LawChange.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Certainty)
};

QString nameOf(const QString& setting) {
    if (setting == QLatin1String("process.overhang_deg")) {
        return Text::tr("Overhang (°)");
    }
    if (setting == QLatin1String("film.grip_fade_deg")) {
        return Text::tr("Grip fade range (°)");
    }
    if (setting == QLatin1String("process.tear_stretch")) {
        return Text::tr("Tearing (stretch in length or area)");
    }
    return Text::tr("Gathering (mean stretch)");
}

} // namespace

void measureLaw(LawChange& change, const LaidFilm& own, const LaidFilm& less,
                const LaidFilm& more) {
    const std::vector<SurfacePoint> places = comparedPlaces(own.body());
    const std::vector<float> down = sheetMoves(own, less, places);
    const std::vector<float> up = sheetMoves(own, more, places);
    std::vector<float> moves;
    std::size_t painted = 0, lost = 0;
    for (std::size_t place = 0; place < places.size(); ++place) {
        if (!own.place(places[place])) {
            continue;
        }
        ++painted;
        if (down[place] < 0 || up[place] < 0) {
            ++lost;
        } else {
            moves.push_back(std::max(down[place], up[place]));
        }
    }
    const auto moved = std::count_if(moves.begin(), moves.end(), [](float distance) {
        return double(distance) > mostHalfSpacingChange;
    });
    if (painted > 0) {
        change.moved = double(moved) / double(painted);
        change.lost = double(lost) / double(painted);
    }
    change.distance = distribution(std::move(moves));
}

QString lawText(const LawChange& change, const std::function<QString(double)>& length) {
    const QLocale locale;
    const auto number = [&](double value) { return locale.toString(value, 'g', 4); };
    const auto percent = [&](double share) { return locale.toString(100 * share, 'f', 1); };
    return Text::tr(
               "%1 varied from %2 to %3 (in the project: %4): 95 % of the painted area moves "
               "by at most %5. %6 % of it moves by more than %7, and %8 % is no longer painted.")
        .arg(nameOf(change.setting), number(change.less), number(change.more), number(change.value),
             length(change.distance.percentile95), percent(change.moved),
             length(mostHalfSpacingChange), percent(change.lost));
}

} // namespace dipwright

#include "inspection/FilmWatch.h"

#include "base/Error.h"
#include "base/NumberText.h"
#include "inspection/SamePhoto.h"
#include "project/Profiles.h"
#include "sheet/page/WatchPage.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmWatch)
};

const SeenBoard* boardOf(const std::vector<SeenBoard>& boards, BoardKind kind) {
    const auto found = std::find_if(boards.begin(), boards.end(),
                                    [kind](const SeenBoard& board) { return board.kind == kind; });
    return found == boards.end() ? nullptr : &*found;
}

void requireUpright(const SeenBoard& board, const QString& where) {
    if (!board.mirrored) {
        return;
    }
    throw Error(board.kind == BoardKind::Film
                    ? Text::tr("The film's chessboard is mirrored; lay the film with its ink side "
                               "up, and use the photo without flipping it")
                    : Text::tr("The card is mirrored; use the photo without flipping it"),
                where);
}

QString swellText(const Measured& swell) {
    return Text::tr("%1 ± %2").arg(numberText(swell.value, 4), numberText(swell.off, 4));
}

double secondsOf(const WatchedPhoto& photo, double begin) {
    return photo.seconds.value_or(begin);
}

// Growth measured at three or more times is not valid for a dip that begins long before the first
// or after the last of them. `beyond` is how long, as a share of the time between these two.
void requireBeginSeen(const FilmWatch& watch, double beyond) {
    std::set<double> moments;
    for (const WatchedPhoto& photo : watch.photos) {
        moments.insert(secondsOf(photo, watch.begin));
    }
    if (moments.size() < 3) {
        return;
    }
    const double first = *moments.begin(), last = *moments.rbegin();
    if (watch.begin < first - beyond * (last - first) ||
        watch.begin > last + beyond * (last - first)) {
        throw Error(Text::tr("The photos show the film from %1 to %2 s after it was laid on the "
                             "water, but the dip begins after %3 s; correct the times, or take "
                             "photos both before and after the start of the dip")
                        .arg(numberText(first, 0), numberText(last, 0), numberText(watch.begin, 0)),
                    watch.photos.front().where);
    }
}

// A photo that is given several times would look like film that does not grow.
void requireDifferent(const std::vector<WatchedPhoto>& photos) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        requireNewPhoto(std::span(photos).first(i), photos[i]);
    }
}

QStringList noGrowthSentences(const FilmWatch& watch) {
    QStringList sentences{Text::tr("Growth is not measured; to measure it, take photos at three or "
                                   "more times, from before the dip begins until after it ends")};
    const auto away = [&](const WatchedPhoto& photo) {
        return std::abs(secondsOf(photo, watch.begin) - watch.begin);
    };
    const auto nearest = std::min_element(
        watch.photos.begin(), watch.photos.end(),
        [&](const WatchedPhoto& a, const WatchedPhoto& b) { return away(a) < away(b); });
    if (nearest != watch.photos.end() && away(*nearest) >= 1) {
        sentences << Text::tr("The swell was measured after %1 s, but the dip begins after %2 s; "
                              "this swell does not include the growth in between")
                         .arg(numberText(secondsOf(*nearest, watch.begin), 0),
                              numberText(watch.begin, 0));
    }
    return sentences;
}

QStringList growthSentences(const FilmWatch& watch) {
    const GrowthFit& growth = watch.growth;
    switch (growth.known) {
    case GrowthKnowledge::No:
        return noGrowthSentences(watch);
    case GrowthKnowledge::None:
        return {Text::tr("The photos show no measurable growth of the film")};
    case GrowthKnowledge::RateOnly:
        return {
            Text::tr("Growth: %1 ± %2 % per second")
                .arg(numberText(100 * growth.rate.value, 4), numberText(100 * growth.rate.off, 4)),
            Text::tr("The film still grew at the same rate in the last photo. Its growth limit "
                     "is therefore unknown, and the growth in the profile stays unchanged. "
                     "Take photos until the film stops growing")};
    case GrowthKnowledge::Both:
        break;
    }
    return {Text::tr("Growth: %1 ± %2 % per second when the dip begins; %3 ± %4 % in total after a "
                     "long time")
                .arg(numberText(100 * growth.rate.value, 4), numberText(100 * growth.rate.off, 4),
                     numberText(100 * growth.limit.value, 2),
                     numberText(100 * growth.limit.off, 2))};
}

double meanResidual(const FilmWatch& watch) {
    double sum = 0, count = 0;
    for (const WatchedPhoto& photo : watch.photos) {
        for (const FilmCorner& corner : photo.film.corners) {
            sum += corner.off.squaredNorm();
            count += 1;
        }
    }
    return std::sqrt(sum / std::max(count, 1.0));
}

// Adds the uncertainty of the card's and the film's rulers, each read to `rulerError`.
Measured withRulers(const Measured& swell, double rulerError) {
    const double share = std::sqrt(2.0) * rulerError / watchRuler;
    return {swell.value, std::hypot(swell.off, share * swell.value)};
}

} // namespace

FlatSettings flatSettings(const FilmOnWater& told, const std::optional<double>& focalLength,
                          const QString& where) {
    const auto scaleOf = [](const std::array<Millimetres, 2>& rulers) {
        return std::array{rulers[0].value() / watchRuler, rulers[1].value() / watchRuler};
    };
    FlatSettings settings;
    settings.cardScale = scaleOf(told.cardRulers);
    settings.filmScale = scaleOf(told.filmRulers);
    settings.cardAbove = told.cardAbove.value();
    if (told.lensK1 || told.lensK2) {
        settings.lens = Lens{told.lensK1.value_or(0), told.lensK2.value_or(0)};
    }
    settings.focalLength = focalLength;
    if (told.focalAs35) {
        settings.focalLength = told.focalAs35->value() / (std::hypot(36.0, 24.0) / 2);
    }
    if (settings.cardAbove != 0 && !settings.focalLength) {
        throw Error(
            Text::tr(
                "The photo does not contain the camera's focal length, which is needed because the "
                "card lies above the film; give the 35 mm equivalent focal length"),
            where);
    }
    return settings;
}

FlatFilm measureFlatFilm(const QImage& photo, const FlatSettings& settings, const QString& where) {
    const std::vector<SeenBoard> boards = findBoards(photo);
    const SeenBoard* film = boardOf(boards, BoardKind::Film);
    const SeenBoard* card = boardOf(boards, BoardKind::Card);
    if (!film) {
        throw Error(
            card ? Text::tr("Too little of the film's chessboard is visible; photograph all of it, "
                            "sharp and without glare")
                 : Text::tr("No chessboard for measuring the film is visible; print one with "
                            "“dipwright-cli calibrate film” and photograph all of it, sharp and "
                            "without glare"),
            where);
    }
    if (!card) {
        throw Error(Text::tr("The card that gives the scale is not visible; print it with "
                             "“dipwright-cli calibrate card” and lay it beside the film"),
                    where);
    }
    requireUpright(*film, where);
    requireUpright(*card, where);
    return fitFlatFilm(*film, *card, photo.size(), settings, where);
}

FilmWatch evaluatedFilmWatch(std::vector<WatchedPhoto> photos, double begin, double rulerError) {
    requireDifferent(photos);
    FilmWatch watch{std::move(photos), {}, begin, rulerError};
    std::stable_sort(watch.photos.begin(), watch.photos.end(),
                     [&](const WatchedPhoto& a, const WatchedPhoto& b) {
                         return secondsOf(a, begin) < secondsOf(b, begin);
                     });
    constexpr double bySaturation = 0.25; // the law of growth holds that far beyond the photos
    requireBeginSeen(watch, bySaturation);
    std::vector<SwellAt> moments;
    for (const WatchedPhoto& photo : watch.photos) {
        moments.push_back({secondsOf(photo, begin), photo.film.swellX, photo.film.swellY});
    }
    watch.growth = fitGrowth(moments, begin, watch.photos.front().where);
    if (watch.growth.known != GrowthKnowledge::Both) {
        requireBeginSeen(watch, 0); // the film may have grown at another rate
    }
    watch.growth.swellX = withRulers(watch.growth.swellX, rulerError);
    watch.growth.swellY = withRulers(watch.growth.swellY, rulerError);
    return watch;
}

FilmProfile withMeasurement(FilmProfile profile, const FilmWatch& watch, const WatchNotes& notes) {
    const GrowthFit& growth = watch.growth;
    Profile result = profile;
    // Rounds to the digits that photos can determine.
    const auto digits = [](const Measured& measured, int decimals) {
        return QString::number(measured.value, 'f', decimals);
    };
    setByPath(result, QStringLiteral("swell"),
              digits(growth.swellX, 5) + u'x' + digits(growth.swellY, 5));
    const bool growthKnown =
        growth.known == GrowthKnowledge::Both || growth.known == GrowthKnowledge::None;
    if (growthKnown) {
        setByPath(result, QStringLiteral("growth_per_s"), digits(growth.rate, 7));
        setByPath(result, QStringLiteral("growth_limit"), digits(growth.limit, 6));
    }
    auto& film = std::get<FilmProfile>(result);
    if (!notes.lot.isEmpty()) {
        film.lot = notes.lot;
    }
    QStringList photos;
    for (const WatchedPhoto& photo : watch.photos) {
        photos << photo.sha256;
    }
    constexpr qsizetype mostPhotos = 60;
    film.measured = {notes.date,
                     notes.waterTemperature,
                     photos.mid(0, mostPhotos).join(u' '),
                     meanResidual(watch),
                     film.swellX,
                     film.swellY,
                     growth.swellX.off,
                     growth.swellY.off,
                     growthKnown ? std::optional(film.growthRate) : std::nullopt,
                     growthKnown ? std::optional(film.growthLimit) : std::nullopt,
                     film.measured.relaxationTime};
    return film;
}

QStringList watchSentences(const FilmWatch& watch) {
    QStringList sentences{Text::tr("Swell when the dip begins: along X %1, along Z %2")
                              .arg(swellText(watch.growth.swellX), swellText(watch.growth.swellY))};
    sentences << growthSentences(watch);
    double uneven = 0;
    for (const WatchedPhoto& photo : watch.photos) {
        uneven = std::max(uneven, photo.film.unevennessMillimetres);
    }
    sentences << Text::tr("Unevenness: 95 % of the film lies within %1 mm of where an evenly "
                          "swollen film would lie")
                     .arg(numberText(uneven, 3));
    return sentences;
}

} // namespace dipwright

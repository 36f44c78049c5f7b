#include "accuracy/verdict/FinerFilm.h"
#include "base/NumberText.h"

#include <QCoreApplication>
#include <QLocale>
#include <array>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

using Kind = VerdictReason::Kind;

QString percent(double share, int moreDecimals = 0) {
    return numberText(100 * share, (share < 0.1 ? 1 : 0) + moreDecimals);
}

// Returns value and limit of a reason in per cent, with enough decimals to show that they differ.
std::array<QString, 2> percents(const VerdictReason& reason) {
    constexpr int most = 3;
    int more = 0;
    while (more < most && reason.value != reason.limit &&
           percent(reason.value, more) == percent(reason.limit, more)) {
        ++more;
    }
    return {percent(reason.value, more), percent(reason.limit, more)};
}

QString errorText(const VerdictReason& reason, const LengthText& length) {
    switch (reason.kind) {
    case Kind::NotAsked:
        return Text::tr("The numerical error was not estimated.");
    case Kind::NotCompared:
        return Text::tr("The numerical error could not be estimated: %1.").arg(reason.text);
    case Kind::NothingAlike:
        return Text::tr(
            "The numerical error is not known, because this dip and the coarser dips for "
            "comparison paint no place in common. Set smaller cells (Film > Resolution).");
    case Kind::Certain:
        return Text::tr("Numerical error: at most %1 on 95 % of the painted area.")
            .arg(length(reason.value));
    case Kind::OffBy:
        if (reason.most == 0) {
            return Text::tr("Numerical error: at most %1 on 95 % of the painted area; the limit is "
                            "%2. Set more points (Film > Points), or turn the part.")
                .arg(length(reason.value), length(reason.limit));
        }
        if (cellToSet(reason.most) >= leastFilmCell) {
            return Text::tr(
                       "Numerical error: at most %1 on 95 % of the painted area; the limit "
                       "is %2. Set cells of %3 (Film > Resolution > Cell size), or turn the part.")
                .arg(length(reason.value), length(reason.limit), length(cellToSet(reason.most)));
        }
        return Text::tr("Numerical error: at most %1 on 95 % of the painted area; the limit is %2. "
                        "Turn the part.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::OffByMuch:
        return Text::tr("Numerical error: at most %1 on 95 % of the painted area; the limit is %2. "
                        "Turn the part, or set much smaller cells or more points "
                        "(Film > Resolution).")
            .arg(length(reason.value), length(reason.limit));
    case Kind::Step:
        return Text::tr("Numerical error: at most %1 on 95 % of the painted area; the limit is %2. "
                        "Most of this error comes from the length of the steps: set a smaller step "
                        "(Dipping > Step).")
            .arg(length(reason.value), length(reason.limit));
    case Kind::FarOffPlaces:
        return Text::tr("The numerical error may exceed %2 on %1 % of the painted area. Check the "
                        "places that the program lists.")
            .arg(percent(reason.value), length(reason.limit));
    case Kind::UnknownError:
        return Text::tr("The numerical error of %1 % of the painted area is unknown, because film "
                        "with larger cells or steps does not reach it; the limit is %2 %. Set "
                        "smaller cells (Film > Resolution), or turn the part.")
            .arg(percents(reason)[0], percents(reason)[1]);
    case Kind::Border:
        return Text::tr("The border of the painted area is uncertain: with other cells or steps, "
                        "%1 % of the part changes between painted and unpainted. Set smaller cells "
                        "(Film > Resolution).")
            .arg(percent(reason.value));
    case Kind::Unbalanced:
        return Text::tr("In %1 steps of the dip, the film did not converge; the residual force was "
                        "up to %2 % of the elastic force. Set smaller cells (Film > Resolution).")
            .arg(QLocale().toString(qlonglong(reason.value)), percent(reason.most));
    case Kind::Refined:
        return Text::tr("This verdict is expected: the run repeats the dip with film cells of %1 "
                        "and judges it again.")
            .arg(length(reason.value));
    default:
        return {};
    }
}

QString paintText(const VerdictReason& reason, const LengthText& length) {
    const std::array<QString, 2> shares = percents(reason);
    switch (reason.kind) {
    case Kind::Unpainted:
        return Text::tr("The film does not paint the part. Check the model's unit, its place over "
                        "the film, and the depth of the dip.");
    case Kind::AllMasked:
        return Text::tr("Masks cover everything that the film would paint. Remove a mask, or turn "
                        "the part so that the film reaches other places.");
    case Kind::Air:
        return Text::tr("Trapped air keeps %1 % of the part dry; the limit is %2 %. Turn the part "
                        "so that the air escapes, or drill a vent hole. Vent holes narrower than "
                        "%3 may not be seen.")
            .arg(shares[0], shares[1], length(reason.most));
    case Kind::Pale:
        return Text::tr("%1 % of the painted area will be too pale; the limit is %2 %. The film "
                        "stretches more than the ink limit (Ink > Ink limit) can compensate. Turn "
                        "the part, or choose lighter colours.")
            .arg(shares[0], shares[1]);
    case Kind::Damaged:
        return Text::tr("The film tore or was released on %1 % of the painted area; the limit is "
                        "%2 %. Turn the part.")
            .arg(shares[0], shares[1]);
    case Kind::TornBare:
        return Text::tr(
                   "The film tears, and up to %1 % of the surface that it should paint stays "
                   "bare; the limit is %2 %. Turn the part, or use a film that stretches more.")
            .arg(shares[0], shares[1]);
    case Kind::FilmEdge:
        return Text::tr("Film that paints the part lies only %1 from the film's edge; at least %2 "
                        "are required. Use a larger film, or move the part to the film's centre.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::Rises:
        return Text::tr("The path lifts the part again by more than %1 % of its depth. Film that "
                        "the part carries out of the water is not simulated. Lower the part "
                        "without lifting it, or make a test dip.")
            .arg(shares[1]);
    case Kind::NoInk:
        return Text::tr("The sheet has no ink: its picture is white or transparent. Check the "
                        "texture and the artwork.");
    case Kind::Tank:
    case Kind::UnusualCorrection:
        return reason.text;
    case Kind::LostPlates:
    case Kind::CoveredPicture:
        return reason.text + QLatin1Char('.');
    default:
        return {};
    }
}

// Returns the text of a reason about the measured parts of a job.
QString builtText(const VerdictReason& reason) {
    if (reason.kind == Kind::UnknownDips) {
        return Text::tr("It is not known whether the measured parts by which the sheet is "
                        "corrected were dipped with the present pose, film, process and model. "
                        "Check this, or turn the correction off (As built).");
    }
    if (reason.kind != Kind::OtherDips) {
        return {};
    }
    return reason.value == reason.limit
               ? Text::tr("The sheet is not corrected, because all measured parts were dipped "
                          "with another pose, film, process or model. Measure a part of the "
                          "present dip, or turn the correction off (As built).")
               : Text::tr("The sheet is corrected without %1 of %2 measured parts, which were "
                          "dipped with another pose, film, process or model.")
                     .arg(reason.value)
                     .arg(reason.limit);
}

// Returns the text of a reason about all dips together.
QString jobText(const VerdictReason& reason, const LengthText& length) {
    const std::array<QString, 2> shares = percents(reason);
    switch (reason.kind) {
    case Kind::Unreached:
        return Text::tr("%1 % of the part is painted by neither dip; the limit is %2 %. Turn the "
                        "part in one of the dips.")
            .arg(shares[0], shares[1]);
    case Kind::Narrow:
        return Text::tr("%1 % of the overlap is too narrow; the limit is %2 %. A small placement "
                        "error of the second film shows there. Widen the overlap (Seam > Overlap), "
                        "or turn the part in one of the dips.")
            .arg(shares[0], shares[1]);
    case Kind::NarrowSeam:
        return Text::tr("Half of the overlap is at most %1 wide instead of %2, because the two "
                        "films do not overlap farther there.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::Misassigned:
        return Text::tr("%1 % of the area that seam marks give to one dip is painted by the other "
                        "dip. Film does not reach it there, or the marks are too small. Turn the "
                        "part, or change the marks.")
            .arg(shares[0]);
    case Kind::ZoneBare:
        return Text::tr(
                   "%1 % of the zone is not painted; the limit is %2 %. Turn the part so that film "
                   "reaches it.")
            .arg(shares[0], shares[1]);
    case Kind::BodyBare:
        return Text::tr(
                   "Only %1 % is painted; the limit is %2 %. Move or turn the body, dip deeper, or "
                   "set smaller cells if it is small. If it is to stay bare, mask it.")
            .arg(shares[0], shares[1]);
    case Kind::ZoneExceeded:
        return Text::tr("Handling and numerical error together: at most ±%1 on 95 % of the painted "
                        "area; the limit is ±%2. Reduce the largest cause that the results list "
                        "under Tolerances, or turn the part.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::NoPicture:
        return Text::tr("The model has no texture and no artwork: one plain colour is printed.");
    case Kind::HiddenInks:
        return Text::tr("Artwork hides the amounts of ink in the model's texture, so its colours "
                        "are printed instead. To print the amounts, put the artwork into the "
                        "texture.");
    case Kind::PaintedTwice:
        return Text::tr("Both dips print %1 % of the part at full strength, so these places become "
                        "too dark. Split the part between the dips (share.enabled).")
            .arg(shares[0]);
    case Kind::LittlePainted:
        return Text::tr("The dip paints only %1 % of the part; the limit is %2 %. Check the depth "
                        "and the pose.")
            .arg(shares[0], shares[1]);
    case Kind::FaintPicture:
        return Text::tr("On the part's own colour, the picture keeps only %1 % of its contrast; at "
                        "least %2 % are required. Coat the part, print a white layer under the "
                        "colours, or correct the part colour.")
            .arg(shares[0], shares[1]);
    case Kind::IncompleteModel:
    case Kind::ChangedModel:
        return Text::tr("Model: %1").arg(reason.text);
    case Kind::GuessedFilm:
        return Text::tr("The film's swell is guessed, not measured: the picture may be a few per "
                        "cent too large or too small. Measure the film.");
    case Kind::UnusualSpeed:
        return Text::tr(
                   "The dip speed is %1 mm/s; the usual range is %2 to %3 mm/s. Check this value.")
            .arg(QLocale().toString(reason.value), QLocale().toString(leastUsualSpeed),
                 QLocale().toString(mostUsualSpeed));
    case Kind::UnusualSlowSpeed:
        return Text::tr("%1: the slow speed is %2 mm/s; the usual range is %3 to %4 mm/s. Check "
                        "this value.")
            .arg(reason.text, QLocale().toString(reason.value), QLocale().toString(leastUsualSpeed),
                 QLocale().toString(mostUsualSpeed));
    case Kind::UnusualPathSpeed:
        return Text::tr("%1: the part moves at %2 mm/s on its path; the usual range is %3 to %4 "
                        "mm/s. Check the times of the poses.")
            .arg(reason.text, roundedText(reason.value, 2), QLocale().toString(leastUsualSpeed),
                 QLocale().toString(mostUsualSpeed));
    case Kind::UnusualGrowthRate:
        return Text::tr("The film grows by %1 % per second; more than %2 % is unusual. Check this "
                        "value.")
            .arg(shares[0], shares[1]);
    case Kind::UnusualGrowth:
        return Text::tr(
                   "The film grows by %1 % in all; more than %2 % is unusual. Check this value.")
            .arg(shares[0], shares[1]);
    case Kind::UnusualSwell:
        return Text::tr("The film's swell is %1; the usual range is %2 to %3. Check this value. If "
                        "it was measured, check that the rulers on the card and on the film have "
                        "the length that is printed beside them.")
            .arg(QLocale().toString(reason.value), QLocale().toString(leastUsualSwell),
                 QLocale().toString(mostUsualSwell));
    case Kind::ThinPlaces:
        return reason.text;
    case Kind::ExpiredFilm:
    case Kind::UnknownName:
    case Kind::Misplaced:
        return reason.text + QLatin1Char('.');
    default:
        return {};
    }
}

// Tells whether a second dip may help.
bool secondDipHelps(Kind kind) {
    return kind == Kind::OffBy || kind == Kind::OffByMuch || kind == Kind::Damaged ||
           kind == Kind::TornBare;
}

} // namespace

QString adviceText(Advice advice) {
    switch (advice) {
    case Advice::NotJudged:
        return Text::tr("Not judged");
    case Advice::Print:
        return Text::tr("Print it");
    case Advice::CheckFirst:
        return Text::tr("Check these places first");
    case Advice::DoNotPrint:
        return Text::tr("Do not print");
    }
    return {};
}

QString millimetres(double length) {
    const int decimals = length > 0 && length < 0.01 ? 4 : 2;
    return Text::tr("%1 mm").arg(numberText(length, decimals));
}

QString reasonText(const VerdictReason& reason, const LengthText& length) {
    QString text = errorText(reason, length) + paintText(reason, length) + jobText(reason, length) +
                   builtText(reason);
    if (reason.isOnlyDip && secondDipHelps(reason.kind)) {
        text += QLatin1Char(' ') + Text::tr("A second dip may help, too.");
    }
    if (reason.zone) {
        text = Text::tr("Zone %1: %2").arg(zoneName(*reason.zone), text);
    }
    return reason.body.isEmpty() ? text : Text::tr("%1: %2").arg(reason.body, text);
}

QString placeText(const PlaceToCheck& place, const LengthText& length, const LengthText& area) {
    return place.offBy > place.limit
               ? Text::tr("%1: numerical error up to %3; the limit is %2")
                     .arg(area(place.area), length(place.limit), length(place.offBy))
               : Text::tr("%1: the film did not converge there").arg(area(place.area));
}

QString verdictText(const QString& immersion, const Verdict& verdict) {
    QStringList sentences;
    for (const VerdictReason& reason : verdict.reasons) {
        sentences.append(reasonText(reason, millimetres));
    }
    return Text::tr("%1: %2. %3")
        .arg(immersion, adviceText(verdict.advice), sentences.join(QLatin1Char(' ')));
}

} // namespace dipwright

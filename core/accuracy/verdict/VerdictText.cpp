#include "accuracy/verdict/Verdict.h"

#include <QCoreApplication>
#include <QLocale>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

using Kind = VerdictReason::Kind;

QString percent(double share) {
    return QLocale().toString(100 * share, 'f', share < 0.1 ? 1 : 0);
}

// What is said of the numerical error.
QString errorText(const VerdictReason& reason, const LengthText& length) {
    switch (reason.kind) {
    case Kind::NotAsked:
        return Text::tr("The dip was not compared with coarser ones, so nothing is known of the "
                        "numerical error.");
    case Kind::NotCompared:
        return Text::tr("The dip could not be compared with coarser ones: %1.").arg(reason.text);
    case Kind::NothingAlike:
        return Text::tr("Nothing is painted alike by this dip and by coarser ones.");
    case Kind::Certain:
        return Text::tr("95 % of the sheet is off by %1 or less for numerical reasons.")
            .arg(length(reason.value));
    case Kind::OffBy:
        return (reason.most > 0
                    ? Text::tr("For numerical reasons 95 % of the sheet may be off by up to %1, "
                               "where %2 is allowed. Set Film > Cells to %3, turn the body, or dip "
                               "it twice.")
                          .arg(length(reason.value), length(reason.limit), length(reason.most))
                    : Text::tr("For numerical reasons 95 % of the sheet may be off by up to %1, "
                               "where %2 is allowed. Give the film more points (Film > Points), "
                               "turn the body, or dip it twice.")
                          .arg(length(reason.value), length(reason.limit)));
    case Kind::OffByMuch:
        return Text::tr("For numerical reasons 95 % of the sheet may be off by up to %1, where %2 "
                        "is allowed: too far to tell which cells would do. Turn the body, dip it "
                        "twice, or give the film smaller cells or more points (Film > Cells).")
            .arg(length(reason.value), length(reason.limit));
    case Kind::Step:
        return Text::tr("For numerical reasons 95 % of the sheet may be off by up to %1, where %2 "
                        "is allowed, and most of it comes from the steps. Set Dipping > Step to a "
                        "smaller value.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::FarOffPlaces:
        return Text::tr("For numerical reasons %1 % of the painted area may be off by more than "
                        "%2. Look at the places in the list.")
            .arg(percent(reason.value), length(reason.limit));
    case Kind::Border:
        return Text::tr("The paint's border is not certain: %1 % of the body is painted by finer "
                        "or coarser dips only. Give the film smaller cells (Film > Cells).")
            .arg(percent(reason.value));
    case Kind::Unbalanced:
        return Text::tr("%1 steps of the dip ended without equilibrium, with up to %2 % of the "
                        "elastic forces left. Give the film smaller cells (Film > Cells).")
            .arg(QLocale().toString(qlonglong(reason.value)), percent(reason.most));
    default:
        return {};
    }
}

// What is said of the paint on the body.
QString paintText(const VerdictReason& reason, const LengthText& length) {
    switch (reason.kind) {
    case Kind::Unpainted:
        return Text::tr("The film paints nothing of the body. Check the model's unit, its place "
                        "over the film, and how deep it goes.");
    case Kind::Air:
        return Text::tr("Trapped air keeps %1 % of the body dry, where %2 % is allowed: no film "
                        "reaches it. Turn the body so that the air can leave, or drill a hole for "
                        "it.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::Pale:
        return Text::tr("%1 % of the painted area will look too pale, where %2 % is allowed: the "
                        "film stretches more than Ink > Ink limit can make up for. Turn the body, "
                        "or choose lighter colours.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::Damaged:
        return Text::tr("On %1 % of the painted area the film tore or was pulled off the "
                        "body, where %2 % is allowed. Turn the body, or dip it twice.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::FilmEdge:
        return Text::tr("The painted film comes within %1 of the film's edge, where %2 is wanted. "
                        "Take a larger film, or move the body to the film's middle.")
            .arg(length(reason.value), length(reason.limit));
    default:
        return {};
    }
}

// What is said of the job as a whole.
QString jobText(const VerdictReason& reason, const LengthText& length) {
    switch (reason.kind) {
    case Kind::Unreached:
        return Text::tr("Neither dip reaches %1 % of the body, where %2 % is allowed. Turn one of "
                        "the poses.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::Narrow:
        return Text::tr("%1 % of the overlap of the dips is too narrow, where %2 % is allowed: the "
                        "second film shows there if it lies off. Widen Join > Overlap, or turn one "
                        "of the poses.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::ZoneBare:
        return Text::tr("%1 % is not painted, where %2 % is allowed. Turn the body so that film "
                        "reaches it.")
            .arg(percent(reason.value), percent(reason.limit));
    case Kind::ZoneExceeded:
        return Text::tr("What may be off at the tank and the numerical error together leave 95 % "
                        "only within ±%1, where ±%2 is allowed. Tighten what is listed as off, or "
                        "turn the body.")
            .arg(length(reason.value), length(reason.limit));
    case Kind::NoPicture:
        return Text::tr("The model has neither texture nor artwork: one plain colour is printed.");
    case Kind::ChangedModel:
        return Text::tr("Of the model's file: %1").arg(reason.text);
    case Kind::GuessedFilm:
        return Text::tr("The film's swell is guessed, not measured: the picture may come out a few "
                        "per cent too large or too small. Measure the film.");
    default:
        return {};
    }
}

} // namespace

QString adviceText(Advice advice) {
    switch (advice) {
    case Advice::NotJudged:
        return Text::tr("Not judged");
    case Advice::Print:
        return Text::tr("Print it");
    case Advice::LookFirst:
        return Text::tr("Check these points first");
    case Advice::DoNotPrint:
        return Text::tr("Do not print");
    }
    return {};
}

QString millimetres(double length) {
    return Text::tr("%1 mm").arg(QLocale().toString(length, 'f', 2));
}

QString reasonText(const VerdictReason& reason, const LengthText& length) {
    const QString text =
        errorText(reason, length) + paintText(reason, length) + jobText(reason, length);
    return reason.zone ? Text::tr("Zone %1: %2").arg(zoneName(*reason.zone), text) : text;
}

QString placeText(const UncertainPlace& place, const LengthText& length, const LengthText& area) {
    return Text::tr("%1 off by more than %2, by up to %3 at its worst point")
        .arg(area(place.area), length(place.limit), length(place.offBy));
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

#include "inspection/FitAdvice.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

constexpr double exchangeable = 0.8; // correlation past which two are named together
constexpr double moves = 0.02;       // mm: farther from their place, for all that may be off, than
                                     // none of the places goes

// As far as any of the places goes for so much of the unknown, mm.
double farthest(const PlacesNear& near, std::size_t unknown, double of) {
    double most = 0;
    for (std::size_t i = 0; i < near.places.size(); ++i) {
        if (near.places[i]) {
            most = std::max(most, near.slopes[i].col(Eigen::Index(unknown)).norm());
        }
    }
    return most * of;
}

QString advice(FitQuantity quantity) {
    switch (quantity) {
    case FitQuantity::ShiftX:
    case FitQuantity::ShiftZ:
    case FitQuantity::Turn:
        return Text::tr("give pairs of places all round the body");
    case FitQuantity::SwellX:
    case FitQuantity::SwellY:
    case FitQuantity::Relaxation:
        return Text::tr("photograph places near the body's lowest point and others high on its "
                        "sides, from more than one direction");
    case FitQuantity::Growth:
        return Text::tr("measure growth by photos of the floating film, “inspect film”");
    case FitQuantity::ContactDistance:
    case FitQuantity::Depth:
        break;
    }
    return Text::tr("measure it at the tank and leave it out of the fit");
}

} // namespace

QString notInThisFilm(FitQuantity quantity) {
    return quantity == FitQuantity::Growth
               ? Text::tr("The project's film does not grow, and so its growth cannot be fitted; "
                          "measure it by photos of the floating film, “inspect film”")
               : Text::tr("%1 changes nothing of this film and cannot be fitted")
                     .arg(fitQuantityText(quantity));
}

QString whyUnknown(const JointSolution& solution, const std::vector<FitUnknown>& unknowns,
                   const std::vector<bool>& isFree, std::size_t unknown, const PlacesNear& near,
                   bool hasBodyPairs) {
    const QString name = fitQuantityText(unknowns[unknown].quantity);
    if (farthest(near, unknown, fitScale(unknowns[unknown].quantity).mostOff) < moves) {
        return Text::tr("%1 moves none of the places, so that the pairs do not tell it; %2")
            .arg(name, advice(FitQuantity::Depth));
    }
    Eigen::Index row = 0, column = 0;
    double most = 0;
    std::size_t partner = unknown;
    for (std::size_t i = 0; i < unknown; ++i) {
        row += isFree[i] ? 1 : 0;
    }
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        if (!isFree[i]) {
            continue;
        }
        const double correlation = std::abs(solution.correlation(row, column++));
        if (i != unknown && correlation > most) {
            most = correlation;
            partner = i;
        }
    }
    const QLocale locale;
    if (solution.withCamera[row] > std::max(most, exchangeable)) {
        return Text::tr("The pairs cannot tell %1 from the camera's place (correlation %2); %3")
            .arg(name, locale.toString(solution.withCamera[row], 'f', 2),
                 hasBodyPairs ? Text::tr("give more pairs of the body itself, farther apart")
                              : Text::tr("give pairs of the body itself, its edges, corners or "
                                         "holes, with --pairs"));
    }
    if (most > exchangeable) {
        return Text::tr("The pairs cannot tell %1 from %2 (correlation %3); fit one of the two "
                        "alone, or %4")
            .arg(name, fitQuantityText(unknowns[partner].quantity), locale.toString(most, 'f', 2),
                 advice(unknowns[unknown].quantity));
    }
    return Text::tr("The pairs do not tell %1 well enough; give more of them, or %2")
        .arg(name, advice(unknowns[unknown].quantity));
}

QString whyUnsure(const JointSolution& solution, std::size_t unknown, const PlacesNear& near) {
    const double tenth = std::log(1.1), off = solution.off[Eigen::Index(unknown)];
    if (near.unknowns[unknown].quantity != FitQuantity::Relaxation || off <= tenth) {
        return {};
    }
    const QLocale locale;
    return Text::tr(
               "%1 is known to about %2 % only: a tenth of it moves none of the places seen by "
               "more than %3 mm; give more of them, or %4")
        .arg(fitQuantityText(FitQuantity::Relaxation),
             locale.toString(100 * std::expm1(off), 'f', 0),
             locale.toString(farthest(near, unknown, tenth), 'f', 3),
             advice(FitQuantity::Relaxation));
}

} // namespace dipwright

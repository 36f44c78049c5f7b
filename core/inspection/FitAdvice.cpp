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

constexpr double exchangeable = 0.8; // correlation above which two unknowns are named together
constexpr double leastEffect = 0.02; // mm: a smaller effect counts as none

// Returns the largest movement of a place, in mm, when the unknown changes by `of`.
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
        return Text::tr("give pairs of places all round the part");
    case FitQuantity::SwellX:
    case FitQuantity::SwellY:
    case FitQuantity::Relaxation:
        return Text::tr("photograph places near the part's lowest point and others high on its "
                        "sides, from more than one direction");
    case FitQuantity::Growth:
        return Text::tr("measure growth from photos of the floating film with “inspect film”");
    case FitQuantity::ContactDistance:
    case FitQuantity::Depth:
        break;
    }
    return Text::tr("measure it at the tank and leave it out of the fit");
}

} // namespace

QString hasNoEffectSentence(FitQuantity quantity) {
    return quantity == FitQuantity::Growth
               ? Text::tr("The project's film does not grow, so its growth cannot be fitted; "
                          "measure it from photos of the floating film with “inspect film”")
               : Text::tr("%1 has no effect on this film and cannot be fitted")
                     .arg(fitQuantityText(quantity));
}

QString whyNotDetermined(const JointSolution& solution, const std::vector<FitUnknown>& unknowns,
                         const std::vector<bool>& isFree, std::size_t unknown,
                         const PlacesNear& near, bool hasBodyPairs) {
    const QString name = fitQuantityText(unknowns[unknown].quantity);
    if (farthest(near, unknown, fitScale(unknowns[unknown].quantity).widestKnownInterval) <
        leastEffect) {
        return Text::tr("%1 moves none of the places, so the pairs do not determine it; %2")
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
    if (solution.cameraCorrelation[row] > std::max(most, exchangeable)) {
        return Text::tr(
                   "The pairs cannot separate %1 from the camera's position (correlation %2); %3")
            .arg(name, locale.toString(solution.cameraCorrelation[row], 'f', 2),
                 hasBodyPairs
                     ? Text::tr("give more pairs on the part itself, farther apart")
                     : Text::tr(
                           "give pairs on the part itself (edges, corners or holes) with --pairs"));
    }
    if (most > exchangeable) {
        return Text::tr("The pairs cannot separate %1 from %2 (correlation %3); fit only one of "
                        "the two, or %4")
            .arg(name, fitQuantityText(unknowns[partner].quantity), locale.toString(most, 'f', 2),
                 advice(unknowns[unknown].quantity));
    }
    return Text::tr("The pairs do not determine %1 well enough; give more pairs, or %2")
        .arg(name, advice(unknowns[unknown].quantity));
}

QString whyRelaxationIsUncertain(const JointSolution& solution, std::size_t unknown,
                                 const PlacesNear& near) {
    const double tenth = std::log(1.1), off = solution.off[Eigen::Index(unknown)];
    if (near.unknowns[unknown].quantity != FitQuantity::Relaxation || off <= tenth) {
        return {};
    }
    const QLocale locale;
    return Text::tr("%1 is uncertain by about %2 %: a change by 10 % moves none of the places by "
                    "more than %3 mm; give more pairs, or %4")
        .arg(fitQuantityText(FitQuantity::Relaxation),
             locale.toString(100 * std::expm1(off), 'f', 0),
             locale.toString(farthest(near, unknown, tenth), 'f', 3),
             advice(FitQuantity::Relaxation));
}

} // namespace dipwright

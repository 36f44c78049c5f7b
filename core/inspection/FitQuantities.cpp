#include "inspection/FitQuantities.h"

#include "base/Error.h"
#include "dip/BodyPath.h"
#include "dip/Pose.h"
#include "geometry/TriangleMesh.h"
#include "project/Project.h"

#include <QCoreApplication>

#include <QStringList>
#include <algorithm>
#include <array>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

constexpr double percent = 0.01;
// The relaxation time of viscous film is 0, but the fit needs a start above 0. It starts from this
// share of the dip's duration.
constexpr double viscousStart = 0.03;
// Relaxation times from 1/300 of the dip's duration to 300 times that duration are tried.
constexpr double farthestRelaxation = 300;

struct Described {
    const char* key;
    const char* text;
    const char* unit;
    FitScale scale;
};

const Described& described(FitQuantity quantity) {
    static const std::array<Described, fitQuantityCount> all{{
        {"shift_x",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Position of the part along X"),
         "mm",
         {0.3, 5, 2, 0.01}},
        {"shift_z",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Position of the part along Z"),
         "mm",
         {0.3, 5, 2, 0.01}},
        {"turn",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Rotation of the part about Y"),
         "°",
         {0.5, 5, 3, 0.02}},
        {"swell_x",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Swell along X"),
         "",
         {0.5, 5, 2, 0.01}},
        {"swell_y",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Swell along Z"),
         "",
         {0.5, 5, 2, 0.01}},
        {"relaxation",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Relaxation"),
         "s",
         {0.2, 1, 0.7, 0.01}},
        {"growth", QT_TRANSLATE_NOOP("dipwright::FilmFit", "Growth"), "1/s", {0.2, 1, 0.7, 0.01}},
        {"contact_distance",
         QT_TRANSLATE_NOOP("dipwright::FilmFit", "Contact distance"),
         "mm",
         {0.1, 0.3, 0.2, 0.005}},
        {"depth", QT_TRANSLATE_NOOP("dipwright::FilmFit", "Depth"), "mm", {0.5, 5, 3, 0.02}},
    }};
    return all.at(std::size_t(quantity));
}

void stretch(double& length, std::vector<double>& places, double factor) {
    length *= factor;
    for (double& place : places) {
        place *= factor;
    }
}

} // namespace

std::vector<FitQuantity> usualQuantities() {
    return {FitQuantity::ShiftX, FitQuantity::ShiftZ, FitQuantity::Turn,
            FitQuantity::SwellX, FitQuantity::SwellY, FitQuantity::Relaxation};
}

bool isOfDip(FitQuantity quantity) {
    return quantity == FitQuantity::ShiftX || quantity == FitQuantity::ShiftZ ||
           quantity == FitQuantity::Turn;
}

QString fitQuantityText(FitQuantity quantity) {
    return QCoreApplication::translate("dipwright::FilmFit", described(quantity).text);
}

QString fitQuantityUnit(FitQuantity quantity) {
    return QString::fromUtf8(described(quantity).unit);
}

QString fitQuantityKey(FitQuantity quantity) {
    return QString::fromLatin1(described(quantity).key);
}

FitQuantity fitQuantityOf(const QString& key) {
    QStringList keys;
    for (std::size_t number = 0; number < fitQuantityCount; ++number) {
        keys << fitQuantityKey(FitQuantity(number));
        if (keys.last() == key) {
            return FitQuantity(number);
        }
    }
    throw Error(
        Text::tr("“%1” cannot be fitted; choose from %2").arg(key, keys.join(QStringLiteral(", "))),
        {});
}

FitScale fitScale(FitQuantity quantity) {
    return described(quantity).scale;
}

FittedDips::FittedDips(const Project& project, std::vector<solver::DipSetup> setups)
    : project_(project), setups_(std::move(setups)),
      relaxation_(project.film.relaxationTime.value()) {
    if (!std::isfinite(relaxation_)) {
        relaxation_ = duration();
    } else if (!(relaxation_ > 0)) {
        relaxation_ = viscousStart * duration();
    }
}

double FittedDips::duration() const {
    const solver::DipSetup& first = setups_.front();
    return first.path.isStraightDown() ? first.motion.travel / first.motion.speed
                                       : first.path.poses.back().seconds;
}

bool FittedDips::matters(FitQuantity quantity) const {
    const solver::Settings& settings = setups_.front().settings;
    const bool isProduction = solver::isProductionFilm(settings.lattice, settings.support);
    switch (quantity) {
    case FitQuantity::Relaxation:
        return isProduction;
    case FitQuantity::Growth:
        return isProduction && settings.growthRate > 0 && settings.growthLimit > 0;
    default:
        return true;
    }
}

double FittedDips::within(FitQuantity quantity, double unknown) const {
    switch (quantity) {
    case FitQuantity::Relaxation:
        return std::clamp(unknown, std::log(duration() / farthestRelaxation / relaxation_),
                          std::log(duration() * farthestRelaxation / relaxation_));
    case FitQuantity::ContactDistance:
        return std::max(unknown, -project_.film.contactDistance.value());
    case FitQuantity::SwellX:
    case FitQuantity::SwellY:
        return std::clamp(unknown, -30.0, 50.0);
    default:
        return unknown;
    }
}

ChangedDip FittedDips::dip(int dip, const std::vector<FitUnknown>& unknowns,
                           const std::vector<double>& values) const {
    solver::DipSetup own = setup(dip);
    DipChange change = DipChange::Zero();
    for (std::size_t i = 0; i < unknowns.size(); ++i) {
        const double value = values[i];
        if (isOfDip(unknowns[i].quantity) && unknowns[i].dip != dip) {
            continue;
        }
        switch (unknowns[i].quantity) {
        case FitQuantity::ShiftX:
            of(change, Freedom::X) = value;
            break;
        case FitQuantity::ShiftZ:
            of(change, Freedom::Z) = value;
            break;
        case FitQuantity::Turn:
            of(change, Freedom::TurnY) = value;
            break;
        case FitQuantity::SwellX:
            stretch(own.film.width, own.film.columnPlaces, 1 + percent * value);
            break;
        case FitQuantity::SwellY:
            stretch(own.film.depth, own.film.rowPlaces, 1 + percent * value);
            break;
        case FitQuantity::Relaxation:
            own.settings.relaxationTime = relaxation_ * std::exp(value);
            break;
        case FitQuantity::Growth:
            own.settings.growthRate *= std::exp(value);
            break;
        case FitQuantity::ContactDistance:
            own.settings.contactDistance += value;
            break;
        case FitQuantity::Depth:
            of(change, Freedom::WaterLevel) = value;
            break;
        }
    }
    // On a path, the depth changes the motion, and not only its end.
    const double deeper = of(change, Freedom::WaterLevel);
    if (!own.path.isStraightDown()) {
        of(change, Freedom::WaterLevel) = 0;
    }
    ChangedDip result = changed(
        {*project_.model, project_.immersions[std::size_t(dip)], own, project_.process}, change);
    if (!own.path.isStraightDown()) {
        planPath(result, deeper);
    }
    return result;
}

double FittedDips::depth(const Immersion& immersion) const {
    const TriangleMesh& mesh = project_.model->mesh;
    const BoundingBox box = boundingBox(transformed(mesh, poseTransform(mesh, immersion)));
    return dipDepth(project_.process, double(box.sizes().y()));
}

void FittedDips::planPath(ChangedDip& dip, double deeper) const {
    const TriangleMesh& mesh = project_.model->mesh;
    const TriangleMesh posed = transformed(mesh, poseTransform(mesh, dip.immersion));
    ProcessSettings process = project_.process;
    if (deeper != 0) {
        process.depth = Millimetres(std::max(depth(dip.immersion) + deeper, 0.0));
    }
    dip.setup.path = pathOfModel(bodyPath(posed, dip.immersion, process),
                                 bodyTransform(mesh, dip.immersion), dip.immersion);
    dip.setup.motion.travel = dip.setup.path.poses.back().travelled;
}

double FittedDips::told(const FitUnknown& unknown, double value) const {
    switch (unknown.quantity) {
    case FitQuantity::SwellX:
    case FitQuantity::SwellY:
        return before(unknown) * (1 + percent * value);
    case FitQuantity::Relaxation:
        return relaxation_ * std::exp(value);
    case FitQuantity::Growth:
        return before(unknown) * std::exp(value);
    default:
        return before(unknown) + value;
    }
}

double FittedDips::before(const FitUnknown& unknown) const {
    const Immersion& immersion = project_.immersions[std::size_t(unknown.dip)];
    switch (unknown.quantity) {
    case FitQuantity::ShiftX:
        return immersion.offset[0].value();
    case FitQuantity::ShiftZ:
        return immersion.offset[1].value();
    case FitQuantity::Turn:
        break;
    case FitQuantity::SwellX:
        return project_.film.swellX;
    case FitQuantity::SwellY:
        return project_.film.swellY;
    case FitQuantity::Relaxation:
        return project_.film.relaxationTime.value();
    case FitQuantity::Growth:
        return project_.film.growthRate;
    case FitQuantity::ContactDistance:
        return project_.film.contactDistance.value();
    case FitQuantity::Depth:
        return setups_.front().path.isStraightDown() ? setups_.front().motion.travel - startHeight
                                                     : depth(project_.immersions.front());
    }
    return 0;
}

} // namespace dipwright

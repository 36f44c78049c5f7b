#include "inspection/SimulatedPlaces.h"

#include "accuracy/tolerance/ChangedDips.h"
#include "base/Error.h"
#include "dip/Dip.h"
#include "project/Project.h"

#include <QCoreApplication>

#include <set>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

std::vector<std::shared_ptr<const PosedBody>> bodiesOf(const Project& project) {
    std::vector<std::shared_ptr<const PosedBody>> bodies;
    for (const Immersion& immersion : project.immersions) {
        bodies.push_back(std::make_shared<const PosedBody>(
            posedBody(project.model->mesh, immersion, project.process)));
    }
    return bodies;
}

std::vector<FilledField> fieldsOf(const Project& project,
                                  const std::vector<std::shared_ptr<const PosedBody>>& bodies,
                                  const DistanceField& own, const Progress& progress) {
    std::vector<FilledField> fields;
    for (std::size_t dip = 0; dip < bodies.size(); ++dip) {
        const solver::FilmGrid grid =
            dipGrid(*bodies[dip], project.immersions[dip], project.film, project.process);
        fields.emplace_back(*bodies[dip], fieldForFilm(own, grid, progress));
    }
    return fields;
}

std::vector<solver::DipSetup>
setupsOf(const Project& project, const std::vector<FilledField>& fields,
         const std::vector<std::shared_ptr<const PosedBody>>& bodies) {
    std::vector<solver::DipSetup> setups;
    for (std::size_t dip = 0; dip < bodies.size(); ++dip) {
        setups.push_back(dipSetup(*bodies[dip], fields[dip], project.immersions[dip], project.film,
                                  project.process));
    }
    return setups;
}

} // namespace

SimulatedPlaces::SimulatedPlaces(const Project& project, const DistanceField& field,
                                 const std::vector<PrintedPlace>& printed,
                                 const solver::SolverModule& module, const QString& where,
                                 const Progress& progress)
    : project_(project), printed_(printed), module_(module), bodies_(bodiesOf(project)),
      fields_(fieldsOf(project, bodies_, field, progress)),
      dips_(project, setupsOf(project, fields_, bodies_)) {
    for (const PrintedPlace& place : printed) {
        if (place.dip < 0 || place.dip >= int(project.immersions.size())) {
            throw Error(
                Text::tr("A place belongs to dip %1, but the number of dips in the project is %2")
                    .arg(place.dip + 1)
                    .arg(project.immersions.size()),
                where);
        }
    }
}

PlacesNear SimulatedPlaces::near(const std::vector<FitUnknown>& unknowns,
                                 const Eigen::VectorXd& centre, const std::vector<bool>& isFree,
                                 const Progress& progress) {
    std::set<int> printing;
    for (const PrintedPlace& place : printed_) {
        printing.insert(place.dip);
    }
    const std::vector<double> values(centre.begin(), centre.end());
    std::vector<Tried> tried;
    for (const int dip : printing) {
        tried.push_back({dip, values});
    }
    struct Side {
        std::size_t unknown = 0;
        double value = 0;
    };
    std::vector<Side> sides(tried.size());
    for (std::size_t unknown = 0; unknown < unknowns.size(); ++unknown) {
        const FitQuantity quantity = unknowns[unknown].quantity;
        for (const double way : {1.0, -1.0}) {
            const double moved =
                dips_.within(quantity, values[unknown] + way * fitScale(quantity).step);
            for (const int dip : printing) {
                const bool isMoved = !isOfDip(quantity) || unknowns[unknown].dip == dip;
                if (isFree[unknown] && isMoved && moved != values[unknown]) {
                    tried.push_back({dip, values});
                    tried.back().values[unknown] = moved;
                    sides.push_back({unknown, moved});
                }
            }
        }
    }
    const std::vector<Places> found = simulate(unknowns, tried, progress);
    PlacesNear near{unknowns, centre, Places(printed_.size()), {}};
    near.slopes.assign(printed_.size(), Eigen::Matrix3Xd::Zero(3, Eigen::Index(unknowns.size())));
    for (std::size_t i = 0; i < printed_.size(); ++i) {
        for (std::size_t number = 0; number < printing.size(); ++number) {
            if (tried[number].dip == printed_[i].dip) {
                near.places[i] = found[number][i];
            }
        }
        // A slope comes from the simulations on both sides of the centre. If one side is missing,
        // the centre replaces it.
        for (std::size_t unknown = 0; near.places[i] && unknown < unknowns.size(); ++unknown) {
            std::vector<std::pair<double, Eigen::Vector3d>> known;
            for (std::size_t number = printing.size(); number < tried.size(); ++number) {
                if (sides[number].unknown == unknown && tried[number].dip == printed_[i].dip &&
                    found[number][i]) {
                    known.emplace_back(sides[number].value, *found[number][i]);
                }
            }
            if (known.size() == 1) {
                known.emplace_back(values[unknown], *near.places[i]);
            }
            if (known.size() == 2) {
                near.slopes[i].col(Eigen::Index(unknown)) =
                    (known[0].second - known[1].second) / (known[0].first - known[1].first);
            }
        }
    }
    return near;
}

std::vector<SimulatedPlaces::Places>
SimulatedPlaces::simulate(const std::vector<FitUnknown>& unknowns, const std::vector<Tried>& tried,
                          const Progress& progress) {
    std::vector<Places> found(tried.size());
    for (std::size_t dip = 0; dip < bodies_.size(); ++dip) {
        std::vector<std::size_t> own;
        std::vector<ChangedDip> changed;
        for (std::size_t number = 0; number < tried.size(); ++number) {
            if (tried[number].dip == int(dip)) {
                own.push_back(number);
                changed.push_back(dips_.dip(int(dip), unknowns, tried[number].values));
            }
        }
        const double begin = double(dip) / double(bodies_.size());
        const DippedBody body{*project_.model, project_.immersions[dip], project_.process,
                              bodies_[dip]};
        layDips(body, changed, module_, progress.part(begin, begin + 1 / double(bodies_.size())),
                [&](std::size_t number, const std::shared_ptr<const LaidFilm>& laid) {
                    found[own[number]] = placesOn(*laid, int(dip));
                });
    }
    dipsDone_ += int(tried.size());
    return found;
}

SimulatedPlaces::Places SimulatedPlaces::placesOn(const LaidFilm& laid, int dip) const {
    const Eigen::Array2d swell(laid.film().grid.width / project_.film.width.value(),
                               laid.film().grid.depth / project_.film.height.value());
    const Eigen::Isometry3d toModel = laid.body().modelToPose.inverse();
    Places places(printed_.size());
    for (std::size_t i = 0; i < printed_.size(); ++i) {
        if (printed_[i].dip != dip) {
            continue;
        }
        const Eigen::Vector2d rest = printed_[i].sheet.array() * swell;
        const std::optional<FilmPlace> place = laid.flat(rest.cast<float>());
        // Leaves out places outside the painted area. Also leaves out marked film, because its
        // place follows from a law that was not measured.
        const bool isPaintedUnmarked = place && laid.contact().painted[place->triangle] != 0 &&
                                       laid.marks(place->triangle) == 0;
        const auto lies = isPaintedUnmarked ? laid.onBody(*place) : std::nullopt;
        if (lies) {
            places[i] = toModel * lies->cast<double>();
        }
    }
    return places;
}

} // namespace dipwright

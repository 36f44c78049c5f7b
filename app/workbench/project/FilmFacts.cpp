#include "workbench/project/FilmFacts.h"

#include "base/Error.h"
#include "dip/FilmUnderBody.h"
#include "workbench/project/FilmMeasured.h"
#include "workbench/widgets/Units.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FilmFacts)
};

// Returns the expected time of a dip with `points` film points, scaled from the measured time of
// another dip.
double expectedSeconds(const DippedFilm& measured, std::size_t points) {
    const double ratio = double(points) / double(measured.grid.pointCount());
    return measured.wallSeconds * std::pow(ratio, 1.5);
}

} // namespace

QString FilmFacts::text(const Project& project, const JobResult* result, LengthUnit unit) {
    if (model_ != project.model) {
        model_ = project.model;
        query_ = std::make_unique<const SurfaceQuery>(model_->mesh);
    }
    QStringList lines;
    for (std::size_t number = 0; number < project.immersions.size(); ++number) {
        const Immersion& immersion = project.immersions[number];
        const Underside underside = undersideOf(model_->mesh, *query_, immersion, project.process);
        solver::FilmGrid grid;
        try {
            grid = filmUnderBody(project.film, underside, immersion.offset);
        } catch (const Error& error) {
            return error.sentence();
        }
        QString line = Text::tr("%1: cells of %2, %3 × %4 points")
                           .arg(immersion.name, shownLength(grid.leastSpacing(), unit))
                           .arg(grid.columns)
                           .arg(grid.rows);
        if (result && number < result->immersions.size()) {
            const DippedFilm& measured = result->immersions[number].laid->film();
            line = Text::tr("%1, simulation time about %2 s")
                       .arg(line, QLocale().toString(expectedSeconds(measured, grid.pointCount()),
                                                     'g', 2));
        }
        lines.append(line);
    }
    lines.append(measuredText(project));
    return lines.join(QLatin1Char('\n'));
}

} // namespace dipwright

#include "pipeline/LawChanges.h"

#include "base/Error.h"
#include "dip/Dip.h"
#include "project/Schema.h"

#include <QCoreApplication>

#include <algorithm>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Pipeline)
};

const QStringList& lawSettings() {
    static const QStringList settings{
        QStringLiteral("process.overhang_deg"), QStringLiteral("film.grip_fade_deg"),
        QStringLiteral("process.tear_stretch"), QStringLiteral("film.gathering_stretch")};
    return settings;
}

const Field<Project>& fieldOf(const QString& setting) {
    const std::vector<Field<Project>>& fields = projectFields();
    return *std::find_if(fields.begin(), fields.end(),
                         [&](const Field<Project>& field) { return field.path == setting; });
}

// Returns the variation to either side: a share of the value, or of the default if the value is 0.
double variation(const Field<Project>& law, double value) {
    return lawVariation * (value != 0 ? value : law.get(Project{}).toDouble());
}

// Returns the value within the field's range, with as many digits as a person would write: 0.96
// instead of 0.9600000000000001.
double withinRange(const Field<Project>& field, double value) {
    constexpr int digits = 10;
    return std::clamp(QString::number(value, 'g', digits).toDouble(), field.rule.minimum,
                      field.rule.maximum);
}

Project withValue(Project project, const Field<Project>& field, double value) {
    setField(project, field, QJsonValue(value));
    return project;
}

} // namespace

std::vector<LawChange> lawChanges(const Project& project, const Immersion& immersion,
                                  const std::shared_ptr<const PosedBody>& body, const LaidFilm& own,
                                  const DistanceField& field, const solver::SolverModule& module,
                                  const CancelToken& cancelToken) {
    const FilledField filled(*body,
                             fieldForFilm(field, own.film().grid, Progress{nullptr, cancelToken}));
    std::vector<LawChange> changes;
    std::vector<Project> jobs; // two for each law: with a smaller and with a larger value
    std::vector<solver::BatchItem> dips;
    for (const QString& setting : lawSettings()) {
        const Field<Project>& law = fieldOf(setting);
        const double value = law.get(project).toDouble();
        LawChange change;
        change.setting = setting;
        change.value = value;
        change.less = withinRange(law, value - variation(law, value));
        change.more = withinRange(law, value + variation(law, value));
        for (const double other : {change.less, change.more}) {
            jobs.push_back(withValue(project, law, other));
            const Project& job = jobs.back();
            dips.emplace_back().setup = dipSetup(*body, filled, immersion, job.film, job.process);
        }
        changes.push_back(change);
    }
    simulateDips(dips, module, [&] { return cancelToken.isCancelled(); });
    const auto laid = [&](std::size_t dip) {
        cancelToken.throwIfCancelled();
        DippedFilm film = dippedFilm(dips[dip], immersion);
        if (!isStable(film, dips[dip].setup.motion.travel)) {
            throw Error(Text::tr("The simulation became unstable when this setting was varied; "
                                 "give the film smaller cells or more points"),
                        changes[dip / 2].setting);
        }
        return layFilm(body, std::move(film), jobs[dip].process);
    };
    for (std::size_t law = 0; law < changes.size(); ++law) {
        measureLaw(changes[law], own, *laid(2 * law), *laid(2 * law + 1));
    }
    return changes;
}

} // namespace dipwright

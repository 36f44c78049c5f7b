#include "project/Profiles.h"

#include "base/Error.h"
#include "project/FilmSizes.h"
#include "project/Project.h"

#include <QCoreApplication>
#include <QDate>
#include <QStringList>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Profiles)
};

const QStringList kindNames{QStringLiteral("printer"), QStringLiteral("film"),
                            QStringLiteral("tank")};

void apply(Project& project, const PrinterProfile& printer) {
    project.sheet.resolution = printer.resolution;
    project.ink.limit = printer.inkLimit;
    project.profiles.printer = printer;
}

void apply(Project& project, const FilmProfile& film) {
    resizeFilm(project.film, film.width, film.height);
    project.film.behaviour() = film.behaviour();
    project.ink.law = film.ink;
    project.process.overhang = film.overhang.value_or(project.process.overhang);
    project.process.tearStretch = film.tearStretch.value_or(project.process.tearStretch);
    project.profiles.film = film;
}

void apply(Project& project, const TankProfile& tank) {
    project.film.edges = tank.barriers;
    project.profiles.tank = tank;
}

} // namespace

QString profileKindName(ProfileKind kind) {
    return kindNames.at(int(kind));
}

ProfileKind profileKindOf(const QString& name) {
    const auto index = kindNames.indexOf(name);
    if (index < 0) {
        throw Error(Text::tr("There is no such kind of profile; use printer, film or tank"), name);
    }
    return ProfileKind(index);
}

ProfileKind kindOf(const Profile& profile) {
    return ProfileKind(profile.index());
}

const QString& nameOf(const Profile& profile) {
    return std::visit([](const auto& value) -> const QString& { return value.name; }, profile);
}

void applyProfile(Project& project, const Profile& profile) {
    std::visit([&](const auto& value) { apply(project, value); }, profile);
}

FilmProfile filmProfileOf(const Project& project) {
    FilmProfile film = project.profiles.film.value_or(FilmProfile{});
    film.width = project.film.width;
    film.height = project.film.height;
    film.behaviour() = project.film.behaviour();
    film.ink = project.ink.law;
    return film;
}

bool hasMeasuredSwell(const FilmSettings& film, const ProjectProfiles& profiles) {
    const auto& known = profiles.film;
    return known && !known->measured.date.isEmpty() && film.swellX == known->measured.swellX &&
           film.swellY == known->measured.swellY;
}

bool hasMeasuredGrowth(const FilmSettings& film, const ProjectProfiles& profiles) {
    const auto& known = profiles.film;
    return known && !known->measured.date.isEmpty() &&
           film.growthRate == known->measured.growthRate &&
           film.growthLimit == known->measured.growthLimit;
}

bool hasMeasuredRelaxation(const FilmSettings& film, const ProjectProfiles& profiles) {
    const auto& known = profiles.film;
    return known && !known->measured.date.isEmpty() &&
           film.relaxationTime.value() == known->measured.relaxationTime;
}

bool hasMeasuredInk(const InkSettings& ink, const ProjectProfiles& profiles) {
    const auto& known = profiles.film;
    return known && !known->ink.tones.empty() && ink.law == known->ink;
}

QString expiryWarning(const std::optional<FilmProfile>& film) {
    const QDate expiry = film ? QDate::fromString(film->expiry, Qt::ISODate) : QDate();
    if (!expiry.isValid() || QDate::currentDate() <= expiry) {
        return {};
    }
    const QString name =
        film->lot.isEmpty() ? film->name : Text::tr("%1, lot %2,").arg(film->name, film->lot);
    return Text::tr("The film %1 expired on %2; use a new lot, or test this lot first")
        .arg(name, film->expiry);
}

} // namespace dipwright

#include "project/DipKeys.h"

#include "base/Sha256.h"
#include "model/ModelHash.h"
#include "project/Project.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>

namespace dipwright {
namespace {

constexpr qsizetype keyLetters = 16;

// Sets values that have no effect to their defaults.
void leaveOutUnused(FilmSettings& film, ProcessSettings& process) {
    if (!grows(film)) {
        film.growthRate = FilmSettings().growthRate;
        film.growthLimit = FilmSettings().growthLimit;
    }
    if (process.depth) {
        process.margin = ProcessSettings().margin;
    }
    if (solver::isProductionFilm(film.lattice, film.support)) {
        process.selfContact = ProcessSettings().selfContact;
    }
}

// Returns the same direction in 0° … 360°.
Degrees wrapped(Degrees angle) {
    return angle - Degrees(360 * std::floor(angle.value() / 360));
}

// Sets values that a path of its kind does not use to their defaults, and its heading to 0° … 360°.
void leaveOutUnused(DipPath& path) {
    const DipPath usual;
    const bool isPoses = path.kind == PathKind::Poses;
    if (isPoses || path.kind == PathKind::Straight) {
        path.angle = usual.angle;
        if (path.waterSpeed == usual.waterSpeed) {
            path.heading = usual.heading;
        }
    }
    path.heading = wrapped(path.heading);
    if (path.kind != PathKind::Tilt) {
        path.levelDepth = usual.levelDepth;
    }
    if (path.kind != PathKind::Roll) {
        path.rollRadius = usual.rollRadius;
    }
    if (isPoses) {
        path.turn = usual.turn;
        path.slowSpeed = usual.slowSpeed;
    } else {
        path.keys = usual.keys;
    }
    if (!path.slowSpeed) {
        path.slowWay = usual.slowWay;
    }
}

// Returns the settings of film and process that every dip depends on.
QJsonObject filmAndProcess(const Project& project) {
    Project part;
    part.film = project.film;
    part.process = project.process;
    leaveOutUnused(part.film, part.process);
    const QJsonObject counted = countedSettings(part);
    QJsonObject film = counted[QLatin1String("film")].toObject();
    for (const char* key :
         {"preset", "points", "cell_mm", "resolution", "work_million", "wanted_error_mm"}) {
        film.remove(QLatin1String(key));
    }
    QJsonObject process = counted[QLatin1String("process")].toObject();
    for (const char* key :
         {"solver", "time_step_s", "iterations", "relaxation", "contact_travel_cells"}) {
        process.remove(QLatin1String(key));
    }
    return {{QStringLiteral("film"), film}, {QStringLiteral("process"), process}};
}

} // namespace

QStringList dipKeys(const Project& project) {
    QJsonObject all = filmAndProcess(project);
    all[QLatin1String("mesh")] = meshHash(project.model);
    QStringList keys;
    for (Immersion immersion : project.immersions) {
        QJsonArray pose;
        for (const Degrees angle : immersion.rotation) {
            pose.append(wrapped(angle).value());
        }
        for (const Millimetres offset : immersion.offset) {
            pose.append(offset.value());
        }
        all[QLatin1String("pose")] = pose;
        all.remove(QLatin1String("path"));
        if (!immersion.path.isStraightDown()) {
            leaveOutUnused(immersion.path);
            all[QLatin1String("path")] = pathToJson(immersion);
        }
        keys << sha256Hex(QJsonDocument(all).toJson(QJsonDocument::Compact)).left(keyLetters);
    }
    return keys;
}

AsBuilt partsDippedAlike(const Project& project) {
    return project.asBuilt.places.empty() || !project.model
               ? project.asBuilt
               : dippedAlike(project.asBuilt, dipKeys(project));
}

} // namespace dipwright

#include "inspection/FilmFitFiles.h"

#include "accuracy/correction/SheetCorrection.h"
#include "base/Error.h"
#include "base/NumberText.h"
#include "disk/FolderTransaction.h"
#include "project/DipKeys.h"
#include "project/Profiles.h"
#include "project/Project.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTextStream>

#include <algorithm>
#include <cmath>

namespace dipwright {
namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(dipwright::FilmFit)
};

const QString jsonName = QStringLiteral("fit.json");
const QString tableName = QStringLiteral("fit-places.csv");
constexpr double strong = 0.9; // correlations from this value on are reported

// Elastic film has an infinite time.
QJsonValue numberOrNull(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

QJsonArray quantitiesJson(const FilmFit& fit) {
    QJsonArray all;
    for (std::size_t row = 0; row < fit.quantities.size(); ++row) {
        const FittedQuantity& one = fit.quantities[row];
        QJsonArray correlations;
        for (Eigen::Index column = 0; column < fit.correlation.cols(); ++column) {
            correlations.append(fit.correlation(Eigen::Index(row), column));
        }
        all.append(QJsonObject{{"quantity", fitQuantityKey(one.unknown.quantity)},
                               {"dip", one.unknown.dip + 1},
                               {"unit", fitQuantityUnit(one.unknown.quantity)},
                               {"before", numberOrNull(one.before)},
                               {"after", one.after},
                               {"low", one.low},
                               {"high", one.high},
                               {"correlation", correlations}});
    }
    return all;
}

QByteArray jsonOf(const FilmFit& fit, const FitPairs& pairs, const std::vector<FittedPhoto>& photos,
                  const WatchNotes& notes) {
    QJsonArray left, list;
    for (const FitUnknown& unknown : fit.left) {
        left.append(fitQuantityKey(unknown.quantity));
    }
    for (const FittedPhoto& photo : photos) {
        list.append(
            QJsonObject{{"file", QFileInfo(photo.where).fileName()}, {"sha256", photo.sha256}});
    }
    const auto used = std::count_if(fit.off.begin(), fit.off.end(),
                                    [](const FitDistance& off) { return off.isOnBody; });
    return QJsonDocument(
               QJsonObject{{"version", 1},
                           {"date", notes.date},
                           {"lot", notes.lot},
                           {"water_temperature_c", notes.waterTemperature
                                                       ? QJsonValue(*notes.waterTemperature)
                                                       : QJsonValue()},
                           {"quantities", quantitiesJson(fit)},
                           {"not_told", left},
                           {"doubt", fit.doubt},
                           {"places", qint64(fit.off.size())},
                           {"places_used", qint64(used)},
                           {"places_of_the_body", qint64(pairs.body.size())},
                           {"rms_px", QJsonArray{fit.beforePixels, fit.afterPixels}},
                           {"rms_mm", QJsonArray{fit.beforeMillimetres, fit.afterMillimetres}},
                           {"rounds", fit.rounds},
                           {"dips", fit.dips},
                           {"photos", list}})
        .toJson();
}

QByteArray tableOf(const FilmFit& fit, const FitPairs& pairs) {
    QByteArray table;
    QTextStream out(&table);
    out << "photo,x_px,y_px,dip,sheet_x_mm,sheet_y_mm,used,before_x_px,before_y_px,after_x_px,"
           "after_y_px,after_mm\n";
    for (std::size_t i = 0; i < fit.off.size(); ++i) {
        const PrintedPlace& place = pairs.printed[i];
        const FitDistance& off = fit.off[i];
        const auto number = [](double value) { return QString::number(value, 'f', 4); };
        out << place.photo + 1 << ',' << number(place.pixel.x()) << ',' << number(place.pixel.y())
            << ',' << place.dip + 1 << ',' << number(place.sheet.x()) << ','
            << number(place.sheet.y()) << ',' << int(off.isOnBody);
        for (const double value :
             {off.before.x(), off.before.y(), off.after.x(), off.after.y(), off.millimetres}) {
            out << ',' << number(value);
        }
        out << '\n';
    }
    out.flush();
    return table;
}

int decimalsOf(FitQuantity quantity) {
    switch (quantity) {
    case FitQuantity::SwellX:
    case FitQuantity::SwellY:
        return 4;
    case FitQuantity::Growth:
        return 6;
    default:
        return 2;
    }
}

QString sentenceOf(const FittedQuantity& found) {
    const QStringList cells = fitCells(found);
    return Text::tr("%1: %2 (before: %3; 95 % interval: %4)")
        .arg(cells[0], cells[2], cells[1], cells[3]);
}

const FittedQuantity* found(const FilmFit& fit, FitQuantity quantity) {
    const auto at =
        std::find_if(fit.quantities.begin(), fit.quantities.end(),
                     [&](const FittedQuantity& one) { return one.unknown.quantity == quantity; });
    return at == fit.quantities.end() ? nullptr : &*at;
}

// Rounds to the digits that photos can determine.
QString digits(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

} // namespace

QStringList fitCells(const FittedQuantity& found) {
    const FitQuantity quantity = found.unknown.quantity;
    const auto number = [&](double value) {
        return std::isfinite(value) ? numberText(value, decimalsOf(quantity)) : QStringLiteral("∞");
    };
    const QString unit = fitQuantityUnit(quantity);
    const QString name =
        found.unknown.dip > 0
            ? Text::tr("%1, dip %2").arg(fitQuantityText(quantity)).arg(found.unknown.dip + 1)
            : fitQuantityText(quantity);
    return {name, number(found.before),
            unit.isEmpty() ? number(found.after) : number(found.after) + u' ' + unit,
            Text::tr("%1 to %2").arg(number(found.low), number(found.high))};
}

void writeFilmFit(const FilmFit& fit, const FitPairs& pairs, const std::vector<FittedPhoto>& photos,
                  const WatchNotes& notes, const QString& folder) {
    FolderTransaction files(folder, {jsonName, tableName});
    files.write(jsonName, jsonOf(fit, pairs, photos, notes));
    files.write(tableName, tableOf(fit, pairs));
    files.commit();
}

QStringList fitSentences(const FilmFit& fit) {
    QStringList sentences;
    for (const FittedQuantity& one : fit.quantities) {
        sentences << sentenceOf(one);
    }
    for (Eigen::Index row = 0; row < fit.correlation.rows(); ++row) {
        for (Eigen::Index column = 0; column < row; ++column) {
            const double correlation = fit.correlation(row, column);
            if (std::abs(correlation) > strong) {
                sentences
                    << Text::tr("%1 and %2 cannot be determined independently: correlation %3")
                           .arg(fitQuantityText(fit.quantities[std::size_t(row)].unknown.quantity),
                                fitQuantityText(
                                    fit.quantities[std::size_t(column)].unknown.quantity),
                                numberText(correlation, 2));
            }
        }
    }
    for (const FitUnknown& unknown : fit.left) {
        sentences << Text::tr("%1 is not determined by these pairs and keeps its value")
                         .arg(fitQuantityText(unknown.quantity));
    }
    if (!fit.doubt.isEmpty()) {
        sentences << fit.doubt;
    }
    sentences << Text::tr("Root mean square distance between the simulated and the photographed "
                          "print: %1 px (%2 mm) before the fit, %3 px (%4 mm) after it")
                     .arg(numberText(fit.beforePixels, 2), numberText(fit.beforeMillimetres, 3),
                          numberText(fit.afterPixels, 2), numberText(fit.afterMillimetres, 3));
    return sentences;
}

FilmProfile withFit(FilmProfile profile, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                    const WatchNotes& notes) {
    Profile result = profile;
    const FittedQuantity* swellX = found(fit, FitQuantity::SwellX);
    const FittedQuantity* swellY = found(fit, FitQuantity::SwellY);
    const FittedQuantity* growth = found(fit, FitQuantity::Growth);
    setByPath(result, QStringLiteral("swell"),
              digits(swellX ? swellX->after : profile.swellX, 5) + u'x' +
                  digits(swellY ? swellY->after : profile.swellY, 5));
    if (growth) {
        setByPath(result, QStringLiteral("growth_per_s"), digits(growth->after, 7));
    }
    if (const FittedQuantity* relaxation = found(fit, FitQuantity::Relaxation)) {
        setByPath(result, QStringLiteral("relaxation_time_s"), digits(relaxation->after, 3));
    }
    if (const FittedQuantity* contact = found(fit, FitQuantity::ContactDistance)) {
        setByPath(result, QStringLiteral("contact_distance_mm"), digits(contact->after, 3));
    }
    auto& film = std::get<FilmProfile>(result);
    if (!notes.lot.isEmpty()) {
        film.lot = notes.lot;
    }
    QStringList hashes;
    for (const FittedPhoto& photo : photos) {
        hashes << photo.sha256;
    }
    FilmMeasurement& measured = film.measured;
    measured.date = notes.date;
    measured.waterTemperature = notes.waterTemperature;
    measured.photos = hashes.join(u' ');
    measured.residual = fit.afterMillimetres;
    if (swellX && swellY) {
        measured.swellX = film.swellX;
        measured.swellY = film.swellY;
        measured.swellErrorX = (swellX->high - swellX->low) / 2;
        measured.swellErrorY = (swellY->high - swellY->low) / 2;
    }
    if (growth) {
        measured.growthRate = film.growthRate;
        measured.growthLimit = film.growthLimit;
    }
    if (found(fit, FitQuantity::Relaxation)) {
        measured.relaxationTime = film.relaxationTime.value();
    }
    return film;
}

FilmProfile newProfileFor(const Project& project, const QString& name) {
    FilmProfile profile = filmProfileOf(project);
    profile.name = name;
    return profile;
}

QString otherFilmNote(const FilmProfile& profile, const Project& project, const FilmFit& fit) {
    FilmBehaviour own = profile, jobs = project.film;
    const auto ignore = [&](FitQuantity quantity, auto member) {
        if (found(fit, quantity)) {
            own.*member = jobs.*member;
        }
    };
    ignore(FitQuantity::SwellX, &FilmBehaviour::swellX);
    ignore(FitQuantity::SwellY, &FilmBehaviour::swellY);
    ignore(FitQuantity::Relaxation, &FilmBehaviour::relaxationTime);
    ignore(FitQuantity::Growth, &FilmBehaviour::growthRate);
    ignore(FitQuantity::ContactDistance, &FilmBehaviour::contactDistance);
    const bool isSame =
        own == jobs && profile.width == project.film.width && profile.height == project.film.height;
    return isSame ? QString()
                  : Text::tr("The film profile %1 has other values than the project's film, under "
                             "which the values were fitted; compare the two before you use it")
                        .arg(profile.name);
}

Project withFit(const Project& project, const FilmFit& fit, const std::vector<FittedPhoto>& photos,
                const WatchNotes& notes, const QString& newProfile) {
    FilmProfile film = filmProfileOf(project);
    if (!project.profiles.film) {
        film.name = newProfile;
    }
    Project changed = withPlacement(project, fit);
    applyProfile(changed, withFit(film, fit, photos, notes));
    changed.process.overhang = project.process.overhang; // the fit does not determine it
    changed.process.tearStretch = project.process.tearStretch;
    return changed;
}

void requireUncorrected(const Project& project, const QString& where) {
    const AsBuilt built = partsDippedAlike(project);
    if (isCorrected(built, 1) || isCorrected(built, 2)) {
        throw Error(Text::tr("The job's sheets are already corrected by its measured parts, so "
                             "fitted values in the job would correct the same error twice; turn "
                             "the correction off (As built) and fit a part whose sheet was not "
                             "corrected"),
                    where);
    }
}

Project withPlacement(Project project, const FilmFit& fit) {
    for (std::size_t dip = 0; dip < project.immersions.size(); ++dip) {
        const Immersion& was = project.immersions[dip];
        const Immersion& is = fit.immersions[dip];
        const QString path = QStringLiteral("immersions[%1].").arg(dip);
        if (is.offset != was.offset) {
            setByPath(project, path + QStringLiteral("offset_mm"),
                      digits(is.offset[0].value(), 3) + u'x' + digits(is.offset[1].value(), 3));
        }
        if (is.rotation != was.rotation) {
            setByPath(project, path + QStringLiteral("rotation_deg"),
                      digits(is.rotation[0].value(), 3) + u'x' + digits(is.rotation[1].value(), 3) +
                          u'x' + digits(is.rotation[2].value(), 3));
        }
    }
    if (fit.depth && fit.depth != project.process.depth) {
        setByPath(project, QStringLiteral("process.depth_mm"), digits(fit.depth->value(), 3));
    }
    return project;
}

} // namespace dipwright

#include "workbench/project/FilmMeasured.h"

#include "base/Error.h"
#include "project/ProfileLibrary.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "workbench/widgets/ShippedNames.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QStringList>
#include <algorithm>

namespace dipwright {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(FilmMeasured)
};

} // namespace

QString measuredText(const FilmProfile& film) {
    return film.measured.date.isEmpty() ? Text::tr("not measured")
                                        : Text::tr("measured on %1").arg(film.measured.date);
}

QString measuredText(const Project& project) {
    QStringList measured, guessed;
    const auto add = [&](bool isMeasured, const QString& name) {
        (isMeasured ? measured : guessed).append(name);
    };
    add(hasMeasuredSwell(project.film, project.profiles), Text::tr("swell"));
    add(hasMeasuredGrowth(project.film, project.profiles), Text::tr("growth"));
    add(hasMeasuredRelaxation(project.film, project.profiles), Text::tr("relaxation"));
    const QString comma = QStringLiteral(", ");
    QStringList parts;
    if (!measured.isEmpty()) {
        parts.append(Text::tr("%1 measured on %2")
                         .arg(measured.join(comma), project.profiles.film->measured.date));
    }
    if (!guessed.isEmpty()) {
        parts.append(Text::tr("%1 not measured").arg(guessed.join(comma)));
    }
    QString sentence = parts.join(QStringLiteral("; "));
    sentence.front() = sentence.front().toUpper();
    return sentence;
}

void addFilmProfiles(QComboBox& box, const QString& chosen) {
    box.addItem(Text::tr("None (film not measured)"), QString());
    const ProfileLibrary library;
    for (const ProfileEntry& entry : library.profiles(ProfileKind::Film)) {
        try {
            const Profile profile = library.profile(ProfileKind::Film, entry.name);
            box.addItem(Text::tr("%1 (%2)").arg(shownName(entry.name),
                                                measuredText(std::get<FilmProfile>(profile))),
                        entry.name);
        } catch (const Error&) { // the profiles dialog reports damaged files
        }
    }
    box.setCurrentIndex(std::max(0, box.findData(chosen)));
}

} // namespace dipwright

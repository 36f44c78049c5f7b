// The fields of a film's material: a project and a profile share them and pass them to each other,
// and the documentation lists them all.
#include "project/FilmFields.h"
#include "base/NumberText.h"

#include "TestFolders.h"
#include "base/Error.h"
#include "project/ProfileFields.h"
#include "project/Profiles.h"
#include "project/Project.h"
#include "project/Schema.h"

#include <QFile>
#include <QJsonArray>
#include <QLocale>
#include <QTest>

using namespace dipwright;

namespace {

// A field's path in a project and in a profile.
struct Paths {
    QString project, profile;
};

std::vector<Paths> materialPaths() {
    std::vector<Paths> paths;
    for (const auto& material : filmBehaviourFields()) {
        paths.push_back({QStringLiteral("film.") + material.field.path, material.field.path});
    }
    for (const auto& material : inkLawFields()) {
        paths.push_back({QStringLiteral("ink.") + material.field.path,
                         QStringLiteral("ink_") + material.field.path});
    }
    const FilmLimitFields limits = filmLimitFields();
    for (const auto& field : {limits.tearStretch.field, limits.overhang.field}) {
        paths.push_back({QStringLiteral("process.") + field.path, field.path});
    }
    return paths;
}

const Field<Project>& fieldAt(const QString& path) {
    for (const Field<Project>& field : projectFields()) {
        if (field.path == path) {
            return field;
        }
    }
    throw std::runtime_error("the project has no " + path.toStdString());
}

// Returns a valid value that is not the default.
QJsonValue unusual(const FieldRule& rule) {
    if (rule.kind == FieldKind::Choice) {
        return rule.choices.last();
    }
    if (rule.kind == FieldKind::Text) {
        return QStringLiteral("cyan 0.3 0.5 0.1 3");
    }
    QJsonArray parts;
    for (int part = 0; part < rule.parts; ++part) {
        parts.append(rule.minimum + (rule.maximum - rule.minimum) * (0.3 + 0.1 * part));
    }
    return rule.parts == 1 ? parts.first() : QJsonValue(parts);
}

Project unusualProject() {
    Project project;
    for (const Paths& path : materialPaths()) {
        const Field<Project>& field = fieldAt(path.project);
        setField(project, field, unusual(field.rule));
    }
    return project;
}

QString numberText(double number) {
    return number == 1e6 ? QStringLiteral("10⁶") : QString::number(number, 'g', 10);
}

QString rangeText(const FieldRule& rule) {
    if (rule.kind == FieldKind::Choice) {
        return u'`' + rule.choices.join(QStringLiteral("`, `")) + u'`';
    }
    if (rule.kind == FieldKind::Text) {
        return QStringLiteral("text, ") + QLocale(QLocale::English).toString(int(rule.maximum));
    }
    return (rule.parts > 1 ? QStringLiteral("%1 × ").arg(rule.parts) : QString()) +
           (rule.nullable ? QStringLiteral("null, ") : QString()) + numberText(rule.minimum) +
           QStringLiteral(" … ") + numberText(rule.maximum);
}

QString valueText(const QJsonValue& value) {
    if (value.isArray()) {
        QStringList parts;
        for (const QJsonValue& part : value.toArray()) {
            parts.append(valueText(part));
        }
        return parts.join(QStringLiteral(", "));
    }
    return value.isNull()     ? QStringLiteral("null")
           : value.isDouble() ? numberText(value.toDouble())
                              : value.toString();
}

// Returns the cells of the documentation's row for a path. A row may list several paths:
// `film.edges.left`, `.right`.
QStringList rowFor(const QString& path) {
    QFile file(sourceFolder("/docs/files-and-commands.md"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QString whole = QStringLiteral("`%1`").arg(path);
    const QString section = QStringLiteral("`%1.").arg(path.section(u'.', 0, -2));
    const QString last = QStringLiteral("`.%1`").arg(path.section(u'.', -1));
    for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n')) {
        const QStringList cells = line.split(u'|');
        if (cells.size() > 3 &&
            (cells[1].contains(whole) || (cells[1].contains(section) && cells[1].contains(last)))) {
            return {cells[1].trimmed(), cells[2].trimmed(), cells[3].trimmed()};
        }
    }
    return {};
}

} // namespace

class FilmFieldsTest : public QObject {
    Q_OBJECT

private slots:
    void profileRule_filmField_equalsTheProjectsRule() {
        QCOMPARE(materialPaths().size(), std::size_t(16));
        for (const Paths& path : materialPaths()) {
            FieldRule project = fieldAt(path.project).rule;
            const FieldRule profile = profileRule(ProfileKind::Film, path.profile);
            QCOMPARE(profile.kind, project.kind);
            QCOMPARE(profile.parts, project.parts);
            QCOMPARE(profile.minimum, project.minimum);
            QCOMPARE(profile.maximum, project.maximum);
            QCOMPARE(profile.choices, project.choices);
            const FieldWords words = materialWords(path.profile);
            QVERIFY2(!words.label.isEmpty() && !words.help.isEmpty(), qPrintable(path.profile));
        }
    }

    void applyProfile_takesOverEveryField() {
        const Project source = unusualProject();
        Profile profile = FilmProfile();
        for (const Paths& path : materialPaths()) {
            setProfileValue(profile, path.profile, fieldAt(path.project).get(source));
        }
        Project project;
        applyProfile(project, profile);
        for (const Paths& path : materialPaths()) {
            const Field<Project>& field = fieldAt(path.project);
            QVERIFY2(field.get(project) != field.get(Project()), qPrintable(path.project));
            QCOMPARE(field.get(project), field.get(source));
        }
    }

    void filmProfileOf_appliedAgain_changesNothing() {
        const Project before = unusualProject();
        Project project = before;
        applyProfile(project, filmProfileOf(project));
        QVERIFY(project.profiles.film);
        project.profiles = before.profiles;
        QCOMPARE(toJson(project), toJson(before));
    }

    void inkTones_refused_errorNamesThePath() {
        const auto where = [](const auto& set) {
            try {
                set();
            } catch (const Error& error) {
                return error.where();
            }
            return QString();
        };
        Project project;
        QCOMPARE(where([&] { setByPath(project, QStringLiteral("ink.tones"), "mauve 1"); }),
                 QStringLiteral("ink.tones"));
        Profile profile = FilmProfile();
        QCOMPARE(where([&] { setByPath(profile, QStringLiteral("ink_tones"), "mauve 1"); }),
                 QStringLiteral("ink_tones"));
    }

    // A sheet that is older than a field keeps its job number.
    void countedSettings_laterFieldWithDefault_isOmitted() {
        const QStringList later{QStringLiteral("growth_per_s"), QStringLiteral("growth_limit"),
                                QStringLiteral("grip_fade_deg"),
                                QStringLiteral("gathering_stretch")};
        Project project;
        applyProfile(project, FilmProfile());
        const QJsonObject usual = countedSettings(project);
        const QJsonObject film = usual["film"].toObject();
        const QJsonObject profile = usual["profiles"].toObject()["film"].toObject();
        QCOMPARE(usual["version"].toInt(), 1);
        QVERIFY(film.contains("swell") && profile.contains("swell"));
        for (const QString& key :
             later + QStringList{QStringLiteral("resolution"), QStringLiteral("cell_mm")}) {
            QVERIFY2(!film.contains(key), qPrintable(key));
        }
        for (const QString& key :
             later + QStringList{QStringLiteral("overhang_deg"), QStringLiteral("tear_stretch"),
                                 QStringLiteral("flash_time_s"), QStringLiteral("drying_time_s"),
                                 QStringLiteral("measured")}) {
            QVERIFY2(!profile.contains(key), qPrintable(key));
        }
        QVERIFY(usual["process"].toObject().contains("overhang_deg"));

        FilmProfile measured;
        measured.measured.date = QStringLiteral("2027-03-31");
        applyProfile(project, measured);
        project.film.growthRate = 0.01;
        const QJsonObject counted = countedSettings(project);
        QVERIFY(counted["film"].toObject().contains("growth_per_s"));
        const QJsonObject photos =
            counted["profiles"].toObject()["film"].toObject()["measured"].toObject();
        QVERIFY(photos.contains("growth_per_s") && !photos.contains("relaxation_time_s"));
    }

    void documentation_filmFields_hasEveryFieldWithItsLimits() {
        for (const Paths& path : materialPaths()) {
            const Field<Project>& field = fieldAt(path.project);
            const QStringList row = rowFor(path.project);
            QVERIFY2(row.size() > 2, qPrintable(path.project));
            QCOMPARE(row[1], rangeText(field.rule));
            QCOMPARE(row[2], valueText(field.get(Project())));
        }
    }
};

QTEST_GUILESS_MAIN(FilmFieldsTest)
#include "FilmFieldsTest.moc"

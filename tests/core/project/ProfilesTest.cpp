// Profiles of printers, films and tanks: their files, the library, and the copy in a project.
#include "project/ProfileLibrary.h"

#include "base/Error.h"
#include "base/ProgramName.h"
#include "project/ProfileFields.h"
#include "project/Profiles.h"
#include "project/Project.h"

#include <QJsonArray>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace dipwright;

namespace {

PrinterProfile printer() {
    PrinterProfile profile;
    profile.name = QStringLiteral("Büro / hinten: \"links\"");
    profile.queue = QStringLiteral("office");
    profile.scaleX = 1.004;
    profile.scaleY = 0.997;
    profile.margins = {Millimetres(3), Millimetres(4), Millimetres(5), Millimetres(6)};
    profile.iccProfile = QByteArray("\0\1\2icc", 6);
    profile.intent = RenderingIntent::Perceptual;
    profile.blackPoint = false;
    profile.keptInks = KeptInks::Pure;
    profile.deviceLink = QByteArray("\0link", 5);
    profile.inkLimit = 1.7;
    profile.resolution = DotsPerInch(600);
    return profile;
}

FilmProfile film() {
    FilmProfile profile;
    profile.name = QStringLiteral("Blue box");
    profile.width = Millimetres(297);
    profile.height = Millimetres(420);
    profile.swellX = 1.03;
    profile.swellY = 1.06;
    profile.relaxationTime = Seconds(4);
    profile.edges.leftPinned = profile.edges.topPinned = true;
    profile.contactDistance = Millimetres(0.1);
    profile.growthRate = 0.004;
    profile.growthLimit = 0.2;
    profile.gripFade = Degrees(7);
    profile.gatheringStretch = 0.7;
    profile.tearStretch = 3;
    profile.feed = FeedDirection::LongEdgeFirst;
    profile.soakTime = Seconds(75);
    profile.activatorTime = Seconds(8);
    profile.lot = QStringLiteral("B-17");
    profile.expiry = QStringLiteral("2027-03-31");
    return profile;
}

TankProfile tank() {
    TankProfile profile;
    profile.name = QStringLiteral("Long tank");
    profile.width = Millimetres(300);
    profile.length = Millimetres(900);
    profile.waterLevel = Millimetres(25);
    profile.barriers.rightPinned = true;
    profile.markDistance = {Millimetres(198), Millimetres(285)};
    profile.waterDepth = Millimetres(320);
    profile.reach = Millimetres(110);
    profile.speed = MillimetresPerSecond(80);
    profile.turnSpeed = DegreesPerSecond(45);
    return profile;
}

QString refusal(const QJsonObject& json) {
    try {
        profileFromJson(json, QStringLiteral("x.json"));
    } catch (const Error& error) {
        return error.sentence();
    }
    return {};
}

} // namespace

class ProfilesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    ProfileLibrary library_{folder_.path()};

private slots:
    void profileLibrary_earlierCommandLineFolder_isFound();
    void profileFromJson_readsWhatToJsonWrote();
    void profileLibrary_shippedProfiles_areValid();
    void profileLibrary_usersProfile_replacesTheShippedOne();
    void exportProfile_importedAgain_isTheSame();
    void profileLibrary_invalidName_isNotSaved_data();
    void profileLibrary_invalidName_isNotSaved();
    void profileLibrary_missingProfile_isNamed();
    void profileLibrary_severalFilesOfOneName_areNotChanged();
    void importProfile_damagedFile_isRefused();
    void profileLibrary_damagedFile_doesNotHideOthers();
    void profileFromJson_valueOutOfRange_isRefusedByPath();
    void setByPath_refusedValue_leavesTheProfile();
    void applyProfile_project_takesTheProfilesValues();
    void toJson_profiles_areStoredByContent();
};

void ProfilesTest::profileFromJson_readsWhatToJsonWrote() {
    for (const Profile& profile : {Profile(printer()), Profile(film()), Profile(tank())}) {
        QVERIFY(profileFromJson(toJson(profile), QString()) == profile);
        QJsonObject newer = toJson(profile);
        newer["future"] = QJsonArray{1, 2};
        QCOMPARE(toJson(profileFromJson(newer, QString())), newer);
    }
}

void ProfilesTest::profileLibrary_shippedProfiles_areValid() {
    for (ProfileKind kind : {ProfileKind::Printer, ProfileKind::Film, ProfileKind::Tank}) {
        const auto entries = library_.profiles(kind);
        QVERIFY(entries.size() >= 2);
        for (const ProfileEntry& entry : entries) {
            QVERIFY(!entry.isUsers());
            QCOMPARE(nameOf(library_.profile(kind, entry.name)), entry.name);
        }
    }
}

void ProfilesTest::profileLibrary_usersProfile_replacesTheShippedOne() {
    const ProfileEntry shipped = library_.profiles(ProfileKind::Printer).front();
    auto changed = std::get<PrinterProfile>(library_.profile(ProfileKind::Printer, shipped.name));
    changed.scaleX = 1.01;
    library_.replace(changed);
    changed.scaleX = 1.02;
    library_.replace(changed);
    QCOMPARE(std::get<PrinterProfile>(library_.profile(ProfileKind::Printer, shipped.name)).scaleX,
             1.02);
    library_.remove(ProfileKind::Printer, shipped.name);
    QVERIFY(std::get<PrinterProfile>(library_.profile(ProfileKind::Printer, shipped.name)).scaleX !=
            1.02);
    QVERIFY_EXCEPTION_THROWN(library_.remove(ProfileKind::Printer, shipped.name), Error);
}

void ProfilesTest::exportProfile_importedAgain_isTheSame() {
    const QString path = folder_.filePath("out.json");
    exportProfile(printer(), path);
    const QString broken = folder_.filePath("broken.json");
    QFile file(broken);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{}") == 2);
    file.close();
    try {
        exportProfile(printer(), broken);
        QFAIL("the file was replaced, expected an Error");
    } catch (const Error& error) {
        QCOMPARE(error.sentence().count(broken), 1);
    }
    library_.replace(importProfile(path));
    QVERIFY(library_.profile(ProfileKind::Printer, printer().name) == Profile(printer()));
    QVERIFY_EXCEPTION_THROWN(exportProfile(printer(), folder_.filePath("no/such/folder/x.json")),
                             Error);
}

void ProfilesTest::profileLibrary_invalidName_isNotSaved_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("reasonPart");
    QTest::newRow("no name") << QString() << "needs a name";
    QTest::newRow("of spaces") << "  "
                               << "needs a name";
    QTest::newRow("too long") << QString(101, u'a') << "at most 100 characters";
}

void ProfilesTest::profileLibrary_invalidName_isNotSaved() {
    QFETCH(QString, name);
    QFETCH(QString, reasonPart);
    const QTemporaryDir folder;
    const ProfileLibrary library(folder.path());
    FilmProfile profile = film();
    profile.name = name;
    const auto failureOf = [](const auto& write) {
        try {
            write();
        } catch (const Error& error) {
            return error.sentence();
        }
        return QString();
    };
    for (const QString& failure : {failureOf([&] { library.save(profile, std::nullopt); }),
                                   failureOf([&] { library.replace(profile); })}) {
        QVERIFY2(failure.contains(reasonPart), qPrintable(failure));
    }
    QVERIFY(QDir(folder.path()).isEmpty());
    profile.name = QString(100, u'a');
    library.save(profile, std::nullopt);
    QVERIFY(library.profile(ProfileKind::Film, profile.name) == Profile(profile));
}

void ProfilesTest::profileLibrary_missingProfile_isNamed() {
    try {
        library_.profile(ProfileKind::Film, "Green box");
        QFAIL("the library returned a missing film, expected an Error");
    } catch (const Error& error) {
        QVERIFY(error.sentence().contains("Green box"));
        QVERIFY(error.sentence().contains("Ideal film, A4"));
    }
}

void ProfilesTest::profileLibrary_severalFilesOfOneName_areNotChanged() {
    QTemporaryDir folder;
    const ProfileLibrary library(folder.path());
    library.replace(tank());
    TankProfile other = tank();
    other.waterLevel = Millimetres(99);
    const QString otherFile = folder.filePath(QStringLiteral("tank/aaa.json"));
    exportProfile(other, otherFile);
    const auto entries = library.profiles(ProfileKind::Tank);
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [](const auto& one) { return one.name == tank().name; });
    QVERIFY(severalFiles(*entry)->message().contains(otherFile));
    QVERIFY(severalFiles(*entry)->message().contains(entry->others.value(0)));
    QVERIFY_EXCEPTION_THROWN(library.requireOneFile(ProfileKind::Tank, tank().name), Error);
    QVERIFY_EXCEPTION_THROWN(library.save(tank(), other), Error);
    QVERIFY_EXCEPTION_THROWN(library.replace(tank()), Error);
    QVERIFY_EXCEPTION_THROWN(library.remove(ProfileKind::Tank, tank().name), Error);
    QVERIFY(library.profile(ProfileKind::Tank, tank().name) == Profile(other));
    QVERIFY(QFile::remove(otherFile));
    library.remove(ProfileKind::Tank, tank().name);
    QVERIFY(!library.contains(ProfileKind::Tank, tank().name));
}

void ProfilesTest::importProfile_damagedFile_isRefused() {
    const QString path = folder_.filePath("damaged.json");
    for (const QByteArray& bytes :
         {QByteArray(), QByteArray("{\"format\":\"dipwr"), QByteArray("[1,2]"), QByteArray("{}"),
          QByteArray("\x89PNG\r\n")}) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        QVERIFY_EXCEPTION_THROWN(importProfile(path), Error);
    }
    QVERIFY_EXCEPTION_THROWN(importProfile(folder_.filePath("nosuch.json")), Error);
    QJsonObject newer = toJson(Profile(film()));
    newer["version"] = 7;
    QVERIFY(refusal(newer).contains('7'));
    QJsonObject unknownKind = toJson(Profile(film()));
    unknownKind["kind"] = "scanner";
    QVERIFY(refusal(unknownKind).contains("scanner"));
}

void ProfilesTest::profileLibrary_damagedFile_doesNotHideOthers() {
    QDir().mkpath(folder_.filePath("film"));
    QFile file(folder_.filePath("film/000.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("not a profile");
    file.close();
    QVERIFY(library_.profiles(ProfileKind::Film).size() >= 2);
}

void ProfilesTest::profileFromJson_valueOutOfRange_isRefusedByPath() {
    QJsonObject json = toJson(Profile(printer()));
    json["scale"] = QJsonArray{1.0, 2.0};
    QVERIFY(refusal(json).contains("scale[1]"));
    json = toJson(Profile(printer()));
    json["icc_profile"] = "%%%";
    QVERIFY(refusal(json).contains("icc_profile"));
    json = toJson(Profile(printer()));
    json["name"] = "  ";
    QVERIFY(refusal(json).contains("name"));
    json = toJson(Profile(film()));
    json["gathering_stretch"] = 0.5;
    QVERIFY(refusal(json).contains("gathering_stretch"));
    json = toJson(Profile(film()));
    json["growth_limit"] = 2;
    QVERIFY(refusal(json).contains("growth_limit"));
    json = toJson(Profile(film()));
    json["expiry"] = "soon";
    QVERIFY(refusal(json).contains("soon"));
}

void ProfilesTest::setByPath_refusedValue_leavesTheProfile() {
    const Profile before = film();
    Profile profile = before;
    QVERIFY_EXCEPTION_THROWN(setByPath(profile, "expiry", "soon"), Error);
    QVERIFY(profile == before);
    QVERIFY_EXCEPTION_THROWN(setProfileValue(profile, "expiry", "soon"), Error);
    QVERIFY(profile == before);
}

void ProfilesTest::applyProfile_project_takesTheProfilesValues() {
    Project project;
    project.process.overhang = Degrees(25);
    applyProfile(project, film());
    QCOMPARE(project.film.width.value(), 297.0);
    QCOMPARE(project.film.preset, QString("A3"));
    QCOMPARE(project.film.swellY, 1.06);
    QCOMPARE(project.film.relaxationTime.value(), 4.0);
    QVERIFY(project.film.edges.leftPinned);
    QCOMPARE(project.film.growthRate, 0.004);
    QCOMPARE(project.film.growthLimit, 0.2);
    QCOMPARE(project.film.gripFade.value(), 7.0);
    QCOMPARE(project.film.gatheringStretch, 0.7);
    QCOMPARE(project.process.tearStretch, 3.0);
    QCOMPARE(project.process.overhang.value(), 25.0); // the profile does not set it
    applyProfile(project, printer());
    QCOMPARE(project.sheet.resolution.value(), 600.0);
    QCOMPARE(project.ink.limit, 1.7);
    applyProfile(project, tank());
    QVERIFY(project.film.edges.rightPinned && !project.film.edges.leftPinned);
}

void ProfilesTest::toJson_profiles_areStoredByContent() {
    Project project;
    project.name = QStringLiteral("Turtle");
    applyProfile(project, printer());
    applyProfile(project, film());
    const QJsonObject json = toJson(project);
    const Project read = fromJson(json, QStringLiteral("turtle.dipw"));
    QVERIFY(read.profiles == project.profiles);
    QCOMPARE(toJson(read), json);
    QJsonObject wrong = json;
    QJsonObject profiles = json["profiles"].toObject();
    profiles["printer"] = profiles["film"];
    wrong["profiles"] = profiles;
    QVERIFY_EXCEPTION_THROWN(fromJson(wrong, QStringLiteral("turtle.dipw")), Error);
}

// Up to version 0.1 the command line had its own folder. A printer that was calibrated there must
// be found, or its sheets get the wrong size.
void ProfilesTest::profileLibrary_earlierCommandLineFolder_isFound() {
    QStandardPaths::setTestModeEnabled(true);
    const auto restore = qScopeGuard([] { QStandardPaths::setTestModeEnabled(false); });
    nameProgram();
    const QString earlier = earlierDataFolder() + QStringLiteral("/profiles");
    const auto clean = qScopeGuard([&] { QDir(earlier).removeRecursively(); });
    ProfileLibrary(earlier).replace(printer());
    const ProfileLibrary library;
    const Profile found = library.profile(ProfileKind::Printer, printer().name);
    QCOMPARE(std::get<PrinterProfile>(found).scaleX, printer().scaleX);
    library.remove(ProfileKind::Printer, printer().name);
    QVERIFY(!library.contains(ProfileKind::Printer, printer().name));
}

QTEST_GUILESS_MAIN(ProfilesTest)
#include "ProfilesTest.moc"

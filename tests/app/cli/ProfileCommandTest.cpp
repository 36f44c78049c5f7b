// Tests `dipwright-cli profile`.
#include "CliProcess.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using dipwright::test::cli;
using dipwright::test::Outcome;

class ProfileCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString in(const char* name) const { return folder_.filePath(QLatin1String(name)); }

private slots:
    void initTestCase() {
        qputenv("DIPWRIGHT_PROFILE_PATH", folder_.filePath("profiles").toUtf8());
    }

    void import_profileOfTheSameName_isReplacedAndSaidSo() {
        QCOMPARE(cli({"profile", "set", "film", "Roll", "--set", "swell=1.05x1.02"}).exitCode, 0);
        QCOMPARE(cli({"profile", "export", "film", "Roll", in("roll.json")}).exitCode, 0);
        QCOMPARE(cli({"profile", "import", in("roll.json")}).out,
                 QByteArray("Replaced the film profile Roll\n"));
        QCOMPARE(cli({"profile", "remove", "film", "Roll"}).exitCode, 0);
        QCOMPARE(cli({"profile", "import", in("roll.json")}).out,
                 QByteArray("Saved the film profile Roll\n"));
    }

    void import_damagedIccProfile_isRefused() {
        QCOMPARE(cli({"profile", "set", "printer", "Jet"}).exitCode, 0);
        QCOMPARE(cli({"profile", "export", "printer", "Jet", in("jet.json")}).exitCode, 0);
        QFile file(in("jet.json"));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QJsonObject profile = QJsonDocument::fromJson(file.readAll()).object();
        QVERIFY(profile.contains("icc_profile"));
        profile["name"] = QStringLiteral("Broken");
        profile["icc_profile"] = QString::fromLatin1(QByteArray("no profile").toBase64());
        file.resize(0);
        file.seek(0);
        file.write(QJsonDocument(profile).toJson());
        file.close();
        const Outcome imported = cli({"profile", "import", in("jet.json")});
        QVERIFY2(imported.exitCode == 1 && imported.err.contains("ICC profile"), imported.err);
        QVERIFY(!cli({"profile", "list"}).out.contains("Broken"));
    }

    void set_emptyValueOrBareSetting_saysWhatToWrite() {
        const Outcome empty = cli({"profile", "set", "printer", "Ink", "--set", "scale="});
        QVERIFY2(empty.exitCode == 2 && empty.err.contains("An empty value is not"), empty.err);
        for (const QStringList& words : {QStringList{"scale="}, QStringList{"printer", "scale=1"},
                                         QStringList{"printer", "Ink", "scale=1;1"}}) {
            const Outcome bare = cli(QStringList{"profile", "set"} + words);
            QVERIFY2(bare.exitCode == 2 && bare.err.contains("--set PATH=VALUE"), bare.err);
        }
        QVERIFY(!cli({"profile", "list"}).out.contains("scale="));
        const Outcome nameless = cli({"profile", "show", "printer"});
        QVERIFY2(nameless.exitCode == 2 && nameless.err.contains("NAME is missing"), nameless.err);
    }

    void set_damagedIccProfile_isRefused() {
        for (const char* setting : {"icc_profile=YWJj", "device_link=YWJj"}) {
            const Outcome set = cli({"profile", "set", "printer", "Inky", "--set", setting});
            QVERIFY2(set.exitCode != 0 && set.err.contains("ICC profile"), set.err);
        }
        QVERIFY(!cli({"profile", "list"}).out.contains("Inky"));
    }

    void set_name_saysHowAProfileIsRenamed() {
        const Outcome set = cli({"profile", "set", "printer", "Old", "--set", "name=New"});
        QVERIFY2(set.exitCode == 2 && set.err.contains("not renamed"), set.err);
    }

    void set_nameWithTheMarkOfTheList_isRefused() {
        const Outcome set = cli({"profile", "set", "film", "Ideal film, A4 (built in)"});
        QVERIFY2(set.exitCode == 2 && set.err.contains("is called Ideal film, A4"), set.err);
        QCOMPARE(cli({"profile", "set", "film", "Ideal film, A4"}).exitCode, 0);
        QCOMPARE(cli({"profile", "remove", "film", "Ideal film, A4"}).exitCode, 0);
    }

    void severalFilesOfOneName_areShownButNotChanged() {
        QCOMPARE(cli({"profile", "set", "tank", "Twin"}).exitCode, 0);
        QCOMPARE(cli({"profile", "export", "tank", "Twin", in("profiles/tank/aaa.json")}).exitCode,
                 0);
        for (const QStringList& words : {QStringList{"list"},
                                         {"show", "tank", "Twin"},
                                         {"set", "tank", "Twin"},
                                         {"remove", "tank", "Twin"},
                                         {"use", "tank", "Twin", in("none.dipw")}}) {
            const Outcome outcome = cli(QStringList("profile") + words);
            QVERIFY2(outcome.err.contains("Several files") && outcome.err.contains("aaa.json"),
                     outcome.err);
            QCOMPARE(outcome.exitCode, words[0] == "list" || words[0] == "show" ? 0 : 1);
        }
        QVERIFY(QFile::remove(in("profiles/tank/aaa.json")));
        QCOMPARE(cli({"profile", "remove", "tank", "Twin"}).exitCode, 0);
    }
};

QTEST_MAIN(ProfileCommandTest)
#include "ProfileCommandTest.moc"

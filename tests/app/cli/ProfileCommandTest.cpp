// Tests `dipwright-cli profile import` and `profile wedge`.
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
};

QTEST_MAIN(ProfileCommandTest)
#include "ProfileCommandTest.moc"

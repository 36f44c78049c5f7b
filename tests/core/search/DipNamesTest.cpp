// Tests how the dips of found poses are named after the project's dips.
#include "search/DipNames.h"

#include <QtTest>

using namespace dipwright;

namespace {

Immersion dip(const QString& name, double x, double y, double z) {
    Immersion immersion;
    immersion.name = name;
    immersion.rotation = {Degrees(x), Degrees(y), Degrees(z)};
    return immersion;
}

QStringList names(std::vector<Immersion> found, const std::vector<Immersion>& own) {
    nameDips(found, own);
    QStringList names;
    for (const Immersion& immersion : found) {
        names.append(immersion.name);
    }
    return names;
}

} // namespace

class DipNamesTest : public QObject {
    Q_OBJECT

    const std::vector<Immersion> own_{dip("Belly", 0, 0, 0), dip("Shell", 0, 0, 180)};

private slots:
    void nameDips_nearlyOwnPoses_keepTheirNames() {
        QCOMPARE(names({dip("", 10, 70, 5), dip("", 0, 0, 170)}, own_),
                 (QStringList{"Belly", "Shell"}));
    }

    void nameDips_sidesInOtherOrder_namesFollowTheSides() {
        QCOMPARE(names({dip("", 0, -10, 180), dip("", 20, 0, 0)}, own_),
                 (QStringList{"Shell", "Belly"}));
    }

    // Both are nearer to the shell; only one can have its name.
    void nameDips_otherSide_isNumbered() {
        QCOMPARE(names({dip("", 0, 0, 100), dip("", 0, 0, 180)}, own_),
                 (QStringList{"Dip 1", "Shell"}));
        QCOMPARE(names({dip("", 180, 0, 0)}, {dip("Front", 0, 0, 0)}), QStringList{"Dip 1"});
    }

    void nameDips_otherNumberOfDips_areNumbered() {
        QCOMPARE(names({dip("", 0, 0, 0)}, own_), QStringList{"Dip 1"});
    }

    void nameDips_numberedOwnDips_keepTheirNumbers() {
        QCOMPARE(names({dip("", 0, 0, 180), dip("", 0, 0, 0)},
                       {dip("Dip 1", 0, 0, 0), dip("Dip 2", 0, 0, 180)}),
                 (QStringList{"Dip 1", "Dip 2"}));
    }
};

QTEST_GUILESS_MAIN(DipNamesTest)
#include "DipNamesTest.moc"

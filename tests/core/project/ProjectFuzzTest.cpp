// Thousands of damaged project files. Each opens or is refused with a message; none crashes the
// program or exhausts its memory. The damage is the same in every run.
#include "SampleProject.h"

#include "base/Error.h"
#include "project/ProjectStore.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QtTest>
#include <random>
#include <set>

using namespace dipwright;
using namespace dipwright::test;

namespace {

constexpr int damagedFiles = 3000;
constexpr int damagedDocuments = 4000;

using Random = std::mt19937;

int below(Random& random, qsizetype limit) {
    return int(random() % std::uint32_t(limit));
}

QByteArray damaged(QByteArray bytes, Random& random) {
    const int faults = 1 + below(random, 6);
    for (int fault = 0; fault < faults && !bytes.isEmpty(); ++fault) {
        const int place = below(random, bytes.size());
        switch (below(random, 5)) {
        case 0:
            bytes[place] = char(bytes[place] ^ (1 << below(random, 8)));
            break;
        case 1:
            bytes[place] = char(below(random, 2) * 0xff);
            break;
        case 2:
            bytes.truncate(place);
            break;
        case 3:
            bytes.remove(place, 1 + below(random, 40));
            break;
        default:
            bytes.insert(place, bytes.mid(below(random, bytes.size()), 1 + below(random, 40)));
        }
    }
    return bytes;
}

QJsonValue surprise(Random& random) {
    static const QJsonArray values{QJsonValue(),
                                   true,
                                   -1,
                                   0,
                                   1e300,
                                   -1e300,
                                   0.5,
                                   4294967296.0,
                                   "",
                                   "text",
                                   QString(100'000, 'x'),
                                   QJsonArray(),
                                   QJsonArray{1, 2},
                                   QJsonArray{1, 2, 3},
                                   QJsonArray{"1", QJsonValue()},
                                   QJsonObject(),
                                   QJsonObject{{"a", 1}}};
    return values.at(below(random, values.size()));
}

int valuesIn(const QJsonValue& value) {
    int count = 1;
    for (const QJsonValue& element : value.toArray()) {
        count += valuesIn(element);
    }
    for (const QJsonValue& element : value.toObject()) {
        count += valuesIn(element);
    }
    return count;
}

// Numbers all values inside `value`, starting at `next`. Returns `value` with those removed or
// replaced whose number is in `places`.
QJsonValue damagedAt(const QJsonValue& value, const std::set<int>& places, int& next,
                     Random& random) {
    if (places.contains(next++)) {
        next += valuesIn(value) - 1;
        return below(random, 3) == 0 ? QJsonValue(QJsonValue::Undefined) : surprise(random);
    }
    if (value.isObject()) {
        QJsonObject object;
        const QJsonObject old = value.toObject();
        for (auto entry = old.begin(); entry != old.end(); ++entry) {
            const QJsonValue damaged = damagedAt(entry.value(), places, next, random);
            if (!damaged.isUndefined()) {
                object.insert(entry.key(), damaged);
            }
        }
        return object;
    }
    if (value.isArray()) {
        QJsonArray array;
        for (const QJsonValue& element : value.toArray()) {
            const QJsonValue damaged = damagedAt(element, places, next, random);
            if (!damaged.isUndefined()) {
                array.append(damaged);
            }
        }
        return array;
    }
    return value;
}

// Returns the document with one to four values removed or replaced. Large documents lose as many
// values as small ones, so they are not refused more often.
QJsonValue damagedJson(const QJsonObject& document, Random& random) {
    const int values = valuesIn(document);
    std::set<int> places;
    for (int faults = 1 + below(random, 4); faults > 0; --faults) {
        places.insert(below(random, values));
    }
    int next = 0;
    return damagedAt(document, places, next, random);
}

} // namespace

class ProjectFuzzTest : public QObject {
    Q_OBJECT

private slots:
    void loadProject_damagedFiles_openOrAreRefused() {
        QTemporaryDir folder;
        const QString path = folder.filePath("job.dipw");
        saveProject(sampleProject(), path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray good = file.readAll();
        file.close();
        Random random(1);
        int refused = 0;
        for (int turn = 0; turn < damagedFiles; ++turn) {
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(damaged(good, random));
            file.close();
            try {
                QVERIFY(loadProject(path).model);
            } catch (const Error& error) {
                QVERIFY(!error.message().isEmpty());
                ++refused;
            }
        }
        QVERIFY(refused > damagedFiles / 2);
    }

    void fromJson_damagedDocuments_areReadOrRefused() {
        const QJsonObject good = toJson(sampleProject());
        Random random(2);
        int read = 0;
        int refused = 0;
        for (int turn = 0; turn < damagedDocuments; ++turn) {
            const QJsonValue json = damagedJson(good, random);
            try {
                const Project project = fromJson(json.toObject(), QStringLiteral("job.dipw"));
                // A document that was read can be written and read again: all its values are in
                // range.
                const QJsonObject written = toJson(project);
                QCOMPARE(toJson(fromJson(written, QStringLiteral("job.dipw"))), written);
                ++read;
            } catch (const Error& error) {
                QVERIFY(!error.message().isEmpty());
                ++refused;
            }
        }
        QVERIFY2(read > 50 && refused > 50,
                 qPrintable(
                     QStringLiteral("%1 documents read, %2 refused; expected more than 50 of each")
                         .arg(read)
                         .arg(refused)));
    }
};

QTEST_GUILESS_MAIN(ProjectFuzzTest)
#include "ProjectFuzzTest.moc"

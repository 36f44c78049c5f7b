// Runs the fuzz targets over their corpus in the ordinary build, with whole and damaged files. A
// target must accept a file or throw Error. `scripts/fuzz --keep` adds files to corpus/NAME. A file
// named fault-… once triggered a bug that is now fixed.
#include "TestFolders.h"
#include "WholeSample.h"
#include <QDir>
#include <QtTest>

#include <map>
#include <random>

extern "C" {
#define FUZZED(name) int fuzz_##name(const unsigned char* data, std::size_t size);
DIPWRIGHT_FUZZED
#undef FUZZED
}

namespace {

const QDir corpus(sourceFolder("/tests/fuzz/corpus"));

#define FUZZED(name) {QStringLiteral(#name), fuzz_##name},
const std::map<QString, int (*)(const unsigned char*, std::size_t)> targets{DIPWRIGHT_FUZZED};
#undef FUZZED

// Returns whether assimp reads the format. Other tests damage such files in separate processes,
// because assimp may crash.
bool isAssimps(const QString& name) {
    return QStringList{"obj", "stl", "gltf", "glb", "dae", "fbx", "3ds"}.contains(name);
}

QByteArray corpusFile(const QString& place) {
    QFile file(corpus.filePath(place));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

// Returns the bytes with a few of them changed, a piece removed, or a piece repeated.
QByteArray damaged(QByteArray bytes, std::mt19937& random) {
    const auto anywhere = [&] {
        return qsizetype(random() % std::size_t(std::max<qsizetype>(bytes.size(), 1)));
    };
    switch (random() % 3) {
    case 0:
        for (int i = 0; i < 4 && !bytes.isEmpty(); ++i) {
            bytes[anywhere()] = char(random());
        }
        return bytes;
    case 1:
        return bytes.remove(anywhere(), anywhere() / 4 + 1);
    default:
        return bytes.insert(anywhere(), bytes.mid(anywhere(), 64));
    }
}

} // namespace

class CorpusTest : public QObject {
    Q_OBJECT

private slots:
    void fuzzTarget_corpus_isNotEmpty() {
        for (const auto& [name, target] : targets) {
            QVERIFY2(!QDir(corpus.filePath(name)).isEmpty(), qPrintable(name));
        }
    }

    void fuzzTarget_corpusFile_isReadOrRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("file");
        for (const auto& [name, target] : targets) {
            for (const QString& file : QDir(corpus.filePath(name)).entryList(QDir::Files)) {
                QTest::addRow("%s/%s", qPrintable(name), qPrintable(file)) << name << file;
            }
        }
    }
    void fuzzTarget_corpusFile_isReadOrRefused() {
        QFETCH(QString, name);
        QFETCH(QString, file);
        const QByteArray bytes = corpusFile(name + u'/' + file);
        QVERIFY(!bytes.isEmpty() || file.startsWith(QLatin1String("fault")));
        read(name, bytes);
    }

    void fuzzTarget_damagedFiles_areReadOrRefused_data() {
        QTest::addColumn<QString>("name");
        for (const auto& [name, target] : targets) {
            if (!isAssimps(name)) {
                QTest::addRow("%s", qPrintable(name)) << name;
            }
        }
    }
    void fuzzTarget_damagedFiles_areReadOrRefused() {
        QFETCH(QString, name);
        std::mt19937 random(1);
        for (const QString& file : QDir(corpus.filePath(name)).entryList(QDir::Files)) {
            const QByteArray bytes = corpusFile(name + u'/' + file);
            for (int copy = 0; copy < dipwright::test::sampleOf(2, 200); ++copy) {
                read(name, damaged(bytes, random));
            }
        }
    }

private:
    static void read(const QString& name, const QByteArray& bytes) {
        QCOMPARE(targets.at(name)(reinterpret_cast<const unsigned char*>(bytes.constData()),
                                  std::size_t(bytes.size())),
                 0);
    }
};

QTEST_GUILESS_MAIN(CorpusTest)
#include "CorpusTest.moc"

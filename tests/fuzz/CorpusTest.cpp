// What the targets of libFuzzer have learned (corpus/NAME, by scripts/fuzz --keep), given to them
// by the ordinary build: whatever is read is refused by Error or accepted. Files named fault-… are
// what a mended fault was found with.
#include "TestFolders.h"
#include <QDir>
#include <QtTest>

#include <map>

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

} // namespace

class CorpusTest : public QObject {
    Q_OBJECT

private slots:
    void everyTargetHasACorpus() {
        for (const auto& [name, target] : targets) {
            QVERIFY2(!QDir(corpus.filePath(name)).isEmpty(), qPrintable(name));
        }
    }

    void allOfItIsReadOrRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("file");
        for (const auto& [name, target] : targets) {
            for (const QString& file : QDir(corpus.filePath(name)).entryList(QDir::Files)) {
                QTest::addRow("%s/%s", qPrintable(name), qPrintable(file)) << name << file;
            }
        }
    }
    void allOfItIsReadOrRefused() {
        QFETCH(QString, name);
        QFETCH(QString, file);
        QFile bytes(corpus.filePath(name + u'/' + file));
        QVERIFY(bytes.open(QIODevice::ReadOnly));
        const QByteArray all = bytes.readAll();
        QCOMPARE(targets.at(name)(reinterpret_cast<const unsigned char*>(all.constData()),
                                  std::size_t(all.size())),
                 0);
    }
};

QTEST_GUILESS_MAIN(CorpusTest)
#include "CorpusTest.moc"

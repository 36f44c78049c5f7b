// Fuzzes the reader of a print history record. An accepted record must survive being written and
// read again.
#include "printing/PrintHistory.h"

#include <QFile>
#include <QTemporaryDir>

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    using namespace dipwright;
    static const QTemporaryDir folder;
    static const PrintHistory history(folder.path());
    QFile file(folder.filePath(QStringLiteral("20260101T000000000-0.print.json")));
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(reinterpret_cast<const char*>(data), qint64(size)) != qint64(size)) {
        return 0;
    }
    file.close();
    std::vector<PrintRecord> records = history.records();
    if (!records.empty()) {
        const QString fate = outcomeText(records.front());
        const bool isKept = history.keep(records.front()).isEmpty();
        const std::vector<PrintRecord> again = history.records();
        if (!isKept || again.size() != 1 || outcomeText(again.front()) != fate ||
            again.front().job != records.front().job ||
            again.front().copies != records.front().copies) {
            std::abort();
        }
    }
    return 0;
}

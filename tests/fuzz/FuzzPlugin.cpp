// Fuzzes the description of a solver plugin, which is read before any code of the plugin runs.
#include "solver/SolverRegistry.h"

#include <QFile>
#include <QTemporaryDir>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("fuzz.json")));
    if (file.open(QIODevice::WriteOnly)) {
        file.write(reinterpret_cast<const char*>(data), qint64(size));
        file.close();
        const dipwright::SolverRegistry registry{QStringList{folder.path()}};
    }
    return 0;
}

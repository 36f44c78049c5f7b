// Fuzzes the reader of a project file: archive, document and mesh. FuzzPicture.cpp covers pictures.
#include "base/Error.h"
#include "model/StoredModel.h"
#include "project/Project.h"
#include "project/ZipReader.h"

#include <QJsonDocument>
#include <QTemporaryFile>

namespace {

void readAll(const QString& path) {
    dipwright::ZipReader archive(path);
    for (const QString& name : archive.names()) {
        try {
            const QByteArray bytes = archive.read(name);
            dipwright::fromJson(QJsonDocument::fromJson(bytes).object(), path);
            dipwright::readModel(bytes, path);
        } catch (const dipwright::Error&) {
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    static QTemporaryFile file;
    if (!file.isOpen() && !file.open()) {
        return 0;
    }
    file.resize(0);
    file.seek(0);
    file.write(reinterpret_cast<const char*>(data), qint64(size));
    file.flush();
    try {
        readAll(file.fileName());
    } catch (const dipwright::Error&) {
    }
    return 0;
}
